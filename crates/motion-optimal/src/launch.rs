//! The first and last bit of path, between rest and the spline of speeds.

use crate::bounds::{Bounds, USED};
use crate::cells::{Cell, Frame};
use crate::leg::Leg;

/// Share of the path to the next change of its polynomials that a launch may take.
const SHARE: f64 = 0.9;

/// On a curve it is so short that what the curve asks for is no more than this share of what the
/// way itself does: by its curvature, and by how that changes.
const BENT: f64 = 0.02;

/// A bit of path made with constant jerk from rest, or to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Launch {
    /// Its length, mm.
    pub way_mm: f64,
    /// Greatest squared speed at its fast end.
    pub most: f64,
}

impl Launch {
    /// With limits along it.
    fn new(way_mm: f64, accel: f64, jerk: f64) -> Self {
        let root = (4.5 * jerk * USED * way_mm * way_mm).cbrt();
        Self { way_mm, most: (root * root).min(1.5 * way_mm * accel) }
    }

    /// From rest where a cell begins.
    pub fn into<const N: usize>(
        cell: &Cell<N>,
        bounds: &Bounds<N>,
        jerk: &[f64; N],
        legs: &[Leg],
    ) -> Self {
        Self::at(&cell.frame, cell, bounds, jerk, legs)
    }

    /// To rest where a cell ends.
    pub fn out_of<const N: usize>(
        cell: &Cell<N>,
        bounds: &Bounds<N>,
        jerk: &[f64; N],
        legs: &[Leg],
    ) -> Self {
        Self::at(&cell.frame.after(cell.h), cell, bounds, jerk, legs)
    }

    /// With s̈ = j·t the jerk of an axis is q′·j + 3·q″·ṡ·s̈ + q‴·ṡ³ = (q′ + 9·q″·w + 4.5·q‴·w²)·j
    /// after the way w, and its acceleration (q′ + 1.5·q″·w)·s̈.
    fn at<const N: usize>(
        rest: &Frame<N>,
        cell: &Cell<N>,
        bounds: &Bounds<N>,
        jerk: &[f64; N],
        legs: &[Leg],
    ) -> Self {
        let least = |w: f64, limits: &[f64; N], bent: f64, twisted: f64| {
            let share = |k: usize| {
                let [p, c, d] = [rest.slope[k], rest.bend[k], rest.twist[k]].map(f64::abs);
                p + (1.0 + bent) * w * (c + w * d) + twisted * w * w * d
            };
            (0..N).map(|k| limits[k] / share(k)).fold(f64::INFINITY, f64::min)
        };
        let [a, j] = [&bounds.accel, jerk].map(|limits| least(0.0, limits, 0.0, 0.0));
        let mut w = (a * a * a / (6.0 * j * j)).min(SHARE * cell.h);
        for k in 0..N {
            w = w.min(BENT / rest.bend[k].abs()).min((BENT / rest.twist[k].abs()).sqrt());
        }
        let [v, a] = [(&bounds.speed, 0.0), (&bounds.accel, 1.5)]
            .map(|(limits, bent)| least(w, limits, bent, 0.0));
        let launch = Self::new(w, a, least(w, jerk, 9.0, 4.5));
        let stretch = 1.0 + BENT;
        let feed = legs[cell.owner as usize].feed_cap(&rest.slope.map(|p| p * stretch));
        Self { most: launch.most.min(feed).min(v * v), ..launch }
    }

    /// The outer ordinate as a share of the middle one of the piece that joins.
    pub fn share(&self, h: f64) -> f64 {
        1.0 / (1.0 + 2.0 * h / (3.0 * self.way_mm))
    }

    /// The jerk with which a squared speed is reached.
    pub fn jerk(&self, x: f64) -> f64 {
        x.powf(1.5) / (4.5 * self.way_mm * self.way_mm)
    }

    /// Returns the time it takes to reach a squared speed.
    pub fn takes_s(&self, x: f64) -> f64 {
        (6.0 * self.way_mm / self.jerk(x)).cbrt()
    }
}

/// End of a window: at rest or in motion.
#[derive(Clone, Copy, Debug)]
pub(crate) enum End {
    /// Rest, and the way from it or to it.
    Rest(Launch),
    /// Motion at a squared speed that is known, and s̈.
    Motion([f64; 2]),
}

impl End {
    /// Returns the length of path that it takes.
    pub const fn way_mm(&self) -> f64 {
        match self {
            Self::Rest(launch) => launch.way_mm,
            Self::Motion(_) => 0.0,
        }
    }
}
