//! Commands to OpenSBP.
//!
//! The counterpart of the interpreter: arcs stay arcs (CG), dwells are PAUSE, outputs SO, and where a
//! program moves its zero, VA does. Places are working locations in the unit of the file. What
//! OpenSBP has no word for becomes a comment that says so and is told beside the text.
//!
//! Speeds are where the languages differ most. A feed counts along the path; OpenSBP gives XY and Z
//! a speed each (see `speeds`).

mod arcs;
mod commands;
mod file;
mod moves;
mod places;
mod printing;
mod speeds;
mod switches;
#[cfg(test)]
mod tests;
mod written_speeds;

pub use file::SbpPrinter;
pub use printing::Printing;

use kerf_program::{Printer as _, Sourced, Written};

/// Writes a program.
pub fn print(commands: &[Sourced], printing: &Printing) -> Written {
    let mut printer = SbpPrinter::new(printing);
    for sourced in commands {
        printer.command(sourced);
    }
    Box::new(printer).finish()
}
