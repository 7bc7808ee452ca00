//! What a person should look at before cutting.

use std::fmt;

/// Something noticed while tool paths were made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Number of the shape in the drawing, counted from 1.
    pub shape: usize,
    /// What is the matter, and what helps.
    pub text: String,
}

impl Warning {
    pub(crate) fn new(shape: usize, text: impl Into<String>) -> Self {
        Self { shape, text: text.into() }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "shape {}: {}", self.shape, self.text)
    }
}
