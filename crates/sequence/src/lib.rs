//! Jobs on a machine: the order in which outputs switch, delays pass and the tool moves, and what a
//! stop in the middle does to it (Profiler reference, "Machining the Job", "Special Delay Times
//! During Cutting", "Pausing the Machine").
//!
//! A [`Sequence`] is an [`Interpreter`](kerf_program::Interpreter): it is stepped, never blocks, and
//! gives the same commands as a part file does. So preview, time, trace and a real run treat a job and
//! a program alike, and the time of a job is that of the plan.
//!
//! ```text
//!  Job ──► pass by pass ──► small steps ──► commands
//!             ▲  shape.rs, beam.rs, plasma.rs   carry.rs, path.rs
//!             └── stop, arc lost, estop: pause.rs ──► State (one table for all machines)
//!                 power cut: taken_up.rs
//! ```
//!
//! A job goes by the settings of the machine (nine areas of them), its table of states and its lines by name.
//! These are one model, so that this crate stands above [`kerf_machine`] and lends it whole instead of
//! copying half of it.
//!
//! What a pass is made of is decided when it begins, from what then holds: a pause may have changed
//! speeds, ZBottom or the height of the sheet. A router, a laser, a plasma torch and a knife differ
//! in a few small steps only.

mod beam;
mod begin;
mod bounds;
mod carry;
mod entry;
mod forbidden;
mod height;
mod limited;
mod part_program;
mod path;
mod pause;
mod place;
mod plasma;
mod program;
mod sequence;
mod shape;
mod small;
mod start;
mod taken_up;

pub use begin::lies;
pub use part_program::{Speeds, print};
pub use sequence::Sequence;
pub use start::straddling;
