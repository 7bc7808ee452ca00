//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::print_stdout, clippy::unwrap_used)]

mod bombs;
mod corpus;
mod dxf;
#[path = "../../../tests/corpus/find.rs"]
mod find;
mod hpgl;
mod malformed;
mod motion;
mod svg;
mod svg_seen;
