//! Conversions kept as files that a person can read.
//!
//! Each source in `golden` has beside it what it is converted to, for every target that its first line
//! names (`'to: linuxcnc grbl` or `(to: sbp)`; `linuxcnc-kept` keeps variables), with what was told at
//! the end. When a conversion
//! changes for a reason, `KERF_BLESS=1 cargo test -p kerf-convert --test all golden::` writes the new one;
//! read the difference before keeping it.

use crate::support::{GENERIC, GRBL, LINUXCNC, SBP, converted, plain};
use kerf_convert::{Conversion, Language};
use kerf_program::settings::LinearUnit;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

fn sources() -> Vec<PathBuf> {
    let entries = fs::read_dir(folder()).unwrap().map(|e| e.unwrap().path());
    let source = |p: &PathBuf| p.extension().is_some_and(|e| e == "sbp" || e == "nc");
    let mut sources: Vec<PathBuf> = entries.filter(source).collect();
    sources.sort();
    sources
}

/// The words behind `to:` in the first line.
fn targets(text: &str) -> Vec<String> {
    let line = text.lines().next().unwrap_or_default().trim_matches(['\'', '(', ')']);
    line.trim().trim_start_matches("to:").split_whitespace().map(str::to_owned).collect()
}

fn language(word: &str) -> Language {
    match word {
        "linuxcnc" => LINUXCNC,
        "grbl" => GRBL,
        "generic" => GENERIC,
        _ => SBP,
    }
}

fn conversion(source: &Path, target: &str) -> String {
    let text = fs::read_to_string(source).unwrap();
    let from = if source.extension().unwrap() == "sbp" { SBP } else { LINUXCNC };
    let name = source.file_name().unwrap().to_string_lossy().into_owned();
    let (target, kept) = target.strip_suffix("-kept").map_or((target, false), |t| (t, true));
    let how =
        Conversion { keep_variables: kept, ..plain(from, language(target), LinearUnit::Inch) };
    let made = converted(&name, text.as_bytes(), &how, folder());
    let mut out = made.text.unwrap_or_else(|| "nothing was written\n".into());
    for d in made.diagnostics {
        out += &format!("; {} line {}: {}\n", d.code, d.place.line, d.message);
    }
    out
}

#[test]
fn conversions_are_as_they_were() {
    let sources = sources();
    assert!(sources.len() >= 4);
    for source in sources {
        for target in targets(&fs::read_to_string(&source).unwrap()) {
            let golden = source.with_extension(format!("{target}.txt"));
            let got = conversion(&source, &target);
            if env::var_os("KERF_BLESS").is_some() {
                fs::write(&golden, &got).unwrap();
            }
            let expected = fs::read_to_string(&golden).unwrap_or_default();
            assert_eq!(got, expected, "{}", golden.display());
        }
    }
}
