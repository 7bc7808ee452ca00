//! Settings as a part file that sets them: the lines that UV shows, in the order in which they have
//! to be carried out. The journal keeps settings so, and settings files (.sbd) are the same text.

use crate::run_context::RunContext;
use crate::session::Session;
use kerf_diag::Diagnostic;
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_program::Settings;
use kerf_sbp::Options;
use kerf_trace::Event;
use kerf_workspace::Workspace;
use std::sync::Arc;

/// The name of the text where a mistake in it is told.
const NAME: &str = "settings.sbd";

/// Lines that reading settings may execute.
const MOST_LINES: u64 = 10_000;

/// The text that sets these.
pub fn write(settings: &Settings) -> String {
    let head = "'Settings of Kerf.".to_owned();
    let lines = std::iter::once(head).chain(kerf_sbp::table::settings_lines(settings));
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

/// The settings that a text sets.
///
/// # Errors
/// The first mistake in it.
pub fn read(text: &str) -> Result<Settings, Box<Diagnostic>> {
    let program = kerf_sbp::read(Arc::from(NAME), text.as_bytes());
    let program_options =
        Options { typed: true, base_locations: true, max_lines: MOST_LINES, ..Options::default() };
    let options = RunOptions { program: program_options, ..RunOptions::default() };
    let mut session = Session::default();
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let mut events: Vec<Event> = Vec::new();
    let context = RunContext {
        sink: &mut events,
        operator: &mut (),
        requests: &mut (),
        machine: crate::simulated(),
    };
    let summary = session.run(program, options, &mut workspace, context);
    match summary.error {
        Some(error) => Err(error),
        None => Ok(session.memory.settings),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::text::{TextOptions, run_text};

    fn after(program: &str) -> Settings {
        let ran = run_text(&[("a.sbp", program)], "a.sbp", TextOptions::default());
        ran.session.memory.settings
    }

    #[test]
    fn settings_come_back_in_either_unit() {
        for program in ["VC,.375\nSR\nSW,3", "VD,,5,1,0,2\nVC,9.5\nVN,,,,,2,2", ""] {
            let text = write(&after(program));
            assert_eq!(write(&read(&text).unwrap()), text);
        }
        assert!(write(&after("VC,.375")).contains("\nVC,0.375,"));
    }

    #[test]
    fn temporary_values_are_not_kept() {
        assert_eq!(write(&after("VS,9\nVL,0,3\nVO,1,2")), write(&after("")));
    }

    #[test]
    fn a_mistake_is_told_with_its_line() {
        let error = read("VC,.25\nVC,x\n").unwrap_err();
        assert_eq!((error.place.line, &*error.place.file), (2, NAME));
    }
}
