//! LinuxCNC as a value: orders go in, bytes for a bridge beside it come out, and the other way round.
//!
//! LinuxCNC is a program with its own operator's panel. It takes a program file, or single lines that it makes one at a
//! time (MDI) from a row of ten; only a file is looked through ahead. So orders are gathered into *pieces*: all that is
//! known up to the next stand becomes one file, and the next piece is begun when that one is made. ADR 17 tells what was
//! measured.
//!
//! ```text
//!  Order ──► gathered ──► piece ──► bridge: file, mode AUTO, run ──► LinuxCNC
//!            (GATHER_S)             bridge: which line, where, what is on ──► status ──► Done
//! ```
//!
//! The [bridge](BRIDGE) is a small program in Python that runs beside LinuxCNC and uses its public module. Each line between
//! the two has a check number, and a garbled one stops the machine. Orders are in LinuxCNC's machine frame (`G53`). A stop is
//! its abort, which slows down on the path and keeps the place.
//!
//! [`fake`] is a fake bridge, for tests.

mod check;
mod driver;
pub mod fake;
mod hears;
mod lines;
mod piece;
mod said;
mod status;
mod zeros;

pub use driver::LinuxCnc;

/// The program beside LinuxCNC.
pub const BRIDGE: &str = include_str!("bridge.py");

/// The port at which a bridge listens where none is named.
pub const PORT: u16 = 5107;
