//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::expect_used, clippy::print_stdout, clippy::unwrap_used, non_snake_case)]

mod bad_input;
mod beside_a_server;
mod bombs;
mod command;
mod command_line;
mod contradictions;
mod convert;
mod damaged_files;
mod descriptors;
mod draw;
mod ended_while_planning;
mod engrave;
mod examples;
mod faults;
#[path = "../../../tests/corpus/find.rs"]
mod find;
mod full_disk;
mod gcode;
mod glossary;
mod golden;
mod height_map;
mod heights;
mod hostile;
mod job_options;
mod keeping;
mod killed;
mod log;
mod machine;
mod mistakes;
mod nc;
mod outside;
mod own_corpus;
mod placed;
mod plot;
mod preview;
mod probing;
mod profiles;
mod programs;
mod registry;
mod replaced;
mod rows;
mod sending;
mod shop;
mod smoothing;
mod spared;
mod structured;
mod terminal;
mod three_d;
mod time;
mod toolpath;
mod traversal;
mod values;
mod values_between_commands;
mod warned;
