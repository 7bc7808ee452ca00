//! Part files to G-code, G-code to part files.
//!
//! ```text
//!  source ──read, follow──► commands, comments, questions ──Printer──► text
//!                                │                                      │
//!                                └───────────── compare ◄──read, follow─┘
//! ```
//!
//! - [`convert`] follows the program on paper: variables, loops, subroutines and Cut commands become
//!   the moves they make. Arcs stay arcs.
//! - What is written is read back and followed again. A file that would move the tool otherwise is
//!   never handed out.
//! - What the other language, or its controller, has no words for becomes a comment in the text and a
//!   diagnostic at the line that it comes from. Motion that cannot be said is an error.
//!
//! The crate knows no files and no clock; what a program asks for comes from hosts that the caller
//! gives.

mod compare;
mod conversion;
mod counted;
mod follow;
mod host;
mod item;
mod kept;
mod languages;
mod resolved;
mod start;
mod times;

pub use compare::{Comparing, Difference, SAME_MM, same_motion};
pub use conversion::{Conversion, Converted, Hosts, Language, Source};
pub use item::{Item, Passage};
pub use times::cutting_s;

use kerf_program::Axes;

/// Follows a program from a place, as a conversion does.
pub fn passage(
    source: &Source<'_>,
    how: &Conversion,
    hosts: Hosts<'_, '_>,
    start: Axes,
) -> Passage {
    resolved::run(source, how, hosts, start, false)
}

/// Follows the path of a program from a place, as a conversion does; what is no path does nothing.
pub fn path(source: &Source<'_>, how: &Conversion, hosts: Hosts<'_, '_>, start: Axes) -> Passage {
    resolved::run(source, how, hosts, start, true)
}

/// Converts a program.
pub fn convert(source: &Source<'_>, how: &Conversion, hosts: Hosts<'_, '_>) -> Converted {
    let made = resolved::convert(source, how, hosts);
    Converted { diagnostics: counted::told_once(made.diagnostics), ..made }
}
