//! The selected shapes again, in rows and columns or round a centre (Profiler reference, "Array").

use super::OpError;
use crate::{ArrayLevel, Editor, Shape, bounds_of};
use kerf_geom::{Point2, Transform2, Vec2};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The most shapes that an array may come to: more are a slip of a digit.
const MOST_SHAPES: u64 = 200_000;

/// The most vertices of them.
const MOST_VERTICES: u64 = 5_000_000;

/// Spacing is the gap between neighbouring boxes (readings, P-25).
pub(super) fn in_rows(
    draft: &mut Editor,
    rows: u32,
    columns: u32,
    gap: Vec2,
) -> Result<(), OpError> {
    let array = ArrayLevel {
        rows,
        columns,
        row_gap_mm: gap.y,
        column_gap_mm: gap.x,
        ..ArrayLevel::default()
    };
    let shapes = selected_shapes(draft)?;
    fits(array.count(), &shapes)?;
    let size = bounds_of(shapes.iter().map(Arc::as_ref)).map_or(Vec2::default(), |b| b.size());
    let pitch = array.pitch(size);
    let by = |n| {
        let (row, column) = array.cell(n);
        Transform2::moved(Vec2::new(f64::from(column) * pitch.x, f64::from(row) * pitch.y))
    };
    add(draft, &shapes, (1..array.count()).map(by));
    Ok(())
}

/// The number counts the original; each copy is turned with its angle (readings, P-24).
pub(super) fn round(draft: &mut Editor, count: u32, centre: Point2) -> Result<(), OpError> {
    let shapes = selected_shapes(draft)?;
    fits(u64::from(count), &shapes)?;
    let turn = |n| Transform2::turned(centre, TAU * f64::from(n) / f64::from(count));
    add(draft, &shapes, (1..count).map(turn));
    Ok(())
}

fn selected_shapes(draft: &Editor) -> Result<Vec<Arc<Shape>>, OpError> {
    Ok(draft.selected()?.into_iter().map(|n| draft.drawing.shapes[n].clone()).collect())
}

fn fits(copies: u64, shapes: &[Arc<Shape>]) -> Result<(), OpError> {
    let vertices = shapes.iter().map(|shape| shape.path.vertices.len()).sum::<usize>();
    let total = |each: usize| copies.saturating_mul(each as u64);
    if !(1..=MOST_SHAPES).contains(&total(shapes.len())) {
        let (what, bound) = ("the number of shapes", "1 to 200,000");
        return Err(OpError::Bound { what, value: total(shapes.len()) as f64, bound });
    }
    if total(vertices) > MOST_VERTICES {
        let (what, bound) = ("the number of vertices", "5 million at the most");
        return Err(OpError::Bound { what, value: total(vertices) as f64, bound });
    }
    Ok(())
}

fn add(draft: &mut Editor, shapes: &[Arc<Shape>], maps: impl Iterator<Item = Transform2>) {
    for map in maps {
        draft.drawing.shapes.extend(shapes.iter().map(|shape| Arc::new(shape.mapped(&map))));
    }
}
