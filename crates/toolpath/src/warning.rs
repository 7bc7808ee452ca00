//! Warnings of what a person should look at before cutting.

use kerf_drawing::{Shape, spot};
use kerf_geom::Point2;
use std::fmt;
use std::sync::Arc;

/// Something noticed while tool paths were made.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// Number of the shape in the drawing, counted from 1.
    pub shape: usize,
    /// Place of the matter: usually where the shape begins.
    pub at: Option<Point2>,
    /// Description of the matter, and what helps.
    pub text: String,
}

impl Warning {
    pub(crate) fn new(shape: usize, text: impl Into<String>) -> Self {
        Self { shape, at: None, text: text.into() }
    }

    /// The same with the place of its shape, where none is told.
    pub(crate) fn placed(self, shapes: &[Arc<Shape>]) -> Self {
        let shape = self.shape.checked_sub(1).and_then(|place| shapes.get(place));
        Self { at: self.at.or_else(|| shape.and_then(|shape| shape.path.start())), ..self }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "shape {}{}: {}", self.shape, spot(self.at), self.text)
    }
}
