//! `kerf fmt`: part files, tidied.

use crate::exit::{Exit, Usage};
use crate::given;
use crate::out;
use crate::parse::{self, Dialects};
use crate::report::Diagnostics;
use anyhow::{Context, Result, bail};
use clap::Args;
use kerf_diag::{Code, Diagnostic};
use kerf_sbp::{Dialect, Language};
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

/// Formats part files of both languages: capitals, commas, blanks; names, numbers and comments stay
///
/// Files are rewritten in place, whole or not at all. Lines that cannot be read stay as they are.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf fmt box.sbp\n  kerf fmt --check parts/\n  kerf fmt - < box.sbp\
    \n\nExit codes: 0 done, 1 with --check when a file would change, or no text, 2 the command line was wrong"
)]
pub struct FmtArgs {
    /// Part files, or folders with part files in them; - reads standard input and writes standard output
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Lists the files that would change, and changes none
    #[arg(long)]
    check: bool,
    /// Dialect of the files: sb3, fabmo or strict
    #[arg(long, default_value = "sb3", value_parser = parse::dialect)]
    dialect: Dialects,
}

pub fn run(args: &FmtArgs) -> Result<Exit> {
    args.files.iter().try_for_each(|file| refuse_others(file))?;
    let mut failed = false;
    for file in &part_files(&args.files)? {
        let outcome = one(file, args)?;
        failed |= outcome == Outcome::Refused || args.check && outcome == Outcome::Changes;
    }
    Ok(if failed { Exit::Failed } else { Exit::Good })
}

/// The name of standard input.
const STREAM: &str = "-";

/// Refuses what is no part file by its name: to a formatter every text is one.
fn refuse_others(file: &Path) -> Result<()> {
    let name = file.to_string_lossy();
    if name != STREAM && !file.is_dir() && !is_part_file(file) {
        let known: Vec<_> = kerf_sbp::PART_ENDINGS.iter().chain(&kerf_sbp::GCODE_ENDINGS).collect();
        let known = known.iter().map(|it| format!(".{it}")).collect::<Vec<_>>().join(" ");
        bail!(Usage(format!(
            "{name} is no part file by its ending: part files are {known}; rename it, or `kerf fmt - < {name}` \
             prints it formatted"
        )));
    }
    Ok(())
}

fn is_part_file(file: &Path) -> bool {
    let name = file.to_string_lossy();
    kerf_sbp::is_part_name(&name) || kerf_sbp::is_gcode_name(&name)
}

/// The files, and in place of each folder the part files in it and in those within, by their names.
fn part_files(named: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for path in named {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let entries = fs::read_dir(path).and_then(Iterator::collect::<io::Result<Vec<_>>>);
        let entries =
            entries.with_context(|| format!("cannot read the folder {}", path.display()))?;
        let mut inside: Vec<PathBuf> = entries.iter().map(fs::DirEntry::path).collect();
        // A link to a folder may lead back.
        inside.retain(|it| if it.is_dir() { !it.is_symlink() } else { is_part_file(it) });
        inside.sort();
        files.extend(part_files(&inside)?);
    }
    Ok(files)
}

/// Outcome of formatting a file.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// It is as it should be.
    Same,
    /// Formatting changes it.
    Changes,
    /// It is no text, or something else than a program.
    Refused,
}

/// Formats one file.
fn one(file: &Path, args: &FmtArgs) -> Result<Outcome> {
    let stream = file == Path::new(STREAM);
    let bytes = if stream { read_stream()? } else { read_file(file)? };
    if let Some(why) = refusal(file, &bytes, args.dialect.sbp) {
        Diagnostics::default().show(&why);
        return Ok(Outcome::Refused);
    }
    let formatted = format(file, &bytes, args.dialect.sbp);
    let changes = formatted != bytes;
    if args.check {
        if changes {
            tell(file);
        }
    } else if stream {
        let written = io::stdout().write_all(&formatted);
        out::unless_gone(written).context("cannot write the formatted text")?;
    } else if changes {
        out::file(file, &formatted)?;
    }
    Ok(if changes { Outcome::Changes } else { Outcome::Same })
}

/// Returns the error by which a file as a whole is no program.
fn refusal(file: &Path, bytes: &[u8], dialect: Dialect) -> Option<Diagnostic> {
    let name = file.to_string_lossy();
    let told = kerf_part::read_as(name.as_ref().into(), bytes, dialect).diagnostics;
    told.into_iter().find(|it| it.is_error() && matches!(it.code, Code::NotText | Code::NotGcode))
}

/// Old files are not UTF-8: each byte stands for a character then, and comes back as it was.
fn format(file: &Path, bytes: &[u8], dialect: Dialect) -> Vec<u8> {
    let name = file.to_string_lossy();
    let language = kerf_sbp::read_part_as(name.as_ref().into(), bytes, dialect).language;
    let formatted = |text: &str| match language {
        Language::Gcode => kerf_gcode::format(text),
        _ => kerf_sbp::format_as(text, dialect),
    };
    if let Ok(text) = std::str::from_utf8(bytes) {
        return formatted(text).into_bytes();
    }
    let text: String = bytes.iter().map(|b| char::from(*b)).collect();
    let back: Option<Vec<u8>> = formatted(&text).chars().map(|c| u8::try_from(c).ok()).collect();
    back.unwrap_or_else(|| bytes.to_vec())
}

fn read_stream() -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::stdin().read_to_end(&mut bytes).context("cannot read standard input")?;
    Ok(bytes)
}

fn read_file(file: &Path) -> Result<Vec<u8>> {
    match fs::read(file) {
        Ok(bytes) => Ok(bytes),
        Err(error) => {
            bail!(Usage(format!("cannot read {}: {}", file.display(), given::why(file, &error))))
        }
    }
}

fn tell(file: &Path) {
    crate::out::print(&format!("{}\n", file.display()));
}
