//! The rows of the ledgers, a module an area.

#![allow(clippy::unwrap_used, clippy::expect_used, non_snake_case)]

mod cut;
mod file;
mod flow;
mod gcode;
mod headless;
mod height;
mod io;
mod lang;
mod limits;
mod motion;
mod motors;
mod moves;
mod outputs;
mod set;
mod step;
mod sysvar;
mod values;
mod zero;
