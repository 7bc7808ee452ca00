//! The rows of the Profiler ledger that jobs on a machine show, a module an area.

mod bounds;
mod console;
mod console_moves;
mod delays;
mod digitize;
mod digitize_console;
mod entry;
mod estop;
mod group;
mod height;
mod height_kept;
mod homing;
mod interlock;
mod job;
mod knife;
mod laser;
mod mark;
mod moves;
mod patient;
mod pause;
mod plasma;
mod said_while_waiting;
mod signals;
mod timing;
