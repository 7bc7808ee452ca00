//! The virtual tools: forms that make part files (command reference, "Virtual Tools").
//!
//! ```text
//!  Tool ── fields ──► a form, or KEY=VALUE in a line ──► Entries ── Tool::make ──► ToolOutput: files as text
//! ```
//!
//! A tool knows no machine and no disk: what it makes is text, in the unit of the form. Whoever calls
//! it writes the files and previews or runs them.

mod add_ins;
mod carve;
mod copy;
mod drill_press;
mod entries;
mod field;
mod fluter;
mod folders;
mod header;
mod height_grid;
mod indexer;
mod lines;
mod probe;
mod setup;
mod surfacer;
mod table;
mod tool;
mod typesetter;

pub use add_ins::{AddIn, add_ins};
pub use entries::{Entries, Mistake};
pub use field::{Field, Kind};
pub use folders::Folders;
pub use header::with_header;
pub use table::{TOOLS, tool};
pub use tool::{FileFolder, OutputFile, Tool, ToolOutput};

#[cfg(test)]
mod testing {
    use super::*;

    /// Returns what a tool makes of a line: its first file, or its mistakes, a line each.
    pub fn made(letter: char, line: &str) -> String {
        let tool = tool(letter).expect("a tool");
        match tool.make(&tool.read_line(line), false, &()) {
            Ok(made) => made.files[0].text.clone(),
            Err(found) => {
                let lines: Vec<_> =
                    found.iter().map(|m| format!("{}: {}", m.field, m.text)).collect();
                lines.join("\n")
            }
        }
    }
}
