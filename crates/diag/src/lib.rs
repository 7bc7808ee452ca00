//! Diagnostics that tell a person about a mistake: where it is, what is wrong, how to mend it.
//!
//! A [`Diagnostic`] carries a stable [`Code`], a [`SourcePlace`] in a file, one sentence of message and
//! one of hint. The table of codes in [`codes`] is the only list there is: `kerf explain`, the
//! reference pages and the tests read it. [`render_text`] draws diagnostics like a compiler does.

pub mod codes;
mod diagnostic;
mod render;
mod repetitions;
mod suggest;
mod text;

pub use codes::{Code, Explanation, explain};
pub use diagnostic::{Diagnostic, Severity, SourcePlace};
pub use render::{Sources, render_text};
pub use repetitions::Repetitions;
pub use suggest::did_you_mean;
pub use text::{decode, with_commas};
