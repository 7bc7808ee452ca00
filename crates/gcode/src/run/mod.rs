//! The stepped interpreter.
//!
//! An [`Interpreter`] executes one line a step and appends [`Command`](kerf_program::Command)s to a
//! list. It runs ahead of the machine as far as the language allows: a block that stops the program,
//! reads an input or probes first asks [`Host::settle`].
//!
//! Everything inside is millimetres, degrees and seconds; the file's units are converted where words
//! are read and where values are shown.
//!
//! ```text
//!  interpreter ─ fast::run_moves     runs of plain moves
//!              └ step::step ─ execute   one block, in the order of RS274/NGC 3.8
//!                   modes offsets spindle stops flow comments
//!                   motion ─ arc cycles spline probe ─ go ──► commands
//!  context      what a block is lent: the core, the host, the list of commands
//!  core         the whole state, as values that know nothing of each other's callers:
//!                 state coordinates place (compensation) calls progress under_way asking sequels
//! ```
//!
//! A file knows only files below it. Functions that give no commands are lent the values that they read and
//! return [`Refused`](stop::Refused); its place in the file is looked up once, where a step ends.

mod arc;
mod arc_words;
mod asking;
mod block;
mod call;
mod calls;
mod comments;
mod compensate;
mod compensation;
mod context;
mod controllers;
mod coordinates;
mod core;
mod curve;
mod cycles;
mod execute;
mod expression;
mod fast;
mod feed;
mod flat;
mod flow;
mod go;
mod hole;
mod interpreter;
mod io;
mod modes;
mod motion;
mod offsets;
mod parameters;
mod piece;
mod place;
mod probe;
mod progress;
mod round;
mod session;
mod spatial;
mod spindle;
mod spline;
mod state;
mod step;
mod stepping;
mod stop;
mod stops;
#[cfg(test)]
mod tests;
mod under_way;

pub use interpreter::Interpreter;
pub use session::{Options, Session};
pub use state::{CoordinateSystem, FeedMode, Modal, Plane, Rates, Side, State};
