//! The ledger's rows of CP, and absurd numbers for circles. Parameter lists in inches.

use crate::common::{at, cc, check, cp, origin, passes, refused};
use kerf_cut::MAX_STEPS;

#[test]
fn sbp_cut_cp_start() {
    check(
        cp("4,10,10", &origin()),
        "cut 10 12 0
         cw 360 about 10 10 to 10 12 0",
    );
}

#[test]
fn sbp_cut_cp_angles() {
    check(
        cp("4,10,10,T,1,90,180", &origin()),
        "cut 12 10 0
         cw 90 about 10 10 to 10 8 0",
    );
    let cut = cp("4,10,10,T,-1,90,180", &origin()).unwrap();
    passes(&origin(), &cut, &[[12.0, 10.0], [10.0, 12.0], [8.0, 10.0], [10.0, 8.0]]);
}

#[test]
fn sbp_cut_cp_comp() {
    check(
        cp("4,10,10,O", &origin()),
        "cut 10 12.125 0
         cw 360 about 10 10 to 10 12.125 0",
    );
    check(
        cp("4,10,10,I", &origin()),
        "cut 10 11.875 0
         cw 360 about 10 10 to 10 11.875 0",
    );
}

#[test]
fn sbp_cut_cp_default_angles() {
    assert_eq!(cp("4,10,10", &origin()), cp("4,10,10,T,1,0,0", &origin()));
    check(
        cp("4,10,10,T,-1", &origin()),
        "cut 10 12 0
         ccw 360 about 10 10 to 10 12 0",
    );
}

#[test]
fn sbp_cut_cp_plunge() {
    check(
        cp("4,10,10,T,1,,,-.25,2,1,1,0,0,1", &at(0.0, 0.0, 0.5)),
        "cut 10 12 0.5
         cut 10 12 0
         cut 10 12 -0.25
         cw 360 about 10 10 to 10 12 -0.25
         cut 10 12 -0.5
         cw 360 about 10 10 to 10 12 -0.5
         cut 10 12 0.5",
    );
}

#[test]
fn sbp_cut_cp_prop() {
    let cut = cp("16,0,0,T,1,270,90,0,1,3,1", &origin()).unwrap();
    passes(&origin(), &cut, &[[-24.0, 0.0], [0.0, 8.0], [24.0, 0.0]]);
}

#[test]
fn a_tool_at_the_first_point_of_cp_stays_there() {
    check(cp("4,0,-2", &origin()), "cw 360 about 0 -2 to 0 0 0");
}

#[test]
fn absurd_numbers_are_refused() {
    refused(cc("1e300", &origin()), "diameter is not a usable number");
    refused(cc("4,T,1,0,360,1e300", &origin()), "plunge is not a usable number");
    refused(cc("4,T,1,0,360,-.1,1000000000", &origin()), "depth of all plunges");
    // An arc, its plunge and what goes before and after them, and once more for the way back.
    assert!(cc("4,T,1,0,360,0,83332", &origin()).is_ok());
    refused(cc("4,T,1,0,360,0,83333", &origin()), &format!("more than {MAX_STEPS} moves"));
    refused(cc("4,T,1,0,360,0,1000000000", &origin()), &format!("more than {MAX_STEPS} moves"));
    refused(cc("4,T,1,1e300", &origin()), "begin angle");
    refused(cc("4,T,1,0,1e300", &origin()), "end angle");
    refused(cc("4,T,1,0,360,0,1,0,1", &origin()), "proportions must not be zero");
    refused(cc("30000,T,1,0,360,0,1,1,2", &origin()), &format!("more than {MAX_STEPS} moves"));
    let nan = kerf_cut::Context { circle_mm: f64::NAN, ..origin() };
    refused(cc("4", &nan), "circle resolution");
    refused(cp("4,1e300,0", &origin()), "centre");
}
