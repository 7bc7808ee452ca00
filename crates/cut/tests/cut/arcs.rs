//! The ledger's rows of CG and CA, one test a row. Parameter lists in inches.

use crate::common::{IN, at, ca, cc, cg, cg_after, check, origin, passes, refused};
use kerf_cut::{CutError, Step};
use kerf_program::settings::LinearUnit;

#[test]
fn sbp_cut_cg_params() {
    check(
        cg(",2,-2,0,-2,T,1,-.1,1,1,1,0,1", &origin()),
        "cut 0 0 -0.1
         cw 90 about 0 -2 to 2 -2 -0.1",
    );
}

#[test]
fn sbp_cut_cg_ij() {
    check(cg(",2,-2,0,-2,T,1", &origin()), "cw 90 about 0 -2 to 2 -2 0");
    check(cg(",2,-2,0,-2,T,-1", &origin()), "ccw 270 about 0 -2 to 2 -2 0");
    let cut = cg(",2,-2,0,-2,T,-1", &origin()).unwrap();
    passes(&origin(), &cut, &[[-2.0, -2.0], [0.0, -4.0], [2.0, -2.0]]);
}

#[test]
fn sbp_cut_cg_full() {
    assert_eq!(cg(",,,0,-2", &origin()), cc("4", &origin()));
    assert_eq!(cg(",0,0,0,-2", &origin()), cc("4", &origin()));
}

#[test]
fn sbp_cut_cg_diam() {
    check(cg("4,2,-2,,,T,1", &origin()), "cw 90 about 0 -2 to 2 -2 0");
    check(cg("4,2,-2,,,T,-1", &origin()), "ccw 90 about 2 0 to 2 -2 0");
}

#[test]
fn sbp_cut_cg_diam_ignores_ij() {
    assert_eq!(cg("4,2,-2,9,9,T,1", &origin()), cg("4,2,-2,,,T,1", &origin()));
}

#[test]
fn sbp_cut_cg_diam_noend() {
    refused(cg("4", &origin()), "end point or centre offsets needed");
}

#[test]
fn sbp_cut_cg_diam_short() {
    refused(cg("2,2,-2", &origin()), "farther than the diameter");
    refused(cg("0,2,-2", &origin()), "diameter must be positive");
}

#[test]
fn half_a_circle_by_a_rounded_diameter() {
    check(cg("2.828,2,-2,,,T,1", &origin()), "cw 180 about 1 -1 to 2 -2 0");
}

#[test]
fn sbp_cut_cg_modal() {
    let (first, used) = cg_after(",2,-2,0,-2", None, &origin()).unwrap();
    assert_eq!(used, Some([0.0, -2.0 * IN]));
    let (again, kept) = cg_after(",2,-2", used, &origin()).unwrap();
    assert_eq!((&again, kept), (&first, used));
    let (lone, _) = cg_after(",2,-2,,-2", Some([0.0, 7.0]), &origin()).unwrap();
    assert_eq!(lone, first);
    refused(cg(",2,-2", &origin()), "no earlier CG");
    // A diameter leaves what an earlier CG had.
    assert_eq!(cg_after("4,2,-2", used, &origin()).unwrap().1, used);
}

#[test]
fn a_lone_offset_stands_beside_a_zero() {
    check(cg(",2,-2,,-2", &origin()), "cw 90 about 0 -2 to 2 -2 0");
    refused(cg(",2,-2,0,0", &origin()), "both zero");
}

#[test]
fn sbp_cut_cg_comp() {
    check(cg(",2,-2,0,-2,O,1", &origin()), "cw 90 about 0 -2.125 to 2.125 -2.125 0");
    check(cg(",2,-2,0,-2,I,1", &origin()), "cw 90 about 0 -1.875 to 1.875 -1.875 0");
}

#[test]
fn sbp_cut_cg_features() {
    let pocket = |line: &str| cg(line, &origin()).unwrap();
    let same = cc("4,I,1,0,360,-.1,1,1,1,2", &origin()).unwrap();
    assert_eq!(pocket(",,,0,-2,I,1,-.1,1,1,1,2"), same);
    check(
        cg(",2,-2,0,-2,T,1,-.1,1,1,1,3", &origin()),
        "cw 90 about 0 -2 to 2 -2 -0.1
         cut 2 -2 0",
    );
    let stretched = cg(",2,-2,0,-2,T,1,0,1,3,1", &origin()).unwrap();
    passes(&origin(), &stretched, &[[0.0, 0.0], [6.0, -2.0]]);
    assert_eq!(crate::common::told(&stretched).last().unwrap(), "cut 6 -2 0");
}

#[test]
fn sbp_cut_cg_mismatch() {
    refused(cg(",3,-3,0,-2", &origin()), "not on the circle");
    let error = cg(",3,-3,0,-2", &origin()).unwrap_err();
    let message = error.message(LinearUnit::Inch);
    assert!(message.contains("3.1623 in") && message.contains(" 2 in"), "{message}");
    assert!(matches!(cg(",2.0101,-2,0,-2", &origin()), Err(CutError::EndNotOnCircle { .. })));
    assert!(cg(",2.0099,-2,0,-2", &origin()).is_ok());
}

#[test]
fn rounded_numbers_still_give_a_true_circle() {
    // Large radius, short chord, four decimals: the centre gives way, the end does not.
    for line in [",0.5,0.0012,0.2501,100,T,-1", ",2.0003,-2,0,-2", ",-2,-2.0001,0,-2"] {
        let cut = cg(line, &origin()).unwrap();
        let [Step::Arc { centre, to, .. }] = cut.steps[..] else { panic!("{line}: one arc") };
        let radii = [centre[0].hypot(centre[1]), (to[0] - centre[0]).hypot(to[1] - centre[1])];
        assert!((radii[0] - radii[1]).abs() < 1e-9, "{line}: {radii:?}");
    }
}

