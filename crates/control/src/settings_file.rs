//! The settings file: what the machine knows between sessions, as a part file that sets it.
//!
//! Settings are the lines that UV shows; the last line, VA, says what the place where the machine
//! stood is called. Axis C has no place in VA: it starts at 0. People may read the file and change
//! it; a mistake in it is told with its line.

use crate::session::{Company, RunOptions, Session};
use crate::shelf::Shelf;
use crate::{Event, files::MemoryDisk};
use kerf_diag::Diagnostic;
use kerf_program::settings::to_user;
use kerf_program::{Axes, Axis, Frame, Settings};
use kerf_sbp::Options;
use std::sync::Arc;

/// Name of the file in the data folder.
pub const SETTINGS_FILE: &str = "settings.sbd";

/// Begins a file whose locations are those before a run that has not come to its end.
const UNDER_WAY: &str = "'A run is under way: the locations below are those before it.";

/// Lines that reading a settings file may execute.
const MOST_LINES: u64 = 10_000;

/// What a settings file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Restored {
    /// Settings, frames and position.
    pub memory: kerf_sbp::Session,
    /// The run after which the file would have been written never came to its end: the machine may
    /// stand elsewhere.
    pub unverified: bool,
}

/// The text of the settings file. Of a preview that was not left, what was before it is kept.
/// `under_way` marks the file until the run that begins now is over.
pub fn write(memory: &kerf_sbp::Session, under_way: bool) -> String {
    let mut lines = vec!["'Settings and locations of Kerf, written when a run is over.".to_owned()];
    if under_way {
        lines.push(UNDER_WAY.into());
    }
    let (settings, frame, position) = match &memory.before_preview {
        Some(before) => (&*before.settings, &before.frame, before.position),
        None => (&memory.settings, &memory.frame, memory.position),
    };
    lines.extend(kerf_sbp::table::settings_lines(settings));
    lines.push(locations(settings, frame, position));
    lines.join("\n") + "\n"
}

/// VA with working and base locations in the user's units.
fn locations(settings: &Settings, frame: &Frame, position: Axes) -> String {
    let values = [frame.working(position), frame.base(position)].map(|place| {
        let axes = Axis::ALL.into_iter().take(5);
        axes.map(|axis| shown(to_user(place[axis], settings.axis_scale(axis)))).collect::<Vec<_>>()
    });
    format!("VA,{}", values.concat().join(","))
}

/// A billionth of a unit is below every step of every machine.
fn shown(value: f64) -> String {
    let rounded = (value * 1e9).round() / 1e9;
    format!("{}", rounded + 0.0)
}

/// Reads a settings file.
///
/// # Errors
/// The first mistake in it.
pub fn read(text: &str) -> Result<Restored, Box<Diagnostic>> {
    let program = kerf_sbp::read(Arc::from(SETTINGS_FILE), text.as_bytes());
    let program_options =
        Options { typed: true, base_locations: true, max_lines: MOST_LINES, ..Options::default() };
    let options = RunOptions { program: program_options, ..RunOptions::default() };
    let mut session = Session::default();
    let mut shelf = Shelf::in_memory(MemoryDisk::default());
    let mut events: Vec<Event> = Vec::new();
    let company = Company { sink: &mut events, operator: &mut (), pace: &mut () };
    let summary = session.run(program, options, &mut shelf, company);
    match summary.error {
        Some(error) => Err(error),
        None => Ok(Restored {
            memory: session.memory,
            unverified: text.lines().any(|line| line.trim() == UNDER_WAY),
        }),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::text::{TextOptions, run_text};

    fn after(program: &str) -> kerf_sbp::Session {
        run_text(&[("a.sbp", program)], "a.sbp", TextOptions::default()).session.memory
    }

    #[test]
    fn sbp_val_va_store() {
        let memory = after("M3,4,5,6\nZT\nM3,8,10,12\nVA,1,2,3\n");
        let text = write(&memory, false);
        assert_eq!(text.lines().last(), Some("VA,1,2,3,0,0,4,5,6,0,0"));
        let back = read(&text).unwrap().memory;
        let places = |m: &kerf_sbp::Session| {
            let user = |place| m.settings.to_user(place).0;
            (user(m.frame.working(m.position)), user(m.frame.base(m.position)))
        };
        assert_eq!(places(&back), places(&memory));
        assert_eq!(write(&back, false), text, "once more changes nothing");
    }

    #[test]
    fn settings_come_back_in_either_unit() {
        for program in ["VC,.375\nSR\nSW,3", "VD,,5,1,0,2\nVC,9.5\nVN,,,,,2,2", ""] {
            let memory = after(program);
            let text = write(&memory, false);
            assert_eq!(write(&read(&text).unwrap().memory, false), text);
        }
        assert!(write(&after("VC,.375"), false).contains("\nVC,0.375,"));
    }

    #[test]
    fn temporary_values_are_not_kept() {
        assert_eq!(write(&after("VS,9\nVL,0,3\nVO,1,2"), false), write(&after(""), false));
    }

    #[test]
    fn of_a_preview_what_was_before_it_is_kept() {
        let text = write(&after("MX,1\nSP\nMX,5\nVC,2"), false);
        assert_eq!(text, write(&after("MX,1"), false));
    }

    #[test]
    fn a_run_that_never_ended_leaves_its_mark() {
        let memory = after("MX,1");
        assert!(read(&write(&memory, true)).unwrap().unverified);
        assert!(!read(&write(&memory, false)).unwrap().unverified);
    }

    #[test]
    fn a_mistake_is_told_with_its_line() {
        let error = read("VC,.25\nVC,x\n").unwrap_err();
        assert_eq!((error.place.line, &*error.place.file), (2, SETTINGS_FILE));
    }
}
