//! The tests of this crate from outside, one program.

#![allow(clippy::unwrap_used)]

mod conformance;
mod wire;
