//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::unwrap_used)]

mod check;
#[path = "../../geom/tests/families/mod.rs"]
mod families;
mod random;
mod rings;
mod zigzag;
