//! Rows of the Profiler ledger about what a tool leaves of a sheet.

use kerf_drawing::{Editor, script};
use kerf_geom::{Indexed, Point2, Polyarc, offset};
use kerf_toolpath::job;

/// The paths of a drawing, in cutting order.
fn paths(text: &str) -> Vec<Polyarc> {
    let mut editor = Editor::default();
    for (_, operation) in script(text).unwrap() {
        editor.apply(&operation).unwrap();
    }
    let (job, _) = job(&editor.drawing).unwrap();
    job.paths.iter().map(|path| path.shape.path.clone()).collect()
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() < 1e-3, "{value} is not {expected}");
}

/// Tells whether the material that a tool of that radius leaves at a place hangs together with the sheet's edge, seen
/// on a grid of a millimetre over −50 … 200 in both directions.
fn hangs_on(paths: &[Polyarc], radius: f64, at: (i32, i32)) -> bool {
    let cuts = Indexed::new(paths);
    let cut = |(x, y): (i32, i32)| cuts.is_nearer(Point2::new(f64::from(x), f64::from(y)), radius);
    let mut seen = std::collections::BTreeSet::new();
    let mut open = vec![at];
    while let Some((x, y)) = open.pop() {
        if x <= -50 || y <= -50 || x >= 200 || y >= 200 {
            return true;
        }
        if !cut((x, y)) && seen.insert((x, y)) {
            open.extend([(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)]);
        }
    }
    false
}

#[test]
fn pro_toolpath_offset_radius() {
    let found = paths("line 0,0 100,0 100,100 0,100 close; set black offset=5");
    let part = offset(&found[0], -5.0).unwrap();
    assert_eq!(part.len(), 1);
    let bounds = part[0].path.bounds();
    near(bounds.min.x, 0.0);
    near(bounds.max.y, 100.0);
    near(part[0].path.signed_area(), 10_000.0);
    assert!(!hangs_on(&found, 5.0, (50, 50)));
}

/// A path that goes round two squares and crosses itself behind each.
const TWO_LOOPS: &str = "line -20,0 50,0 50,50 0,50 0,-40 80,-40 80,0 150,0 150,50 100,50 100,-40; \
                         set black offset=5";

#[test]
fn pro_toolpath_selfloop_multi() {
    let found = paths(TWO_LOOPS);
    assert_eq!(found.len(), 1);
    assert!(!hangs_on(&found, 5.0, (25, 25)) && !hangs_on(&found, 5.0, (125, 25)));
    assert!(hangs_on(&found, 5.0, (180, 180)));
    // Their inner corners are where they were drawn: 5 mm from the path.
    let cuts = Indexed::new(&found);
    near(cuts.nearest(Point2::new(50.0, 50.0)).unwrap().1.distance, 5.0);
    near(cuts.nearest(Point2::new(150.0, 25.0)).unwrap().1.distance, 5.0);
}

#[test]
fn pro_edit_break_tags() {
    let square = "line 0,0 100,0 100,100 0,100 close; break 1 50,0; break 1 100,50; break 2 50,100; \
                  break 3 0,50; set black tag=3";
    let found = paths(square);
    let lengths: Vec<f64> = found.iter().map(Polyarc::length).collect();
    assert_eq!(lengths.len(), 4);
    lengths.iter().for_each(|length| near(*length, 97.0));
    let gap = |n: usize| {
        let end = found[n].end().unwrap();
        found[(n + 1) % 4].start().unwrap().distance(end)
    };
    (0..4).for_each(|n| near(gap(n), 3.0));
}

/// A polygon as a clause.
fn polygon(sides: u32, radius: f64) -> String {
    let place = |k: u32| {
        let turn = std::f64::consts::TAU * f64::from(k) / f64::from(sides);
        format!("{},{}", radius * turn.cos(), radius * turn.sin())
    };
    let places: Vec<String> = (0..sides).map(place).collect();
    format!("line {} close", places.join(" "))
}

/// The largest corner of a closed path, degrees.
fn sharpest(path: &Polyarc) -> f64 {
    let count = path.segment_count();
    let turn = |k: usize| {
        let (a, b) = (path.segment(k).direction(1.0), path.segment((k + 1) % count).direction(0.0));
        a.cross(b).atan2(a.dot(b)).abs().to_degrees()
    };
    (0..count).map(turn).fold(0.0, f64::max)
}

fn with_smoothing(factor: f64) -> Polyarc {
    let mut editor = Editor::default();
    for (_, operation) in script(&format!("{}; set black offset=5", polygon(72, 50.0))).unwrap() {
        editor.apply(&operation).unwrap();
    }
    let (job, warnings) = kerf_toolpath::smoothed_job(&editor.drawing, factor).unwrap();
    assert_eq!(warnings, []);
    job.paths[0].shape.path.clone()
}

#[test]
fn pro_toolpath_smoothed_base() {
    let smooth = with_smoothing(0.6);
    for k in 0..720 {
        let at = smooth.place_after(smooth.length() * f64::from(k) / 720.0).unwrap().at;
        assert!((at.distance(Point2::default()) - 55.0).abs() <= 0.06, "{at:?}");
    }
    assert!(sharpest(&smooth) < 1.0);
    let plain = with_smoothing(0.0);
    let arcs = plain.segments().filter(|segment| segment.arc().is_some()).count();
    assert_eq!((plain.segment_count(), arcs), (144, 72));
}
