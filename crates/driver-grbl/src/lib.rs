//! The protocol of grbl 1.1 and grblHAL as a value: orders go in, bytes come out, and the other way round.
//!
//! A controller of this family has a buffer of received characters, a planner with the next moves, and a row
//! of step segments that are as good as made. Motion goes on without a stop as long as the planner has
//! moves, so lines are sent ahead: as many as the buffer holds, counted by their characters (grbl
//! interface, "Streaming: character-counting").
//!
//! ```text
//!  Order ──► queue ──► sent, not answered ──► answered "ok": in the planner ──► done
//!                      (at most RX bytes)                   (status report: Bf)   (reply: Done)
//! ```
//!
//! An `ok` says that a line was understood, not that it was made. What was made is learnt from status
//! reports: they tell how many moves the planner still has. A move that has left the planner is in the row
//! of step segments for a moment longer ([`flights`]).
//!
//! Moves are sent in the controller's machine frame (`G53 G1`), so that work offsets which somebody left in
//! it do not matter. A stop is a feed hold; only when that stands is the controller reset, which keeps its
//! place.
//!
//! [`fake`] is a fake controller, for tests.

mod at_once;
mod card;
mod driver;
mod error_texts;
mod explained;
mod facts;
pub mod fake;
mod flights;
mod gap;
mod hears;
mod kept_settings;
mod lines;
mod own_words;
mod place;
mod report;
mod said;
pub mod settings;
mod signals;
mod tool_wait;
mod upload;
mod zeros;

pub use driver::Grbl;
