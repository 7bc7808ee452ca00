//! The tests of this crate from outside, one program.

#![allow(clippy::unwrap_used)]

mod arcs;
mod card;
mod conformance;
mod faults;
mod fluid_card;
mod gap;
mod kept_settings;
mod set_up;
mod tool_wait;
mod turned;
mod wire;
