//! Areas cleared: paths by which a round tool takes away everything that lies in a region.
//!
//! A *region* is a set of closed contours as a drawing has them: what bounds material runs
//! counter-clockwise, holes in it clockwise. The tool's centre may go where it is at least half its
//! diameter away from every contour; what the tool covers from there can be *reached*, the corners it
//! leaves cannot. [`rings`] and [`zigzag`] give paths of the centre that
//!
//! - never leave the places it may go to, links between rings included;
//! - cover everything that can be reached, but for pieces smaller than [`SMALLEST_MM2`];
//! - hang together, so that the tool is lifted once for each island of places it may go to.
//!
//! # Rings
//!
//! ```text
//!  ┌───────────────────┐   contour
//!  │ ┌───────────────┐ │   ring 0, half the diameter inside
//!  │ │ ┌───────────┐ │ │   ring 1, one step further
//!  │ │ │  ───────  │ │ │   what ring 1 leaves in the middle: a stroke
//!  │ │ └─┼─────────┘ │ │   a link
//!  │ └───┼───────────┘ │
//!  └───────────────────┘
//! ```
//!
//! With a step near the diameter, rings alone leave cusps in corners and strips in the middle. Where they
//! do is known exactly: between ring k and ring k + 1 it is what lies farther than the radius inside ring
//! k and is not covered by ring k + 1 ([`left_over`]). Each such piece gets a stroke ([`stroke`]).
//!
//! Rings and strokes are the nodes of a tree whose edges are the shortest links ([`tree`]); walking round
//! the tree gives one path ([`tour`]).
//!
//! Lengths are millimetres, places those of the drawing.

mod cutter;
mod error;
mod inside;
mod islands;
mod left_over;
mod levels;
mod route;
mod spans;
mod stroke;
mod tour;
mod tree;
mod zigzag;

pub use cutter::{CutDirection, Cutter};
pub use error::PocketError;
pub use left_over::SMALLEST_MM2;
pub use zigzag::{Zigzag, zigzag};

use kerf_geom::{Coarse, Indexed, Offsetter, Polyarc};
use levels::{Levels, Offsets};

/// The paths that clear a region.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cleared {
    /// One for each island of places where the tool fits, or a few.
    pub paths: Vec<Polyarc>,
    /// Told when an offset could not be exact.
    pub coarse: Option<Coarse>,
}

/// The paths that clear a region ring by ring, one for each island of places where the tool fits.
/// Nothing comes of a region into which the tool does not fit. Who clears many regions keeps one offsetter
/// for all of them.
///
/// # Errors
/// Contours that are open, broken or cross each other, and more rings than anybody cuts.
pub fn rings(
    region: &[Polyarc],
    cutter: &Cutter,
    way: CutDirection,
    offsetter: &Offsetter,
) -> Result<Cleared, PocketError> {
    let mut offsets = Offsets::new(offsetter);
    let levels = Levels::of(region, cutter, &mut offsets)?;
    let inside = inside::Inside::of(region, cutter);
    let pieces = left_over::pieces(region, cutter, &levels, &mut offsets)?;
    let rings = Indexed::new(levels.rings.iter().flatten());
    let strokes = pieces.iter().filter_map(|p| stroke::covering(p, cutter, &inside, &rings));
    let islands = islands::islands(&levels, strokes.collect());
    let paths = islands.iter().flat_map(|island| tour::paths(island, &inside, way)).collect();
    Ok(Cleared { paths, coarse: offsets.coarse })
}
