//! The section of `docs/benchmarks.md` that this program writes.

use crate::figure::{Figure, RUNS};
use crate::inputs::Input;
use crate::table;
use anyhow::{Context, Result};
use std::path::Path;
use std::process::Command;
use std::{fs, thread};

const PAGE: &str = "docs/benchmarks.md";
const BEGIN: &str = "<!-- make bench RECORD=1 writes from here -->";
const END: &str = "<!-- to here -->";

/// What was measured, where and how.
pub fn section(inputs: &[String], figures: &[Figure]) -> String {
    let mut text = format!(
        "Measured {} at commit {}, on {}, {} cores, {}, {}. Command: `make bench`. Median of \
         {RUNS} runs after one to warm up, with the smallest and the largest; every stage runs on one \
         core. *Processor* is user and system time: what passes on an idle machine, whatever else \
         this one did; rates and goals go by it. *Elapsed* is the median by the clock on the wall{}.\n\n",
        said("date", &["-u", "+%F"]),
        said("git", &["describe", "--always", "--dirty"]),
        processor(),
        thread::available_parallelism().map_or(1, usize::from),
        said("uname", &["-sr"]),
        said("rustc", &["--version"]),
        load(),
    );
    text += &inputs.concat();
    text + "\n" + &table::markdown(figures)
}

/// What an input is, as an item of a list.
pub fn about(input: &Input) -> String {
    let Input { name, about, files } = input;
    let files = if files.len() == 1 { String::new() } else { format!("{} files, ", files.len()) };
    let (lines, megabytes) = (input.lines(), input.bytes() as f64 / 1e6);
    format!("- `{name}`: {about} ({files}{lines} lines, {megabytes:.1} MB)\n")
}

/// Puts the section into the page.
pub fn record(section: &str) -> Result<()> {
    let page = fs::read_to_string(PAGE).context(PAGE)?;
    let (before, rest) = page.split_once(BEGIN).with_context(|| format!("{PAGE}: no {BEGIN}"))?;
    let (_, after) = rest.split_once(END).with_context(|| format!("{PAGE}: no {END}"))?;
    let page = format!("{before}{BEGIN}\n\n{section}\n{END}{after}");
    fs::write(Path::new(PAGE), page).context(PAGE)
}

/// What a command says in one line.
fn said(command: &str, arguments: &[&str]) -> String {
    let output = Command::new(command).args(arguments).output();
    let said = output.map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned());
    said.ok().filter(|text| !text.is_empty()).unwrap_or_else(|| "unknown".into())
}

/// How busy the machine was at the end of it.
fn load() -> String {
    let load = fs::read_to_string("/proc/loadavg").unwrap_or_default();
    load.split(' ').next().map_or_else(String::new, |load| format!(", at a load of {load}"))
}

fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| line.strip_prefix("model name"));
    model.map_or_else(|| said("uname", &["-m"]), |m| m.trim_start_matches([' ', '\t', ':']).into())
}
