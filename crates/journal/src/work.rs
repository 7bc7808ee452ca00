//! Work of a machine: a part file, a job, or a move by hand.

use kerf_machine::{Configuration, Errand};
use kerf_part::Program;
use kerf_program::job::Job;
use kerf_program::{Axes, Axis};
use std::sync::Arc;

/// Something to run.
#[derive(Debug)]
pub enum Work {
    /// A part file.
    Part(Box<Program>),
    /// A job, and the machine whose cutting sequence it takes.
    Job(Arc<Job>, Arc<Configuration>),
    /// A move by hand on that machine.
    Hand(Errand, Arc<Configuration>),
}

impl Work {
    /// Name shown to people.
    pub fn name(&self) -> Arc<str> {
        match self {
            Self::Part(program) => program.name().clone(),
            Self::Job(job, _) => job.name.clone(),
            Self::Hand(errand, _) => errand.name().into(),
        }
    }

    /// Returns the number of its lines, or shapes.
    pub fn line_count(&self) -> usize {
        match self {
            Self::Part(program) => program.line_count(),
            Self::Job(job, _) => job.shapes.iter().map(|s| s.number as usize).max().unwrap_or(0),
            Self::Hand(..) => 0,
        }
    }
}

impl Work {
    /// Returns the job origin that it takes when it begins while the tool is at a position: X and Y from home, mm; that
    /// position, if the machine is set so. A job that is homed in X and Y first takes none that is worth keeping.
    pub fn takes_origin(&self, position: Axes) -> Option<[f64; 2]> {
        let Self::Job(_, machine) = self else { return None };
        let homes = machine.homing.at_job_start;
        let moved = [Axis::X, Axis::Y].iter().any(|axis| homes.contains(*axis));
        let takes = machine.job.change_origin_at_start && !moved;
        takes.then(|| [position[Axis::X], position[Axis::Y]])
    }
}

impl Default for Work {
    fn default() -> Self {
        Self::Part(Box::default())
    }
}

impl From<Program> for Work {
    fn from(program: Program) -> Self {
        Self::Part(Box::new(program))
    }
}

impl From<kerf_sbp::Program> for Work {
    fn from(program: kerf_sbp::Program) -> Self {
        Program::from(program).into()
    }
}
