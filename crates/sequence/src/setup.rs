//! A job where it is cut, and the machine that cuts it.

use crate::begin;
use kerf_geom::Point2;
use kerf_machine::Configuration;
use kerf_machine::homing::{soft_bounds, table_bounds};
use kerf_machine::planning::job_settings;
use kerf_program::job::Job;
use kerf_program::{Axes, Axis, Frame, Settings};
use std::sync::Arc;

/// Places closer than this are the same, mm.
pub(crate) const SAME_MM: f64 = 1e-9;

/// A job and its machine.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    /// The job at hand.
    pub job: Arc<Job>,
    /// The job that was given, where the one at hand is a part of it.
    pub whole: Arc<Job>,
    pub machine: Arc<Configuration>,
    /// Settings of the planner.
    pub settings: Arc<Settings>,
    pub frame: Frame,
}

impl Setup {
    /// A job on a machine that stands at a position, machine frame.
    pub fn new(job: Arc<Job>, machine: Arc<Configuration>, position: Axes) -> Self {
        let job = begin::placed(job, &machine, position);
        let mut frame = Frame::default();
        let origin = job.origin.unwrap_or_default();
        (frame.working_zero[Axis::X], frame.working_zero[Axis::Y]) = (origin.x, origin.y);
        let settings = Arc::new(job_settings(&machine));
        Self { whole: job.clone(), job, machine, settings, frame }
    }

    /// Returns the range of an axis, machine frame; `None` when it has no bounds.
    pub fn reach(&self, axis: Axis) -> Option<[f64; 2]> {
        let (soft, table) = (soft_bounds(&self.machine, axis), table_bounds(&self.machine, axis));
        match (soft, table) {
            (Some(soft), Some(table)) => Some([soft.0.max(table.0), soft.1.min(table.1)]),
            (soft, table) => soft.or(table).map(Into::into),
        }
    }

    /// Returns `true` if a position lies over a place of the job.
    pub fn is_over(&self, position: Axes, place: Point2) -> bool {
        let to = self.job.on_table(place);
        let (dx, dy) = (to.x - position[Axis::X], to.y - position[Axis::Y]);
        dx.abs() <= SAME_MM && dy.abs() <= SAME_MM
    }
}
