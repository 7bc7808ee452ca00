//! Whether the cut of one part takes from another.

use crate::gouge::Contours;
use crate::shape_paths::{Pass, ShapePath};
use crate::warning::Warning;
use kerf_drawing::{Drawing, crosses};
use kerf_geom::BoxTree;
use std::collections::BTreeSet;

/// Warns of shapes into which the tool cuts on its way round another one: they lie nearer to each other
/// than it is wide. The offset is the tool's radius.
pub(crate) fn check(
    number: usize,
    paths: &[ShapePath],
    contours: &Contours,
    twins: &[Option<usize>],
    warnings: &mut Vec<Warning>,
) {
    let of = |shape: usize| twins[shape].unwrap_or(shape);
    let mut hit = BTreeSet::new();
    for path in paths.iter().filter(|path| path.pass == Pass::Final && path.offset_mm != 0.0) {
        let lead = |name| {
            let found = path.leads.iter().find(|(lead, _)| *lead == name);
            found.map_or(0, |(_, lead)| lead.segment_count())
        };
        let (first, last) = (lead("lead-in"), lead("lead-out"));
        let count = path.path.segment_count() - last.min(path.path.segment_count());
        for segment in path.path.segments().take(count).skip(first) {
            // Not itself; and what is drawn twice is told as that.
            let other = |shape| of(shape) != of(number - 1);
            contours.nearer_of(&segment, path.offset_mm.abs(), other, |shape| {
                hit.insert(shape);
            });
        }
    }
    for shape in hit {
        let text = format!(
            "its cut takes from shape {}: they lie nearer than the tool is wide; move them apart or take \
             a smaller tool",
            shape + 1
        );
        warnings.push(Warning::new(number, text));
    }
}

/// Warns of closed shapes that cross each other, both of them cut. What is drawn again is told as
/// that, and looked at once: a heap of copies has pairs without number.
pub(crate) fn crossing(drawing: &Drawing, twins: &[Option<usize>], warnings: &mut Vec<Warning>) {
    let part = |n: &usize| {
        let shape = &drawing.shapes[*n];
        let settings = drawing.settings(shape.group);
        twins[*n].is_none() && shape.is_closed() && settings.on && !settings.traversal
    };
    let parts: Vec<usize> = (0..drawing.shapes.len()).filter(part).collect();
    let boxes: Vec<_> = parts.iter().map(|n| drawing.shapes[*n].path.bounds()).collect();
    let parts: Vec<usize> = BoxTree::order(&boxes).into_iter().map(|place| parts[place]).collect();
    let path = |n: usize| &drawing.shapes[parts[n]].path;
    let tree = BoxTree::new((0..parts.len()).map(|n| path(n).bounds()));
    let mut crossed = Vec::new();
    tree.own_pairs(|a, b| {
        if crosses(path(a), path(b)) {
            let (a, b) = (parts[a], parts[b]);
            crossed.push((a.min(b) + 1, a.max(b) + 1));
        }
    });
    crossed.sort_unstable();
    let told = |(a, b)| Warning::new(a, format!("it crosses shape {b}: the parts overlap"));
    warnings.extend(crossed.into_iter().map(told));
}