/// The centre may move where the arc runs, here three quarters of a circle to the left; the quarter that it leaves out,
/// where the circle is farther off, does not count.
#[test]
fn the_arc_itself_tells_how_far_its_centre_may_move() {
    let cut = cg(",-4.0083268,-4,0,-4", &origin()).unwrap();
    let [Step::Arc { centre, to, .. }] = cut.steps[..] else { panic!("one arc: {:?}", cut.steps) };
    let radii = [centre[0].hypot(centre[1]), (to[0] - centre[0]).hypot(to[1] - centre[1])];
    assert!((radii[0] - radii[1]).abs() < 1e-9, "{radii:?}");
    // A little more is too much.
    assert_eq!(cg(",-4.0085,-4,0,-4", &origin()).unwrap().steps.len(), 2);
}

#[test]
fn a_nearly_whole_circle_keeps_its_centre_and_is_closed_straight() {
    check(
        cg(",-.002,.005,0,-2", &origin()),
        "cw 359.9428 about 0 -2 to -0.002 0 0
         cut -0.002 0.005 0",
    );
}

#[test]
fn the_end_is_where_the_user_put_it() {
    let cut = cg(",2.003,-2.001,0,-2", &origin()).unwrap();
    assert_eq!(cut.steps[0].to(), [2.003 * IN, -2.001 * IN, 0.0]);
}

#[test]
fn a_scaled_file_scales_arcs_to_a_scaled_end() {
    // FP proportions 2, 2: the end point comes scaled, I and J as written.
    let scaled = kerf_cut::Context { scale: [2.0, 2.0, 1.0], ..at(2.0, 0.0, 0.0) };
    check(cg(",6,-4,0,-2", &scaled), "cw 90 about 2 -4 to 6 -4 0");
    check(cg("4,6,-4", &scaled), "cw 90 about 2 -4 to 6 -4 0");
}

#[test]
fn sbp_cut_ca_basic() {
    check(ca("10,2.5", &origin()), "cw 106.2602 about 5 -3.75 to 10 0 0");
    passes(&origin(), &ca("10,2.5", &origin()).unwrap(), &[[5.0, 2.5], [10.0, 0.0]]);
}

#[test]
fn sbp_cut_ca_semi() {
    check(ca("10,5", &origin()), "cw 180 about 5 0 to 10 0 0");
}

#[test]
fn sbp_cut_ca_tall() {
    check(ca("4,3", &origin()), "cw 225.2397 about 2 0.8333 to 4 0 0");
    passes(&origin(), &ca("4,3", &origin()).unwrap(), &[[2.0, 3.0]]);
}

#[test]
fn sbp_cut_ca_dir() {
    check(ca("10,2.5,T,-1", &origin()), "ccw 106.2602 about -5 -3.75 to -10 0 0");
    passes(&origin(), &ca("10,2.5,T,-1", &origin()).unwrap(), &[[-5.0, 2.5]]);
}

#[test]
fn sbp_cut_ca_align() {
    check(ca("10,2.5,T,1,90", &origin()), "cw 106.2602 about -3.75 -5 to 0 -10 0");
    passes(&origin(), &ca("10,2.5,T,1,90", &origin()).unwrap(), &[[2.5, -5.0]]);
    let turned = ca("10,2.5,T,1,30", &origin()).unwrap();
    passes(&origin(), &turned, &[[5.5801, -0.3349], [8.6603, -5.0]]);
}

#[test]
fn sbp_cut_ca_out() {
    check(ca("10,2.5,O", &origin()), "cw 106.2602 about 5.1 -3.825 to 10.2 0 0");
}

#[test]
fn sbp_cut_ca_in() {
    check(ca("10,2.5,I", &origin()), "cw 106.2602 about 4.9 -3.675 to 9.8 0 0");
}

#[test]
fn sbp_cut_ca_plunge_reps() {
    check(
        ca("10,2.5,T,1,0,-.25,2", &origin()),
        "cut 0 0 -0.25
         cw 106.2602 about 5 -3.75 to 10 0 -0.25
         jog 10 0 1
         jog 0 0 1
         cut 0 0 -0.5
         cw 106.2602 about 5 -3.75 to 10 0 -0.5
         cut 10 0 0",
    );
}

#[test]
fn sbp_cut_ca_prop() {
    let cut = ca("10,2.5,T,1,0,0,1,2,1", &origin()).unwrap();
    passes(&origin(), &cut, &[[10.0, 2.5], [20.0, 0.0]]);
}

#[test]
fn sbp_cut_ca_prop__turned_first() {
    // Alignment 90 puts the span along Y; the proportion of the table then stretches the rise.
    let cut = ca("10,2.5,T,1,90,0,1,2,1", &origin()).unwrap();
    passes(&origin(), &cut, &[[5.0, -5.0], [0.0, -10.0]]);
}

#[test]
fn sbp_cut_ca_nopullup_from0() {
    check(
        ca("10,2.5,T,1,0,-.25,1,1,1,0,1,1", &at(0.0, 0.0, 0.5)),
        "cut 0 0 0
         cut 0 0 -0.25
         cw 106.2602 about 5 -3.75 to 10 0 -0.25",
    );
}

#[test]
fn sbp_cut_ca_err() {
    refused(ca("0,1", &origin()), "arch length must be positive");
    refused(ca("10,0", &origin()), "arch height must be positive");
    refused(ca("10,-1", &origin()), "arch height must be positive");
}

#[test]
fn an_arch_has_no_pocket() {
    refused(ca("10,2.5,T,1,0,-.25,1,1,1,2", &origin()), "feature must be 0 or 1");
}
