//! The ledger's rows of CR and of pockets, one test a row. Parameter lists in inches.

use crate::common::{at, cc, check, cp, cr, number, origin, passes, refused};
use kerf_cut::{Context, Cut};
use std::fmt::Write;

/// The corners of a rectangle at Z 0, in order.
#[track_caller]
fn corners(line: &str, places: [[i32; 2]; 4]) {
    let lines: Vec<_> = places.iter().map(|[x, y]| format!("cut {x} {y} 0")).collect();
    check(cr(line, &origin()), &lines.join("\n"));
}

#[test]
fn sbp_cut_cr_square() {
    corners("10", [[0, 10], [10, 10], [10, 0], [0, 0]]);
}

#[test]
fn sbp_cut_cr_start4() {
    corners("10,5", [[0, 5], [10, 5], [10, 0], [0, 0]]);
}

#[test]
fn sbp_cut_cr_start1() {
    corners("10,5,T,1,1", [[10, 0], [10, -5], [0, -5], [0, 0]]);
}

#[test]
fn sbp_cut_cr_start2() {
    corners("10,5,T,1,2", [[0, -5], [-10, -5], [-10, 0], [0, 0]]);
}

#[test]
fn sbp_cut_cr_start3() {
    corners("10,5,T,1,3", [[-10, 0], [-10, 5], [0, 5], [0, 0]]);
}

#[test]
fn sbp_cut_cr_ccw() {
    corners("10,5,T,-1,4", [[10, 0], [10, 5], [0, 5], [0, 0]]);
    corners("10,5,T,-1,1", [[0, -5], [10, -5], [10, 0], [0, 0]]);
    corners("10,5,T,-1,2", [[-10, 0], [-10, -5], [0, -5], [0, 0]]);
    corners("10,5,T,-1,3", [[0, 5], [-10, 5], [-10, 0], [0, 0]]);
    assert_eq!(cr("10,5,T,-1,4", &origin()).unwrap().heading_deg, 180.0);
}

#[test]
fn sbp_cut_cr_out() {
    check(
        cr("10,5,O", &origin()),
        "cut 0 5.25 0
         cut 10.25 5.25 0
         cut 10.25 0 0
         cut 0 0 0",
    );
}

#[test]
fn sbp_cut_cr_in() {
    check(
        cr("10,5,I", &origin()),
        "cut 0 4.75 0
         cut 9.75 4.75 0
         cut 9.75 0 0
         cut 0 0 0",
    );
    refused(cr("10,.25,I", &origin()), "cutter larger than hole");
}

#[test]
fn sbp_cut_cr_plunge() {
    check(
        cr("10,5,T,1,4,-.25,2", &origin()),
        "cut 0 0 -0.25
         cut 0 5 -0.25
         cut 10 5 -0.25
         cut 10 0 -0.25
         cut 0 0 -0.25
         cut 0 0 -0.5
         cut 0 5 -0.5
         cut 10 5 -0.5
         cut 10 0 -0.5
         cut 0 0 -0.5
         cut 0 0 0",
    );
}

#[test]
fn sbp_cut_cr_from0() {
    check(
        cr("10, 5, , , , -.25, , , 1", &at(0.0, 0.0, 0.5)),
        "cut 0 0 0
         cut 0 0 -0.25
         cut 0 5 -0.25
         cut 10 5 -0.25
         cut 10 0 -0.25
         cut 0 0 -0.25
         cut 0 0 0.5",
    );
}

#[test]
fn a_spiral_rectangle_is_refused() {
    refused(cr("2,1,,,,,,3", &origin()), "0-2");
}

#[test]
fn sbp_cut_cr_sign() {
    refused(cr("-10,5", &origin()), "length X must be positive");
    refused(cr("10,-5", &origin()), "length Y must be positive");
}

#[test]
fn a_mirrored_file_mirrors_rectangles() {
    let mirrored = Context { scale: [-2.0, 1.0, 1.0], ..origin() };
    check(
        cr("10,5,O", &mirrored),
        "cut 0 5.25 0
         cut -20.25 5.25 0
         cut -20.25 0 0
         cut 0 0 0",
    );
}

/// The cutting moves at one level, without the small moves out into corners and back.
fn level(cut: &Cut, z: &str) -> String {
    let told = crate::common::told(cut);
    let at_level = |s: &&String| s.starts_with("cut") && s.ends_with(&format!(" {z}"));
    let all: Vec<_> = told.iter().filter(at_level).cloned().collect();
    let mut kept: Vec<String> = Vec::new();
    for step in all {
        let back = kept.len() > 1 && kept[kept.len() - 2] == step;
        if back { kept.truncate(kept.len() - 1) } else { kept.push(step) }
    }
    kept.join("\n")
}

#[track_caller]
fn check_level(line: &str, context: &Context, places: &[[f64; 2]]) {
    let cut = cr(line, context).unwrap();
    let want: Vec<_> =
        places.iter().map(|p| format!("cut {} {} -0.1", number(p[0]), number(p[1]))).collect();
    assert_eq!(level(&cut, "-0.1"), want.join("\n"));
}

#[test]
fn sbp_cut_cr_pocket() {
    let ring = |inset: f64| {
        let (x, y) = (2.0 - inset, 1.0 - inset);
        [[inset, inset], [inset, y], [x, y], [x, inset], [inset, inset]]
    };
    check_level("2,1,T,1,4,-.1,1,2", &origin(), &[ring(0.0), ring(0.225), ring(0.45)].concat());
    let told = crate::common::told(&cr("2,1,T,1,4,-.1,1,2", &origin()).unwrap());
    assert_eq!(told[told.len() - 3..], ["jog 0.45 0.45 1", "jog 0 0 1", "cut 0 0 0"]);
}

