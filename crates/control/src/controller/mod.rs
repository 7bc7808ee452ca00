//! A run on a real controller.
//!
//! The run is the same as on the simulated machine: the plan says where every axis goes, the model of the
//! machine keeps outputs, frames and times. What is different is who decides *when* a move is made and
//! *where* a stop ends: the controller does, and the run follows it.
//!
//! ```text
//!  Runner ── pass(move) ───► Drive ─── advance, stop ──► Machine: Connection ── orders ──► Link ── Driver ──► controller
//!  World  ── set(output) ──────────────────────────────►   │                                               │
//!     ▲                                                    │                                               │
//!     └── made, or where it stands ◄───────────────────────┴────────────── status reports ◄────────────────┘
//! ```
//!
//! - Moves of a plan are sent ahead, so that the controller never has to stop between them; the run goes on
//!   with the next move when the controller has made one.
//! - A stop is the controller's own: it slows down on the path and is reset where it stands. From the place
//!   that it tells the moment of the plan is found, and the run stands there too.
//! - Times of the trace are those of the plan. The controller takes its own.

mod attached;
mod card;
mod chords;
mod connection;
mod driven;
mod either;
mod kept_settings;
mod lacks;
mod line_file;
mod line_log;
mod lost;
pub(crate) mod merged;
mod ordered_outputs;
pub mod queued;
mod row;
#[cfg(test)]
mod sent_tests;
mod socket;
mod stopwatch;
mod touch_off;
mod turned;
mod zeros;

pub use attached::{AttachReport, First};
pub use card::{CardEnd, CardState, CardWish, do_on_card, follow_card};
pub use connection::Connection;
pub use either::{Controller, Place, dry_run};
pub use kept_settings::{STEPS, WrittenSetting, question_in, settings_in};
pub use lacks::{Lacks, lines, output_name, output_of_name, wired};
pub use line_file::HEAD;
pub use line_log::{LineLog, LoggedLine, Portion};
pub use socket::{Ends, Opens, Socket};
pub use touch_off::TouchedOff;
pub use zeros::{change_zero, working_reads, zeros_of};
