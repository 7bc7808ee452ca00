//! Drawings from files and into files.
//!
//! A reader gives back what could be read, and [`Finding`]s with the line of everything that could
//! not: a file that is broken in one place is read in all others, and nothing is invented. A drawing
//! is refused only when there is nothing of a drawing in the file.
//!
//! [`open`] and [`Format`] choose the reader and the writer by the ending of a file's name.

pub mod bitmap;
pub mod dxf;
mod effort;
mod finding;
mod format;
pub mod hpgl;
mod layers;
pub mod motion;
mod places;
pub mod rsg;
pub mod svg;
mod tidy;
mod unkept;

pub use effort::{Ended, MOST_PLACED, MOST_PLACED_VERTICES};
pub use finding::{Finding, Weight};
pub use format::{
    Content, FORMATS, Format, JOB_ENDING, Opening, ending, is_drawing, open, readable, writable,
};
use unkept::unkept;

use kerf_drawing::{Drawing, Heightened};

impl Imported {
    /// Gives groups with 3D shapes the height 3D, and notes it.
    pub fn heighten(&mut self) {
        let all = 0..self.drawing.shapes.len();
        for made in kerf_drawing::heighten(&mut self.drawing, all) {
            let weight =
                if matches!(made, Heightened::Flat(_)) { Weight::Warning } else { Weight::Note };
            self.findings.push(Finding::of_file(weight, made.to_string()));
        }
    }
}

/// A drawing that was read, and what was noticed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// The drawing, millimetres.
    pub drawing: Drawing,
    /// Findings that a person should know, in the order of the file.
    pub findings: Vec<Finding>,
    /// The layers that shapes came from, in the order of the file, each with its shapes as places in
    /// the drawing.
    pub layers: Vec<(String, Vec<usize>)>,
    /// List of what was skipped, by name: `skipped: TEXT 4`.
    pub skipped: Option<String>,
    /// The reason for which the drawing is empty, where its reading ended early.
    pub ended: Option<Ended>,
}
