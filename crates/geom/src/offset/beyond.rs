//! Proofs of a few products that two segments keep their distance; where there is none they are measured.

use crate::segment::square;
use crate::{Point2, Segment, Vec2};

/// Region at least a limit away from one segment, as far as it is quickly seen.
///
/// Beside a line everything beyond a parallel line is. Beside an arc it is everything beyond its circle, and
/// what lies behind lines square to the radii of both ends: then it lies behind those of all radii between.
///
/// ```text
///   ───────────────●──────            ╲   ╭───────╮   ╱      a place behind both of the
///     limit        │                   ╲╱   ╲   ╱  ╲╱        edges is at least as far from
///   ╶ ╶ ╶ ╶ ╶ ╶ ╶ ╶ ╶ ╶ ╶               ╲    ╲ ╱   ╱         every place of the arc as the
///      everything down here               ╲   V   ╱          edges are from its ends
/// ```
pub(super) struct Beyond<'a> {
    segment: &'a Segment,
    limit: f64,
    shape: Shape,
}

enum Shape {
    /// A line has a direction to its left.
    Line { left: Vec2 },
    /// An arc has radii at its ends, if these are no more than 120 degrees apart: between them no unit vector
    /// takes more of the two together than twice.
    Arc { ends: Option<[Vec2; 2]> },
}

const MOST_SWEEP_RAD: f64 = 2.0;

impl<'a> Beyond<'a> {
    pub fn of(segment: &'a Segment, limit: f64) -> Self {
        let shape = match *segment {
            Segment::Line { start, end } => {
                let way = end - start;
                Shape::Line { left: way.left() / square(way).sqrt() }
            }
            Segment::Arc { start, end, centre, radius, sweep_rad } => {
                let ends = [(start - centre) / radius, (end - centre) / radius];
                Shape::Arc { ends: (sweep_rad.abs() <= MOST_SWEEP_RAD).then_some(ends) }
            }
        };
        Self { segment, limit, shape }
    }

    /// Returns `true` if another segment, which leaves in some direction, certainly lies at least the limit away.
    pub fn has(&self, other: &Segment, leaves: Vec2) -> bool {
        let limit = self.limit;
        match (&self.shape, self.segment, other) {
            (Shape::Line { left: mine }, Segment::Line { .. }, Segment::Line { .. }) => {
                is_aside(self.segment, *mine, other, limit)
                    || is_aside(other, leaves.left(), self.segment, limit)
            }
            (Shape::Line { left: mine }, line, Segment::Arc { centre, radius, .. }) => {
                off_circle(line, *mine, *centre, *radius, limit)
                    || is_past_end(line, other, limit)
                    || is_aside(line, *mine, other, limit)
            }
            (Shape::Arc { ends }, Segment::Arc { centre, radius, .. }, Segment::Line { .. }) => {
                let left = leaves.left();
                off_circle(other, left, *centre, *radius, limit)
                    || behind(*ends, *centre, 0.5 * (radius - limit), other)
                    || is_aside(other, left, self.segment, limit)
            }
            (
                Shape::Arc { ends },
                Segment::Arc { centre, radius, .. },
                Segment::Arc { centre: c, radius: r, .. },
            ) => {
                circles_apart(square(*c - *centre), *radius, *r, limit)
                    || behind(*ends, *centre, 0.5 * (radius - limit), other)
            }
            _ => false,
        }
    }
}

/// Tells whether all of a segment lies on one side of a line and as far from it as the limit.
fn is_aside(line: &Segment, left: Vec2, other: &Segment, limit: f64) -> bool {
    let (low, high) = extent(other, line.start(), left);
    low >= limit || high <= -limit
}

/// Between which distances from a place a segment lies along a unit vector.
fn extent(segment: &Segment, from: Point2, along: Vec2) -> (f64, f64) {
    let (a, b) = (along.dot(segment.start() - from), along.dot(segment.end() - from));
    let (mut low, mut high) = if a < b { (a, b) } else { (b, a) };
    if let Segment::Arc { centre, radius, .. } = *segment {
        let middle = along.dot(centre - from);
        if segment.faces(centre + along) {
            high = middle + radius;
        }
        if segment.faces(centre - along) {
            low = middle - radius;
        }
    }
    (low, high)
}

