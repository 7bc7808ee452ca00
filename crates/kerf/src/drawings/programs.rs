//! Drawings from programs: what G-code or a part file cuts, as shapes.

use crate::report::Diagnostics;
use anyhow::{Result, bail};
use kerf_control::files::{Folders, RealDisk};
use kerf_control::stored::Stored;
use kerf_control::{Desk, Shelf};
use kerf_convert::{Conversion, Language, Source};
use kerf_formats::{Finding, Imported, Weight, motion};
use kerf_gcode::Dialect;
use kerf_program::Axes;
use kerf_program::settings::{LinearUnit, Settings};
use std::path::{Path, PathBuf};

/// Whether a file is a program that can be drawn.
pub fn is_program(file: &Path) -> bool {
    language(file).is_some()
}

fn language(file: &Path) -> Option<Language> {
    Language::of_file(&file.display().to_string(), Dialect::Generic)
}

/// What a program cuts. It is followed as in a preview, from millimetres and zeros; a program that does
/// not run to its end gives no drawing.
pub fn read(file: &Path, bytes: &[u8]) -> Result<Imported> {
    let Some(from) = language(file) else { bail!("{} is no program", file.display()) };
    let source = Source { name: file.display().to_string().into(), bytes, language: from };
    let mut settings = Settings::default();
    settings.use_linear_unit(LinearUnit::Mm);
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
    let mut desk =
        |follow: &mut dyn FnMut(&mut dyn kerf_program::Host) -> kerf_convert::Passage| {
            let folders = Folders::new(parts.into(), Vec::new(), Vec::new());
            let mut shelf = Shelf::preview(RealDisk, folders, &Stored::default(), PathBuf::new());
            follow(&mut Desk::new(&mut shelf, &mut ()))
        };
    let passage = kerf_convert::path(&source, &how, &mut desk, Axes::default());
    let shown = Diagnostics::default();
    passage.diagnostics.iter().for_each(|diagnostic| shown.show(diagnostic));
    if passage.diagnostics.iter().any(kerf_diag::Diagnostic::is_error) {
        bail!("{}: a program with errors is not drawn", file.display());
    }
    let mut read = motion::read(passage.commands(), passage.start);
    if let Language::Gcode(_) = from {
        let ignored = kerf_gcode::no_path(&kerf_gcode::read(source.name, bytes));
        read.findings.extend(ignored.map(|text| Finding { line: 0, weight: Weight::Note, text }));
    }
    Ok(read)
}
