//! Finds copies of a block in arrays that cut into each other.
//!
//! Copies lie on a grid, so that it is enough to look at one block and at the few steps that lead to another
//! one so near that they may meet:
//!
//! ```text
//!   ┌────┐ ┌────┐      steps in x: one column, two … while the blocks are near; and from the last column of
//!   │  ●─┼─┼──► │                  one job to the first of the next
//!   └──┼─┘ └────┘      steps in y: the same with rows; each in x goes with each in y, upwards or downwards
//!      ▼
//! ```

use crate::gouge::Contours;
use crate::job::CutPath;
use crate::shape_paths::Pass;
use crate::warning::Warning;
use kerf_drawing::{ArrayLevel, Arrays, Drawing};
use kerf_geom::{Bounds2, Transform2, Vec2};
use kerf_program::rounded;
use std::collections::BTreeMap;

/// The most steps looked at in one direction: blocks that overlap so often are told long before.
const MOST_STEPS: usize = 4;

/// Steps that differ by less are one, millimetres.
const SAME_STEP_MM: f64 = 1e-9;

/// Warns of shapes that are cut into when their neighbours in an array are cut.
pub(crate) fn check(
    drawing: &Drawing,
    block: &[CutPath],
    contours: &Contours,
    given_up: &dyn Fn() -> bool,
    warnings: &mut Vec<Warning>,
) {
    let Some(bounds) = drawing.bounds() else { return };
    let mut reached = bounds;
    block.iter().for_each(|path| reached.merge(&reach(drawing, path)));
    let near = reached.size();
    let mut hit = BTreeMap::new();
    for step in steps(&drawing.arrays, bounds.size(), near) {
        for path in block.iter().filter(|path| path.pass != Pass::Traversal) {
            if given_up() {
                return;
            }
            for by in [-step, step] {
                let radius = drawing.settings(path.shape.group).offset_mm.abs();
                let to = Transform2::moved(by);
                if !moved_bounds(&reach(drawing, path), by).meets(&bounds) {
                    continue;
                }
                contours.touched(&path.shape.mapped(&to).path, radius, |shape| {
                    hit.entry((path.from, shape)).or_insert(-by);
                });
            }
        }
    }
    warnings.extend(hit.into_iter().map(|((from, shape), by)| told(from, shape, by)));
}

/// Returns the places of the blocks that something may reach that leaves its block by no more than so much, this one
/// first.
pub(crate) fn blocks(drawing: &Drawing, reach_mm: f64) -> Vec<Vec2> {
    let size = drawing.bounds().map_or(Vec2::default(), |bounds| bounds.size());
    let near = size + Vec2::new(reach_mm, reach_mm);
    let both = steps(&drawing.arrays, size, near).into_iter().flat_map(|step| [step, -step]);
    [Vec2::default()].into_iter().chain(both).collect()
}

fn told(from: usize, shape: usize, by: Vec2) -> Warning {
    let text = format!(
        "in the array its cut takes from shape {}{}: make the gap larger",
        shape + 1,
        away(by)
    );
    Warning::new(from, text)
}

/// The words for a block; none for this one.
pub(crate) fn away(by: Vec2) -> String {
    if by == Vec2::default() {
        return String::new();
    }
    let [x, y] = [by.x, by.y].map(|value| rounded(value, 3));
    format!(" of the block {x},{y} away")
}

/// Returns a box that holds all that a path takes away.
fn reach(drawing: &Drawing, path: &CutPath) -> Bounds2 {
    path.shape.path.bounds().grown(drawing.settings(path.shape.group).offset_mm.abs())
}

fn moved_bounds(bounds: &Bounds2, by: Vec2) -> Bounds2 {
    Bounds2::of(bounds.min + by, bounds.max + by)
}

/// The steps from a copy of the block to others that come so near; of two opposite ones only one.
fn steps(arrays: &Arrays, block: Vec2, near: Vec2) -> Vec<Vec2> {
    let (inner, outer) = (arrays.block, arrays.job);
    let (pitch, job_pitch) = (inner.pitch(block), outer.pitch(inner.size(block)));
    let columns = |level: ArrayLevel| level.columns;
    let rows = |level: ArrayLevel| level.rows;
    let across = along([columns(inner), columns(outer)], [pitch.x, job_pitch.x], near.x);
    let up = along([rows(inner), rows(outer)], [pitch.y, job_pitch.y], near.y);
    let pairs = across.iter().flat_map(|x| up.iter().map(move |y| (*x, *y)));
    let signs = |(x, y): (f64, f64)| {
        let both = if x > 0.0 && y > 0.0 { vec![1.0, -1.0] } else { vec![1.0] };
        both.into_iter().map(move |sign| Vec2::new(x, sign * y))
    };
    pairs.filter(|(x, y)| *x > 0.0 || *y > 0.0).flat_map(signs).collect()
}

/// Distances from 0 upwards along one axis between copies that come nearer than `near`: `counts` and `pitches`
/// are those of the block and of the job.
fn along(counts: [u32; 2], pitches: [f64; 2], near: f64) -> Vec<f64> {
    let [pitch, job_pitch] = pitches;
    let last = counts[0].saturating_sub(1);
    let within = (0..=last).map(|n| f64::from(n) * pitch).take_while(|by| *by < near);
    let mut found: Vec<f64> = within.take(MOST_STEPS).collect();
    if counts[1] > 1 {
        let to_next = (0..=last).rev().map(|n| job_pitch - f64::from(n) * pitch);
        found.extend(to_next.take_while(|by| *by < near).filter(|by| *by >= 0.0).take(MOST_STEPS));
    }
    found.sort_by(f64::total_cmp);
    found.dedup_by(|b, a| *b - *a < SAME_STEP_MM);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_lead_to_the_blocks_beside_one_and_to_the_next_job() {
        assert_eq!(along([3, 1], [110.0, 500.0], 106.0), [0.0]);
        assert_eq!(along([3, 1], [102.0, 500.0], 106.0), [0.0, 102.0]);
        // The last column of a job is 101 mm from the first of the next.
        assert_eq!(along([3, 2], [110.0, 321.0], 106.0), [0.0, 101.0]);
        assert_eq!(along([100, 1], [10.0, 0.0], 106.0), [0.0, 10.0, 20.0, 30.0]);
        let arrays = Arrays {
            block: ArrayLevel { rows: 2, columns: 2, ..ArrayLevel::default() },
            ..Arrays::default()
        };
        let size = Vec2::new(10.0, 20.0);
        let found = steps(&arrays, size, Vec2::new(12.0, 22.0));
        let expected = [(0.0, 20.0), (10.0, 0.0), (10.0, 20.0), (10.0, -20.0)];
        assert_eq!(found, expected.map(|(x, y)| Vec2::new(x, y)));
    }
}
