//! A program as everything it does, written in another language.

use crate::compare::{Comparing, SAME_MM, same_motion};
use crate::follow::follow;
use crate::item::{Item, Passage};
use crate::kept::{self, KEPT_MM, Unkept};
use crate::start::{ODD, says_its_height, says_its_places, zeros_in_machine};
use crate::times::{cutting_s, switched};
use crate::{Conversion, Converted, Hosts, Language, Source};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_gcode::{Writer, Writing};
use kerf_program::settings::LinearUnit;
use kerf_program::{At, Axes, Axis, Command, Lost, Printer, Settings, Status, Written};
use kerf_sbp::{Printing, SbpPrinter};
use std::sync::Arc;

/// Cutting times of a program that keeps its variables may differ by this share: speeds of shallow
/// slopes, and the seven digits of variables.
const SAME_SHARE: f64 = 0.006;

/// Greatest distance of chords from an arc of G18 and G19 in a drawing, mm: where one stands upright the chords
/// beside it become half as long again, and stay within a hundredth.
const DRAWN_MM: f64 = 0.004;

/// Converts by following the program.
pub fn convert(source: &Source<'_>, how: &Conversion, hosts: Hosts<'_, '_>) -> Converted {
    let (passage, start) = passage(source, how, hosts);
    if !ended_well(&passage) {
        let mut diagnostics = passage.diagnostics;
        if !diagnostics.iter().any(Diagnostic::is_error) {
            diagnostics.push(stopped(source));
        }
        return Converted { text: None, diagnostics };
    }
    let mut unkept = None;
    if how.keep_variables {
        match keep(source, &passage, how, start, hosts) {
            Ok(text) => {
                let diagnostics = told_before(&passage, source, start);
                return Converted { text: Some(text), diagnostics };
            }
            Err(diagnostic) => unkept = Some(diagnostic),
        }
    }
    let (passage, start) = with_heights(passage, start, source, how, hosts);
    let mut diagnostics = told_before(&passage, source, start);
    diagnostics.extend(unkept);
    as_moves(&passage, start, how, hosts, diagnostics)
}

/// Returns what following the program told.
fn told_before(passage: &Passage, source: &Source<'_>, start: Axes) -> Vec<Diagnostic> {
    let from_here = (start == Axes::default()).then(|| from_here(passage, source));
    passage.diagnostics.iter().cloned().chain(from_here).collect()
}

/// Moves by numbers have to know every height; a part file with variables asks for it when it runs.
fn with_heights(
    passage: Passage,
    start: Axes,
    source: &Source<'_>,
    how: &Conversion,
    hosts: Hosts<'_, '_>,
) -> (Passage, Axes) {
    if start == Axes::default() || says_its_height(&passage) {
        return (passage, start);
    }
    let zeros = passage.zeros;
    (Passage { zeros, ..run(source, how, hosts, Axes::default(), false) }, Axes::default())
}

/// The program as the moves it makes.
fn as_moves(
    passage: &Passage,
    start: Axes,
    how: &Conversion,
    hosts: Hosts<'_, '_>,
    mut diagnostics: Vec<Diagnostic>,
) -> Converted {
    let (unit, settings) = settings_for(how, passage);
    let written = write(passage, how, &settings, unit, start);
    diagnostics.extend(written.lost.iter().map(|lost| told(lost, passage, how.to)));
    if written.lost.iter().any(|lost| lost.is_motion) {
        return Converted { text: None, diagnostics };
    }
    let how = &Conversion { keep_variables: false, ..how.clone() };
    if let Err(difference) = read_back(passage, &written.text, how, &settings, start, hosts) {
        diagnostics.push(difference);
        return Converted { text: None, diagnostics };
    }
    Converted { text: Some(written.text), diagnostics }
}

/// Converts tree to tree, if that gives the same motion, speeds and switching.
fn keep(
    source: &Source<'_>,
    passage: &Passage,
    how: &Conversion,
    start: Axes,
    hosts: Hosts<'_, '_>,
) -> Result<String, Diagnostic> {
    let settings = &settings_for(how, passage).1;
    let unkept = |unkept: Unkept| {
        let place = SourcePlace::line(source.name.clone(), unkept.line);
        Diagnostic::new(Code::NotKept, place, format!("variables are not kept: {}", unkept.what))
            .hint("the file was written as the moves it makes")
    };
    let keeping = Conversion { settings: settings.clone(), ..how.clone() };
    let text = kept::convert(source, &keeping).map_err(unkept)?;
    let found = read_back(passage, &text, how, settings, start, hosts).map_err(|difference| {
        unkept(Unkept { line: difference.place.line, what: difference.message })
    })?;
    let [first, second] = [cutting_s(passage, &how.settings), cutting_s(&found, settings)];
    if (first - second).abs() > SAME_SHARE * first + 1e-6 || switched(passage) != switched(&found) {
        let what = "its speeds or switches would not be the same".into();
        return Err(unkept(Unkept { line: 1, what }));
    }
    Ok(text)
}

