//! One owner of one machine: runs programs on it and tells what happens.
//!
//! ```text
//!  Session::run ── Runner ── Interpreter            asks World: machine, operator, files
//!                    │  └─── Mover, plan ── Machine (kerf-sim)
//!                    └─────► Sink: Event, Event, …  trace, picture, progress
//! ```
//!
//! - [`Session`] is what stays between runs; [`Session::run`] is one run.
//! - [`Event`](kerf_trace::Event) is one thing that a run tells; a [`Sink`](kerf_trace::Sink) takes events.
//! - [`controller`] runs the same on a real machine: the plan is the same, who makes it is not.
//! - [`Workspace`](kerf_workspace::Workspace) is everything on disk that a program may reach. A preview gets a copy that keeps its
//!   writes to itself.
//! - [`run_text`] does it all in memory: for tests, editors, whoever has no disk.
//!
//! The same program, settings, files, answers and inputs give the same events, byte for byte.

pub mod answers;
mod at_rest;
mod away;
mod before;
mod begun;
mod beside;
mod bound;
mod by_hand;
mod check;
pub mod command_passing;
pub mod controller;
mod conversion;
mod desk;
pub mod drawn;
mod drive;
mod errands;
mod execute;
mod heights;
mod hold;
mod homing;
mod host;
pub mod job_file;
mod kept;
mod nudge;
mod part_log;
pub mod password;
mod pendant;
mod preview_mode;
mod reentry;
mod repetitions;
mod requests;
mod runner;
mod session;
pub mod settings_text;
mod stack;
pub mod start_up;
mod stopping;
mod table_limits;
mod text;
mod tracked;
mod trail;
pub mod transfer;
mod turning;
mod waiting;
mod warning;
mod workspace_host;
mod world;
mod world_clock;

use kerf_machine::Driven;
use kerf_sim::Simulated;

pub use away::LIFT;
pub use begun::Begun;
pub use by_hand::Jog;
pub use check::{Checked, check};
pub use desk::Desk;
pub use nudge::{Nudge, Outside};
pub use repetitions::Repetitions;
pub use requests::{OperatorRequest, Requests, Script, StopAt};
pub use session::{Company, DrivenBy, Session, dialect_word};
pub use text::{Outcome, TextOptions, run_text};
pub use world_clock::WorldClock;

/// The simulated machine of a run that takes no time.
pub fn simulated() -> Driven {
    Simulated::driven(())
}
