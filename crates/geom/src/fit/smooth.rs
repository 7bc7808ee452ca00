//! Runs of short lines replaced by the curve through their vertices (Profiler reference, "Tool Path
//! Smoothing"; readings, Smoothing).
//!
//! A *run* is a chain of lines between corners of more than 45°. In a run of at least three lines every
//! vertex gets the direction of the circle through it and its neighbours; a line becomes a pair of arcs
//! with these directions if they stay within the limit. Next to a line that stays, the arcs end in its
//! direction where the limit allows it. The model of motion that smooths while it moves goes by the same rules.

use super::biarc::{Station, biarc};
use crate::{Point2, Polyarc, Segment, Vec2, tol};

/// Sharper corners stay; corners drawn at just the limit, with a few decimals, do not.
const SHARP_RAD: f64 = std::f64::consts::FRAC_PI_4 + 1e-6;
/// Shorter runs are corners and not curves.
const FEWEST: usize = 3;
/// Places of an arc at which its distance from its line is measured.
const PROBES: u32 = 8;

/// The same path with curves for runs of lines that these leave by no more than the limit, millimetres. It
/// passes every vertex, and begins where it began.
#[must_use]
pub fn smoothed(path: &Polyarc, limit_mm: f64) -> Polyarc {
    if limit_mm <= 0.0 || path.segment_count() < FEWEST {
        return path.clone();
    }
    let run = Runs::of(path);
    let mut segments = Vec::with_capacity(path.segment_count());
    let mut curved = false;
    for (number, segment) in run.segments.iter().enumerate() {
        match run.curve(number, limit_mm) {
            Some(arcs) => segments.extend(arcs),
            None => segments.push(*segment),
        }
        curved |= segments.last() != Some(segment);
    }
    if curved { rejoined(&segments, path.closed) } else { path.clone() }
}

/// Neighbours on one circle made one, without moving the start of a closed path.
fn rejoined(segments: &[Segment], closed: bool) -> Polyarc {
    let mut path = Polyarc::from_segments(segments, false).merged();
    if closed {
        path.vertices.pop();
    }
    Polyarc { closed, ..path }
}

struct Runs {
    closed: bool,
    segments: Vec<Segment>,
    /// For each segment its direction and length if it is a line.
    ways: Vec<Option<(Vec2, f64)>>,
    /// Number of lines in the run of each segment.
    long: Vec<usize>,
}

impl Runs {
    fn of(path: &Polyarc) -> Self {
        let segments: Vec<Segment> = path.segments().collect();
        let ways = segments.iter().map(way).collect();
        let mut runs = Self { closed: path.closed, ways, long: vec![0; segments.len()], segments };
        runs.measure();
        runs
    }

    /// The segment before or after another.
    fn beside(&self, number: usize, after: bool) -> Option<usize> {
        let count = self.segments.len();
        match (after, self.closed) {
            (true, true) => Some((number + 1) % count),
            (false, true) => Some((number + count - 1) % count),
            (true, false) => Some(number + 1).filter(|next| *next < count),
            (false, false) => number.checked_sub(1),
        }
    }

    /// The line that goes on smoothly before or after a line.
    fn goes_on(&self, number: usize, after: bool) -> Option<usize> {
        let other = self.beside(number, after)?;
        let ((a, _), (b, _)) = (self.ways[number]?, self.ways[other]?);
        (a.cross(b).atan2(a.dot(b)).abs() <= SHARP_RAD).then_some(other)
    }

    fn measure(&mut self) {
        let count = self.segments.len();
        for start in 0..count {
            let begins = self.ways[start].is_some() && self.goes_on(start, false).is_none();
            if begins {
                self.mark(start);
            }
        }
        // What has no beginning goes all the way round.
        let round = |long: &usize| *long == 0;
        if self.ways.iter().all(Option::is_some) && self.long.iter().all(round) {
            self.long = vec![count; count];
        }
    }

    fn mark(&mut self, start: usize) {
        let next = |n: &usize| self.goes_on(*n, true).filter(|n| *n != start);
        let members: Vec<usize> =
            std::iter::successors(Some(start), next).take(self.segments.len()).collect();
        members.iter().for_each(|n| self.long[*n] = members.len());
    }

    /// The arcs that take the place of a line; nothing where it stays.
    fn curve(&self, number: usize, limit: f64) -> Option<Vec<Segment>> {
        let (start, end) = self.directions(number)?;
        self.arcs(number, start, end, limit)?;
        let beside = |after| {
            let other = self.goes_on(number, after)?;
            let (from, to) = self.directions(other)?;
            let stays = self.arcs(other, from, to, limit).is_none();
            if stays { Some(self.ways[other]?.0) } else { None }
        };
        let aligned_start = beside(false)
            .filter(|along| self.arcs(number, *along, end, limit).is_some())
            .unwrap_or(start);
        let aligned_end = beside(true)
            .filter(|along| self.arcs(number, aligned_start, *along, limit).is_some())
            .unwrap_or(end);
        self.arcs(number, aligned_start, aligned_end, limit)
    }

