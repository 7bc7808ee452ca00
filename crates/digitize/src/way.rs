//! Ways of the tool along the digitized path.

use crate::{Digitizer, Dimension, Kind, Point, Refusal, Stand};
use kerf_geom::Segment;

/// So near to a point the tool is at it, millimetres: below what a machine repeats to.
const AT_MM: f64 = 1e-3;

/// A part of a way: to one of the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// A line or an arc, from the job origin.
    pub path: Segment,
    /// Z at its end, from home; in 2D it stays where it is.
    pub z_mm: Option<f64>,
    /// Number of the point that is reached, from 1.
    pub point: usize,
}

impl Digitizer {
    /// The way from the current point to another along the path, through every point between. A tool that
    /// is not at the current point goes there first, straight.
    ///
    /// Nothing where there are no points, or none of that number.
    pub fn way_to(&self, tool: &Stand, point: usize) -> Vec<Leg> {
        if self.current == 0 || !(1..=self.points.len()).contains(&point) {
            return Vec::new();
        }
        let mut way = Vec::new();
        if self.points[self.current - 1].distance(tool, self.dimension) > AT_MM {
            way.push(self.straight(tool, self.current));
        }
        let mut number = self.current;
        while number != point {
            let to = if point > number { number + 1 } else { number - 1 };
            way.push(self.leg(self.between(number, to), to));
            number = to;
        }
        way
    }

    /// To the point before the current one; nothing at the first.
    pub fn way_back(&self, tool: &Stand) -> Vec<Leg> {
        if self.current > 1 { self.way_to(tool, self.current - 1) } else { Vec::new() }
    }

    /// To the point behind the current one; nothing at the last.
    pub fn way_on(&self, tool: &Stand) -> Vec<Leg> {
        if self.current < self.points.len() {
            self.way_to(tool, self.current + 1)
        } else {
            Vec::new()
        }
    }

    /// Straight to the current point.
    ///
    /// # Errors
    /// There is none.
    pub fn way_to_current(&self, tool: &Stand) -> Result<Vec<Leg>, Refusal> {
        if self.points.is_empty() {
            return Err(Refusal::NoPoints);
        }
        Ok(vec![self.straight(tool, self.current)])
    }

    /// Straight to the point nearest to the tool.
    ///
    /// # Errors
    /// There is none.
    pub fn way_to_nearest(&self, tool: &Stand) -> Result<Vec<Leg>, Refusal> {
        Ok(vec![self.straight(tool, self.nearest(tool)?)])
    }

    /// The tool was moved along a way: the last point that it has reached is the current one, also where it
    /// was stopped on the way.
    pub fn moved(&mut self, way: &[Leg], tool: &Stand) {
        let at_end = |leg: &Leg| {
            let up = leg.z_mm.map_or(0.0, |z| z - tool.z_mm);
            leg.path.end().distance(tool.at).hypot(up) <= AT_MM
        };
        let on = |leg: &Leg| leg.path.distance(tool.at) <= AT_MM && !at_end(leg);
        let passed = match way.last() {
            Some(last) if at_end(last) => way.len(),
            _ => way.iter().position(on).unwrap_or(way.len()),
        };
        let reached = passed.checked_sub(1).map(|leg| way[leg].point);
        if let Some(point) = reached.filter(|point| (1..=self.points.len()).contains(point)) {
            self.current = point;
        }
    }

    fn straight(&self, tool: &Stand, point: usize) -> Leg {
        self.leg(Segment::line(tool.at, self.points[point - 1].stand.at), point)
    }

    fn leg(&self, path: Segment, point: usize) -> Leg {
        let z = self.points[point - 1].stand.z_mm;
        Leg { path, z_mm: (self.dimension == Dimension::Three).then_some(z), point }
    }

    /// The line or the part of an arc between two neighbours, from the first to the second.
    pub(crate) fn between(&self, from: usize, to: usize) -> Segment {
        let (first, last) = (from.min(to), from.max(to));
        let part = self.part_of_arc(first, last).unwrap_or_else(|| {
            Segment::line(self.points[first - 1].stand.at, self.points[last - 1].stand.at)
        });
        if from < to { part } else { part.reversed() }
    }

    /// The part of an arc between two neighbours of which one is its arc point.
    fn part_of_arc(&self, first: usize, last: usize) -> Option<Segment> {
        let middle = [first, last].into_iter().find(|n| self.points[n - 1].kind == Kind::Arc)?;
        let whole = arc(self.points.get(middle.checked_sub(2)?..=middle)?)?;
        let (from, to) = (self.points[first - 1].stand.at, self.points[last - 1].stand.at);
        let share = whole.share_of(self.points[middle - 1].stand.at).clamp(0.0, 1.0);
        let part = if middle == last { whole.part(0.0, share) } else { whole.part(share, 1.0) };
        Some(Segment::bulged(from, to, part.bulge()))
    }
}

/// The arc through three points in order, the line where they lie on one; nothing where there is none.
pub(crate) fn arc(points: &[Point]) -> Option<Segment> {
    let [start, via, end] = points else { return None };
    Segment::through(start.stand.at, via.stand.at, end.stand.at)
}
