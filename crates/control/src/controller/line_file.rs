//! Lines between Kerf and a controller as text, and the file that they are written to.

use super::line_log::LoggedLine;
use kerf_machine::driver::LineKind;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// A day, milliseconds.
const DAY_MS: u64 = 86_400_000;

/// A file to which lines are written as they pass. Where the disk refuses, the machine goes on.
pub struct LineFile(BufWriter<File>);

impl LineFile {
    /// Begins it.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn create(path: &Path) -> io::Result<Self> {
        let mut file = BufWriter::new(File::create(path)?);
        file.write_all(HEAD.as_bytes())?;
        Ok(Self(file))
    }

    /// Adds a line.
    pub fn write(&mut self, line: &LoggedLine) {
        drop(writeln!(self.0, "{}", line.shown()));
    }

    /// Has the disk take what was written.
    pub fn flush(&mut self) {
        drop(self.0.flush());
    }
}

/// First line of such a text.
pub const HEAD: &str = "# time (UTC), > sent or < came, the line, # what it means\n";

impl LoggedLine {
    /// The line as text: its time of day, UTC, its way, itself and the words beside it.
    pub fn shown(&self) -> String {
        let ms = self.at_ms % DAY_MS;
        let (h, m, s) = (ms / 3_600_000, ms / 60_000 % 60, ms / 1000 % 60);
        let way = match (self.kind, self.is_sent) {
            (LineKind::Link, _) => '#',
            (_, true) => '>',
            (_, false) => '<',
        };
        let words = match (&*self.text, &*self.words) {
            (_, "") | ("", _) => self.words.clone(),
            (_, words) => format!("  # {words}"),
        };
        format!("{h:02}:{m:02}:{s:02}.{:03} {way} {}{words}", ms % 1000, self.text)
    }
}
