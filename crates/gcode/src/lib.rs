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

mod checks;
pub mod codes;
mod expr;
mod format;
mod gathered;
mod interp;
mod lines;
mod no_path;
mod reader;
#[cfg(test)]
mod testing;
pub mod tree;
mod writer;

pub use expr::{Expr, Function, Operator};
pub use format::format;
pub use interp::{
    CoordinateSystem, Dialect, FeedMode, Interpreter, Modal, Options, Plane, Rates, Session, Side,
    State, Tool,
};
pub use no_path::no_path;
pub use reader::{looks_like_opensbp, read, read_text};
pub use tree::Program;
pub use writer::{Writer, Writing, write};
