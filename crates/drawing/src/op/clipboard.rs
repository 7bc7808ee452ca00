//! Copies kept aside (Profiler reference, "Clipboard").

use super::OpError;
use crate::{Editor, Shape, bounds_of};
use kerf_geom::{Point2, Transform2};
use std::sync::Arc;

pub(super) fn clip(draft: &mut Editor) -> Result<(), OpError> {
    let selected = draft.selected()?;
    draft.clipboard = selected.into_iter().map(|n| draft.drawing.shapes[n].clone()).collect();
    Ok(())
}

/// The shapes of a file that whoever sent the operation has read.
pub(super) fn load(
    draft: &mut Editor,
    file: &str,
    shapes: Option<&[Arc<Shape>]>,
) -> Result<Vec<String>, OpError> {
    let shapes = shapes.ok_or_else(|| OpError::NotRead(file.to_owned()))?;
    draft.clipboard = shapes.to_vec();
    Ok(vec![format!("{} shapes of {file} are on the clipboard", shapes.len())])
}

pub(super) fn paste(draft: &mut Editor, at: Point2, absolute: bool) -> Result<(), OpError> {
    let bounds = bounds_of(draft.clipboard.iter().map(Arc::as_ref));
    let bounds = bounds.ok_or(OpError::ClipboardEmpty)?;
    let from = if absolute { Point2::default() } else { bounds.min };
    let map = Transform2::moved(at - from);
    let first = draft.drawing.shapes.len();
    let pasted = draft.clipboard.iter().map(|shape| Arc::new(shape.mapped(&map)));
    draft.drawing.shapes.extend(pasted);
    draft.selection = (first..draft.drawing.shapes.len()).collect();
    Ok(())
}