/// Tells whether a line keeps its distance from a whole circle, outside or inside.
fn off_circle(line: &Segment, left: Vec2, centre: Point2, radius: f64, limit: f64) -> bool {
    let inner = radius - limit;
    let within = |at: Point2| square(at - centre) <= inner * inner;
    left.dot(centre - line.start()).abs() >= radius + limit
        || (inner > 0.0 && within(line.start()) && within(line.end()))
}

/// Bound of the losses by rounding here.
const ROUNDING_MM: f64 = 1e-9;

/// Returns `true` if a line inside a circle lies past one end of its arc, as beside a rounded inner corner. With x
/// along the tangent, h along the radius at the end, a place (x, h) with x ≥ 0 and h ≥ 0 is √(r² + h² − 2hr cos φ) or
/// more from the place φ before the end, so r − h or more from all.
fn is_past_end(line: &Segment, arc: &Segment, limit: f64) -> bool {
    let Segment::Arc { start, end, centre, radius, sweep_rad } = *arc else { return false };
    if sweep_rad.abs() > std::f64::consts::PI || radius <= limit {
        return false;
    }
    let (low, high) = (1e-3 * radius, radius - limit - ROUNDING_MM);
    let (from, to) = (line.start() - centre, line.end() - centre);
    [(start, -1.0), (end, 1.0)].into_iter().any(|(at, way)| {
        let out = (at - centre) / radius;
        let onward = out.left() * (way * sweep_rad.signum());
        [from, to].iter().all(|place| {
            let height = place.dot(out);
            place.dot(onward) >= -ROUNDING_MM && low <= height && height <= high
        })
    })
}

/// Tells whether two circles keep their distance, side by side or one in the other.
fn circles_apart(between_squared: f64, a: f64, b: f64, limit: f64) -> bool {
    let (outer, inner) = (a + b + limit, (a - b).abs() - limit);
    between_squared >= outer * outer || (inner >= 0.0 && between_squared <= inner * inner)
}

/// Tells whether a segment lies behind lines square to the radii at the ends of an arc, this far from its centre.
fn behind(ends: Option<[Vec2; 2]>, centre: Point2, edge: f64, other: &Segment) -> bool {
    ends.is_some_and(|ends| {
        edge >= 0.0 && ends.iter().all(|out| extent(other, centre, *out).1 <= edge)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::offset::chord::Chord;

    /// Segments and places that are dismissed without measuring are never nearer than the limit.
    #[test]
    fn what_lies_beyond_is_no_nearer() {
        let mut seed = 3u64;
        let mut dice = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut dismissed = [0; 2];
        for _ in 0..20_000 {
            let mut place = || Point2::new(dice() * 10.0, dice() * 10.0);
            let (p, q, r, s) = (place(), place(), place(), place());
            let mut bulge = || if dice() < 0.4 { 0.0 } else { dice() * 1.9 - 0.95 };
            let (a, b) = (Segment::bulged(p, q, bulge()), Segment::bulged(r, s, bulge()));
            let limit = dice() * 5.0;
            let (chord, apart) = (Chord::of(&b, limit), a.distance_to(&b));
            if Beyond::of(&a, limit).has(&b, b.direction(0.0)) {
                dismissed[0] += 1;
                assert!(apart >= limit - 1e-9, "{a:?} {b:?} {limit} {apart}");
            }
            if !chord.may_be_nearer(p, limit * limit) {
                dismissed[1] += 1;
                assert!(b.distance(p) >= limit - 1e-9, "{p:?} {b:?} {limit}");
            }
        }
        assert!(dismissed[0] > 2000 && dismissed[1] > 2000, "{dismissed:?}");
    }
}
