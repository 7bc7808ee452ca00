//! Losses of a drawing in a file of another maker's format.

use kerf_drawing::{Drawing, Group};

/// Tells what DXF and SVG have no place for, where the drawing has any of it.
pub fn unkept(drawing: &Drawing) -> Option<&'static str> {
    let plain = Drawing::default();
    let shapes = drawing.shapes.iter().any(|shape| shape.group != Group::Black || shape.pause);
    let lost = shapes || drawing.groups != plain.groups || drawing.arrays != plain.arrays;
    lost.then_some("groups and arrays will not be saved; .rsg keeps them")
}
