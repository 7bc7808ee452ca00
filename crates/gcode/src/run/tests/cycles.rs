//! Canned cycles one after the other: what stays, what rises, what is refused.

use super::{fails, path};

#[test]
fn a_cycle_with_a_higher_r_rises_before_it_travels() {
    // What stands between the holes is why R is higher.
    path(
        "G0 Z4⏎G99⏎G81 X-1 R1 Z-5⏎R2 X1⏎X2",
        "J0,0,4 J-1,0,4 J-1,0,1 L-1,0,-5 J-1,0,1 J-1,0,2 J1,0,2 L1,0,-5 J1,0,2 J2,0,2 L2,0,-5 J2,0,2",
    );
}

#[test]
fn a_cycle_in_another_plane_begins_anew() {
    let first = "G0 Z9⏎G81 X1 R2 Z-1⏎G18 G81 Y-1 R2 X3";
    path(first, "J0,0,9 J1,0,9 J1,0,2 L1,0,-1 J1,0,9 J1,2,9 J3,2,9 L3,-1,9 J3,2,9");
    fails("G0 Z9⏎G81 X1 R2 Z-1⏎G18 G81 X3 R2", "G008 4:1 G81 without Y");
}

#[test]
fn g87_keeps_its_way_beside_the_hole() {
    let around = |x: f64| {
        let at = |dx: f64, z: f64| format!("{},0,{z}", x + dx);
        format!(
            "J{} J{} J{} L{} L{} J{} J{} J{}",
            at(1.0, 2.0),
            at(1.0, -5.0),
            at(0.0, -5.0),
            at(0.0, -3.0),
            at(0.0, -5.0),
            at(1.0, -5.0),
            at(1.0, 2.0),
            at(0.0, 2.0)
        )
    };
    let expected = format!("J0,0,2 J4,0,2 {} J8,0,2 {}", around(4.0), around(8.0));
    path("M3 S9⏎G99⏎G87 X4 R2 Z-5 I1 J0 K-3⏎X8", &expected);
    let relative = format!("J0,0,2 J4,0,2 {}", around(4.0));
    path("M3 S9⏎G99 G91⏎G87 X4 R2 Z-7 I1 J0 K2", &relative);
    fails("M3 S9⏎G87 X4 R2 Z-5 K-3", "G008 3:1 G87 without I, J or K");
}

#[test]
fn a_cycle_does_not_go_with_inverse_time() {
    fails("G93⏎G81 X1 R2 Z-1 F2", "G007 3:1 G81 while G93 holds");
}
