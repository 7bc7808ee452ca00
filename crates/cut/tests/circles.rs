//! The ledger's rows of CC and CP, one test a row. Parameter lists in inches.
// Two underscores set off which part of a row a test shows.
#![allow(clippy::unwrap_used, non_snake_case)]

mod common;
use common::{IN, at, cc, check, cp, legs, number, origin, passes, refused};
use kerf_cut::{Cut, MAX_STEPS, Step};
use kerf_program::settings::PlungeSign;

#[track_caller]
fn end_z(cut: &Cut) -> f64 {
    cut.steps.last().unwrap().to()[2] / IN
}

fn chords(cut: &Cut) -> u32 {
    match cut.steps[0] {
        Step::Arc { chords, .. } => chords,
        Step::Line { .. } => 0,
    }
}

fn small(cut: &Cut) -> bool {
    matches!(cut.steps[0], Step::Arc { small: true, .. })
}

#[test]
fn sbp_cut_segments__circle() {
    let cut = cc("4", &origin()).unwrap();
    assert_eq!((cut.steps.len(), chords(&cut)), (1, 252));
    let coarse = kerf_cut::Context { circle_mm: 0.2 * IN, ..origin() };
    assert_eq!(chords(&cc("4", &coarse).unwrap()), 63);
    assert_eq!(chords(&cc("4,T,1,0,90", &origin()).unwrap()), 63);
}

#[test]
fn sbp_cut_segments__ellipse() {
    // An ellipse is made of chords no longer than the resolution.
    let legs = legs([0.0; 3], &cc("4,T,1,,,0,1,2,1", &origin()).unwrap().steps);
    for (from, step) in legs {
        let to = step.to();
        assert!((to[0] - from[0]).hypot(to[1] - from[1]) < 0.05);
    }
}

#[test]
fn sbp_cut_seg_downshift__circle() {
    assert_eq!(chords(&cc(".1", &origin()).unwrap()), 63);
    assert_eq!(chords(&cc("4", &origin()).unwrap()), 252);
}

#[test]
fn sbp_cut_cc_default() {
    check(cc("4", &origin()), "cw 360 about 0 -2 to 0 0 0");
    let cut = cc("4", &origin()).unwrap();
    passes(&origin(), &cut, &[[2.0, -2.0], [0.0, -4.0], [-2.0, -2.0], [0.0, 0.0]]);
}

#[test]
fn a_diameter_is_positive() {
    refused(cc("0", &origin()), "diameter must be positive");
    refused(cc("-2", &origin()), "diameter must be positive");
}

#[test]
fn sbp_cut_cc_180_540() {
    let cut = cc("4,T,1,180,540", &origin()).unwrap();
    passes(&origin(), &cut, &[[-2.0, 2.0], [0.0, 4.0], [0.0, 0.0]]);
}

#[test]
fn sbp_cut_cc_270_630() {
    let cut = cc("4,T,1,270,630", &origin()).unwrap();
    passes(&origin(), &cut, &[[2.0, 2.0], [4.0, 0.0], [0.0, 0.0]]);
}

#[test]
fn sbp_cut_cc_90_180() {
    check(cc("4,T,1,90,180", &origin()), "cw 90 about -2 0 to -2 -2 0");
}

#[test]
fn sbp_cut_cc_90_180_ccw() {
    check(cc("4,T,-1,90,180", &origin()), "ccw 270 about -2 0 to -2 -2 0");
    let cut = cc("4,T,-1,90,180", &origin()).unwrap();
    passes(&origin(), &cut, &[[-2.0, 2.0], [-4.0, 0.0], [-2.0, -2.0]]);
}

#[test]
fn sbp_cut_cc_90_m180_ccw() {
    let (one, other) = (cc("4,T,-1,90,-180", &origin()), cc("4,T,-1,90,180", &origin()));
    assert_eq!(one, other);
}

#[test]
fn sbp_cut_cc_corner() {
    let cut = cc("2,T,-1,180,90", &at(10.0, 0.0, 0.0)).unwrap();
    assert_eq!(cut.heading_deg, 0.0);
    check(Ok(cut), "ccw 90 about 10 1 to 11 1 0");
}

#[test]
fn sbp_cut_cc_blank_begin() {
    check(cc("4,T,1,,90", &origin()), "cw 90 about 0 -2 to 2 -2 0");
    check(cc("4,T,-1,,270", &origin()), "ccw 90 about 0 -2 to -2 -2 0");
}

#[test]
fn sbp_cut_cc_blank_end() {
    check(cc("4,T,1,90", &origin()), "cw 360 about -2 0 to 0 0 0");
    passes(&origin(), &cc("4,T,-1,90", &origin()).unwrap(), &[[-2.0, 2.0], [0.0, 0.0]]);
}

#[test]
fn sbp_cut_cc_equal_angles() {
    check(cc("4,T,1,0,0", &origin()), "cw 360 about 0 -2 to 0 0 0");
    check(cc("4,T,1,45,45", &origin()), "cw 360 about -1.4142 -1.4142 to 0 0 0");
}

