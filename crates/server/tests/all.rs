//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::expect_used, clippy::print_stdout, clippy::unwrap_used, non_snake_case)]

mod asked;
mod controller;
mod controller_card;
mod digitize;
mod drawing;
mod gate;
mod given_up;
mod hand_console;
mod hand_console_serial;
mod hand_functions;
mod job;
mod jobs;
mod jog;
mod jog_board;
mod language;
mod open_file_state;
mod preview_mode;
mod ran;
mod requests;
mod safety;
mod saving;
mod shop;
mod status;
mod stop_forms;
mod support;
mod timing;
mod who_may_what;
