//! The depth of each pass.

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Depth of a cut, by what it is measured from (Profiler reference, "Height type").
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CutDepth {
    /// Through the material: at ZBottom.
    #[default]
    Thru,
    /// So many millimetres above ZSurface; negative is into the material.
    Mm(f64),
    /// The height of each point of the shape, measured from ZSurface.
    #[serde(rename = "3d")]
    ThreeD,
}

/// The three heights of a machine, millimetres, upwards; on the machine from Z home, below it negative (Profiler
/// reference, "Special Z Axis Positions"). Top ≥ surface ≥ bottom.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Heights {
    /// Height at which the tool travels, between shapes and when not machining.
    pub top_mm: f64,
    /// The surface of the material: zero of cutting heights.
    pub surface_mm: f64,
    /// The lowest the tool may go; where THRU cuts.
    pub bottom_mm: f64,
}

impl Default for Heights {
    /// Those of the machine SIM (readings, SIM).
    fn default() -> Self {
        Self { top_mm: -10.0, surface_mm: -20.0, bottom_mm: -30.0 }
    }
}

/// A cut below ZBottom.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("it would be cut at {z_mm} mm, below ZBottom at {bottom_mm} mm")]
pub struct LowError {
    /// Height at which it would be cut.
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
    /// The passes of a shape. Multi-pass divides a depth below the surface into equal steps with a
    /// last one that is smaller; above the surface there is one pass (readings, Depths).
    ///
    /// `pass_mm` is the depth of one pass, all at once without it; `z_mm` are the heights of the shape's points above
    /// the surface, flat ones have none.
    ///
    /// # Errors
    /// A pass or a point lies below ZBottom.
    pub fn of(
        height: CutDepth,
        pass_mm: Option<f64>,
        z_mm: &[f64],
        heights: &Heights,
    ) -> Result<Self, LowError> {
        let Heights { surface_mm, bottom_mm, .. } = *heights;
        let levels = match height {
            CutDepth::Thru => vec![bottom_mm],
            CutDepth::ThreeD => {
                let lowest = surface_mm + z_mm.iter().copied().fold(0.0, f64::min);
                // Heights that were moved onto ZBottom are rounded.
                if lowest < bottom_mm - ROUNDED_MM {
                    return Err(LowError { z_mm: lowest, bottom_mm });
                }
                return Ok(Self::Along(surface_mm));
            }
            CutDepth::Mm(depth_mm) => steps(depth_mm, pass_mm).map(|z| surface_mm + z).collect(),
        };
        match levels.iter().find(|z| **z < bottom_mm) {
            Some(z) => Err(LowError { z_mm: *z, bottom_mm }),
            None => Ok(Self::Level(levels)),
        }
    }
}

/// Heights that differ by less are one, millimetres.
const ROUNDED_MM: f64 = 1e-6;

/// The most passes of one path: more are a slip of the decimal point.
const MOST_PASSES: f64 = 10_000.0;

fn steps(depth: f64, pass: Option<f64>) -> impl Iterator<Item = f64> {
    let pass = pass.filter(|pass| depth < 0.0 && *pass > 0.0).unwrap_or(depth.abs());
    // At the surface itself there is one pass.
    let count =
        if depth == 0.0 { 1.0 } else { (depth.abs() / pass).ceil().clamp(1.0, MOST_PASSES) };
    // More passes than there may be are made deeper, all of them.
    let pass = pass.max(depth.abs() / count);
    let count = count as u32;
    (1..=count).map(move |k| if k == count { depth } else { depth.signum() * pass * f64::from(k) })
}
