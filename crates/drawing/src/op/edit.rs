//! Selecting, moving, copying, turning, scaling, mirroring, erasing (Profiler reference, "Edit").

use super::{How, OpError};
use crate::{Choice, Editor, Shape};
use kerf_geom::{Point2, Transform2, Vec2};

pub(super) fn select(draft: &mut Editor, choice: &Choice, how: How) -> Result<(), OpError> {
    let count = draft.drawing.shapes.len();
    let chosen = choice.of(&draft.drawing).map_err(|number| OpError::NoShape { number, count })?;
    let before = std::mem::take(&mut draft.selection);
    draft.selection = match how {
        How::New => chosen,
        How::Remove => before.into_iter().filter(|n| chosen.binary_search(n).is_err()).collect(),
        How::Add => {
            let mut all = [before, chosen].concat();
            all.sort_unstable();
            all.dedup();
            all
        }
    };
    Ok(())
}

pub(super) fn shift(draft: &mut Editor, by: Vec2) -> Result<(), OpError> {
    map(draft, &Transform2::moved(by))
}

pub(super) fn copy(draft: &mut Editor, by: Vec2) -> Result<(), OpError> {
    let to = Transform2::moved(by);
    draft.add_from_selected(|shape| shape.mapped(&to))
}

pub(super) fn rotate(draft: &mut Editor, angle_deg: f64, about: Point2) -> Result<(), OpError> {
    map(draft, &Transform2::turned(about, angle_deg.to_radians()))
}

pub(super) fn scale(draft: &mut Editor, factor: f64, about: Point2) -> Result<(), OpError> {
    above_zero("the factor", factor)?;
    map(draft, &Transform2::scaled(about, factor, factor))
}

/// A mirror turns counter-clockwise into clockwise; a closed shape is turned back, so that a part
/// stays a part and a hole a hole (readings, P-20).
pub(super) fn mirror(draft: &mut Editor, a: Point2, b: Point2, raw: bool) -> Result<(), OpError> {
    if a == b {
        return Err(OpError::SamePlace("the two points of the mirror line"));
    }
    let map = Transform2::mirrored(a, b - a);
    draft.change_selected(|_, shape| Ok(mirrored(shape, &map, raw)))
}

pub(super) fn mirrored(shape: &Shape, map: &Transform2, raw: bool) -> Shape {
    let mirrored = shape.mapped(map);
    if shape.is_closed() && !raw { mirrored.reversed() } else { mirrored }
}

pub(super) fn erase(draft: &mut Editor) -> Result<(), OpError> {
    let mut gone = vec![false; draft.drawing.shapes.len()];
    draft.selected()?.into_iter().for_each(|place| gone[place] = true);
    draft.remove(&gone);
    Ok(())
}

fn map(draft: &mut Editor, map: &Transform2) -> Result<(), OpError> {
    draft.change_selected(|_, shape| Ok(shape.mapped(map)))
}

pub(super) fn above_zero(what: &'static str, value: f64) -> Result<(), OpError> {
    let fits = value > 0.0 && value.is_finite();
    if fits { Ok(()) } else { Err(OpError::Bound { what, value, bound: "above 0" }) }
}
