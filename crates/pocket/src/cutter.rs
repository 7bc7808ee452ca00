//! The tool, and how it goes about its work.

use crate::PocketError;
use serde::{Deserialize, Serialize};

/// A round tool and how far its paths lie apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutter {
    diameter_mm: f64,
    step_mm: f64,
}

impl Cutter {
    /// A tool of that diameter whose neighbouring paths overlap by so much.
    ///
    /// # Errors
    /// A diameter that is not above 0, and an overlap that is not between 0 and the diameter.
    pub fn new(diameter_mm: f64, overlap_mm: f64) -> Result<Self, PocketError> {
        let refused = |what, value, bound| Err(PocketError::Bound { what, value, bound });
        if !(diameter_mm > 0.0 && diameter_mm.is_finite()) {
            return refused("the diameter of the tool", diameter_mm, "above 0");
        }
        if !(0.0..diameter_mm).contains(&overlap_mm) {
            return refused(
                "the overlap",
                overlap_mm,
                "0 or more and below the diameter of the tool",
            );
        }
        Ok(Self { diameter_mm, step_mm: diameter_mm - overlap_mm })
    }

    /// Width of its cut.
    pub fn diameter_mm(&self) -> f64 {
        self.diameter_mm
    }

    /// Half of that.
    pub fn radius_mm(&self) -> f64 {
        0.5 * self.diameter_mm
    }

    /// Distance between neighbouring paths.
    pub fn step_mm(&self) -> f64 {
        self.step_mm
    }

    /// Depth of the first ring inside a contour. It is half the diameter, but for [`JUST_FITS_MM`], or for
    /// 1/10,000 of the radius where that is less.
    pub(crate) fn first_depth_mm(&self) -> f64 {
        self.radius_mm() - JUST_FITS_MM.min(1e-4 * self.radius_mm())
    }
}

/// A slot exactly as wide as the tool has no width left for its path. A tenth of a micrometre, which no
/// machine shows, makes sure that it is cut.
pub(crate) const JUST_FITS_MM: f64 = 1e-4;

/// Manner in which the tool goes about its work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CutDirection {
    /// With the material on the right of travel, which is climb milling for a spindle that turns
    /// clockwise: counter-clockwise along the outer wall, clockwise round islands. Else the other way.
    pub climb: bool,
    /// From the middle to the wall; else from the wall to the middle.
    pub outward: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlaps_out_of_bounds_are_refused() {
        let told =
            |d, v| Cutter::new(d, v).map_or_else(|e| e.to_string(), |c| c.step_mm().to_string());
        assert_eq!(told(5.0, 0.1), "4.9");
        assert_eq!(told(0.0, 0.0), "the diameter of the tool is 0 mm: it must be above 0");
        let bound = "it must be 0 or more and below the diameter of the tool";
        assert_eq!(told(5.0, 5.0), format!("the overlap is 5 mm: {bound}"));
        assert_eq!(told(5.0, -0.1), format!("the overlap is -0.1 mm: {bound}"));
        assert_eq!(told(5.0, f64::NAN), format!("the overlap is NaN mm: {bound}"));
    }
}
