//! What the console shows of the machine and the job.

use kerf_drawing::Shape;
use kerf_machine::Configuration;
use kerf_program::Axes;
use kerf_wire::{Asked, State};
use std::sync::Arc;

/// The job that is open.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Job {
    /// Name of its file, without folders.
    pub name: String,
    /// Width and height of its paths, mm; nothing for a part program.
    pub size_mm: Option<[f64; 2]>,
    /// How many shapes it has.
    pub shapes: u32,
    /// How far beside themselves its paths are cut, mm.
    pub offset_mm: f64,
}

/// What the machine waits for.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Waits {
    /// Nothing.
    #[default]
    No,
    /// The second Start of a job, which begins with this shape.
    Start(u32),
    /// Start, to go on after a stop or a pause mark.
    Paused,
    /// An answer.
    Question(Box<Asked>),
}

/// What the console shows of the machine and the job. Whoever owns both makes it anew for each key and each
/// screen.
#[derive(Clone, Debug, Default)]
pub struct View {
    /// The job that is open.
    pub job: Option<Job>,
    /// What the machine does.
    pub state: State,
    /// Why it is in alarm, for a person.
    pub why: Option<String>,
    /// What it waits for.
    pub waits: Waits,
    /// The shape that is cut, from 1; 0 while none is.
    pub shape: u32,
    /// Where it stands, machine frame.
    pub position: Axes,
    /// What the machine is; its job origin and finish are those of the open job.
    pub machine: Arc<Configuration>,
    /// The jobs of the current folder, in the order of their names. Only a key looks at them.
    pub files: Vec<String>,
    /// The paths of the job that is open, else the shapes of the drawing. Only a key looks at them.
    pub drawn: Vec<Arc<Shape>>,
}

impl View {
    /// How many shapes the open job has.
    pub fn shapes(&self) -> u32 {
        self.job.as_ref().map_or(0, |job| job.shapes)
    }

    /// It moves, or is about to.
    pub const fn is_moving(&self) -> bool {
        matches!(self.state, State::Running | State::Jogging)
    }
}
