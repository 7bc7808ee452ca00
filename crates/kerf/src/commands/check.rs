//! `kerf check`: what is wrong or doubtful in part files.

use crate::args::{Format, RunArgs};
use crate::checked::Checked;
use crate::drawings::DamagedFile;
use crate::exit::{Exit, Usage};
use crate::report::colour;
use crate::sources::FileLines;
use crate::{checked, given, out, setup};
use anyhow::Result;
use clap::Args;
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace, render_text};
use kerf_trace::{Event, Summary, json};
use std::io;
use std::path::{Path, PathBuf};

/// Reads and dry-runs part files and tells everything that is wrong or doubtful
///
/// Files that a part file names (FP, C#) are checked too. Nothing outside changes. Branches that a run
/// would not take are read, but not run.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf check box.sbp\n  kerf check *.sbp --format json\n\n\
    Exit codes: 0 clean or warnings only, 1 errors, 2 the command line was wrong or a file cannot be read")]
pub struct CheckArgs {
    /// The part files
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    #[command(flatten)]
    run: RunArgs,
}

pub fn run(args: &CheckArgs) -> Result<Exit> {
    let (mut found, mut runs, mut unread) = (Vec::new(), String::new(), false);
    for file in &args.files {
        let checked = check(file, &args.run)?;
        unread |= checked.is_none();
        let checked = checked.unwrap_or_else(|| unreadable(file));
        let new = checked.diagnostics.into_iter().filter(|d| !found.contains(d));
        found.extend(new.collect::<Vec<_>>());
        runs += &checked.summary.map_or_else(String::new, |s| told(file, &s));
    }
    out::print(&match args.format {
        Format::Json => as_json(&found),
        Format::Text => as_text(&found, &runs, args.files.len()),
    });
    let failed = found.iter().any(Diagnostic::is_error);
    Ok(match (unread, failed) {
        (true, _) => Exit::Usage,
        (_, true) => Exit::Failed,
        _ => Exit::Good,
    })
}

/// A named file that cannot be read: one finding among those of the others.
fn unreadable(file: &Path) -> Checked {
    let why = given::bytes(file).err();
    let why = why.map_or_else(|| "cannot be read".into(), |why| why.to_string());
    let place = SourcePlace::line(file.display().to_string().into(), 1);
    let missing = Diagnostic::new(Code::FileNotFound, place, why);
    Checked { diagnostics: vec![missing], summary: None }
}

/// Checks a file; nothing where it cannot be read.
fn check(file: &Path, args: &RunArgs) -> Result<Option<Checked>> {
    let mut job = match setup::prepare(file, args, true) {
        Ok(job) => job,
        Err(error) if error.is::<Usage>() && given::bytes(file).is_err() => return Ok(None),
        Err(error) => {
            let DamagedFile(_, why) = error.downcast::<DamagedFile>()?;
            let place = SourcePlace::line(file.display().to_string().into(), 1);
            let damaged = Diagnostic::new(Code::FileError, place, why.to_string());
            return Ok(Some(Checked { diagnostics: vec![damaged], summary: None }));
        }
    };
    let (work, options) = (job.work, job.options);
    let found = checked::check(&job.session, work, options, &mut job.workspace, &mut job.answers);
    Ok(Some(found))
}

fn as_json(found: &[Diagnostic]) -> String {
    let events: Vec<Event> = found.iter().map(|d| Event::Diag(Box::new(d.clone()))).collect();
    json::to_string(&events) + "\n"
}

/// Tells the duration of a file and the bounds of its cuts.
fn told(file: &Path, summary: &Summary) -> String {
    let cutting = out::bounds(summary).map_or_else(String::new, |b| format!(", cutting {b}"));
    format!("{}: {}{cutting}\n", file.display(), out::duration(summary.seconds))
}

fn as_text(found: &[Diagnostic], runs: &str, files: usize) -> String {
    let lines = FileLines::default();
    let colour = colour(&io::stdout());
    let drawn = found.iter().map(|d| render_text(d, &lines, colour) + "\n\n");
    drawn.collect::<String>() + runs + &summary(found, files) + "\n"
}

/// `2 errors, 1 warning`, or that nothing is wrong.
fn summary(found: &[Diagnostic], files: usize) -> String {
    let count = |severity| found.iter().filter(|d| d.severity == severity).count();
    let words = [
        (count(Severity::Error), "error"),
        (count(Severity::Warning), "warning"),
        (count(Severity::Note), "note"),
    ];
    let told: Vec<String> = words
        .into_iter()
        .filter(|(n, _)| *n > 0)
        .map(|(n, word)| format!("{n} {word}{}", if n == 1 { "" } else { "s" }))
        .collect();
    if !told.is_empty() {
        return told.join(", ");
    }
    if files == 1 { "nothing wrong".into() } else { format!("nothing wrong in {files} files") }
}
