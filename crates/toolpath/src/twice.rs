//! Shapes that are drawn twice: they would be cut twice.

use crate::warning::Warning;
use kerf_drawing::{Drawing, Group, Shape};
use std::collections::BTreeMap;

/// Places in units of this are one, millimetres: far below what a cutter shows.
const UNIT_MM: f64 = 1e-3;

/// Number of shapes that are told one by one.
const MOST_TOLD: usize = 20;

/// A place of the drawing, in units.
type Spot = [i64; 3];

/// Course of a shape, whichever way round and from wherever: its segments in order.
type Way = Vec<(Spot, Spot, i64)>;

/// For each shape that has been drawn before, in the same group, the first one that is alike.
pub(crate) fn twins(drawing: &Drawing) -> Vec<Option<usize>> {
    let mut seen: BTreeMap<(Group, Way), usize> = BTreeMap::new();
    let shapes = drawing.shapes.iter().enumerate();
    shapes
        .map(|(n, shape)| {
            if !drawing.settings(shape.group).on {
                return None;
            }
            let first = *seen.entry((shape.group, way(shape))).or_insert(n);
            (first < n).then_some(first)
        })
        .collect()
}

fn way(shape: &Shape) -> Way {
    let count = shape.path.vertices.len();
    let unit = |value: f64| (value / UNIT_MM).round() as i64;
    let spot = |n: usize| {
        let at = shape.path.vertices[n % count].at;
        [unit(at.x), unit(at.y), unit(shape.height_mm(n % count))]
    };
    if count == 1 {
        return vec![(spot(0), spot(0), 0)];
    }
    let mut way: Way = (0..shape.path.segment_count())
        .map(|n| {
            // A bulge is a number about 1: thousandths are fine enough.
            let (from, to, bulge) = (spot(n), spot(n + 1), unit(shape.path.vertices[n].bulge));
            if from <= to { (from, to, bulge) } else { (to, from, -bulge) }
        })
        .collect();
    way.sort_unstable();
    way
}

/// Warns of shapes that are drawn twice.
pub(crate) fn warn(twins: &[Option<usize>], warnings: &mut Vec<Warning>) {
    let mut twice = twins.iter().enumerate().filter_map(|(n, twin)| Some((n, (*twin)?)));
    warnings.extend(twice.by_ref().take(MOST_TOLD).map(|(n, first)| {
        let text = format!("it is drawn twice, as shape {} is: erase one of them", first + 1);
        Warning::new(n + 1, text)
    }));
    if let Some((n, _)) = twice.next() {
        let text = format!("it and {} more are drawn twice", twice.count());
        warnings.push(Warning::new(n + 1, text));
    }
}