/// Returns what the program does, and where it was followed from.
fn passage(source: &Source<'_>, how: &Conversion, hosts: Hosts<'_, '_>) -> (Passage, Axes) {
    let odd = run(source, how, hosts, ODD, false);
    if !ended_well(&odd) {
        return (odd, ODD);
    }
    let zero = run(source, how, hosts, Axes::default(), false);
    let zeros = zeros_in_machine(&odd, &zero);
    if says_its_places(&odd, &zero) {
        return (Passage { zeros, ..odd }, ODD);
    }
    (Passage { zeros, ..zero }, Axes::default())
}

pub(crate) fn run(
    source: &Source<'_>,
    how: &Conversion,
    hosts: Hosts<'_, '_>,
    start: Axes,
    path_only: bool,
) -> Passage {
    hosts(&mut |host| match source.language {
        Language::OpenSbp => {
            let program = kerf_sbp::read(source.name.clone(), source.bytes);
            let refused = program.has_errors() && !how.sbp.allow_errors;
            let diagnostics = program.diagnostics.clone();
            if refused {
                return Passage { diagnostics, ..Passage::default() };
            }
            let session = kerf_sbp::Session {
                settings: how.settings.clone(),
                position: start,
                variables: how.variables.clone(),
                ..kerf_sbp::Session::default()
            };
            let options = kerf_sbp::Options { preview: true, ..how.sbp.clone() };
            let lines = program.lines.len();
            let mut passage =
                follow(kerf_sbp::Interpreter::new(program, session, options), lines, host);
            passage.diagnostics.splice(0..0, diagnostics);
            passage
        }
        Language::Gcode(dialect) => {
            let program = kerf_gcode::read(source.name.clone(), source.bytes);
            let diagnostics = program.diagnostics.clone();
            if program.has_errors() {
                return Passage { diagnostics, ..Passage::default() };
            }
            let mut settings = how.settings.clone();
            settings.axis_count = 6;
            let session = kerf_gcode::Session { settings, position: start, ..Default::default() };
            let plain = kerf_gcode::Options::default();
            let options = kerf_gcode::Options {
                dialect,
                preview: true,
                max_lines: how.sbp.max_lines,
                proportion: how.sbp.file.proportion,
                path_only,
                speeds_known: path_only || how.to == Language::OpenSbp,
                tolerance_mm: if path_only { DRAWN_MM } else { plain.tolerance_mm },
                ..plain
            };
            let lines = program.line_count() as usize;
            let mut passage =
                follow(kerf_gcode::Interpreter::new(program, session, options), lines, host);
            passage.diagnostics.splice(0..0, diagnostics);
            passage
        }
    })
}

/// A program that does not reach its end would be half a part.
fn ended_well(passage: &Passage) -> bool {
    let ended = matches!(passage.status, Some(Status::Ok | Status::Ended));
    ended && !passage.diagnostics.iter().any(Diagnostic::is_error)
}

/// The unit and the settings that the written file begins with.
fn settings_for(how: &Conversion, passage: &Passage) -> (LinearUnit, Settings) {
    let unit = passage.at_motion.as_ref().map_or(how.settings.linear_unit, |(unit, _)| *unit);
    let mut settings = how.settings.clone();
    settings.use_linear_unit(unit);
    if let Some(axis) = passage.last_axis().filter(|axis| axis.index() >= 3) {
        settings.axis_count = settings.axis_count.max(axis.index() as u8 + 1);
        if let (Some((_, there)), Language::OpenSbp) = (&passage.at_motion, how.from) {
            settings.rotary_units = there.rotary_units;
        }
    }
    (unit, settings)
}

