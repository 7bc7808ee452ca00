//! Loose ends joined into longer shapes.

use crate::{Point2, Polyarc, Segment};
use std::collections::BTreeMap;

/// Treatment of two ends that are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// Both stay, with a line between them where they differ.
    Keep,
    /// The end of the shape before moves to the start of the one after. An arc that loses its end is
    /// made anew through its far end, its old middle and the new end.
    Merge,
}

/// A shape made of others.
#[derive(Clone, Debug, PartialEq)]
pub struct Joined {
    /// The shape.
    pub path: Polyarc,
    /// Numbers of the shapes it is made of, in the order of travel.
    pub members: Vec<usize>,
}

/// Joins open shapes whose ends lie within a distance: the nearest pair first, of equally near ones the
/// first in sequence. A shape takes the direction of its first member; one whose two ends meet is
/// closed. Closed shapes and points come back as they are.
///
/// The result is ordered by the first member of each shape.
pub fn join(paths: &[Polyarc], distance: f64, ends: Ends) -> Vec<Joined> {
    let loose: Vec<End> = loose_ends(paths);
    let partner = partners(paths, &loose, distance);
    let mut seen = vec![false; paths.len()];
    let mut joined = Vec::new();
    for first in 0..paths.len() {
        if !seen[first] {
            joined.push(Chain::from(first, &partner, &mut seen).joined(paths, ends));
        }
    }
    joined
}

/// An end of an open shape: its start (0) or its end (1).
#[derive(Clone, Copy, Debug, PartialEq)]
struct End {
    shape: usize,
    side: usize,
    at: Point2,
}

fn loose_ends(paths: &[Polyarc]) -> Vec<End> {
    let open = paths.iter().enumerate().filter(|(_, p)| !p.closed && p.segment_count() > 0);
    let both = |(shape, p): (usize, &Polyarc)| {
        let end = |side, at: Option<Point2>| at.map(|at| End { shape, side, at });
        [end(0, p.start()), end(1, p.end())].into_iter().flatten().collect::<Vec<_>>()
    };
    open.flat_map(both).collect()
}

/// The end each end is joined to: `partner[shape][side]`.
type Partners = Vec<[Option<(usize, usize)>; 2]>;

/// So many of the nearest ends are looked at in one pass; where more crowd together there is another.
const NEAREST: usize = 8;

fn partners(paths: &[Polyarc], loose: &[End], distance: f64) -> Partners {
    let mut partner: Partners = vec![[None; 2]; paths.len()];
    if !(distance.is_finite() && distance >= 0.0) {
        return partner;
    }
    loop {
        let free = |e: &&End| partner[e.shape][e.side].is_none();
        let ends: Vec<End> = loose.iter().filter(free).copied().collect();
        let pairs = near_pairs(paths, &ends, distance);
        if pairs.is_empty() {
            return partner;
        }
        for (_, a, b) in pairs {
            let (a, b) = (&ends[a], &ends[b]);
            if partner[a.shape][a.side].is_none() && partner[b.shape][b.side].is_none() {
                partner[a.shape][a.side] = Some((b.shape, b.side));
                partner[b.shape][b.side] = Some((a.shape, a.side));
            }
        }
    }
}

/// Pairs of ends within the distance, nearest first.
fn near_pairs(paths: &[Polyarc], ends: &[End], distance: f64) -> Vec<(f64, usize, usize)> {
    // Cells a little wider than the distance, so that a partner is in the same or the next one.
    let width = distance * 1.001 + 1e-9;
    let cell = |p: Point2| ((p.x / width).floor() as i64, (p.y / width).floor() as i64);
    let mut cells: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
    ends.iter().enumerate().for_each(|(k, e)| cells.entry(cell(e.at)).or_default().push(k));
    let mut pairs = Vec::new();
    for (k, end) in ends.iter().enumerate() {
        let (x, y) = cell(end.at);
        let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
        let mut near: Vec<(f64, usize, usize)> = around
            .filter_map(|c| cells.get(&c))
            .flat_map(|list| list.iter().take(64))
            .filter(|&&other| other != k && may_join(paths, end, &ends[other]))
            .map(|&other| (end.at.distance(ends[other].at), k.min(other), k.max(other)))
            .filter(|pair| pair.0 <= distance)
            .collect();
        near.sort_by(in_order);
        near.truncate(NEAREST);
        pairs.append(&mut near);
    }
    pairs.sort_by(in_order);
    pairs.dedup();
    pairs
}

fn in_order(a: &(f64, usize, usize), b: &(f64, usize, usize)) -> std::cmp::Ordering {
    a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2)))
}

/// A shape is closed on itself only if there is more to it than the gap: a short line stays a line.
fn may_join(paths: &[Polyarc], a: &End, b: &End) -> bool {
    a.shape != b.shape || {
        let path = &paths[a.shape];
        let curved = path.segment_count() > 1 || path.vertices[0].bulge != 0.0;
        curved && path.length() > 2.0 * a.at.distance(b.at)
    }
}

/// Shapes that follow each other, each forwards or backwards.
struct Chain {
    links: Vec<(usize, bool)>,
    closed: bool,
}

