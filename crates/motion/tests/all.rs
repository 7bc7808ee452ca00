//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::unwrap_used)]

mod chunks;
mod clocked;
mod controllers;
mod moves;
mod optimal;
mod profiler;
mod properties;
mod ramps;
mod replans;
mod shop;
mod steps;
mod stops;
mod walk;
