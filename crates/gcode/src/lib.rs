//! G-code (RS-274) as routers, lasers and LinuxCNC users write it.
//!
//! ```text
//!  bytes ──read──► Program (a line is a node; a bad line is a node with its diagnostics)
//!                     │
//!            Interpreter::step ──► program::Command …      asks everything through program::Host
//!                                        │
//!                                      write ──► G-code
//!  text ──format──► the same program, tidy
//! ```
//!
//! - [`read`] never fails and never stops at the first mistake.
//! - The [`Interpreter`] is a value: cloned, saved and restored between any two steps. It never
//!   blocks; when the host has no answer yet the step has no effect and is repeated.
//! - [`codes`] is the only list of codes and of what excludes what.
//!
//! The crate knows nothing of planning, machines, files or clocks.

mod run;
mod syntax;
#[cfg(test)]
mod testing;

pub use run::{
    CoordinateSystem, FeedMode, Interpreter, Modal, Options, Plane, Rates, Session, Side, State,
};
pub use syntax::dialect::Dialect;
pub use syntax::expr::{Expr, Function, Operator};
pub use syntax::format::format;
pub use syntax::no_path::no_path;
pub use syntax::reader::{looks_like_opensbp, read, read_text};
pub use syntax::tree::Program;
pub use syntax::writer::{Writer, Writing, write};
pub use syntax::{codes, tree};
