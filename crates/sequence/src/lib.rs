//! Jobs on a machine: the order in which outputs switch, delays pass and the tool moves, and what a
//! stop in the middle does to it (Profiler reference, "Machining the Job", "Special Delay Times
//! During Cutting", "Pausing the Machine").
//!
//! A [`Sequence`] is an [`Interpreter`](kerf_program::Interpreter): it is stepped, never blocks, and
//! gives the same commands as a part file does. So preview, time, trace and a real run treat a job and
//! a program alike, and the time of a job is that of the plan.
//!
//! ```text
//!  Job ──► pass by pass ──► steps (queue) ──► commands
//!           ▲  schedule.rs: which steps, from Progress,   execute.rs, path.rs: what a step gives,
//!           │  Values, Head, Halt and Start               and when it is over
//!           └── stop, arc lost, estop: stops.rs ──► State (one table for all machines)
//!  Job ──► part_program.rs ──► the same commands ──► a printer of OpenSBP or G-code
//! ```
//!
//! Its state is a few small values: the job and its machine (`Setup`), heights and speeds in force
//! (`Values`), place and outputs (`Head`), how far the job is (`Progress`), why it stands (`Halt`), the sheet that is
//! followed (`Sheet`), the start that is waited for (`Start`), and the queue of steps. `Schedule`, `Cut`, `Follower`
//! and `Extent` borrow what they need of these.
//!
//! A job goes by the settings of the machine (nine areas of them), its table of states and its lines by name.
//! These are one model, so that this crate stands above [`kerf_machine`] and lends it whole instead of
//! copying half of it.
//!
//! What a pass is made of is decided when it begins, from what then holds: a pause may have changed
//! speeds, ZBottom or the height of the sheet. A router, a laser, a plasma torch and a knife differ
//! in a few steps only.

mod beam;
mod begin;
mod bounds;
mod cut;
mod effects;
mod entry;
mod execute;
mod forbidden;
mod halt;
mod head;
mod interpreter;
mod limited;
mod part_program;
mod path;
mod place;
mod plasma;
mod queue;
mod schedule;
mod sequence;
mod setup;
mod sheet;
mod start;
mod step;
mod stops;
mod values;
mod watches;

pub use begin::lies;
pub use part_program::{Speeds, print};
pub use sequence::Sequence;
pub use start::straddling;
