//! Rings at growing distance from the contours.

use crate::{Cutter, PocketError};
use kerf_geom::{Bounds2, Coarse, GeomError, OffsetPath, Offsetter, Polyarc};

/// More rings one inside the other than this are a slip of the decimal point.
pub(crate) const MOST_RINGS: f64 = 20_000.0;

/// The rings of a region by how deep they lie inside it, level 0 at half the tool's diameter.
pub(crate) struct Levels {
    /// Rings of each level, in the directions of the contours: outer ones counter-clockwise.
    pub rings: Vec<Vec<Polyarc>>,
}

/// Offsets, and the coarsest of those that could not be exact.
pub(crate) struct Offsets<'o> {
    offsetter: &'o Offsetter<'o>,
    pub coarse: Option<Coarse>,
}

impl<'o> Offsets<'o> {
    pub fn new(offsetter: &'o Offsetter<'o>) -> Self {
        Self { offsetter, coarse: None }
    }

    /// The contours of what lies at least so deep inside a region.
    pub fn inset(&mut self, region: &[Polyarc], depth: f64) -> Result<Vec<Polyarc>, GeomError> {
        Ok(self.noted(self.offsetter.region(region, -depth)?))
    }

    /// The contours of what lies no farther than a distance outside rings.
    pub fn outset(&mut self, rings: &[Polyarc], by: f64) -> Result<Vec<Polyarc>, GeomError> {
        Ok(self.noted(self.offsetter.region(rings, by)?))
    }

    fn noted(&mut self, found: Vec<OffsetPath>) -> Vec<Polyarc> {
        let within = |coarse: &Option<Coarse>| coarse.map_or(0.0, |coarse| coarse.within_mm);
        let coarse = Coarse::of(&found);
        if within(&coarse) > within(&self.coarse) {
            self.coarse = coarse;
        }
        found.into_iter().map(|found| found.path).collect()
    }
}

impl Levels {
    /// All levels until nothing is left.
    pub fn of(
        region: &[Polyarc],
        cutter: &Cutter,
        offsets: &mut Offsets,
    ) -> Result<Self, PocketError> {
        if let Some(contour) = region.iter().position(|contour| !contour.closed) {
            return Err(PocketError::Open { contour });
        }
        let most = most(region, cutter)?;
        let mut rings = Vec::new();
        while rings.len() <= most {
            let found = offsets.inset(region, depth(cutter, rings.len()))?;
            if found.is_empty() {
                return Ok(Self { rings });
            }
            rings.push(found);
        }
        Err(PocketError::Directions)
    }
}

/// Returns the depth at which the rings of a level lie.
pub(crate) fn depth(cutter: &Cutter, level: usize) -> f64 {
    cutter.first_depth_mm() + level as f64 * cutter.step_mm()
}

/// Returns the number of levels there may be: none lies deeper than half the width of all.
fn most(region: &[Polyarc], cutter: &Cutter) -> Result<usize, PocketError> {
    let mut bounds = Bounds2::default();
    region.iter().for_each(|contour| bounds.merge(&contour.bounds()));
    let size = bounds.size();
    let rings = (0.5 * size.x.min(size.y) / cutter.step_mm()).ceil().max(0.0);
    if rings > MOST_RINGS { Err(PocketError::TooMany { rings }) } else { Ok(rings as usize + 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_coarsest_offset_is_told() {
        let path = |within_mm| OffsetPath { path: Polyarc::default(), origins: vec![], within_mm };
        let offsetter = Offsetter::default();
        let mut offsets = Offsets::new(&offsetter);
        for (within, told) in
            [(1e-6, None), (1e-3, Some(1e-3)), (1e-4, Some(1e-3)), (1e-6, Some(1e-3))]
        {
            offsets.noted(vec![path(1e-6), path(within)]);
            assert_eq!(offsets.coarse.map(|coarse| coarse.within_mm), told);
        }
        let told = offsets.coarse.map(|coarse| coarse.to_string());
        let text = "its offset could not be made exactly: it may be off by 0.001 mm";
        assert_eq!(told.as_deref(), Some(text));
    }
}
