//! The shapes that are drawn most.

use super::{Polyarc, Vertex};
use crate::{Point2, Segment, Vec2};
use std::f64::consts::FRAC_PI_8;

impl Polyarc {
    /// A circle, counter-clockwise from its rightmost place: two half circles.
    pub fn circle(centre: Point2, radius: f64) -> Self {
        let side = Vec2::new(radius, 0.0);
        let half = |at| Vertex { at, bulge: 1.0 };
        Self::closed(vec![half(centre + side), half(centre - side)])
    }

    /// An upright rectangle between two opposite corners, counter-clockwise from the lower left one.
    pub fn rectangle(a: Point2, b: Point2) -> Self {
        let (low, high) =
            (Point2::new(a.x.min(b.x), a.y.min(b.y)), Point2::new(a.x.max(b.x), a.y.max(b.y)));
        let corners = [low, Point2::new(high.x, low.y), high, Point2::new(low.x, high.y)];
        Self::lines(corners, true)
    }

    /// A rectangle with rounded corners. The radius is held to half the shorter side.
    pub fn rounded_rectangle(a: Point2, b: Point2, radius: f64) -> Self {
        let (w, h) = ((b.x - a.x).abs(), (b.y - a.y).abs());
        let r = radius.min(w.min(h) * 0.5);
        if r <= 0.0 {
            return Self::rectangle(a, b);
        }
        let low = Point2::new(a.x.min(b.x), a.y.min(b.y));
        let corner = FRAC_PI_8.tan();
        let at = |x: f64, y: f64, bulge: f64| Vertex { at: low + Vec2::new(x, y), bulge };
        let round = vec![
            at(r, 0.0, 0.0),
            at(w - r, 0.0, corner),
            at(w, r, 0.0),
            at(w, h - r, corner),
            at(w - r, h, 0.0),
            at(r, h, corner),
            at(0.0, h - r, 0.0),
            at(0.0, r, corner),
        ];
        Self::closed(round).tidied()
    }

    /// An arc about a centre, from a mathematical angle over a sweep (radians, counter-clockwise
    /// positive). A full turn or more gives the closed circle from that angle.
    pub fn arc(centre: Point2, radius: f64, from_rad: f64, sweep_rad: f64) -> Self {
        let start = centre + Vec2::from_angle(from_rad) * radius;
        if sweep_rad.abs() >= std::f64::consts::TAU {
            let bulge = sweep_rad.signum();
            let across = centre + (centre - start);
            return Self::closed([start, across].map(|at| Vertex { at, bulge }).to_vec());
        }
        let end = centre + Vec2::from_angle(from_rad + sweep_rad) * radius;
        let arc = Segment::Arc { start, end, centre, radius, sweep_rad };
        Self::from_segments(&[arc], false).with_short_arcs()
    }
}
