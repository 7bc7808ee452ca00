//! Rows of the Profiler ledger about what a tool leaves of a sheet.

#![allow(clippy::unwrap_used, missing_docs)]

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

/// Whether what a tool of that radius leaves at a place hangs together with the sheet's edge, seen on a
/// grid of a millimetre over −50 … 200 in both directions.
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
