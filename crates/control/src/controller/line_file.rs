//! Lines between Kerf and a controller as text, and the file that they are written to.

use super::line_log::LoggedLine;
use kerf_machine::driver::LineKind;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::mpsc::{Sender, channel};
use std::thread::{JoinHandle, spawn};

/// A day, milliseconds.
const DAY_MS: u64 = 86_400_000;

/// A file to which lines are written as they pass, by a thread of its own: the machine waits for no disk. Where the disk
/// refuses, the machine goes on.
pub struct LineFile {
    lines: Option<Sender<String>>,
    writes: Option<JoinHandle<()>>,
}

impl LineFile {
    /// Begins it.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn create(path: &Path) -> io::Result<Self> {
        let mut file = BufWriter::new(File::create(path)?);
        file.write_all(HEAD.as_bytes())?;
        let (lines, come) = channel::<String>();
        let writes = spawn(move || {
            while let Ok(line) = come.recv() {
                let all = std::iter::once(line).chain(come.try_iter());
                all.for_each(|line| drop(writeln!(file, "{line}")));
                drop(file.flush());
            }
        });
        Ok(Self { lines: Some(lines), writes: Some(writes) })
    }

    /// Adds a line.
    pub fn write(&self, line: &LoggedLine) {
        self.lines.iter().for_each(|lines| drop(lines.send(line.shown())));
    }
}

impl Drop for LineFile {
    /// The last lines are written.
    fn drop(&mut self) {
        self.lines = None;
        self.writes.take().map(JoinHandle::join).into_iter().for_each(drop);
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