#[test]
fn angles_equal_but_for_single_precision_are_equal() {
    check(cc("4,T,1,45,45.00003", &origin()), "cw 360 about -1.4142 -1.4142 to 0 0 0");
    check(cc("4,T,1,45,44.99997", &origin()), "cw 360 about -1.4142 -1.4142 to 0 0 0");
}

#[test]
fn sbp_cut_cc_modulo() {
    check(cc("4,T,1,0,720", &origin()), "cw 360 about 0 -2 to 0 0 0");
    assert_eq!(cc("4,T,1,-90,0", &origin()), cc("4,T,1,270,360", &origin()));
}

#[test]
fn sbp_cut_cc_out() {
    check(cc("4,O", &origin()), "cw 360 about 0 -2.125 to 0 0 0");
}

#[test]
fn sbp_cut_cc_in() {
    check(cc("4,I", &origin()), "cw 360 about 0 -1.875 to 0 0 0");
    refused(cc(".2,I", &origin()), "cutter larger than hole");
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
fn plunges_are_positive_where_z_counts_downwards() {
    let plus = kerf_cut::Context { plunge_down: PlungeSign::Plus, ..origin() };
    assert_eq!(cc("4,T,1,0,360,.25,3", &plus), cc("4,T,1,0,360,-.25,3", &origin()));
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
fn sbp_cut_cc_prop() {
    let cut = cc("16,T,1,0,360,0,1,3,1", &origin()).unwrap();
    let quarters = [[24.0, -8.0], [0.0, -16.0], [-24.0, -8.0], [0.0, 0.0]];
    passes(&origin(), &cut, &quarters);
    let (sin, cos) = 60f64.to_radians().sin_cos();
    passes(&origin(), &cut, &[[24.0 * sin, -8.0 + 8.0 * cos]]);
}

#[test]
fn sbp_cut_cc_prop_arch() {
    let cut = cc("16,T,1,270,90,0,1,3,1", &origin()).unwrap();
    passes(&origin(), &cut, &[[24.0, 8.0], [48.0, 0.0]]);
    assert!((cut.heading_deg - 180.0).abs() < 1e-9);
}

#[test]
fn sbp_cut_cc_prop_mirror() {
    check(cc("4,T,1,0,90,0,1,-1,1", &origin()), "ccw 90 about 0 -2 to -2 -2 0");
    // Mirrored twice it is turned by half a turn and goes round as before.
    check(cc("4,T,1,0,90,0,1,-1,-1", &origin()), "cw 90 about 0 2 to -2 2 0");
}

#[test]
fn equal_proportions_stay_an_arc() {
    check(cc("4,O,1,0,90,0,1,3,3", &origin()), "cw 90 about 0 -6.125 to 6.125 -6.125 0");
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
    // From below, Z comes up to 0 first.
    let below = cc("4,T,1,0,360,-.25,1,1,1,0,0,1", &at(0.0, 0.0, -1.0)).unwrap();
    assert_eq!(below.steps[0].to()[2], 0.0);
}

#[test]
fn small_circles_are_flagged() {
    assert!(small(&cc(".2", &origin()).unwrap()));
    assert!(!small(&cc(".3", &origin()).unwrap()));
    assert!(!small(&cc(".25", &origin()).unwrap()));
}

#[test]
fn sbp_cut_cc_endpoint() {
    let mut context = at(0.1, 0.2, 0.0);
    let start = context.start;
    for _ in 0..1000 {
        context.start = cc("4,T,1,33", &context).unwrap().steps[0].to();
    }
    assert_eq!(context.start, start);
}

#[test]
fn sbp_cut_scaled_file__geometry() {
    let scaled = |scale| kerf_cut::Context { scale, ..origin() };
    let size = |line: &str, scale| {
        let steps = cc(line, &scaled(scale)).unwrap().steps;
        [0, 1].map(|axis| {
            let all = || steps.iter().map(|s| s.to()[axis] / IN);
            number(all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min))
        })
    };
    assert_eq!(size("4", [2.0, 1.0, 1.0]), ["8", "4"]);
    assert_eq!(size("4,O", [2.0, 1.0, 1.0]), ["8.25", "4.25"]);
    check(
        cc("4,O,1,0,90,-.1", &scaled([2.0, 2.0, 3.0])),
        "cut 0 0 -0.3
         cw 90 about 0 -4.125 to 4.125 -4.125 -0.3
         cut 4.125 -4.125 0",
    );
}

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
    refused(cc("4,T,1,0,360,0,1000000000", &origin()), &format!("more than {MAX_STEPS} moves"));
    refused(cc("4,T,1,1e300", &origin()), "begin angle");
    refused(cc("4,T,1,0,1e300", &origin()), "end angle");
    refused(cc("4,T,1,0,360,0,1,0,1", &origin()), "proportions must not be zero");
    refused(cc("30000,T,1,0,360,0,1,1,2", &origin()), &format!("more than {MAX_STEPS} moves"));
    let nan = kerf_cut::Context { circle_mm: f64::NAN, ..origin() };
    refused(cc("4", &nan), "circle resolution");
    refused(cp("4,1e300,0", &origin()), "centre");
}
