//! Arcs by which the tool comes to a path and leaves it.
//!
//! ```text
//!        C ●──────── R ────────┐          lead-in, right of travel: the arc from Q runs clockwise
//!          │ ╲ A               │          about C and comes to P in the direction of the path
//!    ──────P───►  path         Q
//! ```
//!
//! Source: readings, Leads.

use kerf_drawing::Lead;
use kerf_geom::{Point2, Polyarc, Vec2};

/// The side of the path on which a lead lies, seen in the direction of travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// To the right.
    Right,
    /// To the left.
    Left,
}

impl Side {
    /// The side of an offset: right unless it is negative, so that the lead lies off the part.
    pub fn of_offset(offset_mm: f64) -> Self {
        if offset_mm < 0.0 { Self::Left } else { Self::Right }
    }

    /// The side that a lead with this radius takes: a negative radius puts it on the other one.
    fn for_radius(self, radius_mm: f64) -> Self {
        match (self, radius_mm < 0.0) {
            (side, false) => side,
            (Self::Right, true) => Self::Left,
            (Self::Left, true) => Self::Right,
        }
    }

    /// 1 when an arc on this side turns counter-clockwise.
    fn turn(self) -> f64 {
        match self {
            Self::Right => -1.0,
            Self::Left => 1.0,
        }
    }
}

/// The arc that ends at `at` in the direction `along` (of length 1); nothing without a radius or an
/// angle.
pub fn lead_in(lead: Lead, at: Point2, along: Vec2, side: Side) -> Option<Polyarc> {
    let arc = Arc::of(lead, at, along, side)?;
    let from_rad = (at - arc.centre).angle() - arc.sweep_rad;
    Some(Polyarc::arc(arc.centre, arc.radius, from_rad, arc.sweep_rad))
}

/// The arc that begins at `at` in the direction `along`.
pub fn lead_out(lead: Lead, at: Point2, along: Vec2, side: Side) -> Option<Polyarc> {
    let arc = Arc::of(lead, at, along, side)?;
    let from_rad = (at - arc.centre).angle();
    Some(Polyarc::arc(arc.centre, arc.radius, from_rad, arc.sweep_rad))
}

struct Arc {
    centre: Point2,
    radius: f64,
    sweep_rad: f64,
}

impl Arc {
    fn of(lead: Lead, at: Point2, along: Vec2, side: Side) -> Option<Self> {
        let turn = lead.is_some().then(|| side.for_radius(lead.radius_mm).turn())?;
        let radius = lead.radius_mm.abs();
        let centre = at + along.left() * (turn * radius);
        Some(Self { centre, radius, sweep_rad: turn * lead.angle_deg.to_radians() })
    }
}

/// Puts a lead before or after a path, whose closing segment becomes part of it.
pub(crate) fn with_leads(
    path: &Polyarc,
    lead_in: Option<Polyarc>,
    lead_out: Option<Polyarc>,
) -> Polyarc {
    if lead_in.is_none() && lead_out.is_none() {
        return path.clone();
    }
    let mut vertices = Vec::with_capacity(path.vertices.len() + 8);
    for lead in lead_in.iter() {
        vertices.extend(unclosed(lead));
        vertices.pop();
    }
    vertices.extend(unclosed(path));
    for lead in lead_out.iter() {
        vertices.pop();
        vertices.extend(unclosed(lead));
    }
    Polyarc::open(vertices)
}

/// The vertices of a path with its start again at the end when it is closed.
fn unclosed(path: &Polyarc) -> impl Iterator<Item = kerf_geom::Vertex> + '_ {
    let again = path.vertices.first().filter(|_| path.closed);
    let again = again.map(|first| kerf_geom::Vertex { at: first.at, bulge: 0.0 });
    path.vertices.iter().copied().chain(again)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    const EAST: Vec2 = Vec2::new(1.0, 0.0);

    fn lead(radius_mm: f64, angle_deg: f64) -> Lead {
        Lead { radius_mm, angle_deg }
    }

    fn check(arc: &Polyarc, start: (f64, f64), end: (f64, f64), bulge: f64) {
        let near = |a: Point2, b: (f64, f64)| {
            assert!(a.distance(Point2::new(b.0, b.1)) < 1e-4, "{a:?} is not {b:?}");
        };
        near(arc.start().unwrap(), start);
        near(arc.end().unwrap(), end);
        assert!((arc.vertices[0].bulge - bulge).abs() < 1e-6);
    }

    #[test]
    fn pro_toolpath_leadin() {
        let at = Point2::new(0.0, -5.0);
        let arc = lead_in(lead(10.0, 90.0), at, EAST, Side::Right).unwrap();
        check(&arc, (-10.0, -15.0), (0.0, -5.0), -0.414214);
        assert!((arc.length() - 15.708).abs() < 1e-3);
        let end = arc.segment(0).direction(1.0);
        assert!((end - EAST).length() < 1e-9);
    }

    #[test]
    fn pro_toolpath_leadin_45() {
        let arc = |angle| lead_in(lead(10.0, angle), Point2::default(), EAST, Side::Right).unwrap();
        check(&arc(45.0), (-7.0711, -2.9289), (0.0, 0.0), -0.198912);
        check(&arc(180.0), (0.0, -20.0), (0.0, 0.0), -1.0);
    }

    #[test]
    fn pro_toolpath_leadin_side() {
        assert_eq!(Side::of_offset(0.0), Side::Right);
        assert_eq!(Side::of_offset(-2.0), Side::Left);
        let arc =
            |side, radius| lead_in(lead(radius, 90.0), Point2::default(), EAST, side).unwrap();
        check(&arc(Side::Left, 10.0), (-10.0, 10.0), (0.0, 0.0), 0.414214);
        check(&arc(Side::Right, -10.0), (-10.0, 10.0), (0.0, 0.0), 0.414214);
    }

    #[test]
    fn pro_toolpath_leadout() {
        let at = Point2::new(50.0, -5.0);
        let arc = |angle| lead_out(lead(10.0, angle), at, EAST, Side::Right).unwrap();
        check(&arc(90.0), (50.0, -5.0), (60.0, -15.0), -0.414214);
        check(&arc(45.0), (50.0, -5.0), (57.0711, -7.9289), -0.198912);
    }

    #[test]
    fn pro_toolpath_leadin_zero() {
        for none in [lead(0.0, 90.0), lead(10.0, 0.0)] {
            assert_eq!(lead_in(none, Point2::default(), EAST, Side::Right), None);
        }
    }
}
