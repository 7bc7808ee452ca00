//! The language: text to tree and back. It knows nothing of how a program runs.
//!
//! ```text
//!  bytes ── text lines moves ── reader ──► tree ── format ──► text
//!                                 │
//!            codes, gathered, checks: which words a block may hold
//!  commands ── writer ──► text
//! ```

mod checks;
pub mod codes;
pub(crate) mod dialect;
pub(crate) mod expr;
pub(crate) mod format;
pub(crate) mod gathered;
mod lines;
pub(crate) mod moves;
pub(crate) mod no_path;
mod node;
mod plain_move;
pub(crate) mod reader;
pub(crate) mod text;
pub mod tree;
pub(crate) mod writer;
