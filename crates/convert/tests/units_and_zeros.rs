//! Zeros of the machine and units of linear axes: both languages have to mean the same by them.

use crate::support::{GENERIC, GRBL, LINUXCNC, SBP, converted, followed, plain};
use kerf_convert::{Conversion, Language, Passage};
use kerf_program::settings::LinearUnit::{self, Inch, Mm};
use kerf_program::{Axes, Command};

fn six_axes(from: Language, to: Language, unit: LinearUnit) -> Conversion {
    let mut how = plain(from, to, unit);
    how.settings.axis_count = 6;
    how
}

#[track_caller]
fn converts(from: Language, to: Language, unit: LinearUnit, text: &str) -> String {
    let name = if from == SBP { "part.sbp" } else { "part.nc" };
    let made = converted(name, text.as_bytes(), &six_axes(from, to, unit), ".".into());
    made.text.unwrap_or_else(|| panic!("{text}: {:?}", made.diagnostics))
}

fn end(passage: &Passage) -> Axes {
    let places = passage.commands().filter_map(|s| match &s.command {
        Command::Line(line) => Some(line.to),
        _ => None,
    });
    places.last().unwrap()
}

/// End of a program of a language that begins at zero.
fn end_of(text: &str, language: Language, unit: LinearUnit) -> Axes {
    end(&followed("x", text.as_bytes(), &six_axes(language, SBP, unit), ".".into()))
}

#[test]
fn a_zero_that_lies_at_a_place_of_the_machine_is_written_as_that() {
    let text = "G21 G90\nF600\nG10 L2 P1 X5 Y-5 Z1\nG1 X0 Y0 Z0\nM2\n";
    let part = converts(GENERIC, SBP, Mm, text);
    assert!(part.contains("VA,%(1)+%(6)-5,%(2)+%(7)+5,%(3)+%(8)-1\n"), "{part}");
    for dialect in [GENERIC, GRBL, LINUXCNC] {
        let written = converts(GENERIC, dialect, Mm, text);
        assert!(written.contains("G10 L2 P1 X5 Y-5 Z1\n"), "{written}");
        assert!(!written.contains(".98"), "{written}");
    }
    // The written file goes there from wherever it begins.
    assert_eq!(end_of(&part, SBP, Mm), Axes::xyz(5.0, -5.0, 1.0));
    // A zero that is taken from the tool stays so, and a shift above the system stays above it.
    assert!(converts(GENERIC, SBP, Mm, "G21 G90 F600\nG92 X3\nG1 X4\nM2\n").contains("VA,3\n"));
    let both = "G21 G90 F600\nG92 X3 Y2\nG10 L2 P1 Z5\nG0 X4 Y0\nG1 Z0\nM2\n";
    let written = converts(GENERIC, LINUXCNC, Mm, both);
    assert!(written.contains("G92 X3 Y2\nG10 L2 P1 Z5\n"), "{written}");
}

#[test]
fn a_linear_axis_is_measured_alike_in_both_languages() {
    let code = "G20 G90 F60\nG1 A1\nM2\n";
    let ends = |text: &str, language, unit| end_of(text, language, unit).0[3];
    assert_eq!(ends("MA,1\n", SBP, Inch), 25.4);
    assert_eq!(ends(code, GENERIC, Inch), 25.4);
    assert_eq!(ends(&code.replace("G20", "G21"), GENERIC, Mm), 1.0);
    let part = converts(GENERIC, SBP, Inch, code);
    assert_eq!(ends(&part, SBP, Inch), 25.4, "{part}");
    let written = converts(SBP, LINUXCNC, Inch, "MA,1\nM2,1,2\n");
    assert!(written.contains("A1"), "{written}");
    assert_eq!(ends(&written, LINUXCNC, Inch), 25.4, "{written}");
}

#[test]
fn a_warning_is_told_once_with_a_count() {
    let slow: String = (1..=200).map(|n| format!("G1 X{n} F{}\n", n % 70 + 1)).collect();
    let text = format!("G21 G90\nG0 X0\nM4 S9\n{slow}M5\nM4\nG1 X0\nM2\n");
    let made = converted("part.nc", text.as_bytes(), &plain(GENERIC, SBP, Mm), ".".into());
    let told: Vec<_> =
        made.diagnostics.iter().map(|d| (d.place.line, d.message.as_str())).collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(
        told[0].0 == 3 && told[0].1.ends_with("(1 more like it, the last in line 205)"),
        "{told:?}"
    );
    assert!(told[1].1.contains("VS begins at 1.27 (200 more like it"), "{told:?}");
    // The text says it at each place.
    let part = made.text.unwrap();
    assert!(part.matches("VS begins at 1.27").count() > 100, "{}", part.len());
}
