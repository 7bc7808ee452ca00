//! Finds what rings leave uncut.
//!
//! ```text
//!  ─────────────────  ring k
//!    ╲·············   more than the radius inside ring k ...
//!     ╲ ╭─────────    ... and not covered by ring k + 1: the cusp in its corner
//!      ╲╯
//!       ┌─────────    ring k + 1
//! ```
//!
//! What lies within the radius of ring k is covered by it. What lies further inside, but outside ring
//! k + 1, can only be covered by ring k + 1; what lies inside ring k + 1 is the next level's business. So
//! this finds all there is.

use crate::Cutter;
use crate::levels::{Levels, Offsets, depth};
use kerf_geom::{Combine, GeomError, Polyarc, combine};

/// Uncut pieces smaller than this are left, square millimetres (readings, Clearing); with tools so small
/// that it would be much, those smaller than a thousandth of the square of the diameter.
pub const SMALLEST_MM2: f64 = 0.01;

/// Distance by which the cover of ring k + 1 is taken to reach further, millimetres, so that with an overlap of
/// nothing the edges of what is compared do not fall together.
const TOUCHING_MM: f64 = 1e-4;

/// The pieces that the rings do not cover, as contours. A stroke along a contour covers its piece: no
/// place of it is farther than the radius from its edge.
pub(crate) fn pieces(
    region: &[Polyarc],
    cutter: &Cutter,
    levels: &Levels,
    offsets: &mut Offsets,
) -> Result<Vec<Polyarc>, GeomError> {
    let mut found = Vec::new();
    // With a step below the radius there is nothing between what one ring and the next one cover.
    if cutter.step_mm() > cutter.radius_mm() {
        for level in 0..levels.rings.len() {
            found.extend(after(region, cutter, (levels, level), offsets)?);
        }
    }
    let smallest = SMALLEST_MM2.min(1e-3 * cutter.diameter_mm().powi(2));
    found.retain(|piece| piece.signed_area().abs() >= smallest);
    Ok(found)
}

/// Returns what the rings of a level leave to the next level, and the next level leaves as well. If the
/// difference cannot be computed, the edge of all that is left is followed: too long a way, but nothing remains.
fn after(
    region: &[Polyarc],
    cutter: &Cutter,
    (levels, level): (&Levels, usize),
    offsets: &mut Offsets,
) -> Result<Vec<Polyarc>, GeomError> {
    let left = offsets.inset(region, depth(cutter, level) + cutter.radius_mm())?;
    let next = levels.rings.get(level + 1).filter(|_| !left.is_empty());
    let uncovered = next.map(|next| uncovered(&left, next, cutter, offsets));
    Ok(uncovered.and_then(Result::ok).unwrap_or(left))
}

fn uncovered(
    left: &[Polyarc],
    rings: &[Polyarc],
    cutter: &Cutter,
    offsets: &mut Offsets,
) -> Result<Vec<Polyarc>, GeomError> {
    let covered = offsets.outset(rings, cutter.radius_mm() + TOUCHING_MM)?;
    combine(left, &covered, Combine::Difference)
}
