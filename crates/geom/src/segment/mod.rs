//! One line or circular arc.
//!
//! ```text
//!            · ─ ‥ apex
//!         ·   |     ·        bulge = rise / half the chord = tan(sweep / 4)
//!       ·     | rise  ·      an arc with positive bulge runs counter-clockwise,
//!    end ─────┴───── start   so it lies to the right of its chord
//! ```

mod meet;
mod near;
mod nearest;

pub use meet::{Contact, Contacts};
pub(crate) use near::comes_nearer;
pub use nearest::Foot;
pub(crate) use nearest::square;

use crate::{Arc2, Point2, Vec2, tol};
use serde::{Deserialize, Serialize};

/// A line or an arc, with the direction it is travelled.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Segment {
    /// Straight from start to end.
    Line {
        /// Start of travel.
        start: Point2,
        /// End of travel.
        end: Point2,
    },
    /// Along a circle; less than a full turn.
    Arc {
        /// Start of travel.
        start: Point2,
        /// End of travel.
        end: Point2,
        /// Centre of the circle.
        centre: Point2,
        /// Radius of the circle.
        radius: f64,
        /// Angle travelled, positive counter-clockwise.
        sweep_rad: f64,
    },
}

impl Segment {
    /// A straight segment.
    pub const fn line(start: Point2, end: Point2) -> Self {
        Self::Line { start, end }
    }

    /// The curve from `start` to `end` with a bulge; flatter than [`tol::FLAT_MM`] it is a line.
    ///
    /// With half chord h the rise is b·h, the radius h·(1 + b²) / 2|b|, and the centre lies
    /// h·(1 − b²) / 2b to the left of the middle of the chord.
    pub fn bulged(start: Point2, end: Point2, bulge: f64) -> Self {
        if bulge == 0.0 {
            return Self::Line { start, end };
        }
        let chord = end - start;
        let half = square(chord).sqrt() * 0.5;
        if (bulge * half).abs() < tol::FLAT_MM {
            return Self::Line { start, end };
        }
        let square = bulge * bulge;
        let centre = start.midpoint(end) + chord.left() * ((1.0 - square) / (4.0 * bulge));
        let radius = half * (1.0 + square) / (2.0 * bulge.abs());
        Self::Arc { start, end, centre, radius, sweep_rad: 4.0 * bulge.atan() }
    }

    /// The bulge of the arc from `start` to `end` through a third place: the tangent of half the angle by
    /// which the second chord turns off the first (readings, Bulge).
    pub fn bulge_through(start: Point2, via: Point2, end: Point2) -> f64 {
        let (first, second) = (via - start, end - via);
        let turn = first.cross(second).atan2(first.dot(second));
        (0.5 * turn).tan()
    }

    /// The arc through three places in order, or the line where the second lies on the chord of the others;
    /// nothing where they are on one line in another order, or the first is the last.
    ///
    /// ```
    /// use kerf_geom::{Point2, Segment};
    /// let places = [(0.0, 0.0), (5.0, -5.0), (10.0, 0.0)].map(|(x, y)| Point2::new(x, y));
    /// let arc = Segment::through(places[0], places[1], places[2]).unwrap();
    /// assert!((arc.bulge() - 1.0).abs() < 1e-12);
    /// ```
    pub fn through(start: Point2, via: Point2, end: Point2) -> Option<Self> {
        let (bulge, chord) = (Self::bulge_through(start, via, end), start.distance(end));
        let rises = 0.5 * bulge.abs() * chord;
        let there_is = chord > tol::SAME_PLACE_MM && rises <= tol::FARTHEST_MM;
        there_is.then(|| Self::bulged(start, end, bulge))
    }

    /// Returns the place where travel begins.
    pub const fn start(&self) -> Point2 {
        match *self {
            Self::Line { start, .. } | Self::Arc { start, .. } => start,
        }
    }

    /// Returns the place where travel ends.
    pub const fn end(&self) -> Point2 {
        match *self {
            Self::Line { end, .. } | Self::Arc { end, .. } => end,
        }
    }

    /// tan(sweep / 4); 0 for a line.
    pub fn bulge(&self) -> f64 {
        match *self {
            Self::Line { .. } => 0.0,
            Self::Arc { sweep_rad, .. } => (sweep_rad * 0.25).tan(),
        }
    }

    /// Length of the path.
    pub fn length(&self) -> f64 {
        match *self {
            Self::Line { start, end } => square(end - start).sqrt(),
            Self::Arc { radius, sweep_rad, .. } => radius * sweep_rad.abs(),
        }
    }

    /// The place after a share of the path, 0 … 1. The ends are exact.
    pub fn at(&self, share: f64) -> Point2 {
        if share <= 0.0 {
            return self.start();
        }
        if share >= 1.0 {
            return self.end();
        }
        match *self {
            Self::Line { start, end } => start + (end - start) * share,
            Self::Arc { start, centre, sweep_rad, .. } => {
                centre + (start - centre).rotated(sweep_rad * share)
            }
        }
    }

