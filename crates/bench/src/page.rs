//! The page of benchmarks, `docs/benchmarks.md`, whose parts programs write.

use anyhow::{Context, Result};
use std::process::Command;
use std::{fs, thread};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/benchmarks.md");

/// Tells when, at which commit and on what something was measured.
pub fn measured() -> String {
    format!(
        "Measured {} at commit {}, on {}, {} cores, {}, {}.",
        said("date", &["-u", "+%F"]),
        said("git", &["describe", "--always", "--dirty"]),
        processor(),
        thread::available_parallelism().map_or(1, usize::from),
        said("uname", &["-sr"]),
        said("rustc", &["--version"]),
    )
}

/// Tells how busy the machine was at the end of it.
pub fn load() -> String {
    let load = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    load.split(' ').next().map_or_else(String::new, |load| format!(", at a load of {load}"))
}

/// Puts a text between two lines of the page.
pub fn put(begin: &str, end: &str, text: &str) -> Result<()> {
    let page = fs::read_to_string(PAGE).context(PAGE)?;
    let (before, rest) = page.split_once(begin).with_context(|| format!("{PAGE}: no {begin}"))?;
    let (_, after) = rest.split_once(end).with_context(|| format!("{PAGE}: no {end}"))?;
    fs::write(PAGE, format!("{before}{begin}\n\n{text}\n{end}{after}")).context(PAGE)
}

/// Returns what a command says in one line.
fn said(command: &str, arguments: &[&str]) -> String {
    let output = Command::new(command).args(arguments).output();
    let said = output.map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned());
    said.ok().filter(|text| !text.is_empty()).unwrap_or_else(|| "unknown".into())
}

fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| line.strip_prefix("model name"));
    model.map_or_else(|| said("uname", &["-m"]), |m| m.trim_start_matches([' ', '\t', ':']).into())
}
