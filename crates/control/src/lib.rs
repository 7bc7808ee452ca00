//! One owner of one machine: runs programs on it and tells what happens.
//!
//! ```text
//!  Session::run ── Runner    the loop: commands, stacks of moves, plans, waits
//!                    │
//!                  Stops     what follows on a stop; every way back may be stopped again
//!                    │
//!                  Station ── Interpreter            asks World: machine, operator, files
//!                    │  └──── Drive, Machine         time passes, moves are made
//!                    └──────► Sink: Event, Event, …  trace, picture, progress
//! ```
//!
//! A floor calls those below it and nothing above. What ends a run comes up as the error `RunEnd`.
//!
//! - [`Session`] is what stays between runs; [`Session::run`] is one run, and what it is lent is a [`RunContext`].
//! - [`AtRest`] is its machine while it stands.
//! - [`Event`](kerf_trace::Event) is one thing that a run tells; a [`Sink`](kerf_trace::Sink) takes events.
//! - [`controller`] runs the same on a real machine: the plan is the same, who makes it is not.
//! - [`Workspace`](kerf_workspace::Workspace) is everything on disk that a program may reach. A preview gets a copy that keeps its
//!   writes to itself.
//! - [`run_text`] does it all in memory: for tests, editors, whoever has no disk.
//!
//! The same program, settings, files, answers and inputs give the same events, byte for byte.

pub mod answers;
mod asking;
mod at_rest;

mod by_hand;
mod command_limit;
pub mod controller;
mod diagnostics;
mod drive;
mod execute;
mod follow;
mod hand_words;
mod happenings;
mod hold;
mod homing;
mod host;
mod interruption;
mod kept_pace;
mod learned;
mod lift_aside;
mod map_followed;
mod map_pieces;
mod mapped;
mod nudge;
mod on_record;
mod own_pace;
mod passing;
mod pendant;
mod preparation;
mod reentry;
mod requests;
mod run_context;
mod run_end;
mod run_summary;
mod runner;
mod runs;
mod session;
pub mod settings_text;
mod stack;
mod station;
mod stopped_spindles;
mod stopping;
mod table_limits;
mod text;
mod told_heights;
mod tracked;
mod trail;
mod waiting;
mod way_back;
mod whole_run;
mod world;
mod world_clock;

use kerf_machine::driver::Facts;
use kerf_sim::{Opened, Simulated};

pub use at_rest::AtRest;
pub use diagnostics::{diagnostics, system_variables};
pub use hand_words::{Jog, LIFT};
pub use kept_pace::kept_pace;
pub use learned::Learned;
pub use nudge::{Nudge, Outside};
pub use own_pace::{Clocks, OwnPace, OwnTime};
pub use requests::{OperatorRequest, Requests, Script, StopAt};
pub use run_context::RunContext;
pub use runs::dialect_word;
pub use session::{DrivenBy, Session};
pub use text::{Outcome, TextOptions, run_text};
pub use world_clock::WorldClock;

/// The simulated machine of a run that takes no time.
pub fn simulated() -> Opened {
    Simulated::opened(())
}

/// The same for a dry run of what another machine is to make: what that one carries beside the plan, this one leaves to it.
pub(crate) fn simulated_for(facts: &Facts) -> Opened {
    Simulated::new(()).leaving_torch(facts.follows_torch).open()
}
