//! Area that a pocket removes: the cutter's disc, swept along the moves at one level, must cover the pocket and must
//! not leave it. Looked at point by point on a grid, in inches.

use crate::common::{cc, cr, legs, nearest, origin};
use kerf_cut::{Context, Cut, Step};
use kerf_program::MoveKind;

const CUTTER: f64 = 0.25;
const GRID: f64 = 0.008;
/// The distance to the boundary that does not count: rounding, and the sag of chords.
const EDGE: f64 = 2e-4;

type Leg = ([f64; 3], Step);

/// The cutting moves at the level of the pocket.
fn at_level(context: &Context, cut: &Cut, z: f64) -> Vec<Leg> {
    let low = |place: [f64; 3]| (place[2] - z).abs() < 1e-9;
    let cuts = |s: &Step| !matches!(s, Step::Line { kind: MoveKind::Jog, .. });
    let mut all = legs(context.start, &cut.steps);
    all.retain(|(from, step)| low(*from) && low(step.to()) && cuts(step));
    all
}

fn is_cleared(legs: &[Leg], p: [f64; 2], reach: f64) -> bool {
    legs.iter().any(|(from, step)| nearest(*from, step, p).0 <= reach)
}

/// `depth` tells how far inside the pocket a place is, negative outside.
#[track_caller]
fn check(context: &Context, cut: &Cut, window: [[f64; 2]; 2], depth: impl Fn([f64; 2]) -> f64) {
    let legs = at_level(context, cut, -0.1);
    assert!(!legs.is_empty());
    let steps = |axis: usize| ((window[1][axis] - window[0][axis]) / GRID).ceil() as i32;
    let (mut inside, mut outside) = (0, 0);
    for (ix, iy) in (0..=steps(0)).flat_map(|ix| (0..=steps(1)).map(move |iy| (ix, iy))) {
        let p = [window[0][0] + f64::from(ix) * GRID, window[0][1] + f64::from(iy) * GRID];
        let depth = depth(p);
        if depth > EDGE {
            inside += 1;
            assert!(is_cleared(&legs, p, CUTTER / 2.0 + 1e-9), "material is left at {p:?}");
        } else if depth < -EDGE {
            outside += 1;
            assert!(!is_cleared(&legs, p, CUTTER / 2.0 - 1e-9), "{p:?} is outside and gone");
        }
    }
    assert!(inside > 1000 && outside > 100, "{inside} {outside}");
}

/// Depth inside a rectangle whose corners the cutter leaves round.
fn rounded(low: [f64; 2], high: [f64; 2]) -> impl Fn([f64; 2]) -> f64 {
    let r = CUTTER / 2.0;
    move |p| {
        let beyond = |axis: usize| (low[axis] + r - p[axis]).max(p[axis] - high[axis] + r);
        let (x, y) = (beyond(0), beyond(1));
        r - if x > 0.0 && y > 0.0 { x.hypot(y) } else { x.max(y) }
    }
}

#[track_caller]
fn check_rectangle(line: &str, low: [f64; 2], high: [f64; 2], overlap_percent: f64) {
    let context = Context { overlap_percent, ..origin() };
    let cut = cr(line, &context).unwrap();
    let window = [low.map(|v| v - 0.05), high.map(|v| v + 0.05)];
    check(&context, &cut, window, rounded(low, high));
}

#[test]
fn rectangles_are_cleared_to_the_corners() {
    let r = CUTTER / 2.0;
    for overlap in [0.0, 10.0, 45.0] {
        check_rectangle("2,1,T,1,4,-.1,1,2", [-r, -r], [2.0 + r, 1.0 + r], overlap);
    }
    check_rectangle("1,1.3,I,-1,2,-.1,1,2", [-1.0 + r, -1.3 + r], [r, r], 10.0);
    check_rectangle("1,1,O,1,3,-.1,1,2", [-1.0 - 3.0 * r, -r], [r, 1.0 + 3.0 * r], 10.0);
}

#[test]
fn cores_are_cleared_by_the_centre_line() {
    let r = CUTTER / 2.0;
    // The last side of the rectangle is between one cutter and nearly two wide.
    for (side, overlap) in [(0.85, 10.0), (0.89, 10.0), (0.72, 10.0), (0.99, 0.0)] {
        check_rectangle(
            &format!("1.4,{side},T,1,4,-.1,1,2"),
            [-r, -r],
            [1.4 + r, side + r],
            overlap,
        );
        check_rectangle(
            &format!("{side},{side},T,-1,4,-.1,1,2"),
            [-r, -r],
            [side + r, side + r],
            overlap,
        );
    }
}

#[track_caller]
fn check_circle(line: &str, radius: f64, centre: [f64; 2]) {
    let cut = cc(line, &origin()).unwrap();
    let window = [centre.map(|v| v - radius - 0.05), centre.map(|v| v + radius + 0.05)];
    check(&origin(), &cut, window, |p| radius - (p[0] - centre[0]).hypot(p[1] - centre[1]));
}

#[test]
fn sbp_cut_cc_pocket__cleared() {
    check_circle("4,T,1,0,360,-.1,1,1,1,2", 2.125, [0.0, -2.0]);
}

#[test]
fn sbp_cut_cc_pocket_in__cleared() {
    check_circle("4,I,1,0,360,-.1,1,1,1,2", 2.0, [0.0, -1.875]);
    check_circle("1,I,-1,90,450,-.1,1,1,1,2", 0.5, [-0.375, 0.0]);
}

#[test]
fn an_elliptic_pocket_is_cleared_and_not_left() {
    let context = origin();
    let cut = cc("1.2,I,1,0,360,-.1,1,2,1,2", &context).unwrap();
    let (a, b) = (1.2, 0.6);
    let top = 0.6 - CUTTER / 2.0;
    // First-order distance from the ellipse; exact enough within the edge.
    let depth = |p: [f64; 2]| {
        let (x, y) = (p[0] / a, (p[1] + top) / b);
        let level = x.hypot(y);
        if level == 0.0 { b } else { (1.0 - level) * level / (x / a).hypot(y / b) }
    };
    check(&context, &cut, [[-1.25, -1.15], [1.25, 0.2]], depth);
}
