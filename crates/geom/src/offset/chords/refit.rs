//! From the polygon of a boundary back to exact parallels.
//!
//! Every edge of the polygon lies on the parallel of a segment or on the circle about a corner. Edges in a
//! row on the same curve are one *stretch* of it; where two stretches meet, their curves do.

use super::super::path::{OffsetPath, Origin};
use super::super::scratch::{Buffer, Scratch};
use super::super::source::Source;
use super::super::{raw, rings};
use super::cover::CHORD_MM;
use crate::{BoxTree, Point2, Polyarc, Segment, tol};

/// An edge belongs to a curve that it leaves by no more than this: a chord does by [`CHORD_MM`].
const NEAR_MM: f64 = 2.0 * CHORD_MM;

/// Greatest gap between the polygon's corner and the place where its curves meet, as a share of the distance. Flat
/// crossings lie far from those of the chords.
const REACH: f64 = 0.05;

/// Stretches shorter than this come from rounding.
const SHORT_MM: f64 = 10.0 * tol::SAME_PLACE_MM;

/// Polygons that enclose no more than a strip of this width along themselves come from rounding, too.
const THIN_MM: f64 = 1e-6;

/// All curves that a boundary can lie on, whole.
pub(super) struct Curves {
    list: Vec<(Segment, Origin)>,
    tree: BoxTree,
    reach: f64,
    scratch: Scratch,
}

/// A part of one curve between two corners of the polygon.
#[derive(Clone, Copy)]
struct Stretch {
    /// Number of the curve; nothing where the boundary follows none, as round the end of an open contour.
    curve: Option<usize>,
    from: Point2,
    to: Point2,
}

impl Curves {
    pub fn of(source: &Source, distance: f64) -> Self {
        let mut list = Vec::new();
        for (number, contour) in source.contours.iter().enumerate() {
            let segments: Vec<Segment> = contour.segments().collect();
            let count = segments.len();
            for (n, segment) in segments.iter().enumerate() {
                let origin = |element, corner| Origin { contour: number, element, corner };
                list.extend(raw::parallel(segment, distance).map(|s| (s, origin(n, false))));
                if n + 1 < count || contour.closed {
                    let next = (n + 1) % count;
                    let ways = [segment.direction(1.0), segments[next].direction(0.0)];
                    let corner = raw::corner([segment, &segments[next]], ways, distance);
                    list.extend(corner.map(|s| (s, origin(next, true))));
                }
            }
        }
        let tree = BoxTree::new(list.iter().map(|(s, _)| s.bounds().grown(NEAR_MM)));
        Self { list, tree, reach: REACH * distance.abs(), scratch: Scratch::default() }
    }

    /// The paths along a polygon: a ring, or the pieces beside open contours. Nothing when the polygon
    /// leaves all curves and should not.
    pub fn along(&self, polygon: &[Point2], open: bool) -> Option<Vec<OffsetPath>> {
        let ring = Polyarc::lines(polygon.iter().copied(), true).tidied();
        if ring.signed_area().abs() <= ring.length() * THIN_MM {
            return Some(Vec::new());
        }
        let stretches = self.stretches(&ring);
        if !open {
            if stretches.iter().any(|s| s.curve.is_none()) {
                return None;
            }
            return Some(self.path(&stretches, true).into_iter().collect());
        }
        let runs = stretches.split(|s| s.curve.is_none()).filter(|run| !run.is_empty());
        Some(runs.filter_map(|run| self.path(run, false)).collect())
    }

    /// The stretches of a polygon. The first one begins where a curve does, or where the boundary comes
    /// back to one.
    fn stretches(&self, ring: &Polyarc) -> Vec<Stretch> {
        let mut found: Vec<Stretch> = Vec::new();
        for edge in ring.segments() {
            let curve = self.named(&edge);
            if curve.is_none() && edge.length() <= NEAR_MM {
                continue;
            }
            match found.last_mut() {
                Some(last) if last.curve == curve => last.to = edge.end(),
                _ => found.push(Stretch { curve, from: edge.start(), to: edge.end() }),
            }
        }
        if let [first, .., last] = found.as_mut_slice()
            && first.curve == last.curve
        {
            first.from = last.from;
            found.pop();
        }
        let is_short = |s: &Stretch| s.curve.is_some() && s.from.distance(s.to) <= SHORT_MM;
        if found.len() > 2 {
            found.retain(|s| !is_short(s));
        }
        if let Some(gap) = found.iter().position(|s| s.curve.is_none()) {
            found.rotate_left(gap);
        }
        found
    }

    /// The curve that an edge follows, the one it leaves least.
    fn named(&self, edge: &Segment) -> Option<usize> {
        let (start, middle, end) = (edge.start(), edge.at(0.5), edge.end());
        let along = edge.direction(0.5);
        let mut best = (None, f64::INFINITY);
        self.tree.meeting(&edge.bounds(), |n| {
            let curve = &self.list[n].0;
            let off =
                [start, middle, end].map(|at| curve.distance(at)).into_iter().fold(0.0, f64::max);
            let onward = || curve.direction(curve.nearest(middle).share).dot(along) > 0.0;
            if off <= NEAR_MM && off < best.1 && onward() {
                best = (Some(n), off);
            }
        });
        best.0
    }

    fn path(&self, stretches: &[Stretch], closed: bool) -> Option<OffsetPath> {
        let count = stretches.len();
        if closed && count < 2 {
            return None;
        }
        let meeting = |n: usize| {
            let (before, after) = (&stretches[n], &stretches[(n + 1) % count]);
            self.meeting(before.curve?, after.curve?, before.to)
        };
        let last = if closed { count } else { count - 1 };
        let corners: Vec<Option<Point2>> = (0..last).map(meeting).collect();
        let mut parts = Buffer::new(&self.scratch);
        for (n, stretch) in stretches.iter().enumerate() {
            let (curve, origin) = &self.list[stretch.curve?];
            let before = if n > 0 { Some(n - 1) } else { closed.then_some(count - 1) };
            let from = before
                .map_or_else(|| on(curve, stretch.from), |b| corners[b].unwrap_or(stretch.from));
            let to =
                corners.get(n).map_or_else(|| on(curve, stretch.to), |c| c.unwrap_or(stretch.to));
            parts.push((between(curve, from, to), *origin));
        }
        rings::path(parts, closed)
    }

    /// Finds the place where one curve goes over to another, near a corner of the polygon.
    fn meeting(&self, before: usize, after: usize, near: Point2) -> Option<Point2> {
        let (a, b) = (&self.list[before].0, &self.list[after].0);
        let joint = (a.end().distance(b.start()) <= tol::SAME_PLACE_MM).then(|| a.end());
        let contacts = a.meet(b);
        let places = joint.into_iter().chain(contacts.iter().map(|c| c.at));
        let nearest = places.min_by(|p, q| p.distance(near).total_cmp(&q.distance(near)))?;
        (nearest.distance(near) <= self.reach).then_some(nearest)
    }
}

/// The place of a curve nearest to another one.
fn on(curve: &Segment, place: Point2) -> Point2 {
    curve.nearest(place).at
}

/// The part of a curve between two places on it.
fn between(curve: &Segment, from: Point2, to: Point2) -> Segment {
    match *curve {
        Segment::Line { .. } => Segment::line(from, to),
        Segment::Arc { centre, radius, sweep_rad, .. } => {
            let share = (curve.share_of(to) - curve.share_of(from)).clamp(0.0, 1.0);
            Segment::Arc { start: from, end: to, centre, radius, sweep_rad: sweep_rad * share }
        }
    }
}
