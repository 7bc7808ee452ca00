//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::print_stderr, clippy::unwrap_used)]

mod corpus;
#[path = "../../../tests/corpus/find.rs"]
mod find;
mod golden;
mod properties;
mod rs274;
mod support;
mod tool_changes;
mod units_and_zeros;
