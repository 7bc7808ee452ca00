//! Measures Kerf: how fast part files are read, interpreted, planned and drawn, and with how much
//! memory. `make bench` builds and runs it; a word as argument chooses the inputs whose name contains
//! it, `--record` writes the figures into `docs/benchmarks.md`.
#![allow(clippy::print_stdout, clippy::print_stderr)]

mod boards;
mod child;
mod figure;
mod gcode;
mod huge;
mod inputs;
mod linuxcnc;
mod machine;
mod page;
mod record;
mod references;
mod replan;
mod ruckig;
#[path = "../../../tests/corpus/shared.rs"]
mod shared;
mod stages;
mod table;
mod usage;

use anyhow::Result;
use std::env;

fn main() -> Result<()> {
    let mut arguments = env::args_os().skip(1).peekable();
    if arguments.next_if(|word| word == child::PARENT).is_some() {
        return child::parent(arguments);
    }
    for (own, work) in machine::IN_A_CHILD {
        if arguments.next_if(|word| word == own).is_some() {
            let moves = arguments.next().and_then(|count| count.to_str()?.parse().ok());
            work(moves.unwrap_or_default());
            return Ok(());
        }
    }
    let words: Vec<String> = arguments.map(|word| word.to_string_lossy().into_owned()).collect();
    let recorded = words.iter().any(|word| word == "--record");
    let word = words.iter().find(|word| !word.starts_with("--")).map_or("", String::as_str);
    let (mut about, mut figures) = (Vec::new(), Vec::new());
    for input in inputs::inputs(word) {
        eprintln!("{} …", input.name);
        about.push(record::about(&input));
        figures.extend(stages::figures(&input)?);
        figures.extend(child::figures(&input)?);
    }
    let (more, compared) = gcode::figures(word)?;
    about.extend(more);
    figures.extend(compared);
    for measure in [replan::figures, huge::figures] {
        let (more, measured) = measure(word)?;
        about.extend(more);
        figures.extend(measured);
    }
    let motion = "raster".contains(word);
    if motion {
        eprintln!("motion …");
        figures.extend(machine::figures()?);
    }
    let mut section = record::section(&about, &figures);
    if motion {
        section += &references::tables()?;
        section += &ruckig::table()?;
    }
    if "steps-3x300k".contains(word) {
        section += &boards::table()?;
    }
    if "linuxcnc".contains(word) {
        section += &linuxcnc::table()?;
    }
    println!("{section}");
    if recorded {
        record::record(&section)?;
    }
    Ok(())
}
