//! Makes the job of a drawing: paths shape by shape in the order of cutting, and arrays of them.

use crate::bridge::Bridges;
use crate::entry::{self, Surroundings};
use crate::filter::filtered;
use crate::gouge::{self, Contours};
use crate::job::{CutPath, DrawnJob};
use crate::neighbours;
use crate::order::cutting_order;
use crate::overlap;
use crate::shape_paths::paths;
use crate::twice;
use crate::warning::Warning;
use kerf_drawing::{Drawing, GapError, Group, Shape};
use kerf_geom::fit::smoothed;
use kerf_geom::{Offsetter, Transform2, Vec2};
use kerf_program::Smoothing;
use std::sync::Arc;
use thiserror::Error;

/// The most paths that arrays add to those of the drawing itself: what is more is a slip in the number of rows,
/// not a job.
pub const MOST_PATHS: u64 = 200_000;

/// The most vertices of them.
const MOST_VERTICES: u64 = 5_000_000;

/// Reason why there is no job.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum JobError {
    /// Arrays without bound.
    #[error(
        "the arrays make {copies} copies of the drawing, which come to {paths} paths: 200,000 paths and 5 million \
         vertices at the most beyond the drawing's own; give the arrays fewer rows and columns"
    )]
    TooMany {
        /// Paths of the whole.
        paths: u64,
        /// Copies of the drawing.
        copies: u64,
    },
    /// Arrays whose copies lie on each other.
    #[error(transparent)]
    Gap(#[from] GapError),
    /// Nobody waits for it any more.
    #[error("the tool paths were given up before they were made: ask for them again")]
    GivenUp,
}

/// Makes the job of a drawing: the paths of every shape of the groups that are on, in the drawing's
/// sequence, block after block, smoothed as is usual. What lies inside a shape is cut before it, unless the
/// sequence was set by hand.
///
/// # Errors
/// Arrays that make more than [`MOST_PATHS`], or whose copies lie on each other.
pub fn job(drawing: &Drawing) -> Result<(DrawnJob, Vec<Warning>), JobError> {
    smoothed_job(drawing, Smoothing::default().factor)
}

/// The same with another smoothing factor; 0 smooths nothing (Profiler reference, "When are the
/// Smoothing Factors used?").
///
/// # Errors
/// As [`job`].
pub fn smoothed_job(drawing: &Drawing, factor: f64) -> Result<(DrawnJob, Vec<Warning>), JobError> {
    shaped_job(drawing, Shaping { factor, ..Shaping::default() })
}

/// Changes that are made to the shapes of a drawing before paths are made of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaping {
    /// The smoothing factor; 0 smooths nothing.
    pub factor: f64,
    /// Vertices nearer to each other than this are left out, millimetres; 0 none.
    pub filter_mm: f64,
}

impl Default for Shaping {
    fn default() -> Self {
        Self { factor: Smoothing::default().factor, filter_mm: 0.0 }
    }
}

/// The same with vertices left out that lie too near to each other.
///
/// # Errors
/// As [`job`].
pub fn shaped_job(
    drawing: &Drawing,
    shaping: Shaping,
) -> Result<(DrawnJob, Vec<Warning>), JobError> {
    shaped_job_until(drawing, shaping, &|| false)
}

/// The same, until it is given up: that is asked shape by shape.
///
/// # Errors
/// As [`job`]; or it was given up.
pub fn shaped_job_until(
    drawing: &Drawing,
    shaping: Shaping,
    given_up: &dyn Fn() -> bool,
) -> Result<(DrawnJob, Vec<Warning>), JobError> {
    let mut warnings = Vec::new();
    let block = block(drawing, shaping, given_up, &mut warnings)?;
    let warnings = warnings.into_iter().map(|told: Warning| told.placed(&drawing.shapes)).collect();
    let copies = drawing.arrays.count();
    fits(copies, &block)?;
    let size = drawing.bounds().map_or(Vec2::default(), |bounds| bounds.size());
    drawing.arrays.check(size)?;
    let places = drawing.arrays.placements(size);
    let laid_out = places.flat_map(|by| block.iter().map(move |path| moved(path, by)));
    let plain = drawing.with_shapes(Vec::new());
    let job = DrawnJob {
        paths: laid_out.collect(),
        drawing: plain,
        start: 1,
        smoothing: Some(shaping.factor),
        ..DrawnJob::default()
    };
    Ok((job, warnings))
}

