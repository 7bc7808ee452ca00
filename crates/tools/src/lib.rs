//! The virtual tools: forms that make part files (command reference, "Virtual Tools").
//!
//! ```text
//!  Tool ── fields ──► a form, or KEY=VALUE in a line ──► Entries ── Tool::make ──► Made: files as text
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
mod header;
mod indexer;
mod lines;
mod setup;
mod surfacer;
mod typesetter;

pub use add_ins::{AddIn, add_ins};
pub use entries::{Entries, Mistake};
pub use field::{Field, Kind};
pub use header::with_header;

/// A tool.
#[derive(Debug)]
pub struct Tool {
    /// The letter behind the T.
    pub letter: char,
    /// Its name, as a menu shows it.
    pub name: &'static str,
    /// Description of what it does.
    pub doc: &'static str,
    /// Fields of its form, in order.
    pub fields: &'static [Field],
    make: fn(&Entries<'_>) -> Result<Made, Vec<Mistake>>,
}

/// Result of a tool.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// The files, the one to be opened first.
    pub files: Vec<MadeFile>,
    /// Notes for a person.
    pub notes: Vec<String>,
}

/// A file that a tool made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MadeFile {
    /// Folder to which it belongs.
    pub place: Place,
    /// Its name.
    pub name: String,
    /// Content.
    pub text: String,
}

/// Folder to which a file belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The part folder.
    Parts,
    /// The folder of custom cuts.
    Custom,
}

/// Folders from which a tool may read.
pub trait Folders {
    /// The text of a file in the part folder.
    fn text(&self, name: &str) -> Option<String>;

    /// The file of an installed font, by the font's name.
    ///
    /// # Errors
    /// There is none, and which there are.
    fn font(&self, name: &str) -> Result<Vec<u8>, String>;
}

/// Nothing to read.
impl Folders for () {
    fn text(&self, _: &str) -> Option<String> {
        None
    }

    fn font(&self, name: &str) -> Result<Vec<u8>, String> {
        Err(format!("there is no font {name}"))
    }
}

/// Every tool, in the order of its letters.
pub const TOOLS: [&Tool; 8] = [
    &copy::TOOL,
    &drill_press::TOOL,
    &fluter::TOOL,
    &header::TOOL,
    &indexer::TOOL,
    &setup::TOOL,
    &surfacer::TOOL,
    &typesetter::TOOL,
];

/// The tool of a letter.
pub fn tool(letter: char) -> Option<&'static Tool> {
    TOOLS.into_iter().find(|tool| tool.letter == letter.to_ascii_uppercase())
}

impl Tool {
    /// Makes its files of what was entered, with what the folders have.
    ///
    /// # Errors
    /// Every mistake in what was entered.
    pub fn make(
        &self,
        entered: &[(String, String)],
        metric: bool,
        folders: &dyn Folders,
    ) -> Result<Made, Vec<Mistake>> {
        (self.make)(&Entries::new(self.fields, entered, metric, folders)?)
    }

    /// Reads what was entered in a line: `KEY=VALUE` items between commas, or values in the order of the
    /// form; blank ones keep what the form shows.
    pub fn read_line(&self, line: &str) -> Vec<(String, String)> {
        let item = |(n, item): (usize, &str)| {
            let place = || self.fields.get(n).map_or("?", |field| field.key);
            let (key, value) = item.split_once('=').unwrap_or_else(|| (place(), item));
            (key.trim().to_owned(), value.trim().to_owned())
        };
        line.split(',').enumerate().map(item).filter(|(_, value)| !value.is_empty()).collect()
    }
}

impl Made {
    /// A part file, with notes.
    fn part(name: &str, lines: Vec<String>, notes: Vec<String>) -> Self {
        let (name, text) = (lines::part_name(name), lines.join("\n") + "\n");
        Self { files: vec![MadeFile { place: Place::Parts, name, text }], notes }
    }
}

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
