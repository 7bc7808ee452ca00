//! RSM: a job in a file that drawing programs read.
//!
//! Like an RSG it is plain DXF Release 12 with comments. The paths stand in it as they are cut, arrays
//! laid out; the comments hold where the job lies on the table and what each path comes from.

use crate::job::{CutPath, Job, Origin};
use kerf_drawing::Arrays;
use kerf_formats::{Imported, rsg};
use kerf_geom::Point2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What an RSM has besides the data of an RSG.
#[derive(Default, Serialize, Deserialize)]
struct Head {
    origin: Point2,
    finish: Point2,
    start: usize,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    smoothing: Option<f64>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    edited: bool,
    paths: Vec<Origin>,
}

/// A job as RSM.
pub fn write(job: &Job) -> String {
    let shapes = job.paths.iter().map(|path| path.shape.clone()).collect();
    let mut drawing = job.drawing.with_shapes(shapes);
    drawing.arrays = Arrays::default();
    let origin =
        |path: &CutPath| Origin { from: path.from, pass: path.pass, room_mm: path.room_mm };
    let paths = job.paths.iter().map(origin).collect();
    let Job { origin, finish, start, smoothing, edited, .. } = *job;
    let head = Head { origin, finish, start, smoothing, edited, paths };
    rsg::write_with(&drawing, Some(serde_json::to_value(head).unwrap_or_default()))
}

/// Reads an RSM. A drawing that is none is a job of its shapes as they are; what was noticed comes
/// with it.
pub fn read(bytes: &[u8]) -> (Job, Imported) {
    let (mut read, own) = rsg::read_with(bytes);
    let head: Head = own.and_then(|own| serde_json::from_value(own).ok()).unwrap_or_default();
    let shapes = std::mem::take(&mut read.drawing.shapes);
    let origins = head.paths.iter().copied();
    let numbered = (1..).map(|from| Origin { from, ..Origin::default() });
    let path = |(shape, origin): (Arc<_>, Origin)| {
        let Origin { from, pass, room_mm } = origin;
        CutPath { shape, from, pass, room_mm }
    };
    let missing = numbered.skip(head.paths.len());
    let paths = shapes.into_iter().zip(origins.chain(missing)).map(path).collect();
    let Head { origin, finish, start, smoothing, edited, .. } = head;
    let drawing = read.drawing.clone();
    let start = start.max(1);
    (Job { paths, drawing, origin, finish, start, smoothing, edited }, read)
}
