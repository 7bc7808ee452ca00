//! OpenSBP, the ShopBot language.
//!
//! ```text
//!  bytes ──read──► Program (a line is a node; a bad line is a node with its diagnostics)
//!                     │
//!            Interpreter::step ──► program::Command …      asks everything through program::Host
//!                     ▲
//!                  table: one entry a command: letters, parameters, documentation, effect as data
//! ```
//!
//! - [`read`] never fails and never stops at the first mistake.
//! - The [`Interpreter`] is a value: cloned, saved and restored between any two steps. It never
//!   blocks; when the host has no answer yet the step has no effect and is repeated.
//! - [`table`] is the only list of commands. Parameter checking, defaults, help, the reference page
//!   and completion are made from it.
//!
//! `syntax` holds the language as text, `run` above it the interpreter; `syntax` does not know `run`.
//! The crate knows nothing of planning, machines, files or clocks.

#[cfg(test)]
mod corpus;
mod run;
mod syntax;
#[cfg(test)]
mod testing;

pub use run::{
    BeforePreview, EDITOR, FileParameters, FilePlace, GcodeDone, GcodeDue, Interpreter, LAST_ERROR,
    Options, PART_FILE, POSITION_LOST, RECORDED, RECORDING, SPINDLE_STATUS, Session, Status, Step,
    SystemVariable, VERSION, Variables, Watch, system_variables, with_recorded,
};
pub use syntax::{
    BinaryOp, Dialect, Expr, ExprId, ExprNode, Expressions, Function, GCODE_ENDINGS, Header,
    Language, NamedFile, PART_ENDINGS, Path, PathId, PathStep, Printing, Program, SbpPrinter,
    TextId, UnaryOp, Value, check, check_until, format, format_as, format_number, is_gcode_name,
    is_part_name, print, read, read_as, read_part, read_part_as, read_typed, statement_words,
    stops_on_keys, table, tree,
};
