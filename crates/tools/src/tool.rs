//! A tool and what it makes.

use crate::entries::{Entries, Mistake};
use crate::field::Field;
use crate::folders::Folders;
use crate::lines;

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
    pub(crate) make: fn(&Entries<'_>) -> Result<ToolOutput, Vec<Mistake>>,
}

/// Result of a tool.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ToolOutput {
    /// The files, the one to be opened first.
    pub files: Vec<OutputFile>,
    /// Notes for a person.
    pub notes: Vec<String>,
}

/// A file that a tool made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// Folder to which it belongs.
    pub place: FileFolder,
    /// Its name.
    pub name: String,
    /// Content.
    pub text: String,
}

/// Folder to which a file belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileFolder {
    /// The part folder.
    Parts,
    /// The folder of custom cuts.
    Custom,
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
    ) -> Result<ToolOutput, Vec<Mistake>> {
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

impl ToolOutput {
    /// A part file, with notes.
    pub(crate) fn part(name: &str, lines: Vec<String>, notes: Vec<String>) -> Self {
        let (name, text) = (lines::part_name(name), lines.join("\n") + "\n");
        Self { files: vec![OutputFile { place: FileFolder::Parts, name, text }], notes }
    }
}
