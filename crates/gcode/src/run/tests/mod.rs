//! Tests of programs as data: a program and its motion, or what it tells.
#![allow(clippy::unwrap_used)]

mod controllers;
mod cycles;
mod linuxcnc_readings;
mod motion;
mod nudge;
mod placed;
mod posts;
mod programs;
mod state;

use crate::testing::{FakeHost, Ran, metric, run, run_with};
use crate::{Dialect, Options, Session};
use kerf_program::Tool;
use kerf_program::{Answer, Axes, Axis, Button, Command, Feed, Status};

/// The motion of a program in millimetres.
#[track_caller]
fn path(text: &str, expected: &str) {
    let ran = run(&format!("G21 F100⏎{text}"));
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    assert_eq!(ran.path(), expected, "{text}");
}

/// The code of the error that ends a program.
#[track_caller]
fn fails(text: &str, expected: &str) {
    let ran = run(&format!("G21 F100⏎{text}"));
    let found = ran
        .error
        .as_ref()
        .map(|e| format!("{} {}:{} {}", e.code, e.place.line, e.place.column, e.message));
    assert!(
        found.as_ref().is_some_and(|f| f.starts_with(expected)),
        "{text}: {found:?} is not {expected}"
    );
    assert_eq!(ran.status, Status::Failed);
}

/// Checks the commands that are given beside motion.
#[track_caller]
fn others(text: &str, expected: &str) {
    let ran = run(&format!("G21 F100⏎{text}"));
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    assert_eq!(ran.others(), expected, "{text}");
}

fn prints(text: &str, expected: &str) {
    others(&format!("{text}⏎(PRINT,#<_r>)"), &format!("print={expected}"));
}

fn feeds(ran: &Ran) -> Vec<Feed> {
    let feeds = ran.commands.iter().filter_map(|c| match &c.command {
        Command::Line(l) => Some(l.feed),
        Command::Arc(a) => Some(a.feed),
        _ => None,
    });
    feeds.collect()
}