fn write(
    passage: &Passage,
    how: &Conversion,
    settings: &Settings,
    unit: LinearUnit,
    start: Axes,
) -> Written {
    let shared = Arc::new(settings.clone());
    let title = Some(how.title.clone()).filter(|title| !title.is_empty());
    let [mist_output, flood_output] = how.coolant_outputs;
    match how.to {
        Language::OpenSbp => {
            let declare_axes = settings.axis_count != how.settings.axis_count
                || settings.rotary_units[0] != how.settings.rotary_units[0]
                    && passage.last_axis().is_some_and(|axis| axis >= Axis::A);
            let printing = Printing {
                unit,
                position: start,
                settings: shared,
                declare_axes,
                mist_output,
                flood_output,
                title,
                ..Printing::default()
            };
            fill(Box::new(SbpPrinter::new(&printing)), passage)
        }
        Language::Gcode(dialect) => {
            let writing = Writing {
                dialect,
                unit,
                position: start,
                settings: shared,
                mist_output,
                flood_output,
                title,
                ..Writing::default()
            };
            fill(Box::new(Writer::new(&writing)), passage)
        }
    }
}

fn fill(mut printer: Box<dyn Printer + '_>, passage: &Passage) -> Written {
    let mut zeros = passage.zeros.iter();
    for item in &passage.items {
        match item {
            Item::Command(sourced) => {
                if let Command::Location { frame, .. } = &sourced.command
                    && let Some((at, axes)) = zeros.find(|(at, _)| *at == sourced.at)
                    && !axes.is_empty()
                {
                    printer.zero_at(*at, frame, *axes);
                }
                printer.command(sourced);
            }
            Item::Beside(text) => printer.comment_beside(text),
            Item::Hold(hold) => printer.hold(hold),
            Item::NextTool(name) => printer.next_tool(name),
            Item::Lost(lost) => printer.lose(lost.clone()),
        }
    }
    printer.finish()
}

/// The program ended before its end: an answer stopped it.
fn stopped(source: &Source<'_>) -> Diagnostic {
    let place = SourcePlace::line(source.name.clone(), 1);
    let message = "the program was stopped before its end: nothing is converted";
    Diagnostic::new(Code::NotConverted, place, message)
        .severity(Severity::Error)
        .hint("--answers FILE answers its questions, --set NAME=VALUE gives a variable a value")
}

/// The program goes on from where the tool stands.
fn from_here(passage: &Passage, source: &Source<'_>) -> Diagnostic {
    let line = passage.commands().find(|s| s.command.is_motion()).map_or(1, |s| s.at.line);
    let message = "the program goes on from where the tool stands: converted as if that were zero";
    let place = SourcePlace::line(source.name.clone(), line);
    Diagnostic::new(Code::StartTaken, place, message)
        .hint("put the tool at zero before the converted file runs")
}

fn told(lost: &Lost, passage: &Passage, to: Language) -> Diagnostic {
    let language = match to {
        Language::OpenSbp => "OpenSBP",
        Language::Gcode(_) => "G-code",
    };
    let place = SourcePlace::line(passage.file(lost.at), lost.at.line);
    let message = format!("not in {language}: {}", lost.what);
    let severity = if lost.is_motion { Severity::Error } else { Severity::Warning };
    Diagnostic::new(Code::NotConverted, place, message).severity(severity)
}

/// Reads what was written, follows it and compares.
fn read_back(
    passage: &Passage,
    text: &str,
    how: &Conversion,
    settings: &Settings,
    start: Axes,
    hosts: Hosts<'_, '_>,
) -> Result<Passage, Diagnostic> {
    let name: Arc<str> = Arc::from("converted file");
    let again = Source { name, bytes: text.as_bytes(), language: how.to };
    // The machine has the axes that it has, whatever the file says. One that turns has its unit already, so that
    // naming it does not move it.
    let reading = Conversion {
        settings: Settings { axis_count: how.settings.axis_count, ..settings.clone() },
        sbp: kerf_sbp::Options::default(),
        ..how.clone()
    };
    let found = run(&again, &reading, hosts, start, false);
    let differs = |at: At, what: String| {
        let place = SourcePlace::line(passage.file(at), at.line);
        Diagnostic::new(Code::ConversionDiffers, place, what)
            .hint("nothing was written; this is a fault of Kerf, please report it with the file")
    };
    if !ended_well(&found) {
        let first = found.diagnostics.iter().find(|d| d.is_error());
        let what =
            first.map_or_else(String::new, |d| format!("line {}: {}", d.place.line, d.message));
        return Err(differs(
            At { file: 0, line: 1 },
            format!("the converted file does not run: {what}"),
        ));
    }
    let comparing = Comparing {
        start,
        own_tool_changes: how.to == Language::OpenSbp,
        same_mm: if how.keep_variables { KEPT_MM } else { SAME_MM },
        chords: how.to == Language::OpenSbp,
    };
    same_motion(passage.commands(), found.commands(), comparing).map_err(|difference| {
        let line = difference.line;
        differs(difference.at, format!("{} (line {line} of the converted file)", difference.what))
    })?;
    Ok(found)
}
