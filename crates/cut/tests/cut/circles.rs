//! The ledger's rows of CC that tell of its shape, one test a row. Parameter lists in inches.

use crate::common::{IN, at, cc, check, legs, number, origin, passes, refused};
use kerf_cut::{Cut, Step};

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
fn a_scaled_file_scales_the_shape_and_not_the_cutter() {
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
