//! Plots of a run's motion: speed, acceleration and jerk over time and along the path.
//!
//! A [`Plot`] is filled moment by moment and keeps what a page can show, however long the run
//! ([`curve`]). It is drawn with the same sheet, letters and painter as the pictures of tool paths.
//!
//! ```text
//!  title, summary, key
//!  ── tool paths ─────────────────    ── the same along the path ──
//!  ▆▆ cut, jog, stands; lines ▆▆▆
//!  Speed          ╱▔▔▔╲  - - programmed
//!  Acceleration  ▔▔╲__╱▔
//!  Jerk
//!                 time, s →             way along the path, mm →
//! ```

mod chart;
mod curve;
mod page;
mod record;
mod scale;
mod strip;

pub use record::{Doing, Moment, Place, Plot, Rates};

use crate::png::{self, PngError};
use crate::svg;

/// Over what motion is plotted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// Time.
    Time,
    /// Way along the path.
    Path,
    /// Time on the left, way on the right.
    #[default]
    Both,
}

impl Plot {
    /// The plot as SVG, an A4 page on its side.
    pub fn svg(&self, sides: Sides) -> String {
        svg::write(&page::compose(self, sides))
    }

    /// The plot as PNG, its longer side so many pixels long.
    ///
    /// # Errors
    /// [`PngError`] when the picture would be larger than memory allows.
    pub fn png(&self, sides: Sides, pixels: u32) -> Result<Vec<u8>, PngError> {
        png::paint(&page::compose(self, sides), pixels)
    }
}
