//! Tool paths of 10,000 shapes: offset, tag, leads, two levels of arrays.

use crate::plates;
use crate::row::Row;
use crate::timed::timed;
use anyhow::Result;
use kerf_drawing::{Drawing, Editor, script};

/// Clauses by which the shapes are cut.
const CUT: &str = "directions auto; set black offset=1 tag=1 lead-in=1,90 lead-out=1,45; \
                   array block 2x2 gap 10,10; array job 1x2 gap 20,20";

pub fn measure() -> Result<Row> {
    let drawing = prepared()?;
    let (made, ms) = timed(3, || kerf_toolpath::job(&drawing));
    let (job, warnings) = made?;
    let shapes = drawing.shapes.len();
    let (paths, told) = (job.paths.len(), warnings.len());
    let result = format!("{paths} paths, {told} warnings");
    let row = Row::new(format!("tool paths of {shapes} shapes"), "Kerf", result, ms);
    Ok(row.asked("≤ 1 s", ms <= 1000.0))
}

fn prepared() -> Result<Drawing> {
    let mut editor = Editor::of(plates::plate(10_000, 1));
    for (_, operation) in script(CUT)? {
        editor.apply(&operation)?;
    }
    Ok(editor.drawing)
}
