//! How deep each pass goes.

use kerf_drawing::{GroupSettings, Height};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The three heights of a machine, millimetres, upwards.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Heights {
    /// Where the tool travels.
    pub top_mm: f64,
    /// The surface of the material.
    pub surface_mm: f64,
    /// The lowest the tool may go; where THRU cuts.
    pub bottom_mm: f64,
}

impl Default for Heights {
    /// Those of the machine of the Profiler notes (SIM).
    fn default() -> Self {
        Self { top_mm: -10.0, surface_mm: -20.0, bottom_mm: -30.0 }
    }
}

/// A cut below ZBottom.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("it would be cut at {z_mm}, below ZBottom: {z_mm} < {bottom_mm}")]
pub struct LowError {
    /// Where it would be cut.
    pub z_mm: f64,
    /// ZBottom.
    pub bottom_mm: f64,
}

/// Heights at which a path is cut, in order.
#[derive(Clone, Debug, PartialEq)]
pub enum Depths {
    /// At these heights, one pass each.
    Level(Vec<f64>),
    /// At the height of each point, measured from here.
    Along(f64),
}

impl Depths {
    /// The passes of a group. Multi-pass divides a depth below the surface into equal steps with a
    /// last one that is smaller; above the surface there is one pass (Profiler notes, 3.8).
    ///
    /// # Errors
    /// A pass lies below ZBottom.
    pub fn of(settings: &GroupSettings, heights: &Heights) -> Result<Self, LowError> {
        let Heights { surface_mm, bottom_mm, .. } = *heights;
        let levels = match settings.height {
            Height::Thru => vec![bottom_mm],
            Height::ThreeD => return Ok(Self::Along(surface_mm)),
            Height::Mm(depth) => steps(depth, settings.pass_mm).map(|z| surface_mm + z).collect(),
        };
        match levels.iter().find(|z| **z < bottom_mm) {
            Some(z) => Err(LowError { z_mm: *z, bottom_mm }),
            None => Ok(Self::Level(levels)),
        }
    }
}

/// The most passes of one path: more are a slip of the decimal point.
const MOST_PASSES: f64 = 10_000.0;

fn steps(depth: f64, pass: Option<f64>) -> impl Iterator<Item = f64> {
    let pass = pass.filter(|pass| depth < 0.0 && *pass > 0.0).unwrap_or(depth.abs());
    let count = (depth.abs() / pass).ceil().clamp(1.0, MOST_PASSES) as u32;
    (1..=count).map(move |k| if k == count { depth } else { depth.signum() * pass * f64::from(k) })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn depths(height: Height, pass_mm: Option<f64>, bottom_mm: f64) -> Result<Depths, LowError> {
        let settings = GroupSettings { height, pass_mm, ..Default::default() };
        Depths::of(&settings, &Heights { bottom_mm, ..Default::default() })
    }

    fn check(height: Height, pass_mm: Option<f64>, expected: &[f64]) {
        assert_eq!(depths(height, pass_mm, -35.0), Ok(Depths::Level(expected.to_vec())));
    }

    #[test]
    fn pro_group_multi() {
        check(Height::Mm(-13.0), Some(4.0), &[-24.0, -28.0, -32.0, -33.0]);
    }

    #[test]
    fn pro_group_multi_dist() {
        check(Height::Mm(-12.0), Some(4.0), &[-24.0, -28.0, -32.0]);
        check(Height::Mm(-3.0), Some(4.0), &[-23.0]);
        let zero =
            GroupSettings { height: Height::Mm(-3.0), pass_mm: Some(0.0), ..Default::default() };
        assert!(zero.check().is_err());
    }

    #[test]
    fn pro_group_h_thru() {
        check(Height::Thru, None, &[-35.0]);
        assert!(kerf_drawing::Drawing::default().groups.iter().all(|g| g.height == Height::Thru));
    }

    #[test]
    fn pro_group_h_mm_neg() {
        check(Height::Mm(-2.5), None, &[-22.5]);
    }

    #[test]
    fn pro_group_h_mm_pos() {
        check(Height::Mm(3.0), None, &[-17.0]);
        check(Height::Mm(3.0), Some(1.0), &[-17.0]);
    }

    #[test]
    fn pro_group_multi_limit() {
        let error = depths(Height::Mm(-13.0), None, -30.0).unwrap_err();
        assert!(error.to_string().ends_with("-33 < -30"), "{error}");
    }
}
