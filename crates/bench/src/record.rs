//! The section of `docs/benchmarks.md` that this program writes.

use crate::figure::{Figure, RUNS};
use crate::inputs::Input;
use crate::{page, table};
use anyhow::Result;

const BEGIN: &str = "<!-- make bench RECORD=1 writes from here -->";
const END: &str = "<!-- to here -->";

/// Writes what was measured, where and how.
pub fn section(inputs: &[String], figures: &[Figure]) -> String {
    let mut text = format!(
        "{} Command: `make bench`. Median of {RUNS} runs after one to warm up, with the smallest and the \
         largest; every stage runs on one core. *Processor* is user and system time: what passes on an idle \
         machine, whatever else this one did; rates and goals go by it. *Elapsed* is the median by the clock \
         on the wall{}.\n\n",
        page::measured(),
        page::load(),
    );
    text += &inputs.concat();
    text + "\n" + &table::markdown(figures)
}

/// Describes an input, as an item of a list.
pub fn about(input: &Input) -> String {
    let Input { name, about, files } = input;
    let files = if files.len() == 1 { String::new() } else { format!("{} files, ", files.len()) };
    let (lines, megabytes) = (input.lines(), input.bytes() as f64 / 1e6);
    format!("- `{name}`: {about} ({files}{lines} lines, {megabytes:.1} MB)\n")
}

/// Puts the section into the page.
pub fn record(section: &str) -> Result<()> {
    page::put(BEGIN, END, section)
}
