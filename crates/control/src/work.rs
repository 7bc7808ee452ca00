//! What a machine is given to do: a part file, a job, or a move by hand.

use kerf_machine::{Configuration, Errand};
use kerf_part::Program;
use kerf_program::job::Job;
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

    /// How many lines it has, or shapes.
    pub fn line_count(&self) -> usize {
        match self {
            Self::Part(program) => program.line_count(),
            Self::Job(job, _) => job.shapes.iter().map(|s| s.number as usize).max().unwrap_or(0),
            Self::Hand(..) => 0,
        }
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
