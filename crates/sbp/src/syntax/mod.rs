//! The language as text: its tree, reader, printer, formatter, checks, and the table of its commands.
//!
//! ```text
//!  check  format  printer  typed  walk
//!                 reader
//!             tree    table ── act: the effect of a command, as data
//!        expr   value   dialect
//! ```
//!
//! Nothing here knows how a program runs; `cargo xtask check` holds that.

mod arithmetic;
mod check;
mod dialect;
pub(crate) mod expr;
pub(crate) mod format;
mod header;
mod named_files;
mod number;
mod printer;
pub(crate) mod reader;
pub mod table;
pub mod tree;
mod typed;
pub(crate) mod value;
mod walk;

pub(crate) use arithmetic::operate;
pub use check::{check, check_until, stops_on_keys};
pub use dialect::Dialect;
pub use expr::{
    BinaryOp, Expr, ExprId, ExprNode, Expressions, Function, Path, PathId, PathStep, TextId,
    UnaryOp,
};
pub use format::{format, format_as};
pub use header::Header;
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
