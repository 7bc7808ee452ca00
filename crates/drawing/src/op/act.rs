//! From an operation to the function that carries it out.

use super::{OpError, Operation, Outcome};
use super::{arrays, clear, clipboard, copies, draw, edit, grouping, layout, outline, path};
use super::{picks, sequence, vertices};
use crate::Editor;

/// Carries out an operation on a draft of the drawing; after an error the draft is thrown away.
pub(crate) fn act(draft: &mut Editor, operation: &Operation) -> Result<Outcome, OpError> {
    use Operation as O;
    let mut outcome = Outcome::default();
    match operation {
        O::Select { choice, how } => edit::select(draft, choice, *how)?,
        O::Move { by } => edit::shift(draft, *by)?,
        O::Copy { by } => edit::copy(draft, *by)?,
        O::Rotate { angle_deg, about } => edit::rotate(draft, *angle_deg, *about)?,
        O::Scale { factor, about } => edit::scale(draft, *factor, *about)?,
        O::Mirror { a, b, raw } => edit::mirror(draft, *a, *b, *raw)?,
        O::Erase => edit::erase(draft)?,
        O::Fillet { radius_mm, at } => outline::fillet(draft, *radius_mm, *at)?,
        O::Chamfer { length_mm, at } => outline::chamfer(draft, *length_mm, *at)?,
        O::Offset { distance_mm, keep } => {
            outcome.warnings = outline::offset(draft, *distance_mm, *keep)?;
        }
        O::Join { distance_mm, merge } => outline::join(draft, *distance_mm, *merge)?,
        O::Break { shape, at } => outline::break_at(draft, *shape, *at)?,
        O::Trim { at } => outline::trim(draft, *at)?,
        O::ArrayRect { rows, columns, gap } => copies::in_rows(draft, *rows, *columns, *gap)?,
        O::ArrayRound { count, centre } => copies::round(draft, *count, *centre)?,
        O::Bulge { shape, at, bulge } => vertices::bulge(draft, *shape, *at, *bulge)?,
        O::Radius { shape, at, radius_mm } => vertices::radius(draft, *shape, *at, *radius_mm)?,
        O::Vertex { shape, at, to } => vertices::shift(draft, *shape, *at, *to)?,
        O::Stretch { a, b, by } => vertices::stretch(draft, *a, *b, *by)?,
        O::StretchAt { at, by } => vertices::stretch_at(draft, at, *by)?,
        O::DeleteVertices { shape, at } => vertices::delete(draft, *shape, at)?,
        O::Circle { centre, radius_mm } => draw::circle(draft, *centre, *radius_mm)?,
        O::Rectangle { a, b } => draw::rectangle(draft, *a, *b)?,
        O::Point { at } => draw::point(draft, *at),
        O::Polyarc { vertices, closed } => {
            outcome.warnings = draw::polyarc(draft, vertices, *closed)?;
        }
        O::SpaceLine { places, closed } => {
            outcome.notes = draw::space_line(draft, places, *closed)?;
        }
        O::Reverse => path::reverse(draft)?,
        O::Directions => outcome.warnings = path::directions(draft),
        O::Start { shape, at } => path::start(draft, *shape, *at)?,
        O::Pause { on } => path::pause(draft, *on)?,
        O::Group { group } => grouping::put(draft, *group)?,
        O::CopyToGroup { group } => grouping::copy(draft, *group)?,
        O::Set { group, changes } => grouping::set(draft, *group, changes)?,
        O::Pocket { clearing, pattern } => outcome = clear::pocket(draft, clearing, pattern)?,
        O::Engrave(clearing) => outcome = clear::engrave(draft, clearing)?,
        O::Pick { picking } => outcome.notes = picks::pick(draft, picking)?,
        O::Sequence { order } => outcome = sequence::order(draft, order)?,
        O::Array { level, array } => arrays::set(draft, *level, *array)?,
        O::JustifyLeft => layout::left(draft),
        O::JustifySurface => layout::surface(draft),
        O::JustifyBottom { bottom_mm } => layout::bottom(draft, *bottom_mm)?,
        O::Rotate90 => layout::rotate90(draft),
        O::MirrorDrawing => layout::mirror(draft),
        O::Origin { at } => layout::origin(draft, *at),
        O::CadOrigin => layout::cad_origin(draft),
        O::Clip => clipboard::clip(draft)?,
        O::LoadClipboard { file, shapes } => {
            outcome.notes = clipboard::load(draft, file, shapes.as_deref())?;
        }
        O::ClearClipboard => draft.clipboard.clear(),
        O::Paste { at, absolute } => clipboard::paste(draft, *at, *absolute)?,
        O::Comment { lines } => draft.drawing.set_comments(lines.clone())?,
    }
    Ok(outcome)
}