    /// The directions of the curve at both ends of a line of a run that is long enough.
    fn directions(&self, number: usize) -> Option<(Vec2, Vec2)> {
        let own = self.ways[number].filter(|_| self.long[number] >= FEWEST)?;
        let at = |after: bool| {
            let other = self.ways[self.goes_on(number, after)?]?;
            // The circle through three places has this direction at the middle one.
            (own.0 * other.1 + other.0 * own.1).normalized()
        };
        match (at(false), at(true)) {
            (Some(start), Some(end)) => Some((start, end)),
            (Some(start), None) => Some((start, mirrored(start, own.0))),
            (None, Some(end)) => Some((mirrored(end, own.0), end)),
            (None, None) => None,
        }
    }

    /// The arcs between the ends of a line with these directions, if they stay near it.
    fn arcs(&self, number: usize, start: Vec2, end: Vec2, limit: f64) -> Option<Vec<Segment>> {
        let line = self.segments[number];
        let station = |at: Point2, along| Station { at, along };
        let arcs = biarc(station(line.start(), start), station(line.end(), end))?;
        let near = |arc: &Segment| {
            (0..=PROBES).all(|k| line.distance(arc.at(f64::from(k) / f64::from(PROBES))) <= limit)
        };
        arcs.iter().all(near).then(|| arcs.to_vec())
    }
}

fn way(segment: &Segment) -> Option<(Vec2, f64)> {
    let Segment::Line { start, end } = segment else { return None };
    let long = (*end - *start).length();
    (long > tol::SAME_PLACE_MM).then(|| ((*end - *start) / long, long))
}

/// The direction of a circle at one end of a chord, from that at the other.
fn mirrored(direction: Vec2, chord: Vec2) -> Vec2 {
    chord * (2.0 * direction.dot(chord)) - direction
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vertex;

    fn polygon(sides: u32, radius: f64) -> Polyarc {
        let turn = std::f64::consts::TAU / f64::from(sides);
        let place = |k: u32| Point2::default() + Vec2::from_angle(turn * f64::from(k)) * radius;
        Polyarc::lines((0..sides).map(place), true)
    }

    /// Checks that a polygon becomes the circle round it, or stays as it is.
    fn check(sides: u32, radius: f64, limit: f64, round: bool) {
        let shape = polygon(sides, radius);
        let found = smoothed(&shape, limit);
        if !round {
            return assert_eq!(found, shape);
        }
        let circle = std::f64::consts::PI * radius * radius;
        assert!((found.signed_area() - circle).abs() < 1e-6 * circle, "{}", found.signed_area());
        assert_eq!(found.start(), shape.start());
        assert!(found.vertices.len() <= 4, "{}", found.vertices.len());
    }

    #[test]
    fn polygons_become_circles_within_the_limit() {
        check(72, 50.0, 0.06, true);
        check(36, 50.0, 0.06, false);
        check(36, 50.0, 0.2, true);
        check(36, 10.0, 0.06, true);
        check(12, 10.0, 0.06, false);
        check(8, 10.0, 1.0, true);
        check(7, 10.0, 5.0, false);
        check(72, 50.0, 0.0, false);
    }

    #[test]
    fn the_curve_passes_the_vertices_and_has_no_corners() {
        let place = |k: i32| {
            let x = f64::from(k) * 0.8;
            Point2::new(x, 6.0 * (0.21 * x).sin() + 0.02 * x * x)
        };
        let wave = Polyarc::lines((0..60).map(place), false);
        let found = smoothed(&wave, 0.1);
        let far = |v: &Vertex| found.nearest(v.at).map_or(1.0, |found| found.1);
        assert!(wave.vertices.iter().map(far).fold(0.0, f64::max) < 1e-6);
        for k in 1..found.segment_count() {
            let (before, after) = (found.segment(k - 1), found.segment(k));
            assert!(before.direction(1.0).cross(after.direction(0.0)).abs() < 1e-6);
        }
        assert_eq!((found.start(), found.end()), (wave.start(), wave.end()));
    }

    #[test]
    fn squares_and_arcs_stay() {
        let square = Polyarc::rectangle(Point2::new(0.0, 0.0), Point2::new(0.2, 0.2));
        assert_eq!(smoothed(&square, 1.0), square);
        let slot = Polyarc::rounded_rectangle(Point2::new(0.0, 0.0), Point2::new(9.0, 4.0), 2.0);
        assert_eq!(smoothed(&slot, 1.0), slot);
    }
}
