//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::unwrap_used)]

#[path = "../../geom/tests/families/mod.rs"]
mod families;
mod first_part;
mod heap;
mod nested;
mod parts;
mod rows;
mod warnings;
