//! FC: a file of the part folder becomes a part file beside it.

use crate::desk::Desk;
use crate::shelf::Shelf;
use kerf_convert::{Conversion, Language, Source};
use kerf_gcode::Dialect;
use kerf_program::{FileConversion, FileRequest, Folder, HostError, Settings};
use std::path::Path;

/// Kinds of files that are known, but cannot be converted yet.
const TO_COME: [&str; 9] = ["dxf", "plt", "hpg", "hpgl", "bmp", "jpg", "png", "svg", "bitmap"];

/// Converts a file for a machine with these settings. `kind` says what it is, where its name does not.
///
/// # Errors
/// There is no such file, it is of a kind that is not converted yet, it does not run, or the part file
/// cannot be written.
pub fn convert(
    shelf: &mut Shelf,
    settings: &Settings,
    name: &str,
    kind: Option<&str>,
    overwrite: bool,
) -> Result<FileConversion, HostError> {
    let file = shelf.source(&FileRequest { folder: Folder::Parts, name: name.into() })?;
    let kind = kind.map_or_else(|| extension(name), |kind| kind.replace("g-code", "nc"));
    if TO_COME.contains(&kind.as_str()) {
        return Err(HostError::Refused(format!(
            "{name}: drawings and pictures are not converted yet"
        )));
    }
    let from = match Language::of_file(&format!("x.{kind}"), Dialect::Generic) {
        Some(from @ Language::Gcode(_)) => from,
        _ => return Ok(FileConversion::Unknown),
    };
    let target = Path::new(name).with_extension("sbp").display().to_string();
    if shelf.has(&target) && !overwrite {
        return Ok(FileConversion::Exists(target));
    }
    let source = Source { name: file.name.clone(), bytes: &file.bytes, language: from };
    let text = part_file(shelf, settings, name, &source)?;
    let written = shelf.put(&target, text.as_bytes());
    written.map_err(|e| HostError::Refused(format!("cannot write {target}: {e}")))?;
    Ok(FileConversion::Made(target))
}

fn extension(name: &str) -> String {
    let extension = Path::new(name).extension().unwrap_or_default();
    extension.to_string_lossy().to_ascii_lowercase()
}

/// The text of the part file.
fn part_file(
    shelf: &mut Shelf,
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
    // G-code reads files and writes none, so the shelf stays as it is.
    let converted = kerf_convert::convert(source, &conversion, &mut |follow| {
        follow(&mut Desk::new(shelf, &mut ()))
    });
    converted.text.ok_or_else(|| {
        let found = converted.diagnostics.iter().find(|d| d.is_error());
        let why =
            found.map_or_else(String::new, |d| format!("line {}: {}", d.place.line, d.message));
        HostError::Refused(format!("{name} was not converted: {why}"))
    })
}
