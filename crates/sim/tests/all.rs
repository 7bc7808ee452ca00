//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::unwrap_used, non_snake_case)]

mod bench;
mod conformance;
mod controller;
mod homing;
mod unreliable;
