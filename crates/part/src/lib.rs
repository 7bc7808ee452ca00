//! A part file, whichever language it is in.
//!
//! ShopBot's controllers run OpenSBP and G-code, also line by line in one file (command reference,
//! FP). The two languages know nothing of each other; here they share one machine:
//!
//! ```text
//!            ┌────────── Interpreter ───────────┐
//!  read ──►  │ sbp ── a file or a line of G-code │ ──► commands
//!            │  ▲        is due ──► gcode ──┐    │
//!            │  └── position, frame ◄───────┘    │
//!            └───────────────────────────────────┘
//! ```
//!
//! - [`read`] gives a [`Program`] and everything that is wrong with it, in either language.
//! - The [`Interpreter`] steps OpenSBP. A file of G-code is to it a file that FP opened: proportions,
//!   offset, repetitions and plunges are the same for both. While G-code runs, OpenSBP stands still.
//! - What G-code remembers between files (offsets of G54 and the rest, parameters, tools, modes)
//!   stays in [`kerf_gcode::State`], and survives the run in a [`Session`].

mod files;
mod guest;
mod interp;
mod library;
mod program;
#[cfg(test)]
mod tests;

pub use interp::{Interpreter, Options, Session};
pub use program::{Program, read, read_as};
