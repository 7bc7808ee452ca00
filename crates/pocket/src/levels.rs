//! Rings at growing distance from the contours.

use crate::{Cutter, PocketError};
use kerf_geom::{Bounds2, GeomError, Polyarc, offset_region};

/// More rings one inside the other than this are a slip of the decimal point.
pub(crate) const MOST_RINGS: f64 = 20_000.0;

/// The rings of a region by how deep they lie inside it, level 0 at half the tool's diameter.
pub(crate) struct Levels {
    /// Rings of each level, in the directions of the contours: outer ones counter-clockwise.
    pub rings: Vec<Vec<Polyarc>>,
}

impl Levels {
    /// All levels until nothing is left.
    pub fn of(region: &[Polyarc], cutter: &Cutter) -> Result<Self, PocketError> {
        if let Some(contour) = region.iter().position(|contour| !contour.closed) {
            return Err(PocketError::Open { contour });
        }
        let most = most(region, cutter)?;
        let mut rings = Vec::new();
        while rings.len() <= most {
            let found = inset(region, depth(cutter, rings.len()))?;
            if found.is_empty() {
                return Ok(Self { rings });
            }
            rings.push(found);
        }
        Err(PocketError::Directions)
    }
}

/// How deep the rings of a level lie.
pub(crate) fn depth(cutter: &Cutter, level: usize) -> f64 {
    cutter.first_depth_mm() + level as f64 * cutter.step_mm()
}

/// The contours of what lies at least so deep inside a region.
pub(crate) fn inset(region: &[Polyarc], depth: f64) -> Result<Vec<Polyarc>, GeomError> {
    let found = offset_region(region, -depth)?;
    Ok(found.into_iter().map(|found| found.path).collect())
}

/// How many levels there may be: none lies deeper than half the width of all.
fn most(region: &[Polyarc], cutter: &Cutter) -> Result<usize, PocketError> {
    let mut bounds = Bounds2::default();
    region.iter().for_each(|contour| bounds.merge(&contour.bounds()));
    let size = bounds.size();
    let rings = (0.5 * size.x.min(size.y) / cutter.step_mm()).ceil().max(0.0);
    if rings > MOST_RINGS { Err(PocketError::TooMany { rings }) } else { Ok(rings as usize + 1) }
}
