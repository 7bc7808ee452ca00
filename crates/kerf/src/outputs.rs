//! Files that a command writes and that are there already: one that Kerf wrote, and nobody touched since, is made
//! anew without a question; for any other a person is asked, and a script says --force.

use crate::data_args::{DataArgs, data_folder};
use crate::exit::{Exit, Usage};
use crate::{clock, out, streamed};
use anyhow::{Result, bail};
use clap::Args;
use kerf_files::{Disk, RealDisk};
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// The record of what Kerf wrote lies under this name in the data folder.
const RECORD: &str = "written";

/// At least so many of the files that were written last are known.
const MOST_KNOWN: usize = 2000;

/// Leave to replace a file.
#[derive(Args, Clone, Debug, Default)]
pub struct ForceArgs {
    /// Replaces an existing output file without a question
    #[arg(long)]
    pub force: bool,
}

/// The files that a command writes.
#[derive(Debug, Default)]
pub struct Outputs {
    files: Vec<PathBuf>,
    force: bool,
    data: Option<PathBuf>,
}

/// State of a file when it was looked at: its length, and when it was written, in nanoseconds since 1970.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Stamp {
    bytes: u64,
    written_ns: u128,
}

impl Outputs {
    /// These files; those that are named and are no devices.
    pub fn of<'a>(
        files: impl IntoIterator<Item = &'a Path>,
        force: bool,
        data: Option<&DataArgs>,
    ) -> Self {
        let usual = DataArgs { folder: None };
        // Without a folder for data nothing is known to be Kerf's: that only asks more.
        let data = data_folder(data.unwrap_or(&usual)).ok();
        Self { files: files.into_iter().map(Path::to_owned).collect(), force, data }
    }

    /// Does what writes them, unless a file would be replaced that may not be.
    pub fn around(&self, command: impl FnOnce() -> Result<Exit>) -> Result<Exit> {
        let before: Vec<_> = self.files.iter().map(|file| stamp(file)).collect();
        for (file, present) in self.files.iter().zip(&before) {
            let asks = present.filter(|stamp| !self.force && !self.knows(file, *stamp));
            if let Some(stamp) = asks
                && !may_be_replaced(file, stamp)?
            {
                return Ok(Exit::Stopped);
            }
        }
        // A run that is killed leaves what it wrote: that is Kerf's too. Where it cannot be kept, who writes the file
        // once more is asked.
        let begun = |(file, before): (&PathBuf, &Option<Stamp>)| begun(file, *before);
        drop(self.keep(self.files.iter().zip(&before).map(begun).collect()));
        let done = command();
        let now = self.files.iter().map(|file| stamp(file));
        let files = self.files.iter().zip(now).zip(before);
        let ended = files.map(|((file, now), before)| match now.filter(|_| now != before) {
            Some(now) => line(file, now),
            None => untouched(file),
        });
        drop(self.keep(ended.collect()));
        let notes =
            self.data.iter().flat_map(|data| self.files.iter().map(move |file| (file, data)));
        notes.for_each(|(file, data)| streamed::forget(file, data));
        done
    }

    /// Returns `true` if Kerf wrote a file, and nobody touched it since; also where the writing command was killed.
    fn knows(&self, file: &Path, stamp: Stamp) -> bool {
        let (record, place) = (self.record(), place(file));
        let mut of_it = record.lines().filter(|known| known.ends_with(&place));
        let last = of_it.next_back();
        let cut_short = || last.is_some_and(|known| known.starts_with(BEGUN));
        let as_left = || self.data.as_ref().is_some_and(|data| streamed::is_as_left(file, data));
        record.lines().any(|known| known == line(file, stamp)) || cut_short() && as_left()
    }

    fn record(&self) -> String {
        let path = self.data.as_ref().map(|data| data.join(RECORD));
        path.and_then(|path| fs::read_to_string(path).ok()).unwrap_or_default()
    }

    fn keep(&self, made: Vec<String>) -> io::Result<()> {
        let Some(data) = self.data.as_ref().filter(|_| !made.is_empty()) else { return Ok(()) };
        fs::create_dir_all(data)?;
        let (path, record) = (data.join(RECORD), self.record());
        let known: Vec<&str> = record.lines().collect();
        if known.len() > 2 * MOST_KNOWN {
            let last = known[MOST_KNOWN..].join("\n") + "\n";
            RealDisk.write(&path, last.as_bytes())?;
        }
        // Appended, so that commands that end at the same time do not take each other's lines away.
        RealDisk.append(&path, (made.join("\n") + "\n").as_bytes())
    }
}

/// Returns the state of a file; nothing where there is none under the name.
fn stamp(file: &Path) -> Option<Stamp> {
    let about = fs::metadata(file).ok().filter(fs::Metadata::is_file)?;
    let written = about.modified().ok()?.duration_since(UNIX_EPOCH).ok()?;
    Some(Stamp { bytes: about.len(), written_ns: written.as_nanos() })
}

/// A line of the record begins with it where a command begins to write a file.
const BEGUN: &str = "begun ";

/// A file in the record: what it was, and where it lies.
fn line(file: &Path, stamp: Stamp) -> String {
    format!("{} {}{}", stamp.bytes, stamp.written_ns, place(file))
}

/// The same of one that a command begins to write: what it was before, zeros where there was none.
fn begun(file: &Path, before: Option<Stamp>) -> String {
    let Stamp { bytes, written_ns } = before.unwrap_or(Stamp { bytes: 0, written_ns: 0 });
    format!("{BEGUN}{bytes} {written_ns}{}", place(file))
}

/// The same of one that a command did not write in the end.
fn untouched(file: &Path) -> String {
    format!("untouched{}", place(file))
}

/// Returns the place of a file, as lines of the record end.
fn place(file: &Path) -> String {
    format!(" {}", RealDisk.real_path(file).display())
}

/// Asks whether a file may be replaced that Kerf did not make.
///
/// # Errors
/// Nobody is there who could be asked.
fn may_be_replaced(file: &Path, stamp: Stamp) -> Result<bool> {
    let name = file.display();
    let told = format!(
        "{name} is there already, {}, changed {}; Kerf did not make it, or it was changed since",
        out::count(stamp.bytes, "byte"),
        clock::told(fs::metadata(file).and_then(|about| about.modified()).unwrap_or(UNIX_EPOCH))
    );
    if !(io::stdin().is_terminal() && io::stderr().is_terminal()) {
        bail!(Usage(format!(
            "{told}: nothing was written; --force replaces it, or name another file"
        )));
    }
    eprint!("? {told}. Replace it? (y/N): ");
    let mut answer = String::new();
    let heard = io::stderr().flush().is_ok() && io::stdin().read_line(&mut answer).is_ok();
    Ok(heard && answer.trim().eq_ignore_ascii_case("y"))
}
