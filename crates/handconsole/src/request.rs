//! Requests of the console.

use kerf_drawing::Shape;
use kerf_machine::{Errand, Held};
use kerf_wire::Look;
use std::sync::Arc;

/// A request of the console, for whoever owns machine and files. Requests of one key are granted one after the
/// other; when one is refused, those behind it are dropped.
#[derive(Clone, Debug, PartialEq)]
pub enum ConsoleRequest {
    /// The machine stops.
    Stop,
    /// It goes on after a hold.
    Resume,
    /// The open job is run.
    Start,
    /// The open question is answered.
    Answer(String),
    /// Somebody has taken note of an alarm.
    Acknowledge,
    /// The person at the console drives from now on, and the machine is armed.
    TakeControl,
    /// A job of the current folder is opened.
    Open(String),
    /// The tool moves for as long as the key is held.
    Jog(Held),
    /// The machine does an errand to its end.
    Go(Errand),
    /// Settings of the machine get values, as they are written in a configuration: all of them or none, until
    /// Kerf ends.
    Set(Vec<(&'static str, String)>),
    /// The settings that hold are kept.
    KeepSettings,
    /// Something about the open job.
    Job(JobRequest),
    /// A shape is added, last: to the job that is open, else to the drawing, else to a new job.
    AddShape(Arc<Shape>),
    /// Pages have something else in sight.
    Look(Look),
}

/// A request of the console about the open job.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JobRequest {
    /// Its origin lies there, X and Y from home, mm. Without a job that is where jobs lie that say nothing.
    Origin([f64; 2]),
    /// The head goes there at its end, X and Y from its origin, mm; without a job as with the origin.
    Finish([f64; 2]),
    /// Every path is cut so far beside itself, mm, to the right of travel.
    Offset(f64),
    /// It begins with this shape, from 1.
    Start(u32),
    /// The lowest place of its 3D paths lies at ZBottom.
    Justify,
    /// It is written into its file, with the origin, finish and start that hold.
    Save,
    /// Its shape nearest to the tool is found out.
    Nearest,
}

impl ConsoleRequest {
    /// Returns `true` if its outcome is told in a moment, for which keys wait.
    pub const fn settles(&self) -> bool {
        let placed = matches!(self, Self::Job(JobRequest::Origin(_) | JobRequest::Finish(_)));
        placed || matches!(self, Self::Set(_) | Self::KeepSettings)
    }

    /// Returns `true` if it is only done when the outcome is told, and the console shows it until then.
    pub const fn lasts(&self) -> bool {
        matches!(
            self,
            Self::Go(_) | Self::KeepSettings | Self::AddShape(_) | Self::Job(JobRequest::Nearest)
        )
    }
}
