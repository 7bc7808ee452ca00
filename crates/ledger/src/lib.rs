//! The rows of the ledgers, told in their own words.
//!
//! A row says what must be observed when a few lines of OpenSBP run; a test says the same:
//!
//! ```
//! use kerf_ledger::{at, run, sbp};
//!
//! run("MX,1 ⏎ MY,2").ends_at([1.0, 2.0]);
//! at([1.0, 1.0], "M2,, 4.2").ends_at([1.0, 4.2]);
//! sbp("INPUT \"Depth?\" &d ⏎ MZ,&d").answers(&["-.25"]).run().ends_at([0.0, 0.0, -0.25]);
//! ```
//!
//! Programs run from the state the ledgers call S0 (inches, three axes, everything at 0), on the
//! simulated machine, through the same door as the command line; everything is read from the trace
//! that `kerf trace` prints, so the tests hold the contract of the trace as well. `⏎` separates
//! lines as in the ledgers.
//!
//! The tests lie in `tests/ledger`, a file an area, a test a row, named after it: `SBP-CMD-MX` is
//! `sbp_cmd_mx`. Rows that a crate shows in its own tests are not repeated here.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout)]

mod case;
pub mod hand_console;
pub mod jobs;
mod read;
mod run;
pub mod traces;

pub use case::{Case, at, gcode, run, sbp};
pub use run::Run;
