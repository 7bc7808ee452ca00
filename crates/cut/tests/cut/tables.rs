//! Worked tables of circles, arches, rectangles and pockets (readings, Circle angles and what follows).
//! Inches and degrees.

use crate::common::{IN, at, ca, cc, cg, cp, cr, legs, origin, passes, refused};
use kerf_cut::{Context, Cut, CutError, Step};
use std::f64::consts::FRAC_PI_2;

/// Half a unit of the fourth decimal that the tables have.
const DECIMALS: f64 = 5.1e-5;

type Line = (&'static str, [f64; 2], f64, f64, [f64; 2], [f64; 2], [f64; 2]);

/// Line, start, begin angle, swept angle, centre, half-way place, end.
const CC: &[Line] = &[
    ("4", [0.0, 0.0], 0.0, 360.0, [0.0, -2.0], [0.0, -4.0], [0.0, 0.0]),
    ("4,T,-1", [0.0, 0.0], 360.0, 360.0, [0.0, -2.0], [0.0, -4.0], [0.0, 0.0]),
    ("4,T,1,0,360", [0.0, 0.0], 0.0, 360.0, [0.0, -2.0], [0.0, -4.0], [0.0, 0.0]),
    ("4,T,-1,0,360", [0.0, 0.0], 0.0, 360.0, [0.0, -2.0], [0.0, -4.0], [0.0, 0.0]),
    ("4,T,1,180,540", [0.0, 0.0], 180.0, 360.0, [0.0, 2.0], [0.0, 4.0], [0.0, 0.0]),
    ("4,T,1,270,630", [0.0, 0.0], 270.0, 360.0, [2.0, 0.0], [4.0, 0.0], [0.0, 0.0]),
    ("4,T,1,90,180", [0.0, 0.0], 90.0, 90.0, [-2.0, 0.0], [-0.5858, -1.4142], [-2.0, -2.0]),
    ("4,T,-1,90,180", [0.0, 0.0], 90.0, 270.0, [-2.0, 0.0], [-3.4142, 1.4142], [-2.0, -2.0]),
    ("4,T,-1,90,-180", [0.0, 0.0], 90.0, 270.0, [-2.0, 0.0], [-3.4142, 1.4142], [-2.0, -2.0]),
    ("4,T,1,,90", [0.0, 0.0], 0.0, 90.0, [0.0, -2.0], [1.4142, -0.5858], [2.0, -2.0]),
    ("4,T,-1,,270", [0.0, 0.0], 360.0, 90.0, [0.0, -2.0], [-1.4142, -0.5858], [-2.0, -2.0]),
    ("4,T,1,90", [0.0, 0.0], 90.0, 360.0, [-2.0, 0.0], [-4.0, 0.0], [0.0, 0.0]),
    ("4,T,-1,90", [0.0, 0.0], 90.0, 360.0, [-2.0, 0.0], [-4.0, 0.0], [0.0, 0.0]),
    ("4,T,1,45,45", [0.0, 0.0], 45.0, 360.0, [-1.4142, -1.4142], [-2.8284, -2.8284], [0.0, 0.0]),
    ("2,T,-1,180,90", [10.0, 0.0], 180.0, 90.0, [10.0, 1.0], [10.7071, 0.2929], [11.0, 1.0]),
    ("4,O", [0.0, 0.0], 0.0, 360.0, [0.0, -2.125], [0.0, -4.25], [0.0, 0.0]),
    ("4,I", [0.0, 0.0], 0.0, 360.0, [0.0, -1.875], [0.0, -3.75], [0.0, 0.0]),
    ("4,O,1,90,180", [0.0, 0.0], 90.0, 90.0, [-2.125, 0.0], [-0.6224, -1.5026], [-2.125, -2.125]),
    ("16,T,1,0,360,0,1,3,1", [0.0, 0.0], 0.0, 360.0, [0.0, -8.0], [0.0, -16.0], [0.0, 0.0]),
    ("16,T,1,270,90,0,1,3,1", [0.0, 0.0], 270.0, 180.0, [24.0, 0.0], [24.0, 8.0], [48.0, 0.0]),
    ("4,T,1,0,90,0,1,-1,1", [0.0, 0.0], 0.0, 90.0, [0.0, -2.0], [-1.4142, -0.5858], [-2.0, -2.0]),
    ("4,T,1,300,60", [0.0, 0.0], 300.0, 120.0, [1.7321, -1.0], [1.7321, 1.0], [3.4641, 0.0]),
];

/// The same for CP; the start is computed, the tool comes from 0, 0.
const CP: &[Line] = &[
    ("4,10,10", [10.0, 12.0], 0.0, 360.0, [10.0, 10.0], [10.0, 8.0], [10.0, 12.0]),
    ("4,10,10,T,-1", [10.0, 12.0], 360.0, 360.0, [10.0, 10.0], [10.0, 8.0], [10.0, 12.0]),
    ("4,10,10,T,1,0,0", [10.0, 12.0], 0.0, 360.0, [10.0, 10.0], [10.0, 8.0], [10.0, 12.0]),
    ("4,10,10,T,1,90,180", [12.0, 10.0], 90.0, 90.0, [10.0, 10.0], [11.4142, 8.5858], [10.0, 8.0]),
    (
        "4,10,10,T,-1,90,180",
        [12.0, 10.0],
        90.0,
        270.0,
        [10.0, 10.0],
        [8.5858, 11.4142],
        [10.0, 8.0],
    ),
    ("4,10,10,O", [10.0, 12.125], 0.0, 360.0, [10.0, 10.0], [10.0, 7.875], [10.0, 12.125]),
    ("4,10,10,I", [10.0, 11.875], 0.0, 360.0, [10.0, 10.0], [10.0, 8.125], [10.0, 11.875]),
    ("16,0,0,T,1,270,90,0,1,3,1", [-24.0, 0.0], 270.0, 180.0, [0.0, 0.0], [0.0, 8.0], [24.0, 0.0]),
];

type ArchLine = (&'static str, f64, f64, [f64; 2], [f64; 2], [f64; 2]);

/// Line, path radius, swept angle, centre, apex, end.
const CA: &[ArchLine] = &[
    ("10,2.5", 6.25, 106.2602, [5.0, -3.75], [5.0, 2.5], [10.0, 0.0]),
    ("10,5", 5.0, 180.0, [5.0, 0.0], [5.0, 5.0], [10.0, 0.0]),
    ("4,3", 2.1667, 225.2397, [2.0, 0.8333], [2.0, 3.0], [4.0, 0.0]),
    ("10,2.5,T,-1", 6.25, 106.2602, [-5.0, -3.75], [-5.0, 2.5], [-10.0, 0.0]),
    ("10,2.5,T,1,90", 6.25, 106.2602, [-3.75, -5.0], [2.5, -5.0], [0.0, -10.0]),
    ("10,2.5,T,1,30", 6.25, 106.2602, [2.4551, -5.7476], [5.5801, -0.3349], [8.6603, -5.0]),
    ("10,2.5,T,1,180", 6.25, 106.2602, [-5.0, 3.75], [-5.0, -2.5], [-10.0, 0.0]),
    ("10,2.5,T,-1,180", 6.25, 106.2602, [5.0, 3.75], [5.0, -2.5], [10.0, 0.0]),
    ("10,2.5,O", 6.375, 106.2602, [5.1, -3.825], [5.1, 2.55], [10.2, 0.0]),
    ("10,2.5,I", 6.125, 106.2602, [4.9, -3.675], [4.9, 2.45], [9.8, 0.0]),
];

#[track_caller]
fn near(what: &str, got: [f64; 2], want: [f64; 2]) {
    let off = (got[0] - want[0]).hypot(got[1] - want[1]);
    assert!(off < 1.5 * DECIMALS, "{what}: {got:?} instead of {want:?}");
}

/// The path of one table line whose shape is an ellipse: chords on it, through the places.
fn check_chords(context: &Context, cut: &Cut, line: &Line) {
    let (text, start, _, _, centre, half_way, end) = *line;
    passes(context, cut, &[start, half_way, end]);
    for (_, step) in legs(context.start, &cut.steps).iter().skip(usize::from(text.contains("0,0")))
    {
        let Step::Line { to, .. } = *step else { panic!("{text}: an ellipse is no arc") };
        // Half axes 24 and 8 in all the ellipses of the tables.
        let level = ((to[0] - centre[0]) / 24.0).hypot((to[1] - centre[1]) / 8.0);
        assert!((level - 1.0).abs() < 1e-9, "{text}: {to:?} is beside the ellipse");
    }
}

/// The last step of one table line is the arc that the line tells of.
fn check_arc(context: &Context, cut: &Cut, line: &Line) {
    let (text, start, _, swept, centre, half_way, end) = *line;
    let legs = legs(context.start, &cut.steps);
    let (from, Step::Arc { centre: c, sweep_rad, to, .. }) = legs[legs.len() - 1] else {
        panic!("{text}: no arc")
    };
    near(text, [from[0], from[1]], start);
    near(text, c, centre);
    near(text, [to[0], to[1]], end);
    assert!((sweep_rad.abs().to_degrees() - swept).abs() < DECIMALS, "{text}: {sweep_rad}");
    let arm = [from[0] - c[0], from[1] - c[1]];
    let (sin, cos) = (sweep_rad / 2.0).sin_cos();
    let middle = [c[0] + arm[0] * cos - arm[1] * sin, c[1] + arm[0] * sin + arm[1] * cos];
    near(text, middle, half_way);
    let counter = (text.contains("-1") && !text.contains("-1,1")) != text.contains("-1,1");
    assert_eq!(sweep_rad > 0.0, counter, "{text}: goes round the wrong way");
}

fn check_line(context: &Context, cut: &Cut, line: &Line) {
    if line.0.contains("3,1") {
        check_chords(context, cut, line)
    } else {
        check_arc(context, cut, line)
    }
}

#[test]
fn worked_cc_table() {
    for line in CC {
        let context = at(line.1[0], line.1[1], 0.0);
        let cut = cc(line.0, &context).unwrap();
        assert!(line.0.contains("3,1") || cut.steps.len() == 1, "{}: Z must not move", line.0);
        check_line(&context, &cut, line);
        // Heading of a round path: B + dir·s + 90·dir.
        let dir = if line.0.contains("T,-1") { -1.0 } else { 1.0 };
        let heading = (line.2 + dir * (line.3 + 90.0)).rem_euclid(360.0);
        let mirrored = line.0.ends_with("-1,1");
        let heading = if mirrored { 360.0 - heading } else { heading };
        let off = (cut.heading_deg - heading + 180.0).rem_euclid(360.0) - 180.0;
        assert!(off.abs() < 1e-9, "{}: heading {}", line.0, cut.heading_deg);
    }
}

#[test]
fn worked_cp_table() {
    for line in CP {
        let cut = cp(line.0, &origin()).unwrap();
        check_line(&origin(), &cut, line);
        let first = cut.steps[0].to().map(|v| v / IN);
        near(line.0, [first[0], first[1]], line.1);
    }
}

#[test]
fn worked_ca_table() {
    for (text, radius, swept, centre, apex, end) in CA {
        let cut = ca(text, &origin()).unwrap();
        check_arc(&origin(), &cut, &(text, [0.0, 0.0], 0.0, *swept, *centre, *apex, *end));
        assert!((centre[0].hypot(centre[1]) - radius).abs() < 1.5 * DECIMALS, "{text}");
    }
}

#[test]
fn worked_cg_lines() {
    let arc = |text: &str, swept: f64, centre, half_way, end| {
        let line = ("", [0.0, 0.0], 0.0, swept, centre, half_way, end);
        let cut = cg(text, &origin()).unwrap();
        let Step::Arc { sweep_rad, .. } = cut.steps[0] else { panic!("{text}") };
        assert_eq!(sweep_rad > 0.0, text.contains("-1"), "{text}");
        let turned = Cut { steps: vec![clockwise(cut.steps[0])], ..cut };
        let line = if sweep_rad > 0.0 { mirrored(line) } else { line };
        check_arc(&origin(), &turned, &line);
    };
    arc(",2,-2,0,-2,T,1", 90.0, [0.0, -2.0], [1.4142, -0.5858], [2.0, -2.0]);
    arc(",2,-2,0,-2,T,-1", 270.0, [0.0, -2.0], [-1.4142, -3.4142], [2.0, -2.0]);
    arc(",,,0,-2", 360.0, [0.0, -2.0], [0.0, -4.0], [0.0, 0.0]);
    arc("4,2,-2,,,T,1", 90.0, [0.0, -2.0], [1.4142, -0.5858], [2.0, -2.0]);
    arc("4,2,-2,,,T,-1", 90.0, [2.0, 0.0], [0.5858, -1.4142], [2.0, -2.0]);
    arc(",2,-2,0,-2,O,1", 90.0, [0.0, -2.125], [1.5026, -0.6224], [2.125, -2.125]);
    passes(&origin(), &cg(",2,-2,0,-2,T,-1", &origin()).unwrap(), &[[-2.0, -2.0], [0.0, -4.0]]);
}

/// A counter-clockwise arc seen in the mirror of the Y axis, so that one check serves both.
fn clockwise(step: Step) -> Step {
    match step {
        Step::Arc { centre: [x, y], sweep_rad, to, chords, small } if sweep_rad > 0.0 => {
            Step::Arc {
                centre: [-x, y],
                sweep_rad: -sweep_rad,
                to: [-to[0], to[1], to[2]],
                chords,
                small,
            }
        }
        step => step,
    }
}

fn mirrored(line: Line) -> Line {
    let flip = |[x, y]: [f64; 2]| [-x, y];
    (line.0, flip(line.1), line.2, line.3, flip(line.4), flip(line.5), flip(line.6))
}

#[test]
fn worked_rectangles() {
    for (text, corners) in [
        ("10,5", [[0, 5], [10, 5], [10, 0], [0, 0]]),
        ("10,5,T,1,3", [[-10, 0], [-10, 5], [0, 5], [0, 0]]),
        ("10,5,T,-1,4", [[10, 0], [10, 5], [0, 5], [0, 0]]),
    ] {
        let cut = cr(text, &origin()).unwrap();
        let got: Vec<_> = cut.steps.iter().map(|s| [s.to()[0] / IN, s.to()[1] / IN]).collect();
        let want: Vec<_> = corners.iter().map(|c| c.map(f64::from)).collect();
        assert_eq!(got.len(), 4, "{text}");
        got.iter().zip(want).for_each(|(g, w)| near(text, *g, w));
    }
}

#[test]
fn sbp_cut_cc_prop_comp() {
    let bounds = |text| {
        let cut = cc(text, &origin()).unwrap();
        let all = || cut.steps.iter().map(Step::to);
        [0, 1].map(|axis| {
            let high = all().map(|p| p[axis]).fold(f64::MIN, f64::max);
            let low = all().map(|p| p[axis]).fold(f64::MAX, f64::min);
            (high - low) / IN
        })
    };
    near("O", bounds("16,O,1,0,360,0,1,3,1"), [48.25, 16.25]);
    near("I", bounds("16,I,1,0,360,0,1,3,1"), [47.75, 15.75]);
    near("T", bounds("16,T,1,0,360,0,1,3,1"), [48.0, 16.0]);
    // Smallest radius of curvature .5·.5/2 = .125 is just enough, less is not.
    assert!(cc("1,I,1,0,360,0,1,4,1", &origin()).is_ok());
    refused(cc("1,I,1,0,360,0,1,4.01,1", &origin()), "cutter larger than hole");
}

#[test]
fn worked_arch_equals_its_circle() {
    let arch = ca("10,2.5", &origin()).unwrap();
    let circle = cc("12.5,T,1,306.8699,53.1301", &origin()).unwrap();
    let (
        Step::Arc { centre: a, sweep_rad: s, to: p, .. },
        Step::Arc { centre: b, sweep_rad: t, to: q, .. },
    ) = (arch.steps[0], circle.steps[0])
    else {
        panic!("two arcs")
    };
    near("centre", a, b);
    near("end", [p[0], p[1]], [q[0], q[1]]);
    assert!((s - t).abs() < 1e-5 && s < -FRAC_PI_2);
}

#[test]
fn worked_arch_beside_the_line() {
    // L' = 2R'·sin(θ/2), H' = R'(1 − cos(θ/2)) with R' = 6.375.
    let cut = ca("10,2.5,O", &origin()).unwrap();
    let half = 106.260_204_7_f64.to_radians() / 2.0;
    let end = cut.steps[0].to().map(|v| v / IN);
    near("span", [end[0], end[1]], [2.0 * 6.375 * half.sin(), 0.0]);
    passes(&origin(), &cut, &[[5.1, 6.375 * (1.0 - half.cos())]]);
}

#[test]
fn a_path_without_radius_is_refused() {
    assert!(matches!(cc("0.25,I", &origin()), Err(CutError::CutterLargerThanHole { .. })));
}
