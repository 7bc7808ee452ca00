//! The ledger's rows of CC that tell of plunges, repetitions and spirals. Parameter lists in inches.

use crate::common::{IN, at, cc, check, number, origin, refused};
use kerf_cut::Cut;

#[track_caller]
fn end_z(cut: &Cut) -> f64 {
    cut.steps.last().unwrap().to()[2] / IN
}

#[test]
fn sbp_cut_cc_plunge() {
    check(
        cc("4,T,1,0,360,-.25", &origin()),
        "cut 0 0 -0.25
         cw 360 about 0 -2 to 0 0 -0.25
         cut 0 0 0",
    );
}

#[test]
fn sbp_cut_cc_reps() {
    check(
        cc("4,T,1,0,360,-.25,3", &origin()),
        "cut 0 0 -0.25
         cw 360 about 0 -2 to 0 0 -0.25
         cut 0 0 -0.5
         cw 360 about 0 -2 to 0 0 -0.5
         cut 0 0 -0.75
         cw 360 about 0 -2 to 0 0 -0.75
         cut 0 0 0",
    );
    let flat = cc("4,T,1,0,360,0,3", &origin()).unwrap();
    assert!(flat.steps.len() == 3 && flat.steps.iter().all(|s| s.to() == [0.0; 3]));
    refused(cc("4,T,1,0,360,-.25,0", &origin()), "repetitions must be 1 or more");
}

#[test]
fn sbp_cut_cc_reps_arc() {
    check(
        cc("4,T,1,90,180,-.25,2", &origin()),
        "cut 0 0 -0.25
         cw 90 about -2 0 to -2 -2 -0.25
         jog -2 -2 1
         jog 0 0 1
         cut 0 0 -0.5
         cw 90 about -2 0 to -2 -2 -0.5
         cut -2 -2 0",
    );
}

#[test]
fn the_way_back_never_goes_down() {
    check(
        cc("4,T,1,90,180,-.25,2", &at(0.0, 0.0, 2.0)),
        "cut 0 0 1.75
         cw 90 about -2 0 to -2 -2 1.75
         jog 0 0 1.75
         cut 0 0 1.5
         cw 90 about -2 0 to -2 -2 1.5
         cut -2 -2 2",
    );
}

#[test]
fn the_way_back_without_safe_z_is_over_the_surface() {
    let off = kerf_cut::Context { safe_z: None, ..at(0.0, 0.0, -0.25) };
    let cut = cc("4,T,1,90,180,-.25,2", &off).unwrap();
    assert_eq!(cut.steps[2].to(), [-2.0 * IN, -2.0 * IN, 0.0]);
}

#[test]
fn sbp_cut_cc_spiral() {
    check(
        cc("4,T,1,0,360,-.5,1,1,1,3", &origin()),
        "cw 360 about 0 -2 to 0 0 -0.5
         cut 0 0 0",
    );
}

#[test]
fn sbp_cut_cc_spiral__ellipse() {
    let cut = cc("4,T,1,0,360,-.5,1,2,1,3", &origin()).unwrap();
    let turn = &cut.steps[..cut.steps.len() - 1];
    let right = turn.iter().max_by(|a, b| a.to()[0].total_cmp(&b.to()[0])).unwrap();
    assert!((right.to()[2] / IN + 0.125).abs() < 0.5 / turn.len() as f64, "{right:?}");
    assert_eq!(turn.last().unwrap().to()[2] / IN, -0.5);
}

#[test]
fn sbp_cut_cc_spiral_reps() {
    check(
        cc("4,T,1,0,360,-.25,3,1,1,3", &origin()),
        "cw 360 about 0 -2 to 0 0 -0.25
         cw 360 about 0 -2 to 0 0 -0.5
         cw 360 about 0 -2 to 0 0 -0.75
         cut 0 0 0",
    );
}

#[test]
fn sbp_cut_cc_spiral_bottom() {
    check(
        cc("4,T,1,0,360,-.25,3,1,1,4", &origin()),
        "cw 360 about 0 -2 to 0 0 -0.25
         cw 360 about 0 -2 to 0 0 -0.5
         cw 360 about 0 -2 to 0 0 -0.75
         cw 360 about 0 -2 to 0 0 -0.75
         cut 0 0 0",
    );
}

#[test]
fn sbp_cut_cc_spiral_arc() {
    check(
        cc("4,T,1,0,90,-.2,1,1,1,3", &origin()),
        "cw 90 about 0 -2 to 2 -2 -0.2
         cut 2 -2 0",
    );
}

#[test]
fn sbp_cut_cc_spiral_arc__repeated() {
    check(
        cc("4,T,1,0,90,-.2,2,1,1,4,1", &origin()),
        "cw 90 about 0 -2 to 2 -2 -0.2
         jog 2 -2 1
         jog 0 0 1
         cut 0 0 -0.2
         cw 90 about 0 -2 to 2 -2 -0.4
         jog 2 -2 1
         jog 0 0 1
         cut 0 0 -0.4
         cw 90 about 0 -2 to 2 -2 -0.4",
    );
}

#[test]
fn sbp_cut_cc_nopullup() {
    let from = at(0.0, 0.0, 0.2);
    assert!((end_z(&cc("4,T,1,0,360,-.3,1,1,1,0,1", &from).unwrap()) + 0.1).abs() < 1e-12);
    assert!((end_z(&cc("4,T,1,0,360,-.3,1,1,1,0,0", &from).unwrap()) - 0.2).abs() < 1e-12);
}

#[test]
fn sbp_cut_cc_pullup_height() {
    let from = at(0.0, 0.0, 0.5);
    check(
        cc("4,T,1,0,360,-.75", &from),
        "cut 0 0 -0.25
         cw 360 about 0 -2 to 0 0 -0.25
         cut 0 0 0.5",
    );
    check(cc("4,T,1,0,360,0", &from), "cw 360 about 0 -2 to 0 0 0.5");
}

#[test]
fn sbp_cut_cc_from0() {
    let from = at(0.0, 0.0, 0.5);
    check(
        cc("4,T,1,0,360,-.25,2,1,1,0,0,1", &from),
        "cut 0 0 0
         cut 0 0 -0.25
         cw 360 about 0 -2 to 0 0 -0.25
         cut 0 0 -0.5
         cw 360 about 0 -2 to 0 0 -0.5
         cut 0 0 0.5",
    );
    let cut = cc("4,T,1,0,360,-.25,2,1,1,0,0,0", &from).unwrap();
    let heights: Vec<_> = cut.steps.iter().map(|s| number(s.to()[2] / IN)).collect();
    assert_eq!(heights, ["0.25", "0.25", "0", "0", "0.5"]);
    // From below, Z comes up to 0 first (readings, A-74).
    let below = cc("4,T,1,0,360,-.25,1,1,1,0,0,1", &at(0.0, 0.0, -1.0)).unwrap();
    assert_eq!(below.steps[0].to()[2], 0.0);
}
