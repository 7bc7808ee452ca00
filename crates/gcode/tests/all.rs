//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod conformance;
mod fast_road;
#[path = "../../../tests/corpus/find.rs"]
mod find;
mod mutated;
mod oracle;
mod properties;
mod support;
