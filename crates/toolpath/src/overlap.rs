//! Finds cuts of one part that take from another.

use crate::gouge::Contours;
use crate::shape_paths::{Pass, ShapePath};
use crate::warning::Warning;
use kerf_drawing::{CutDepth, Drawing, Kind, crosses};
use kerf_geom::{BoxTree, Polyarc, Segment};
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

/// Warns of closed shapes that cross each other, both of them cut, and of open ones that are cut across a part as
/// deep as it is. What is drawn again is told as that, and looked at once: a heap of copies has pairs without
/// number.
pub(crate) fn crossing(
    drawing: &Drawing,
    twins: &[Option<usize>],
    given_up: &dyn Fn() -> bool,
    warnings: &mut Vec<Warning>,
) {
    let part = |n: &usize| {
        let shape = &drawing.shapes[*n];
        let settings = drawing.settings(shape.group);
        let is_path =
            shape.is_closed() || shape.kind() == Kind::Polyarc && settings.offset_mm == 0.0;
        twins[*n].is_none() && is_path && settings.on && !settings.traversal
    };
    let parts: Vec<usize> = (0..drawing.shapes.len()).filter(part).collect();
    let boxes: Vec<_> = parts.iter().map(|n| drawing.shapes[*n].path.bounds()).collect();
    let parts: Vec<usize> = BoxTree::order(&boxes).into_iter().map(|place| parts[place]).collect();
    let path = |n: usize| &drawing.shapes[parts[n]].path;
    let paths: Vec<&Polyarc> = (0..parts.len()).map(path).collect();
    let (across, is_all) = pairs_across(&paths, given_up);
    let number = |(a, b): (usize, usize)| (parts[a].min(parts[b]) + 1, parts[a].max(parts[b]) + 1);
    let mut crossed: Vec<_> = across.into_iter().map(number).collect();
    crossed.sort_unstable();
    let more = crossed.first().filter(|_| !is_all).map(|(a, _)| {
        let text =
            "so many shapes cross each other that not all of it was looked for: take copies out";
        Warning::new(*a, text)
    });
    let told = |(a, b)| told_across(drawing, a, b);
    warnings.extend(crossed.into_iter().filter_map(told).chain(more));
}

/// The warning of two shapes that cross, by their numbers; none where an open one is only a groove in a part.
fn told_across(drawing: &Drawing, a: usize, b: usize) -> Option<Warning> {
    let shape = |number: usize| &drawing.shapes[number - 1];
    if shape(a).is_closed() && shape(b).is_closed() {
        return Some(Warning::new(a, format!("it crosses shape {b}: the parts overlap")));
    }
    let (open, part) = if shape(a).is_closed() { (b, a) } else { (a, b) };
    let height = |number: usize| drawing.settings(shape(number).group).height;
    let as_deep = height(open) == CutDepth::Thru || height(open) == height(part);
    let text = format!("it is open and is cut across shape {part}: move it, or cut it less deep");
    as_deep.then(|| Warning::new(open, text))
}

/// Returns `true` if two paths cross; of two open ones nothing is a part.
fn are_across(a: &Polyarc, b: &Polyarc) -> bool {
    match (a.closed, b.closed) {
        (true, _) => crosses(a, b),
        (false, true) => crosses(b, a),
        (false, false) => false,
    }
}

/// Crossings that are looked for: copies thrown on each other cross each with each.
const MOST_CROSSED: usize = 1000;

/// Pairs of paths that come near to each other and are looked at: shapes that touch.
const MOST_NEAR: usize = 200_000;

/// Paths that come no nearer to each other than this do not cross, millimetres: well above what the crossing of
/// two segments is found by.
const NEAR_MM: f64 = 1e-3;

/// Arcs are looked at in pieces of so much, radians: the boxes of half circles within each other all meet.
const PIECE_RAD: f64 = std::f64::consts::PI / 16.0;

/// Pairs of paths, the lower number first, that cross each other; and whether these are all. The boxes of the paths
/// say little: those of a thousand frames within each other are half a million pairs, of which none is near.
fn pairs_across(paths: &[&Polyarc], given_up: &dyn Fn() -> bool) -> (Vec<(usize, usize)>, bool) {
    let of = |(n, path): (usize, &&Polyarc)| -> Vec<(usize, Segment)> {
        // What is given up is looked for no further: its outcome is thrown away.
        if given_up() {
            return Vec::new();
        }
        path.segments().flat_map(pieces).map(|piece| (n, piece)).collect()
    };
    let pieces: Vec<(usize, Segment)> = paths.iter().enumerate().flat_map(of).collect();
    let boxes: Vec<_> = pieces.iter().map(|(_, piece)| piece.bounds().grown(NEAR_MM)).collect();
    if given_up() {
        return (Vec::new(), true);
    }
    let order = BoxTree::order(&boxes);
    let tree = BoxTree::new(order.iter().map(|place| boxes[*place]));
    let (mut near, mut across) = (BTreeSet::new(), Vec::new());
    let is_all = tree.own_pairs_while(|a, b| {
        let ((one, first), (other, second)) = (pieces[order[a]], pieces[order[b]]);
        let pair = (one.min(other), one.max(other));
        let is_near =
            one != other && !near.contains(&pair) && first.distance_to(&second) <= NEAR_MM;
        if is_near && near.insert(pair) && are_across(paths[pair.0], paths[pair.1]) {
            across.push(pair);
        }
        across.len() < MOST_CROSSED && near.len() < MOST_NEAR && !given_up()
    });
    (across, is_all)
}

fn pieces(segment: Segment) -> impl Iterator<Item = Segment> {
    let turn_rad = segment.arc().map_or(0.0, |arc| arc.sweep_rad.abs());
    let count = (turn_rad / PIECE_RAD).ceil().max(1.0) as u32;
    let share = move |n: u32| f64::from(n) / f64::from(count);
    (0..count).map(move |n| segment.part(share(n), share(n + 1)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_geom::Point2;

    fn check(within: impl Fn(f64) -> Polyarc, across: &Polyarc) {
        let all: Vec<Polyarc> = (1..200).map(|n| within(f64::from(n))).collect();
        let mut paths: Vec<&Polyarc> = all.iter().collect();
        assert_eq!(pairs_across(&paths, &|| false), (Vec::new(), true));
        paths.push(across);
        let (pairs, is_all) = pairs_across(&paths, &|| false);
        assert!(is_all && !pairs.is_empty() && pairs.iter().all(|(_, b)| *b == 199), "{pairs:?}");
    }

    #[test]
    fn frames_and_rings_within_each_other_do_not_cross() {
        let frame =
            |by: f64| Polyarc::rounded_rectangle(Point2::new(-by, -by), Point2::new(by, by), 0.5);
        let ring = |radius: f64| Polyarc::circle(Point2::default(), radius);
        let across = Polyarc::circle(Point2::new(3.0, 0.0), 7.2);
        check(frame, &across);
        check(ring, &across);
    }

    /// Five thousand circles thrown on each other were twelve million warnings.
    #[test]
    fn copies_that_cross_each_with_each_are_not_all_looked_for() {
        let ring = |n: u32| Polyarc::circle(Point2::new(f64::from(n) * 1e-2, 0.0), 5.0);
        let all: Vec<Polyarc> = (0..300).map(ring).collect();
        let paths: Vec<&Polyarc> = all.iter().collect();
        let (pairs, is_all) = pairs_across(&paths, &|| false);
        assert_eq!((pairs.len(), is_all), (MOST_CROSSED, false));
    }
}