#[test]
fn sbp_cut_cr_pocket__other_corners_mirror_it() {
    for (line, signs) in [("1", [1.0, -1.0]), ("2", [-1.0, -1.0]), ("3", [-1.0, 1.0])] {
        let here = cr(&format!("2,1,T,1,{line},-.1,1,2"), &origin()).unwrap();
        let bounds = |axis: usize| {
            let all = || here.steps.iter().map(|s| s.to()[axis] * signs[axis]);
            (number(all().fold(f64::MAX, f64::min)), number(all().fold(f64::MIN, f64::max)))
        };
        assert_eq!(bounds(0), ("0".to_owned(), "50.8".to_owned()), "corner {line}");
        assert_eq!(bounds(1), ("0".to_owned(), "25.4".to_owned()), "corner {line}");
    }
}

#[test]
fn sbp_cut_cr_pocket_core() {
    let second = [[0.225, 0.225], [0.225, 0.625], [1.775, 0.625], [1.775, 0.225], [0.225, 0.225]];
    let first = [[0.0, 0.0], [0.0, 0.85], [2.0, 0.85], [2.0, 0.0], [0.0, 0.0]];
    let line = [[0.425, 0.425], [1.575, 0.425]];
    check_level("2,.85,T,1,4,-.1,1,2", &origin(), &[&first[..], &second, &line].concat());
}

#[test]
fn a_pocket_wide_enough_leaves_no_spikes_to_clear() {
    // 20 % overlap: the round cutter reaches all there is in the corners.
    let context = Context { overlap_percent: 20.0, ..origin() };
    let cut = cr("2,1,T,1,4,-.1,1,2", &context).unwrap();
    // plunge, 3 rectangles, 2 ways in, lift, back, pull-up
    assert_eq!(cut.steps.len(), 1 + 3 * 4 + 2 + 3);
}

/// Rings of radius `first - .225 k` about (0, -first), then the centre if it is asked for.
fn rings(first: f64, count: u32, to_centre: bool, z: &str) -> String {
    let centre = number(-first);
    let mut lines = String::new();
    for k in 0..count {
        let start = number(-0.225 * f64::from(k));
        if k > 0 {
            writeln!(lines, "cut 0 {start} {z}").unwrap();
        }
        writeln!(lines, "cw 360 about 0 {centre} to 0 {start} {z}").unwrap();
    }
    if to_centre {
        writeln!(lines, "cut 0 {centre} {z}").unwrap();
    }
    lines
}

#[test]
fn sbp_cut_cc_pocket() {
    let level = rings(2.0, 9, true, "-0.1");
    check(
        cc("4,T,1,0,360,-.1,1,1,1,2", &origin()),
        &format!("cut 0 0 -0.1\n{level}jog 0 -2 1\njog 0 0 1\ncut 0 0 0"),
    );
}

#[test]
fn sbp_cut_cc_pocket_in() {
    let level = rings(1.875, 9, false, "-0.1");
    check(
        cc("4,I,1,0,360,-.1,1,1,1,2", &origin()),
        &format!("cut 0 0 -0.1\n{level}jog 0 -1.8 1\njog 0 0 1\ncut 0 0 0"),
    );
}

#[test]
fn sbp_cut_cc_pocket_reps() {
    let (high, low) = (rings(2.0, 9, true, "-0.1"), rings(2.0, 9, true, "-0.2"));
    check(
        cc("4,T,1,0,360,-.1,2,1,1,2", &origin()),
        &format!(
            "cut 0 0 -0.1\n{high}jog 0 -2 1\njog 0 0 1\n\
             cut 0 0 -0.2\n{low}jog 0 -2 1\njog 0 0 1\ncut 0 0 0"
        ),
    );
}

#[test]
fn a_pocket_without_plunge_ends_where_it_began() {
    let cut = cc("4,T,1,0,360,0,1,1,1,2", &at(0.0, 0.0, -0.2)).unwrap();
    assert_eq!(cut.steps.last().unwrap().to(), at(0.0, 0.0, -0.2).start);
    let stays = cc("4,T,1,0,360,-.1,1,1,1,2,1", &origin()).unwrap();
    assert_eq!(crate::common::told(&stays).last().unwrap(), "cut 0 0 -0.1");
}

#[test]
fn sbp_cut_cc_pocket_arc() {
    refused(cc("4,T,1,0,90,0,1,1,1,2", &origin()), "pocket needs a full circle");
    assert!(cc("4,T,1,0,90,0,1,1,1,1", &origin()).is_ok());
}

#[test]
fn sbp_cut_cp_features() {
    let cut = cp("4,10,10,I,1,,,-.1,1,1,1,2", &origin()).unwrap();
    assert_eq!(crate::common::told(&cut)[0], "cut 10 11.875 0");
    passes(&origin(), &cut, &[[10.0, 11.875], [11.875, 10.0], [10.0, 10.075]]);
}

#[test]
fn a_pocket_needs_cutter_and_overlap() {
    let pocket = "4,T,1,0,360,-.1,1,1,1,2";
    refused(cc(pocket, &Context { cutter_mm: 0.0, ..origin() }), "needs the cutter diameter");
    for overlap_percent in [100.0, -1.0, f64::NAN] {
        refused(cc(pocket, &Context { overlap_percent, ..origin() }), "overlap");
    }
    refused(cc(pocket, &Context { overlap_percent: 99.999_99, ..origin() }), "moves");
    refused(cr("4,4,,,,-.1,1,2", &Context { overlap_percent: 99.999_99, ..origin() }), "moves");
}
