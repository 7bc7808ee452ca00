//! A whole job offset: every path cut beside itself (Profiler reference, "Hand Console", function 60).

use crate::path_with_leads;
use kerf_geom::{Offsetter, Polyarc};
use kerf_program::job::{Job, JobShape, Note, Plunge};
use std::collections::BTreeSet;
use thiserror::Error;

/// Reason why a job is not offset.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum NoRoom {
    /// The path has no way beside it.
    #[error("shape {number}: no path lies {by_mm} mm beside it")]
    Lost {
        /// The shape.
        number: u32,
        /// Distance beside the path, millimetres.
        by_mm: f64,
    },
    /// A path with heights of its own.
    #[error("shape {number} has heights of its own: offset it in the drawing")]
    Heights {
        /// The shape.
        number: u32,
    },
}

/// A job whose paths are cut a distance to the right of travel, negative to the left. Zero changes nothing.
///
/// A helix that had room beside the path may have none beside the other one: the tool goes down along that,
/// as steeply, and the job has a note of the first shape of each group to which this happens.
///
/// # Errors
/// [`NoRoom`] where a path has none.
pub fn offset_job(job: &Job, by_mm: f64) -> Result<Job, NoRoom> {
    if by_mm == 0.0 {
        return Ok(job.clone());
    }
    let offsetter = Offsetter::default();
    let moved: Result<Vec<Vec<JobShape>>, NoRoom> =
        job.shapes.iter().map(|shape| shape_beside(shape, by_mm, &offsetter)).collect();
    let notes = job.notes.iter().cloned().chain(lost_helices(job)).collect();
    Ok(Job { shapes: moved?.into_iter().flatten().collect(), notes, ..job.clone() })
}

/// A note of the first helix of each group.
fn lost_helices(job: &Job) -> impl Iterator<Item = Note> {
    let mut groups = BTreeSet::new();
    let goes_round =
        |shape: &&JobShape| !shape.traversal && matches!(shape.plunge, Plunge::Helix { .. });
    let helices = job.shapes.iter().filter(goes_round);
    helices.filter(move |shape| groups.insert(shape.group.clone())).map(|shape| {
        let group = &shape.group;
        let text = format!(
            "group {group}: beside its paths nobody knows the room for a helix: the tool goes down along them instead, \
             as steeply"
        );
        Note { shape: shape.number, text: text.into() }
    })
}

fn shape_beside(
    shape: &JobShape,
    by_mm: f64,
    offsetter: &Offsetter,
) -> Result<Vec<JobShape>, NoRoom> {
    let number = shape.number;
    if shape.z_mm.iter().any(|z| *z != 0.0) {
        return Err(NoRoom::Heights { number });
    }
    let found = paths_beside(&shape.path, by_mm, offsetter);
    let found = found.filter(|all| !all.is_empty()).ok_or(NoRoom::Lost { number, by_mm })?;
    let plunge = match shape.plunge {
        Plunge::Helix { angle_deg, .. } => Plunge::Ramp { angle_deg },
        other => other,
    };
    let with = |path: Polyarc| {
        let z_mm = vec![0.0; if shape.z_mm.is_empty() { 0 } else { path.vertices.len() }].into();
        JobShape { path: path.into(), z_mm, plunge, ..shape.clone() }
    };
    Ok(found.into_iter().map(with).collect())
}

/// The paths beside one. A closed one keeps its leads, where it has any: they follow its start and its end.
fn paths_beside(path: &Polyarc, by_mm: f64, offsetter: &Offsetter) -> Option<Vec<Polyarc>> {
    let beside = |path: &Polyarc| {
        let found = offsetter.offset(path, by_mm).ok()?;
        Some(found.into_iter().map(|found| found.path).collect::<Vec<_>>())
    };
    let Some(led) = path_with_leads::with_leads_of(path) else { return beside(path) };
    Some(beside(&led.closed)?.iter().map(|ring| led.again(ring)).collect())
}
