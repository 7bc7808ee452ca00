//! Finds the mistakes in a text without running it.

use kerf_diag::{Diagnostic, Severity};
use kerf_program::settings::LinearUnit;
use kerf_sbp::Language;
use kerf_wire::{Checked, Finding, Level};

/// Reads a text as a part file of this name that is started by itself on a machine in a unit.
pub fn check(name: &str, text: &str, unit: LinearUnit) -> Checked {
    check_until(name, text, unit, &|| false)
}

/// The same, until it is given up: then what was found so far is no answer.
pub fn check_until(
    name: &str,
    text: &str,
    unit: LinearUnit,
    given_up: &dyn Fn() -> bool,
) -> Checked {
    let program = kerf_part::read(name.into(), text.as_bytes());
    let mut found: Vec<Diagnostic> = program.diagnostics.clone();
    if program.language() != Language::Gcode && !given_up() {
        found.extend(kerf_sbp::check_until(&program.sbp, Some(unit), given_up));
    }
    found.sort_by_key(|d| (d.place.line, d.place.column));
    Checked { findings: found.iter().map(finding).collect() }
}

/// Tells what cannot be read in lines of a larger text: nothing that needs the rest of it.
pub fn check_lines(name: &str, lines: &str) -> Checked {
    let program = kerf_sbp::read_part(name.into(), lines.as_bytes());
    let program = kerf_part::Program::from(program);
    Checked { findings: program.diagnostics.iter().map(finding).collect() }
}

/// A diagnostic as a page shows it.
pub fn finding(found: &Diagnostic) -> Finding {
    Finding {
        level: match found.severity {
            Severity::Error => Level::Error,
            Severity::Warning => Level::Warning,
            Severity::Note => Level::Note,
        },
        code: found.code.to_string(),
        file: found.place.file.to_string(),
        line: found.place.line,
        column: found.place.column,
        length: found.place.length,
        message: found.message.clone(),
        hint: found.hint.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mistakes_are_told_with_their_place_in_either_language() {
        let places = |name: &str, text: &str| {
            let found = check(name, text, LinearUnit::Inch).findings;
            let errors = found.into_iter().filter(|f| f.level == Level::Error);
            errors.map(|f| f.line).collect::<Vec<_>>()
        };
        assert_eq!(places("a.sbp", "SA\nMX,1\nMX,1,(2\n"), [3]);
        assert_eq!(places("a.nc", "G0 X1\nG1 X Y2\n"), [2]);
        assert!(places("a.sbp", "SA\nMX,1\n").is_empty());
    }

    #[test]
    fn lines_of_a_larger_text_are_told_by_themselves() {
        let lines = |text: &str| {
            let found = check_lines("a.sbp", text).findings;
            found.into_iter().map(|f| f.line).collect::<Vec<_>>()
        };
        assert_eq!(lines("MX,&depth\nMX,(2\nGOTO ELSEWHERE\n"), [2]);
        assert!(lines("\n\n").is_empty(), "the rest of the text is not empty");
    }

    #[test]
    fn a_jump_to_nowhere_is_a_finding() {
        let found = check("a.sbp", "GOTO NOWHERE\n", LinearUnit::Inch).findings;
        assert!(found.iter().any(|f| f.line == 1 && f.message.contains("NOWHERE")), "{found:?}");
    }
}
