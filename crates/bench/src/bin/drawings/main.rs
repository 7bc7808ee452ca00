//! From drawing to tool path, measured: reading DXF, the order of cutting, tool paths. `make bench` builds
//! and runs it; `--record` writes its table into `docs/benchmarks.md`. Processor time, least of some runs.
#![allow(clippy::print_stdout)]

mod bound;
mod dxf;
#[path = "../../page.rs"]
mod page;
mod paths;
#[path = "../../../../drawing/tests/plates/mod.rs"]
mod plates;
mod row;
mod timed;
mod travel;
#[allow(dead_code)]
#[path = "../../usage.rs"]
mod usage;

use anyhow::Result;

const BEGIN: &str = "<!-- make bench RECORD=1 writes drawings from here -->";
const END: &str = "<!-- drawings to here -->";

fn main() -> Result<()> {
    let mut rows = dxf::measure()?;
    rows.extend(travel::measure());
    rows.push(paths::measure()?);
    let text = format!(
        "{} Command: `make bench`. Processor time, the least of a few runs{}.\n\n{}",
        page::measured(),
        page::load(),
        row::table(&rows)
    );
    println!("{text}");
    if std::env::args().any(|word| word == "--record") {
        page::put(BEGIN, END, &text)?;
    }
    Ok(())
}
