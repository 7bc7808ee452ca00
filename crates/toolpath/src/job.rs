//! A job as it is drawn and edited: everything that is cut, in order.

use crate::depth::{Depths, Heights, plunge};
use crate::shape_paths::Pass;
use crate::warning::Warning;
use kerf_drawing::{CutDepth, Drawing, Group, Shape};
use kerf_geom::{Point2, Polyarc};
use kerf_program::job::{Plunge, helix_circle};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// One path of a drawn job: a shape of the drawing's groups, which hold its settings.
#[derive(Clone, Debug, PartialEq)]
pub struct CutPath {
    /// The path with its group; in the black group with THRU nothing else is needed to cut it.
    pub shape: Arc<Shape>,
    /// Number of the shape of the drawing it comes from, counted from 1.
    pub from: usize,
    /// Which cut of that shape it is.
    pub pass: Pass,
    /// The largest radius of a helix at its start, millimetres, 0 for none, where the one that its group asks
    /// for has no room.
    pub room_mm: Option<f64>,
}

/// A job as it is drawn and edited: paths to cut, and the groups that say how they are cut. RSM files hold it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnJob {
    /// The paths, in cutting order, arrays laid out.
    pub paths: Vec<CutPath>,
    /// The drawing that it was made from, without its shapes: settings of the groups, comments.
    pub drawing: Drawing,
    /// Place of the drawing's origin on the table, millimetres from home; nothing for the origin of the machine.
    pub origin: Option<Point2>,
    /// Place of the head at the end, millimetres from the origin; nothing for the finish of the machine.
    pub finish: Option<Point2>,
    /// The path with which the job begins, counted from 1.
    pub start: usize,
    /// The smoothing factor that the paths were made with; nothing for paths that were not made.
    pub smoothing: Option<f64>,
    /// Its paths were changed by hand since they were made.
    pub edited: bool,
}

/// Origin of a path, as files keep it: its shape, its pass, and the room of its helix.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Origin {
    pub from: usize,
    pub pass: Pass,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub room_mm: Option<f64>,
}

/// Tells the shapes that would be cut below ZBottom, each once, however often arrays repeat it: the job is
/// refused where it is to run.
pub fn too_deep(job: &DrawnJob, heights: &Heights) -> Vec<Warning> {
    let mut told = BTreeSet::new();
    let wrong = job.paths.iter().filter_map(|path| job.depths(path, heights).err());
    wrong.filter(|warning| told.insert(warning.shape)).collect()
}

impl DrawnJob {
    /// The paths as shapes of a drawing, to be changed by hand.
    pub fn as_drawing(&self) -> Drawing {
        self.drawing.with_shapes(self.paths.iter().map(|path| path.shape.clone()).collect())
    }

    /// The same job with the shapes of a drawing as its paths. A path that stayed, or that has as many
    /// neighbours as before, still knows the shape it comes from.
    #[must_use]
    pub fn edited(self, drawing: &Drawing) -> Self {
        let as_many = drawing.shapes.len() == self.paths.len();
        let known: BTreeMap<*const Shape, &CutPath> =
            self.paths.iter().rev().map(|path| (Arc::as_ptr(&path.shape), path)).collect();
        let of = |n: usize, shape: &Arc<Shape>| {
            let same = known.get(&Arc::as_ptr(shape)).copied();
            let before = same.or(self.paths.get(n).filter(|_| as_many));
            let new =
                CutPath { shape: shape.clone(), from: n + 1, pass: Pass::Final, room_mm: None };
            before.map_or(new, |path| CutPath { shape: shape.clone(), ..path.clone() })
        };
        let paths = drawing.shapes.iter().enumerate().map(|(n, shape)| of(n, shape)).collect();
        Self { paths, drawing: drawing.with_shapes(Vec::new()), edited: true, ..self }
    }

    /// The heights at which a path is cut, or why it cannot be.
    ///
    /// # Errors
    /// The pass that would go below ZBottom, with the shape it belongs to.
    pub fn depths(&self, path: &CutPath, heights: &Heights) -> Result<Depths, Warning> {
        let settings = self.drawing.settings(path.shape.group);
        let z_mm = path.shape.z_mm.as_deref().unwrap_or_default();
        Depths::of(settings.height, settings.pass_mm, z_mm, heights).map_err(|error| Warning {
            at: path.shape.path.start(),
            ..Warning::new(path.from, error.to_string())
        })
    }

    /// The circle of the helix by which the tool comes to a path, where it does.
    pub fn helix(&self, path: &CutPath) -> Option<Polyarc> {
        let settings = self.drawing.settings(path.shape.group);
        let goes_round = path.pass != Pass::Traversal && settings.height != CutDepth::ThreeD;
        match plunge(settings, path.room_mm) {
            Plunge::Helix { radius_mm, .. } if goes_round => {
                helix_circle(&path.shape.path, radius_mm)
            }
            _ => None,
        }
    }

    /// Length of the cutting paths of each group, millimetres, in the order of the groups.
    pub fn lengths(&self) -> [(Group, f64); 8] {
        Group::ALL.map(|group| {
            let cut = |path: &&CutPath| path.shape.group == group && path.pass != Pass::Traversal;
            (group, self.paths.iter().filter(cut).map(|path| path.shape.path.length()).sum())
        })
    }
}
