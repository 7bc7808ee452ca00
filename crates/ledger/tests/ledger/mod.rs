//! The rows of the ledgers, a module an area.

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
