//! The progress of a transfer, for people who watch it.

use crate::transfer::{Progress, State};
use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// Interval between reports.
const OFTEN: Duration = Duration::from_secs(1);

/// Tells name, bytes and rate: on a terminal in one line, else line by line.
pub struct Shown {
    quiet: bool,
    since: Option<Instant>,
    told: Option<(Instant, State)>,
}

impl Shown {
    /// Nothing is told of a quiet one.
    pub const fn new(quiet: bool) -> Self {
        Self { quiet, since: None, told: None }
    }

    /// It has come so far.
    pub fn tell(&mut self, state: &State, progress: &Progress) {
        if *state == State::Waiting || self.quiet {
            return;
        }
        let since = *self.since.get_or_insert_with(Instant::now);
        let due =
            self.told.as_ref().is_none_or(|(at, before)| at.elapsed() > OFTEN || before != state);
        if !due {
            return;
        }
        self.told = Some((Instant::now(), state.clone()));
        let Progress { name, done, total } = progress;
        let rate = *done as f64 / since.elapsed().as_secs_f64().max(1e-3);
        let end = match state {
            State::Held => ", held: the machine moves",
            State::Done => ", done",
            State::Stopped => ", stopped",
            _ => "",
        };
        let line = format!("{name} {done}/{total} bytes, {rate:.0} bytes/s{end}");
        if io::stderr().is_terminal() {
            eprint!("\r\x1b[K{line}{}", if state.is_over() { "\n" } else { "" });
            drop(io::stderr().flush());
        } else {
            eprintln!("{line}");
        }
    }
}
