//! A part file made ready for the card of a controller, which runs it without Kerf.
//!
//! G-code goes there as it is. A part file of OpenSBP and a job become G-code for grblHAL, followed and read back as
//! `kerf convert` does: places are those of the zero point that holds when the file is run, so that a file on the card is
//! good wherever the workpiece lies.

use crate::host::ConversionHost;
use crate::job_file;
use kerf_convert::{Conversion, Language, Source};
use kerf_formats::ending;
use kerf_gcode::{Dialect, Writer, Writing};
use kerf_machine::Configuration;
use kerf_program::{Printer, Settings};
use kerf_sequence::Speeds;
use kerf_workspace::Workspace;
use std::path::Path;

/// A file for the card.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CardFile {
    /// Its name there.
    pub name: String,
    /// Its content.
    pub content: Vec<u8>,
    /// Findings made on the way.
    pub notes: Vec<String>,
}

/// Makes a part file or a job ready for the card; the workspace has to be one for previews.
///
/// # Errors
/// It is none, or cannot be said in G-code, a sentence.
pub fn for_card(
    name: &str,
    bytes: &[u8],
    (settings, machine): (&Settings, &Configuration),
    workspace: &mut Workspace,
) -> Result<CardFile, String> {
    let file = Path::new(name);
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let converted = |(text, notes): (String, Vec<String>)| CardFile {
        name: format!("{stem}.nc"),
        content: ended(text).into_bytes(),
        notes,
    };
    match Language::of_file(name, Dialect::GrblHal) {
        Some(Language::Gcode(_)) => Ok(CardFile {
            name: file.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            content: bytes.to_vec(),
            notes: Vec::new(),
        }),
        Some(Language::OpenSbp) => part_file(name, bytes, settings, workspace).map(converted),
        None if ending(name) == "rsm" => job(name, bytes, settings, machine).map(converted),
        None => {
            Err(format!("{name} is no part file: .nc .tap .ngc .gcode .sbp and .rsm go on a card"))
        }
    }
}

/// Ends with `M30`: behind `M2` grblHAL waits to run the file once more.
fn ended(text: String) -> String {
    match text.trim_end().strip_suffix("\nM2") {
        Some(program) => format!("{program}\nM30\n"),
        None => text,
    }
}

fn part_file(
    name: &str,
    bytes: &[u8],
    settings: &Settings,
    workspace: &mut Workspace,
) -> Result<(String, Vec<String>), String> {
    let source = Source { name: name.into(), bytes, language: Language::OpenSbp };
    let conversion = Conversion {
        from: source.language,
        to: Language::Gcode(Dialect::GrblHal),
        settings: settings.clone(),
        sbp: kerf_sbp::Options::default(),
        variables: kerf_sbp::Variables::default(),
        keep_variables: false,
        coolant_outputs: [0, 0],
        title: format!("Converted from {name}"),
    };
    let made = kerf_convert::convert(&source, &conversion, &mut |follow| {
        follow(&mut ConversionHost::new(workspace, &mut |_| None))
    });
    let told = |d: &kerf_diag::Diagnostic| format!("{name}:{}: {}", d.place.line, d.message);
    let wrong = made.diagnostics.iter().find(|d| d.is_error()).map(told);
    let notes = made.diagnostics.iter().map(told).collect();
    made.text
        .map(|text| (text, notes))
        .ok_or_else(|| wrong.unwrap_or_else(|| format!("{name} cannot be said in G-code")))
}

fn job(
    name: &str,
    bytes: &[u8],
    settings: &Settings,
    machine: &Configuration,
) -> Result<(String, Vec<String>), String> {
    let (job, findings) =
        job_file::read(bytes, settings.smoothing.factor).map_err(|why| format!("{name}: {why}"))?;
    let writing = Writing { title: Some(format!("Converted from {name}")), ..Writing::default() };
    let mut printer: Box<dyn Printer> = Box::new(Writer::new(&writing));
    let noticed = job_file::print(&job, machine, Speeds::Written, printer.as_mut())
        .map_err(|wrong| format!("{name}: {}", wrong.join("; ")))?;
    let notes = findings.into_iter().map(|found| found.text).chain(noticed).collect();
    Ok((printer.finish().text, notes))
}
