//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::unwrap_used, non_snake_case)]

#[path = "../../pocket/tests/check/mod.rs"]
mod check;
mod cleared;
mod edit;
mod engrave;
#[path = "../../geom/tests/families/mod.rs"]
mod families;
mod plates;
#[path = "../../pocket/tests/random/mod.rs"]
mod random;
mod rows;
mod travel;