/// Arrays that lay out more than anybody cuts are refused.
fn fits(copies: u64, block: &[CutPath]) -> Result<(), JobError> {
    let vertices = block.iter().map(|path| path.shape.path.vertices.len() as u64).sum::<u64>();
    let added = |each: u64| copies.saturating_sub(1).saturating_mul(each);
    if added(block.len() as u64) > MOST_PATHS || added(vertices) > MOST_VERTICES {
        let paths = copies.saturating_mul(block.len() as u64);
        return Err(JobError::TooMany { paths, copies });
    }
    Ok(())
}

/// The paths of the basic block.
fn block(
    drawing: &Drawing,
    shaping: Shaping,
    given_up: &dyn Fn() -> bool,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<CutPath>, JobError> {
    let contours = Contours::of(drawing);
    let around = Surroundings::of(drawing, &contours);
    let twins = twice::twins(drawing);
    twice::warn(&twins, warnings);
    overlap::crossing(drawing, &twins, given_up, warnings);
    let (mut block, offsetter) = (Vec::new(), Offsetter::default());
    let mut bridges = [Bridges::default(); 8];
    for n in cutting_order(drawing, given_up, warnings) {
        let shape = &drawing.shapes[n];
        let settings = drawing.settings(shape.group);
        if given_up() {
            return Err(JobError::GivenUp);
        }
        if !settings.on {
            continue;
        }
        let number = n + 1;
        entry::straight_down(number, settings, warnings);
        let found = paths(number, &shaped(shape, shaping), settings, &offsetter, warnings);
        overlap::check(number, &found, &contours, &twins, warnings);
        if shape.is_closed() {
            bridges[shape.group.index()].look(number, &found, settings);
        }
        // The machine halts before the shape, not before each of its paths.
        let mut pause = shape.pause;
        for path in found {
            gouge::check(number, &path.leads, path.offset_mm, &contours, warnings);
            let room_mm = around.room(number, &path, settings, shape.group, warnings);
            let cut = Shape {
                path: path.path,
                z_mm: path.z_mm,
                group: shape.group,
                pause: std::mem::take(&mut pause),
                start_inserted: false,
            };
            block.push(CutPath { shape: Arc::new(cut), from: number, pass: path.pass, room_mm });
        }
    }
    let of_group = |group: Group| bridges[group.index()].told(drawing.settings(group));
    warnings.extend(Group::ALL.into_iter().flat_map(of_group));
    neighbours::check(drawing, &block, &contours, given_up, warnings);
    if given_up() { Err(JobError::GivenUp) } else { Ok(block) }
}

/// A flat shape as it is machined: without vertices that lie too near, with curves for its short lines.
/// Heights belong to vertices, so that a 3D shape stays as it is.
pub fn shaped(shape: &Shape, Shaping { factor, filter_mm }: Shaping) -> Shape {
    if shape.z_mm.is_some() {
        return shape.clone();
    }
    let limit_mm = Smoothing { factor, ..Smoothing::default() }.limit_mm();
    let path = smoothed(&filtered(&shape.path, filter_mm), limit_mm);
    Shape { path, ..shape.clone() }
}

fn moved(path: &CutPath, by: Vec2) -> CutPath {
    if by == Vec2::default() {
        return path.clone();
    }
    let shape = Arc::new(path.shape.mapped(&Transform2::moved(by)));
    CutPath { shape, ..path.clone() }
}
