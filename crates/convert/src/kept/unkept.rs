//! Constructs that the other language cannot say.

/// Greatest distance of a kept program from its source, mm: variables of OpenSBP have seven digits.
pub const KEPT_MM: f64 = 2e-4;

/// A construct that the other language cannot say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unkept {
    /// Its line, from 1.
    pub line: u32,
    /// Name of the construct, as part of a sentence.
    pub what: String,
}

impl Unkept {
    /// A construct of a line.
    pub(super) fn new(line: u32, what: impl Into<String>) -> Self {
        Self { line, what: what.into() }
    }
}
