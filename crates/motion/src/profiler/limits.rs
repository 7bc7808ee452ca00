//! Limits on the speed of one move and on its ramps: every axis within its speed and acceleration,
//! curves within the centripetal share, cuts within the speed of their direction.

use super::spline::curvature;
use crate::moves::{Basis, Move, Path};
use kerf_program::{Axes, Dynamics, MoveKind, Smoothing};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Places at which a curve is looked at; the first and last are its ends.
const PLACES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Limits of the machine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits<'a> {
    pub dynamics: &'a Dynamics,
    pub smoothing: &'a Smoothing,
}

impl Limits<'_> {
    /// The greatest speed of a move along its reference length, mm/s.
    pub fn speed_mm_s(&self, m: &Move) -> f64 {
        let share = self.greatest_shares(m);
        let v = slowest(&self.dynamics.speed_mm_s, &share).min(m.top_mm_s());
        let v = v.min(self.centripetal_mm_s(m));
        if m.kind == MoveKind::Cut { v.min(self.directional_mm_s(m)) } else { v }
    }

    /// The acceleration of a move along its reference length, mm/s².
    pub fn accel_mm_s2(&self, m: &Move) -> f64 {
        slowest(&self.dynamics.accel_mm_s2, &self.greatest_shares(m))
    }

    /// Returns the greatest speed of each axis, for a speed of 1 along the reference length.
    fn greatest_shares(&self, m: &Move) -> Axes {
        let mut share = match m.path {
            Path::Line => m.derivative(0.0),
            // On the way round either axis goes as fast as the tool, or nearly.
            Path::Arc { .. } => {
                let mut share = m.derivative(0.0);
                let xy = share.0[0].hypot(share.0[1]);
                (share.0[0], share.0[1]) = (xy, xy);
                share
            }
            Path::Curve { .. } => PLACES
                .into_iter()
                .map(|u| Axes(m.derivative(u).0.map(f64::abs)))
                .fold(Axes::default(), |a, b| a.zip(b, f64::max)),
        };
        share.0 = share.0.map(|v| v.abs() / m.length_mm);
        share
    }

    /// The speed at which the acceleration towards the centre is the share that is allowed.
    fn centripetal_mm_s(&self, m: &Move) -> f64 {
        let [x, y, ..] = self.dynamics.accel_mm_s2.0;
        let accel = 0.01 * self.smoothing.centripetal_percent * x.min(y);
        let limit = |u: f64| {
            let (slope, bend) = (m.derivative(u).first3(), m.second_derivative(u).first3());
            let along = slope.iter().map(|v| v * v).sum::<f64>().sqrt() / m.length_mm;
            let curvature = curvature(slope, bend);
            if curvature > 0.0 { (accel / curvature).sqrt() / along } else { f64::INFINITY }
        };
        match m.path {
            Path::Line => f64::INFINITY,
            Path::Arc { .. } => limit(0.0),
            Path::Curve { .. } => PLACES.into_iter().map(limit).fold(f64::INFINITY, f64::min),
        }
    }

    /// The highest cutting speed in the directions of a move (Profiler reference, "Maximum Machine
    /// Cutting Speeds").
    fn directional_mm_s(&self, m: &Move) -> f64 {
        if matches!(m.basis, Basis::Axis(_) | Basis::Rotary) {
            return f64::INFINITY;
        }
        let x_mm_s = self.smoothing.cut_speed_mm_s.unwrap_or(self.dynamics.speed_mm_s.0[0]);
        let share = |u: f64| {
            let [x, y, _] = m.derivative(u).first3().map(f64::abs);
            self.smoothing.speed_share(y.atan2(x))
        };
        // The share goes evenly with the angle: it is least at an end, or along an axis.
        let mut least = share(0.0).min(share(1.0));
        if let Path::Arc { sweep_rad, .. } = m.path {
            let slope = m.derivative(0.0);
            let passed = passed_axes(slope.0[1].atan2(slope.0[0]), sweep_rad);
            for axis in [0, 1].into_iter().filter(|k| passed[*k]) {
                least = least.min(self.smoothing.speed_share(axis as f64 * FRAC_PI_2));
            }
        }
        x_mm_s * least
    }
}

/// Tells for X and Y whether a direction that turns passes them, whichever way along them.
fn passed_axes(from_rad: f64, turn_rad: f64) -> [bool; 2] {
    let (low, high) = if turn_rad < 0.0 {
        (from_rad + turn_rad, from_rad)
    } else {
        (from_rad, from_rad + turn_rad)
    };
    let passes = |offset: f64| {
        let next = ((low - offset) / (0.5 * TAU)).ceil() * 0.5 * TAU + offset;
        next <= high
    };
    [passes(0.0), passes(FRAC_PI_2)]
}

/// The speed, or acceleration, at which no axis exceeds its own.
fn slowest(own: &Axes, share: &Axes) -> f64 {
    let limit = own.zip(*share, |own, share| if share > 0.0 { own / share } else { f64::INFINITY });
    limit.0.into_iter().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::passed_axes;

    #[test]
    fn a_direction_that_turns_passes_axes_either_way() {
        for (from, turn, passed) in [
            (10.0, 20.0, [false, false]),
            (10.0, -20.0, [true, false]),
            (80.0, 20.0, [false, true]),
            (100.0, -20.0, [false, true]),
            (-10.0, 200.0, [true, true]),
            (190.0, -200.0, [true, true]),
        ] {
            let got = passed_axes(f64::to_radians(from), f64::to_radians(turn));
            assert_eq!(got, passed, "{from} {turn}");
        }
    }
}
