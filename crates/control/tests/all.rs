//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::expect_used, clippy::unwrap_used, clippy::print_stdout, non_snake_case)]

mod away;
mod conformance;
mod damaged;
mod damaged_journal;
mod driven;
mod given_up;
mod hold;
mod interlock;
mod journal;
mod late_news;
mod linuxcnc;
mod lost_line;
mod machine_file;
mod no_switch;
mod over_lines;
mod own_planner;
mod place_and_nudge;
mod queued;
mod queued_boards;
mod queued_guards;
mod queued_height;
mod queued_homing;
mod queued_killed;
mod queued_laser;
mod queued_outputs;
mod queued_stops;
mod queued_switches;
mod queued_watched;
mod references;
mod registry;
mod runs;
mod settings_files;
#[path = "../../../tests/corpus/shared.rs"]
mod shared;
mod step_path;
mod streaming;
mod taken_up;
mod taking_up;
mod vcd;
#[allow(dead_code, reason = "its other tests use the rest")]
#[path = "../../driver-grbl/tests/wire.rs"]
mod wire;
