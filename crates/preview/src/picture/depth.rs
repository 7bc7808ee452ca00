//! The scale of depth: which shade a height has.

use crate::palette::{Rgb, depth_colour};

/// Number of shades between the surface and the deepest cut.
pub const SHADES: usize = 16;

/// Heights nearer than this are one, mm.
const SAME_MM: f64 = 1.0e-6;

/// From the surface down to the deepest cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthScale {
    /// Height of the first shade, mm.
    pub top: f64,
    /// Height of the deepest cut, mm.
    pub bottom: f64,
}

impl DepthScale {
    /// The scale for cuts between `lowest` and `highest`.
    ///
    /// A program that never goes below the surface (a plotter's, or one whose zero is the table)
    /// is shaded from its highest cut down.
    pub fn new(surface: f64, lowest: f64, highest: f64) -> Self {
        if !(lowest.is_finite() && highest.is_finite()) {
            return Self { top: 0.0, bottom: 0.0 };
        }
        let top = if surface > lowest + SAME_MM { surface } else { highest };
        Self { top, bottom: lowest }
    }

    /// Depth from top to bottom, mm.
    pub fn range(&self) -> f64 {
        self.top - self.bottom
    }

    /// Returns `true` if all cutting is at one height.
    pub fn is_flat(&self) -> bool {
        self.range() <= SAME_MM
    }

    /// 0 at the top, 1 at the bottom; the bottom when flat.
    pub fn share(&self, z: f64) -> f64 {
        if self.is_flat() { 1.0 } else { (self.top - z) / self.range() }
    }

    /// The shade of a height, or nothing above the surface.
    pub fn shade(&self, z: f64) -> Option<usize> {
        if z > self.top + SAME_MM {
            return None;
        }
        let step = (self.share(z) * SHADES as f64 - 1.0e-6).ceil() - 1.0;
        Some(step.clamp(0.0, (SHADES - 1) as f64) as usize)
    }

    /// The shade, or the one of the move before while the height is within half a step of it.
    pub fn steady_shade(&self, z: f64, before: Option<usize>) -> Option<usize> {
        let fresh = self.shade(z)?;
        let held =
            before.filter(|b| (self.share(z) * SHADES as f64 - (*b as f64 + 0.5)).abs() <= 1.0);
        Some(held.unwrap_or(fresh))
    }

    /// The colour of a shade; the first and last are the ends of the ramp.
    pub fn colour(shade: usize) -> Rgb {
        depth_colour(shade as f64 / (SHADES - 1) as f64)
    }

    /// Shares 0 … 1 of a straight change of height at which the shade changes, in order.
    pub fn crossings(&self, from: f64, to: f64) -> Vec<f64> {
        if self.is_flat() || (to - from).abs() <= SAME_MM {
            return Vec::new();
        }
        let step = self.range() / SHADES as f64;
        let edges = (0..SHADES).map(|k| self.top - step * k as f64);
        let mut shares: Vec<f64> = edges
            .map(|z| (z - from) / (to - from))
            .filter(|s| (1.0e-6..1.0 - 1.0e-6).contains(s))
            .collect();
        shares.sort_by(f64::total_cmp);
        shares
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_run_from_surface_to_bottom() {
        let scale = DepthScale::new(0.0, -16.0, 5.0);
        for (z, shade) in
            [(1.0, None), (0.0, Some(0)), (-1.0, Some(0)), (-1.1, Some(1)), (-16.0, Some(15))]
        {
            assert_eq!(scale.shade(z), shade, "{z}");
        }
    }

    #[test]
    fn a_program_above_the_surface_is_shaded_too() {
        let scale = DepthScale::new(0.0, 2.0, 18.0);
        assert_eq!((scale.top, scale.shade(18.0), scale.shade(2.0)), (18.0, Some(0), Some(15)));
    }

    #[test]
    fn one_height_is_the_bottom() {
        let scale = DepthScale::new(0.0, 0.0, 0.0);
        assert!(scale.is_flat());
        assert_eq!(scale.shade(0.0), Some(SHADES - 1));
    }

    #[test]
    fn a_ramp_is_cut_where_the_shade_changes() {
        let scale = DepthScale::new(0.0, -16.0, 5.0);
        assert_eq!(scale.crossings(1.0, -3.0), vec![0.25, 0.5, 0.75]);
        assert_eq!(scale.crossings(-3.0, 1.0), vec![0.25, 0.5, 0.75]);
        assert!(scale.crossings(-4.0, -4.0).is_empty());
    }
}
