//! The shortest way found to cover a piece that rings leave.
//!
//! A spot visited for a cusp, a straight stroke for a strip, and the edge of the piece for everything
//! else. Each is tried before the next and taken only if it covers the piece and stays where the centre
//! may go.

use crate::Cutter;
use crate::inside::Inside;
use kerf_geom::{Bounds2, Indexed, Point2, Polyarc, Segment, Vec2};

/// Share of the tool's radius by which a stroke is to reach further than it must. Arcs of an edge are looked at
/// so densely that between two places they lie further out by half of it.
const MARGIN: f64 = 2e-3;

/// A path that covers a piece; nothing when the rings cover it after all. A closed path is the edge of
/// the piece, a path of one vertex a spot.
pub(crate) fn covering(
    piece: &Polyarc,
    cutter: &Cutter,
    inside: &Inside,
    rings: &Indexed,
) -> Option<Polyarc> {
    let edge = Edge::of(piece, cutter);
    let stroke = edge.spot(inside, rings).or_else(|| edge.straight(inside));
    Some(stroke.unwrap_or_else(|| piece.clone()))
}

/// Places on the edge of a piece. The distance from a straight stroke is convex, so what covers these
/// covers the lines between them and everything within.
struct Edge {
    places: Vec<Point2>,
    reach: f64,
}

impl Edge {
    fn of(piece: &Polyarc, cutter: &Cutter) -> Self {
        let tool = cutter.radius_mm();
        let places = piece.segments().flat_map(|segment| places(segment, MARGIN * tool)).collect();
        Self { places, reach: tool * (1.0 - MARGIN) }
    }

    fn covered_by(&self, stroke: &Segment) -> bool {
        self.places.iter().all(|place| stroke.distance(*place) <= self.reach)
    }

    /// A spot, as near to the rings as it can be: the way to it helps to cover.
    fn spot(&self, inside: &Inside, rings: &Indexed) -> Option<Polyarc> {
        let middle = self.middle();
        let (_, foot) = rings.nearest(middle)?;
        let way = |share: f64| Segment::line(foot.at, foot.at + (middle - foot.at) * share);
        if !(self.covered_by(&way(1.0)) && inside.holds(&way(1.0))) {
            return None;
        }
        let share = least(|share| self.covered_by(&way(share)));
        Some(Polyarc::lines([way(share).end()], false))
    }

    /// A place from which the farthest place is about as near as it can be: a walk towards the farthest
    /// one with shorter and shorter steps (Bădoiu and Clarkson, "Smaller core-sets for balls").
    fn middle(&self) -> Point2 {
        let mut bounds = Bounds2::default();
        self.places.iter().for_each(|place| bounds.add(*place));
        let mut at = bounds.centre();
        for step in 2..40 {
            let farther = |a: &&Point2, b: &&Point2| a.distance(at).total_cmp(&b.distance(at));
            let Some(far) = self.places.iter().max_by(farther) else { break };
            at += (*far - at) / f64::from(step);
        }
        at
    }

    /// A straight stroke along the piece, as short as it can be.
    fn straight(&self, inside: &Inside) -> Option<Polyarc> {
        let (from, to) = self.extent();
        let part = |a: f64, b: f64| Segment::line(from + (to - from) * a, from + (to - from) * b);
        if !self.covered_by(&part(0.0, 1.0)) {
            return None;
        }
        let end = least(|end| self.covered_by(&part(0.0, end)));
        let start = 1.0 - least(|rest| self.covered_by(&part((1.0 - rest).min(end), end)));
        let stroke = part(start.min(end), end);
        inside.holds(&stroke).then(|| Polyarc::from_segments(&[stroke], false))
    }

    /// The ends of the piece along its main axis.
    fn extent(&self) -> (Point2, Point2) {
        let axis = self.axis();
        let origin = self.places.first().copied().unwrap_or_default();
        let across = |place: &Point2| (*place - origin).dot(axis.left());
        let along = |place: &Point2| (*place - origin).dot(axis);
        let (left, right) = range(self.places.iter().map(across));
        let (from, to) = range(self.places.iter().map(along));
        let base = origin + axis.left() * (0.5 * (left + right));
        (base + axis * from, base + axis * to)
    }

    /// The direction in which the places lie farthest apart.
    fn axis(&self) -> Vec2 {
        let count = self.places.len().max(1) as f64;
        let origin = self.places.first().copied().unwrap_or_default();
        let sum = self.places.iter().fold(Vec2::default(), |sum, place| sum + (*place - origin));
        let mean = origin + sum / count;
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for off in self.places.iter().map(|place| *place - mean) {
            (xx, xy, yy) = (xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y);
        }
        Vec2::from_angle(0.5 * (2.0 * xy).atan2(xx - yy))
    }
}

/// The places of a segment that are looked at, without its start. An arc of radius r rises r·u²/8 above the
/// chord over a small angle u: half the margin at most.
fn places(segment: Segment, margin: f64) -> impl Iterator<Item = Point2> {
    let count = match segment {
        Segment::Line { .. } => 1,
        Segment::Arc { radius, sweep_rad, .. } => {
            let step = 2.0 * (margin / radius).sqrt();
            (sweep_rad.abs() / step).ceil().max(1.0) as usize
        }
    };
    (1..=count).map(move |k| segment.at(k as f64 / count as f64))
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

/// The smallest share for which something holds that holds for 1 and for all larger shares.
fn least(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..24 {
        let middle = 0.5 * (low + high);
        if holds(middle) { high = middle } else { low = middle }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flat arc of a wide corner once rose above what was looked at.
    #[test]
    fn wide_arcs_are_looked_at_densely() {
        for radius in [0.5, 5.0, 80.0] {
            let at = |turn: f64| Point2::default() + Vec2::from_angle(turn) * radius;
            let arc = Segment::bulged(at(0.0), at(0.9), (0.9f64 / 4.0).tan());
            let looked: Vec<Point2> = [arc.start()].into_iter().chain(places(arc, 0.01)).collect();
            let rise =
                |pair: &[Point2]| radius - pair[0].midpoint(pair[1]).distance(Point2::default());
            assert!(looked.windows(2).map(rise).all(|rise| rise <= 0.005 + 1e-9), "{radius}");
        }
    }
}
