//! The place of a job on the table.

use kerf_geom::Point2;
use kerf_machine::Configuration;
use kerf_program::job::Job;
use kerf_program::{Axes, Axis};
use std::sync::Arc;

/// The job where it is cut, and how often: Start may take the present position as origin.
pub(crate) fn placed(job: Arc<Job>, machine: &Configuration, position: Axes) -> Arc<Job> {
    let mut placed = (*job).clone();
    [placed.origin, placed.finish] = lies(&job, machine).map(Some);
    if machine.job.change_origin_at_start {
        placed.origin = Some(Point2::new(position[Axis::X], position[Axis::Y]));
    }
    placed.repeats = placed.repeats.max(machine.job.repeats);
    Arc::new(placed)
}

/// Returns the origin of a job on the table and its finish position: those of the machine, where
/// the job says nothing of them.
pub fn lies(job: &Job, machine: &Configuration) -> [Point2; 2] {
    let set = [machine.job.origin_mm, machine.job.finish_mm].map(|[x, y]| Point2::new(x, y));
    [job.origin.unwrap_or(set[0]), job.finish.unwrap_or(set[1])]
}
