//! Drawings from programs: what G-code or a part file cuts, as shapes.

use crate::report::Diagnostics;
use anyhow::{Result, bail};
use kerf_convert::{Conversion, Language, Passage, Source};
use kerf_files::{Folders, RealDisk};
use kerf_formats::{Finding, Imported, Weight, motion};
use kerf_gcode::Dialect;
use kerf_import::ConversionHost;
use kerf_program::Axes;
use kerf_program::settings::{LinearUnit, Settings};
use kerf_workspace::{Workspace, stored::Stored};
use std::path::{Path, PathBuf};

/// Returns `true` if a file is a program that can be drawn.
pub fn is_program(file: &Path) -> bool {
    language(file).is_some()
}

fn language(file: &Path) -> Option<Language> {
    Language::of_file(&file.display().to_string(), Dialect::Generic)
}

/// Reads what a program cuts. It is followed as in a preview, from zeros, in the unit that is named; else a part file
/// in inches as it is run, and in millimetres where it does not run in inches, and G-code in millimetres. A program
/// that does not run to its end gives no drawing.
pub fn read(file: &Path, bytes: &[u8], units: Option<LinearUnit>) -> Result<Imported> {
    let Some(from) = language(file) else { bail!("{} is no program", file.display()) };
    let usual = if from == Language::OpenSbp { LinearUnit::Inch } else { LinearUnit::Mm };
    let mut passage = follow(file, bytes, from, units.unwrap_or(usual));
    let mut in_mm = None;
    if units.is_none() && from == Language::OpenSbp && !draws(&passage) {
        in_mm = Some(follow(file, bytes, from, LinearUnit::Mm)).filter(draws);
    }
    let is_metric = in_mm.is_some();
    passage = in_mm.unwrap_or(passage);
    let shown = Diagnostics::default();
    passage.diagnostics.iter().for_each(|diagnostic| shown.show(diagnostic));
    if has_errors(&passage) {
        bail!("{}: a program with errors is not drawn", file.display());
    }
    let mut read = motion::read(passage.commands(), passage.start);
    let mut note = |weight, text: String| read.findings.push(Finding::of_file(weight, text));
    if is_metric {
        note(Weight::Note, "read in millimetres: it does not run in inches".into());
    }
    if let Language::Gcode(_) = from {
        let ignored =
            kerf_gcode::no_path(&kerf_gcode::read(file.display().to_string().into(), bytes));
        ignored.into_iter().for_each(|text| note(Weight::Note, text));
    }
    if read.drawing.shapes.is_empty() {
        note(Weight::Warning, "the program cuts nothing".into());
    }
    Ok(read)
}

fn has_errors(passage: &Passage) -> bool {
    passage.diagnostics.iter().any(kerf_diag::Diagnostic::is_error)
}

/// Returns `true` if a program ran to its end and cut something.
fn draws(passage: &Passage) -> bool {
    !has_errors(passage)
        && !motion::read(passage.commands(), passage.start).drawing.shapes.is_empty()
}

fn follow(file: &Path, bytes: &[u8], from: Language, unit: LinearUnit) -> Passage {
    let source = Source { name: file.display().to_string().into(), bytes, language: from };
    let mut settings = Settings::default();
    settings.use_linear_unit(unit);
    let how = Conversion {
        from,
        to: from,
        settings,
        sbp: kerf_sbp::Options::default(),
        variables: kerf_sbp::Variables::default(),
        keep_variables: false,
        coolant_outputs: [0, 0],
        title: String::new(),
    };
    let parts = file.parent().unwrap_or(Path::new(""));
    let mut host = |follow: &mut dyn FnMut(&mut dyn kerf_program::Host) -> Passage| {
        let folders = Folders::new(parts.into(), Vec::new(), Vec::new());
        let mut workspace =
            Workspace::preview(RealDisk, folders, &Stored::default(), PathBuf::new());
        follow(&mut ConversionHost::new(&mut workspace, &mut |_| None))
    };
    kerf_convert::path(&source, &how, &mut host, Axes::default())
}
