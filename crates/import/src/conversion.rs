//! FC: a file of the part folder becomes a part file beside it.

use crate::drawn::{self, Drawn};
use crate::host::ConversionHost;
use kerf_convert::{Conversion, Language, Source};
use kerf_formats::{Format, ending};
use kerf_gcode::Dialect;
use kerf_journal::Kind;
use kerf_program::{
    ConversionRequest, CutChoice, FileConversion, FileRequest, Folder, HostError, Printer, Settings,
};
use kerf_sbp::{Printing, SbpPrinter};
use kerf_workspace::Workspace;
use std::path::Path;

/// Converts a file of the part folder to a part file beside it (FC). What it reads and writes is one step of the tape.
///
/// # Errors
/// As [`converted`].
pub fn convert(
    workspace: &mut Workspace,
    settings: &Settings,
    request: &ConversionRequest,
) -> Result<FileConversion, HostError> {
    let mut tape = std::mem::take(&mut workspace.tape);
    let told = tape.change(Kind::Convert, || converted(workspace, settings, request));
    workspace.tape = tape;
    told
}

/// Converts a file for a machine with these settings, or tells what has to be asked first.
///
/// # Errors
/// There is no such file, it is of a kind that is not converted yet, it does not run, or the part file
/// cannot be written.
fn converted(
    workspace: &mut Workspace,
    settings: &Settings,
    request: &ConversionRequest,
) -> Result<FileConversion, HostError> {
    let (name, mut settings) = (&request.name, settings.clone());
    let file = workspace.source(&FileRequest { folder: Folder::Parts, name: name.clone() })?;
    let kind = request.kind.as_deref().map_or_else(|| ending(name), extension_of_answer);
    let language = Language::of_file(&format!("x.{kind}"), Dialect::Generic);
    let is_drawn = Format::of_ending(&kind).is_some();
    if !is_drawn && !matches!(language, Some(Language::Gcode(_))) {
        return Ok(FileConversion::Unknown);
    }
    let target = Path::new(name).with_extension("sbp").display().to_string();
    if workspace.has(&target) && !request.overwrite {
        return Ok(FileConversion::Exists(target));
    }
    match request.unit {
        Some(unit) => settings.use_linear_unit(unit),
        None if is_drawn || !says_its_unit(name, &file.bytes) => {
            return Ok(FileConversion::Unit(settings.linear_unit));
        }
        None => {}
    }
    let text = match (language, request.cut) {
        (Some(from), _) if !is_drawn => {
            let source = Source { name: file.name.clone(), bytes: &file.bytes, language: from };
            part_file(workspace, &settings, name, &source)?
        }
        (_, Some(cut)) => drawn_part_file(&settings, name, &file.bytes, &kind, cut)?,
        _ => {
            return Ok(FileConversion::Cut(drawn::usual_choice(&kind, settings.linear_unit)));
        }
    };
    let written = workspace.put(&target, text.as_bytes());
    written.map_err(|e| HostError::Refused(format!("cannot write {target}: {e}")))?;
    Ok(FileConversion::Made(target))
}

/// Tells whether a file of G-code says if its numbers are inches or millimetres.
fn says_its_unit(name: &str, bytes: &[u8]) -> bool {
    kerf_gcode::read(name.into(), bytes).says_its_unit()
}

/// Turns the answer to the question of FC into an extension.
fn extension_of_answer(kind: &str) -> String {
    match kind.to_ascii_lowercase().as_str() {
        "g-code" => "nc".into(),
        "bitmap" => "bmp".into(),
        kind => kind.to_owned(),
    }
}

/// The part file of a drawing or a picture; how it is cut stands in the file's head.
fn drawn_part_file(
    settings: &Settings,
    name: &str,
    bytes: &[u8],
    kind: &str,
    cut: CutChoice,
) -> Result<String, HostError> {
    let unit = settings.linear_unit;
    let how = Drawn::of(cut);
    let title = format!("Converted from {name}\n{}", how.settings_line(kind, unit));
    let printing = Printing { unit, title: Some(title), ..Printing::default() };
    let mut printer = SbpPrinter::new(&printing);
    let refused = |error| HostError::Refused(format!("{name} was not converted: {error}"));
    drawn::print(bytes, kind, &how, &mut printer).map_err(refused)?;
    let printer: Box<dyn Printer> = Box::new(printer);
    Ok(printer.finish().text)
}

/// The text of the part file.
fn part_file(
    workspace: &mut Workspace,
    settings: &Settings,
    name: &str,
    source: &Source<'_>,
) -> Result<String, HostError> {
    let units = settings.linear_unit.symbol();
    let conversion = Conversion {
        from: source.language,
        to: Language::OpenSbp,
        settings: settings.clone(),
        sbp: kerf_sbp::Options::default(),
        variables: kerf_sbp::Variables::default(),
        keep_variables: false,
        coolant_outputs: [0, 0],
        title: format!("Converted from {name}\nSettings: machine in {units}"),
    };
    // G-code reads files and writes none, so the workspace stays as it is.
    let converted = kerf_convert::convert(source, &conversion, &mut |follow| {
        follow(&mut ConversionHost::new(workspace, &mut |_| None))
    });
    converted.text.ok_or_else(|| {
        let found = converted.diagnostics.iter().find(|d| d.is_error());
        let why =
            found.map_or_else(String::new, |d| format!("line {}: {}", d.place.line, d.message));
        HostError::Refused(format!("{name} was not converted: {why}"))
    })
}