    /// The place halfway along.
    ///
    /// Off the middle of the chord by the rise, c²/4 / (r + √(r² − c²/4)); near half a circle the root loses its
    /// digits.
    pub(crate) fn middle(&self) -> Point2 {
        match *self {
            Self::Line { start, end } => start.midpoint(end),
            Self::Arc { start, end, radius, sweep_rad, .. } if sweep_rad.abs() < 2.5 => {
                let chord = end - start;
                let quarter = 0.25 * square(chord);
                let depth = (radius * radius - quarter).sqrt();
                let share = 0.5 * quarter.sqrt() / (radius + depth);
                start.midpoint(end) - chord.left() * (share * sweep_rad.signum())
            }
            Self::Arc { .. } => self.at(0.5),
        }
    }

    /// Unit direction of travel after a share of the path; null for a segment without length.
    pub fn direction(&self, share: f64) -> Vec2 {
        match *self {
            Self::Line { start, end } => unit(end - start),
            Self::Arc { start, end, centre, sweep_rad, .. } => {
                let radial = match share {
                    s if s <= 0.0 => start - centre,
                    s if s >= 1.0 => end - centre,
                    s => (start - centre).rotated(sweep_rad * s),
                };
                unit(radial.left()) * sweep_rad.signum()
            }
        }
    }

    /// Travelled the other way.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match *self {
            Self::Line { start, end } => Self::Line { start: end, end: start },
            Self::Arc { start, end, centre, radius, sweep_rad } => {
                Self::Arc { start: end, end: start, centre, radius, sweep_rad: -sweep_rad }
            }
        }
    }

    /// The part between two shares of the path.
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        if from <= 0.0 && to >= 1.0 {
            return *self;
        }
        let (start, end) = (self.at(from), self.at(to));
        match *self {
            Self::Line { .. } => Self::Line { start, end },
            Self::Arc { centre, radius, sweep_rad, .. } => {
                Self::Arc { start, end, centre, radius, sweep_rad: sweep_rad * (to - from) }
            }
        }
    }

    /// Puts the start elsewhere, by less than anyone can tell: to the very place where the segment
    /// before ends.
    pub(crate) fn move_start(&mut self, place: Point2) {
        match self {
            Self::Line { start, .. } | Self::Arc { start, .. } => *start = place,
        }
    }

    /// The parts before and after a share of the path.
    pub fn split(&self, share: f64) -> (Self, Self) {
        (self.part(0.0, share), self.part(share, 1.0))
    }

    /// The arc, or nothing for a line.
    pub fn arc(&self) -> Option<Arc2> {
        match *self {
            Self::Line { .. } => None,
            Self::Arc { start, centre, sweep_rad, .. } => Some(Arc2 { start, centre, sweep_rad }),
        }
    }

    /// Share of the path at which a place of the arc's circle (or of the line) lies, without regard to
    /// the ends: below 0 before the start, above 1 after the end.
    pub fn share_of(&self, place: Point2) -> f64 {
        match *self {
            Self::Line { start, end } => {
                let along = end - start;
                let square = along.dot(along);
                if square > 0.0 { (place - start).dot(along) / square } else { 0.0 }
            }
            Self::Arc { start, centre, sweep_rad, .. } => {
                let from = start - centre;
                let to = place - centre;
                let turned = from.cross(to).atan2(from.dot(to)) * sweep_rad.signum();
                let sweep = sweep_rad.abs();
                // Out of the arc counts from the nearer end.
                let beyond = (std::f64::consts::TAU - sweep) * 0.5;
                let turned = if turned < -beyond { turned + std::f64::consts::TAU } else { turned };
                turned / sweep
            }
        }
    }
}

/// The unit vector along another; null for the null vector.
fn unit(v: Vec2) -> Vec2 {
    let long = square(v).sqrt();
    if long > 0.0 { v / long } else { Vec2::default() }
}

/// Twice the signed area between a curve with a bulge and its chord, positive counter-clockwise:
/// r²·(u − sin u), where u = 4 atan b is the angle, r² = c²·(1 + b²)² / 16b² and r²·sin u = c²·(1 − b²) / 4b. The
/// length c of the chord is given squared.
pub(crate) fn twice_cap_area(chord_squared: f64, bulge: f64) -> f64 {
    let square = bulge * bulge;
    if 0.25 * square * chord_squared < tol::FLAT_MM * tol::FLAT_MM {
        return 0.0;
    }
    let (sweep, turned) = (4.0 * bulge.atan(), (1.0 + square) * (1.0 + square) / (16.0 * square));
    if sweep.abs() > 0.05 {
        return chord_squared * (turned * sweep - (1.0 - square) / (4.0 * bulge));
    }
    // The difference would lose its digits: the first terms of its series.
    let turn = sweep * sweep;
    chord_squared * turned * sweep * turn * (1.0 - turn / 20.0 * (1.0 - turn / 42.0)) / 6.0
}

#[cfg(test)]
mod tests;
