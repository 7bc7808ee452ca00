//! The machine and the job as the console shows them.

use kerf_drawing::Shape;
use kerf_machine::Configuration;
use kerf_program::Axes;
use kerf_wire::{Asked, State};
use std::sync::Arc;

/// The job that is open.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OpenJob {
    /// Name of its file, without folders.
    pub name: String,
    /// Width and height of its paths, mm; nothing for a part program.
    pub size_mm: Option<[f64; 2]>,
    /// Number of its shapes.
    pub shapes: u32,
    /// Distance beside themselves at which its paths are cut, mm.
    pub offset_mm: f64,
}

/// Event that the machine waits for.
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

/// The machine and the job as the console shows them. Whoever owns both makes it anew for each key and each
/// screen.
#[derive(Clone, Debug, Default)]
pub struct View {
    /// The job that is open.
    pub job: Option<OpenJob>,
    /// Activity of the machine.
    pub state: State,
    /// Reason why it is in alarm, for a person.
    pub why: Option<String>,
    /// Event that it waits for.
    pub waits: Waits,
    /// The shape that is cut, from 1; 0 while none is.
    pub shape: u32,
    /// Its position, machine frame.
    pub position: Axes,
    /// Configuration of the machine; its job origin and finish are those of the open job.
    pub machine: Arc<Configuration>,
    /// The jobs of the current folder, in the order of their names. Only a key looks at them.
    pub files: Vec<String>,
    /// The paths of the job that is open, else the shapes of the drawing. Only a key looks at them.
    pub drawn: Vec<Arc<Shape>>,
}

impl View {
    /// Returns the number of shapes of the open job.
    pub fn shapes(&self) -> u32 {
        self.job.as_ref().map_or(0, |job| job.shapes)
    }

    /// It moves, or is about to.
    pub const fn is_moving(&self) -> bool {
        matches!(self.state, State::Running | State::Jogging)
    }
}
