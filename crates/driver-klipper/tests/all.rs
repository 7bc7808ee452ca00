//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::expect_used, clippy::unwrap_used, clippy::print_stdout, missing_docs, dead_code)]

mod bytes;
mod compress;
mod crew;
mod drivers;
mod line;
mod measured;
mod motion;
mod mutated;
mod queue;
mod recorded;
mod refused;
mod session;
#[path = "../../../tests/corpus/shared.rs"]
mod shared;
mod world;
