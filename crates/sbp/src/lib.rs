//! OpenSBP, the ShopBot language.
//!
//! ```text
//!  bytes ──read──► Program (a line is a node; a bad line is a node with its diagnostics)
//!                     │
//!            Interpreter::step ──► program::Command …      asks everything through program::Host
//!                     ▲
//!                  table: one entry a command: letters, parameters, documentation, effect
//! ```
//!
//! - [`read`] never fails and never stops at the first mistake.
//! - The [`Interpreter`] is a value: cloned, saved and restored between any two steps. It never
//!   blocks; when the host has no answer yet the step has no effect and is repeated.
//! - [`table`] is the only list of commands. Parameter checking, defaults, help, the reference page
//!   and completion are made from it.
//!
//! The crate knows nothing of planning, machines, files or clocks.

mod arithmetic;
mod check;
#[cfg(test)]
mod corpus;
mod eval;
mod expr;
mod format;
mod header;
mod interp;
mod named_files;
mod number;
mod printer;
mod reader;
pub mod table;
#[cfg(test)]
mod testing;
pub mod tree;
mod typed;
mod value;
mod walk;

pub use check::{check, check_until, stops_on_keys};
pub use expr::{
    BinaryOp, Expr, ExprId, ExprNode, Expressions, Function, Path, PathId, PathStep, TextId,
    UnaryOp,
};
pub use format::{format, format_as};
pub use header::Header;
pub use interp::{
    BeforePreview, Dialect, EDITOR, FileParameters, FilePlace, GcodeDone, GcodeDue, Interpreter,
    LAST_ERROR, Options, PART_FILE, POSITION_LOST, RECORDED, RECORDING, SPINDLE_STATUS, Session,
    Status, Step, SystemVariable, VERSION, Variables, Watch, system_variables, with_recorded,
};
pub use named_files::NamedFile;
pub use number::format_number;
pub use printer::{Printing, SbpPrinter, print};
pub use reader::{
    GCODE_ENDINGS, PART_ENDINGS, is_gcode_name, is_part_name, read, read_as, read_part,
    read_part_as, statement_words,
};
pub use tree::{Language, Program};
pub use typed::read_typed;
pub use value::Value;
