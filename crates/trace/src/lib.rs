//! The trace of a run: its events, their receivers, and the sums and diagrams made of them.
//!
//! ```text
//!  a run ──► Sink: Event, Event, …  JsonLines   the trace as text
//!                  ExecutedMove, Doing      VcdSink     signals of the motors and the ports
//!                  RunStatus         Lines       a diagram of inputs and outputs
//!        └─► Tally                              lengths, bounds and times of the summary
//! ```
//!
//! - [`Event`] is one thing that a run tells, exactly as `kerf trace` prints it; a [`Sink`] takes events.
//! - [`Made`] is a move with its plan, [`Doing`] the activity of the machine while time passes.
//! - [`RunStatus`] is what a console shows of a run at any time.
//!
//! Nothing here knows what runs, or asks anything of it.

pub mod event;
pub mod json;
mod run_status;
mod sink;
mod summary;
pub mod switching;
mod tally;
pub mod vcd;

pub use event::Event;
pub use run_status::{OpenFile, RunStatus, flag};
pub use sink::{Doing, ExecutedMove, Sink};
pub use summary::Summary;
pub use tally::{Tally, ToolPathTime};