impl Chain {
    /// The chain that holds a shape, in that shape's direction.
    fn from(first: usize, partner: &Partners, seen: &mut [bool]) -> Self {
        // Back to the beginning, or round to the shape itself.
        let (mut shape, mut side) = (first, 0);
        while let Some((before, end)) = partner[shape][side] {
            (shape, side) = (before, 1 - end);
            if shape == first {
                break;
            }
        }
        let closed = partner[shape][side].is_some();
        if closed {
            (shape, side) = (first, 0);
        }
        let begin = shape;
        let mut links = Vec::new();
        loop {
            links.push((shape, side == 1));
            seen[shape] = true;
            match partner[shape][1 - side] {
                Some((next, end)) if next != begin => (shape, side) = (next, end),
                _ => return Self { links, closed },
            }
        }
    }

    fn joined(&self, paths: &[Polyarc], ends: Ends) -> Joined {
        let members = self.links.iter().map(|l| l.0).collect();
        if let ([(only, _)], false) = (self.links.as_slice(), self.closed) {
            return Joined { path: paths[*only].clone(), members };
        }
        let turned = |&(shape, back): &(usize, bool)| -> Vec<Segment> {
            if back {
                paths[shape].reversed().segments().collect()
            } else {
                paths[shape].segments().collect()
            }
        };
        let mut segments: Vec<Segment> = Vec::new();
        for part in self.links.iter().map(turned) {
            bridge(&mut segments, part.first().map(Segment::start), ends);
            segments.extend(part);
        }
        if self.closed {
            let start = segments.first().map(Segment::start);
            bridge(&mut segments, start, ends);
        }
        Joined { path: Polyarc::from_segments(&segments, self.closed), members }
    }
}

/// Leads from the last segment to where the next one starts.
fn bridge(segments: &mut Vec<Segment>, to: Option<Point2>, ends: Ends) {
    let (Some(last), Some(to)) = (segments.last_mut(), to) else { return };
    let end = last.end();
    match ends {
        _ if end == to => {}
        Ends::Keep => segments.push(Segment::line(end, to)),
        Ends::Merge => *last = through(last.start(), last.at(0.5), to, last.bulge()),
    }
}

/// The arc through three places; the line when it was one.
fn through(start: Point2, middle: Point2, end: Point2, bulge: f64) -> Segment {
    if bulge == 0.0 {
        return Segment::line(start, end);
    }
    Segment::bulged(start, end, Segment::bulge_through(start, middle, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    fn line(a: (f64, f64), b: (f64, f64)) -> Polyarc {
        Polyarc::lines([p(a.0, a.1), p(b.0, b.1)], false)
    }

    #[test]
    fn a_gap_is_bridged_or_merged() {
        let two = [line((0., 0.), (10., 0.)), line((10.3, 0.), (20., 0.))];
        let keep = join(&two, 0.5, Ends::Keep);
        assert_eq!((keep.len(), keep[0].path.vertices.len()), (1, 4));
        let merge = join(&two, 0.5, Ends::Merge);
        let places = [p(0., 0.), p(10.3, 0.), p(20., 0.)];
        assert_eq!(merge[0].path, Polyarc::lines(places, false));
        assert_eq!(join(&two, 0.1, Ends::Keep).len(), 2);
    }

    #[test]
    fn an_arc_that_loses_its_end_keeps_its_middle() {
        let arc =
            Polyarc::open(vec![crate::Vertex::new(0., 0., 1.), crate::Vertex::new(10., 0., 0.)]);
        let found = join(&[arc, line((10.2, 0.), (20., 0.))], 0.5, Ends::Merge);
        assert!((found[0].path.vertices[0].bulge - 0.980584).abs() < 1e-6);
    }

    #[test]
    fn four_sides_in_any_order_and_direction_make_a_square() {
        let sides = [
            line((0.2, 0.), (9.8, 0.)),
            line((10., 9.8), (10., 0.2)),
            line((9.8, 10.), (0.2, 10.)),
            line((0., 0.2), (0., 9.8)),
        ];
        let found = join(&sides, 0.5, Ends::Merge);
        assert!(found.len() == 1 && found[0].path.closed);
        assert_eq!(found[0].path.vertices.len(), 4);
        let turned: Vec<Polyarc> = sides.iter().rev().cloned().collect();
        let area = |f: &[Joined]| f[0].path.signed_area().abs();
        assert!(
            (area(&join(&turned, 0.5, Ends::Keep)) - area(&join(&sides, 0.5, Ends::Keep))).abs()
                < 1e-9
        );
        assert_eq!(join(&sides, 0.1, Ends::Keep).len(), 4);
    }

    #[test]
    fn short_lines_and_crowds_are_no_trouble() {
        assert!(!join(&[line((0., 0.), (0.1, 0.))], 0.5, Ends::Keep)[0].path.closed);
        let star: Vec<Polyarc> = (0..300).map(|k| line((0., 0.), (10., f64::from(k)))).collect();
        let found = join(&star, 0.5, Ends::Keep);
        assert_eq!(found.iter().map(|j| j.members.len()).sum::<usize>(), 300);
        assert!(join(&star, f64::NAN, Ends::Keep).len() == 300);
        let circle = Polyarc::circle(p(0., 0.), 1.0);
        assert_eq!(join(std::slice::from_ref(&circle), 0.5, Ends::Keep)[0].path, circle);
    }
}
