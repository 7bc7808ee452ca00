//! Terms of a conversion: the source, the languages, the result.

use crate::Passage;
use kerf_diag::Diagnostic;
use kerf_gcode::Dialect;
use kerf_program::{Host, Settings};
use std::sync::Arc;

/// A language, and for G-code whose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// OpenSBP.
    OpenSbp,
    /// G-code.
    Gcode(Dialect),
}

impl Language {
    /// The language of a file name, G-code in the given dialect; `None` for any other file.
    ///
    /// ```
    /// use kerf_convert::Language;
    /// assert_eq!(Language::of_file("Box.SBP", Default::default()), Some(Language::OpenSbp));
    /// assert_eq!(Language::of_file("box.dxf", Default::default()), None);
    /// ```
    pub fn of_file(name: &str, dialect: Dialect) -> Option<Self> {
        if kerf_sbp::is_part_name(name) {
            return Some(Self::OpenSbp);
        }
        kerf_sbp::is_gcode_name(name).then_some(Self::Gcode(dialect))
    }
}

/// A program to convert.
#[derive(Clone, Debug)]
pub struct Source<'a> {
    /// Name shown to people.
    pub name: Arc<str>,
    /// The text.
    pub bytes: &'a [u8],
    /// Its language.
    pub language: Language,
}

/// Options of a conversion.
#[derive(Clone, Debug)]
pub struct Conversion {
    /// The language of the source.
    pub from: Language,
    /// The language that is written.
    pub to: Language,
    /// The machine's settings at the start.
    pub settings: Settings,
    /// Options by which a part file is read.
    pub sbp: kerf_sbp::Options,
    /// Variables set before the start.
    pub variables: kerf_sbp::Variables,
    /// Keep variables, conditions and subroutines where both languages can say them.
    pub keep_variables: bool,
    /// The outputs of mist and flood coolant; 0 for none.
    pub coolant_outputs: [u8; 2],
    /// Comments in the first lines.
    pub title: String,
}

/// Result of a conversion.
#[derive(Debug)]
pub struct Converted {
    /// The text; nothing when it could not be converted.
    pub text: Option<String>,
    /// Diagnostics that were found on the way.
    pub diagnostics: Vec<Diagnostic>,
}

/// Follows a program with a fresh host: files and answers as at the start.
pub type Hosts<'a, 'b> =
    &'a mut (dyn FnMut(&mut dyn FnMut(&mut dyn Host) -> Passage) -> Passage + 'b);
