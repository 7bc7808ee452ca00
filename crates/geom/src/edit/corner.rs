//! Corners rounded or cut.

use crate::{GeomError, Polyarc, Segment, Vertex, offset::parallel, tol};

/// The polyarc with an arc of a radius at a vertex, tangent to both segments, lines or arcs.
///
/// ```text
///       │ ·            The centre lies on the parallels of both segments at the radius, on the side
///       │·· c          to which the corner turns; the arc begins and ends at its feet.
///    ───┘···
/// ```
///
/// # Errors
/// A radius that is not positive; a vertex that is no corner; segments too short for the radius.
pub fn fillet(path: &Polyarc, vertex: usize, radius: f64) -> Result<Polyarc, GeomError> {
    positive(radius, "the radius")?;
    let corner = Corner::at(path, vertex)?;
    let (before, after) = (corner.before, corner.after);
    let turn = before.direction(1.0).cross(after.direction(0.0));
    let inward = -radius * turn.signum();
    let centres = match (parallel(&before, inward), parallel(&after, inward)) {
        (Some(a), Some(b)) if turn.abs() > 1e-9 => a.meet(&b),
        _ => return Err(corner.refused("no fillet of this radius fits the corner")),
    };
    let from_vertex = |c: &&crate::Contact| c.at.distance(before.end());
    let nearest = centres.iter().min_by(|a, b| from_vertex(a).total_cmp(&from_vertex(b)));
    let Some(nearest) = nearest else {
        return Err(corner.refused("a segment is shorter than the fillet needs"));
    };
    let kept = (before.part(0.0, nearest.on_first), after.part(nearest.on_second, 1.0));
    // Of the whole segments: nothing may be left of one, and nothing has no direction.
    let (u, v) = (before.direction(nearest.on_first), after.direction(nearest.on_second));
    let bulge = (u.cross(v).atan2(u.dot(v)) * 0.25).tan();
    Ok(corner.replaced(
        path,
        &kept.0,
        Segment::bulged(kept.0.end(), kept.1.start(), bulge),
        &kept.1,
    ))
}

/// The polyarc with a corner cut off a length back along each segment.
///
/// # Errors
/// As [`fillet`].
pub fn chamfer(path: &Polyarc, vertex: usize, length: f64) -> Result<Polyarc, GeomError> {
    positive(length, "the length of the chamfer")?;
    let corner = Corner::at(path, vertex)?;
    let (long_before, long_after) = (corner.before.length(), corner.after.length());
    if length > long_before.min(long_after) + tol::SAME_PLACE_MM {
        return Err(corner.refused("a segment is shorter than the chamfer needs"));
    }
    let before = corner.before.part(0.0, 1.0 - length / long_before);
    let after = corner.after.part(length / long_after, 1.0);
    Ok(corner.replaced(path, &before, Segment::line(before.end(), after.start()), &after))
}

fn positive(value: f64, what: &'static str) -> Result<(), GeomError> {
    if value.is_finite() && value > 0.0 { Ok(()) } else { Err(GeomError::NotPositive { what }) }
}

struct Corner {
    vertex: usize,
    number_before: usize,
    before: Segment,
    after: Segment,
}

impl Corner {
    fn at(path: &Polyarc, vertex: usize) -> Result<Self, GeomError> {
        let count = path.segment_count();
        let inner = if path.closed { vertex < count } else { vertex > 0 && vertex < count };
        if !inner || count < 2 {
            let at = path.vertices.get(vertex).map(|v| v.at).unwrap_or_default();
            return Err(GeomError::Impossible { what: "no corner between two segments", at });
        }
        let number_before = (vertex + count - 1) % count;
        let (before, after) = (path.segment(number_before), path.segment(vertex));
        Ok(Self { vertex, number_before, before, after })
    }

    fn refused(&self, what: &'static str) -> GeomError {
        GeomError::Impossible { what, at: self.before.end() }
    }

    /// The path with what is kept of the two segments and something between them.
    fn replaced(
        &self,
        path: &Polyarc,
        before: &Segment,
        between: Segment,
        after: &Segment,
    ) -> Polyarc {
        let mut vertices = path.vertices.clone();
        vertices[self.number_before].bulge = before.bulge();
        vertices[self.vertex] = Vertex { at: between.start(), bulge: between.bulge() };
        vertices.insert(self.vertex + 1, Vertex { at: between.end(), bulge: after.bulge() });
        Polyarc { vertices, closed: path.closed }.tidied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Point2;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    fn elbow(long: f64) -> Polyarc {
        Polyarc::lines([p(0., 0.), p(long, 0.), p(long, long)], false)
    }

    #[test]
    fn a_right_angle_gets_a_quarter_circle() {
        let round = fillet(&elbow(100.0), 1, 10.0).expect("a fillet");
        assert!(round.vertices[1].at.distance(p(90., 0.)) < 1e-12);
        assert!(round.vertices[2].at.distance(p(100., 10.)) < 1e-12);
        assert!((round.vertices[1].bulge - 0.414213562373).abs() < 1e-9);
        let cut = chamfer(&elbow(100.0), 1, 10.0).expect("a chamfer");
        assert_eq!(cut.vertices[1].at, p(90., 0.));
    }

    #[test]
    fn segments_have_to_be_long_enough() {
        let refused = |r: Result<Polyarc, GeomError>| r.expect_err("refused").to_string();
        assert!(refused(fillet(&elbow(9.0), 1, 10.0)).contains("shorter"));
        assert!(refused(chamfer(&elbow(9.0), 1, 10.0)).contains("shorter"));
        let whole = fillet(&elbow(10.0), 1, 10.0).expect("just long enough");
        let round = whole.segments().find(|segment| segment.length() > 1.0).expect("an arc");
        assert!((round.length() - 5.0 * std::f64::consts::PI).abs() < 1e-9, "a quarter turn");
        let sharp = Polyarc::lines([p(15., 0.), p(0., 0.), p(7.5, 12.990381)], false);
        assert!(refused(fillet(&sharp, 1, 10.0)).contains("shorter"));
        assert!(refused(fillet(&elbow(9.0), 0, 1.0)).contains("no corner"));
        assert!(refused(fillet(&elbow(9.0), 1, -1.0)).contains("positive"));
    }

    #[test]
    fn lines_and_arcs_are_joined_tangentially() {
        let slice = Polyarc::closed(vec![
            Vertex::new(0., 0., 0.),
            Vertex::new(20., 0., 1.0),
            Vertex::new(0., 20., 0.),
        ]);
        for vertex in 0..3 {
            let round = fillet(&slice, vertex, 1.5).expect("a fillet");
            assert_eq!(round.vertices.len(), 4);
            let radius = |s: Segment| s.arc().map_or(0.0, |a| a.radius());
            assert!((radius(round.segment(vertex)) - 1.5).abs() < 1e-9);
            let joint = |k: usize| {
                let (a, b) = (round.segment((k + 3) % 4), round.segment(k % 4));
                a.direction(1.0).cross(b.direction(0.0)).abs()
            };
            assert!(joint(vertex) < 1e-9 && joint(vertex + 1) < 1e-9);
        }
    }
}
