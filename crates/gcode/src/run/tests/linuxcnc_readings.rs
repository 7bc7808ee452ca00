//! Cusps, tools and offsets as LinuxCNC reads them.

use super::*;

#[track_caller]
fn ends(text: &str, expected: &str) {
    let ran = run(&format!("G21 G90 F600⏎{text}"));
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    assert_eq!(ran.end(), expected, "{text}");
}

#[test]
fn a_cusp_between_two_arcs_is_an_inside_corner() {
    // A row of scallops: the tool ends where both circles beside the path cross, √(6² − 5²) above it.
    path(
        "G0 X0 Y0⏎G41.1 D2⏎G1 X10 Y0⏎G2 X20 Y0 R5⏎G2 X30 Y0 R5⏎G1 X40⏎G40⏎G0 Y10",
        "L9.0839,1,0 A20,3.3166,0@15,0:-136.8486 A30.9161,1,0@25,0:-136.8486 L40,1,0 J40,10,0",
    );
}

#[test]
fn zero_of_a_turned_system_keeps_what_is_not_named() {
    ends("G10 L2 P1 R30⏎G1 X10 Y10⏎G10 L20 P1 X0⏎G1 X0", "3.6603,13.6603,0");
    // Y reads as before.
    prints("G10 L2 P1 R30⏎G1 X10 Y10⏎G10 L20 P1 X0⏎#<_r>=#5421", "10.000000");
}

#[test]
fn a_tool_measured_in_the_last_system_forgets_where_the_others_are() {
    let measured = "G10 L2 P9 Z7⏎G1 Z10⏎T3 M6⏎G10 L11 P3 Z1.5⏎G43⏎G1 Z0";
    ends(measured, "0,0,1.5");
    // G92 does not count either.
    ends(&measured.replace("T3 M6", "G92 Z4 T3 M6⏎G92.1"), "0,0,1.5");
}

#[test]
fn d0_and_an_empty_spindle_cut_with_a_cutter_and_say_so() {
    let with = |text: &str| {
        let mut session = metric();
        session.state.tools.insert(1, Tool { diameter_mm: 2.0, ..Tool::default() });
        session.settings.cutter.diameter_mm = 6.0;
        let text = format!("G21 F100⏎{text}⏎G1 X10⏎G40");
        run_with(&text, FakeHost::default(), session, Options::default())
    };
    let in_spindle = with("T1 M6⏎G41 D0");
    assert_eq!((in_spindle.path().as_str(), in_spindle.codes().as_str()), ("L10,1,0", "W014"));
    let empty = with("G41");
    assert_eq!((empty.path().as_str(), empty.codes().as_str()), ("L10,3,0", "W014"));
}

#[test]
fn a_diameter_below_zero_is_the_other_side() {
    path("G41.1 D-4⏎G1 X10⏎G40", "L10,-2,0");
    fails("G41 D-4", "R009 2:1 D may not be negative");
}

#[test]
fn a_cusp_of_quarter_circles_is_inside_on_one_side_and_outside_on_the_other() {
    let hills = "G1 Y10⏎G2 X10 Y0 R10⏎G2 X20 Y10 R10⏎G1 Y20⏎G40";
    // Above the hills the tool is kept out of the valley; below them it goes round its point.
    let above = run(&format!("G21 F100⏎G41.1 D2 {hills}")).path();
    assert!(above.contains("A10,4.5826,0@0,0:"), "{above}");
    let below = run(&format!("G21 F100⏎G42.1 D2 {hills}")).path();
    assert!(below.contains("@10,0:180"), "{below}");
    // A spur of straight lines has no inside.
    path("G41.1 D2 G1 X10⏎X20⏎X10⏎G40", "L10,1,0 L20,1,0 A20,-1,0@20,0:-180 L10,-1,0");
}
