//! The file of what G-code remembers between sessions: offsets of G54 and the rest, the places of G28
//! and G30, parameters, tools. People may read it and change it; a mistake in it is told with its
//! line. Modes are in it too, for lines that are typed one by one; a file begins with the usual ones.

use kerf_diag::{Code, Diagnostic, Place};
use kerf_gcode::State;
use std::sync::Arc;

/// Name of the file in the data folder.
pub const GCODE_FILE: &str = "gcode.json";

/// The text of the file; `None` when G-code has nothing to remember.
pub fn write(state: &State) -> Option<String> {
    let text = || serde_json::to_string_pretty(state).ok();
    (*state != State::default()).then(text).flatten().map(|text| text + "\n")
}

/// Reads the file.
///
/// # Errors
/// The first mistake in it.
pub fn read(text: &str) -> Result<State, Box<Diagnostic>> {
    serde_json::from_str(text).map_err(|error| {
        let place = Place {
            column: error.column() as u32,
            ..Place::line(Arc::from(GCODE_FILE), error.line() as u32)
        };
        Box::new(Diagnostic::new(Code::FileError, place, error.to_string()))
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::text::{TextOptions, run_text};

    #[test]
    fn what_g_code_remembers_comes_back() {
        let program = "G10 L2 P2 X1.5 Y.1\nG55\n#500=7.25\n#<_depth>=3\nG10 L1 P3 R.125 Z1\nG28.1";
        let state = run_text(&[("a.nc", program)], "a.nc", TextOptions::default()).session.gcode;
        assert_eq!(state.systems[1].offset.0[0], 1.5 * 25.4);
        let text = write(&state).unwrap();
        assert_eq!(read(&text).unwrap(), state);
        assert_eq!(write(&State::default()), None);
    }

    #[test]
    fn a_mistake_is_told_with_its_line() {
        let error = read("{\n\"modal\": 3\n}").unwrap_err();
        assert_eq!((error.place.line, &*error.place.file), (2, GCODE_FILE));
    }
}
