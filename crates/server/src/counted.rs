//! A file of the data folder of which it is noticed when it is gone, or an older copy lies in its place.
//!
//! ```text
//!  devices.json         digest 9f86d081…          a count and a digest before what was written ([`crate::digested`])
//!                       written 17
//!                       [ …
//!  devices.json.mark    digest 3c01be46…          the count of the newest, and whether it was kept or taken away
//!                       17 kept
//! ```
//!
//! The mark follows the file, so that a process that is killed between both leaves a file that is newer than its mark:
//! that one is the newest. Only when a file is taken away does the mark go first.

use crate::digested::{checked, with_digest};
use crate::locks::lock;
use kerf_files::{Disk, RealDisk, replace_whole, write_private};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Begins the line of the count. A file of an earlier version has none.
const WRITTEN: &str = "written ";

/// Word of the mark for a file that was written.
const KEPT: &str = "kept";

/// Word of the mark for a file that was taken away.
const NONE: &str = "none";

/// A file that is counted, under a name.
#[derive(Debug)]
pub struct Counted {
    file: PathBuf,
    /// Only this user reads it.
    is_secret: bool,
    /// The count of the newest.
    count: Mutex<u64>,
}

/// Content of a counted file's place.
#[derive(Debug, PartialEq, Eq)]
pub enum Found {
    /// Nothing, as Kerf left it.
    Nothing,
    /// Nothing, and Kerf had left something.
    Gone,
    /// The newest that Kerf wrote.
    Newest(Vec<u8>),
    /// Something that Kerf wrote before the newest.
    Older(Vec<u8>),
}

impl Counted {
    /// A file that everybody may read.
    pub fn new(file: PathBuf) -> Self {
        Self { file, is_secret: false, count: Mutex::new(0) }
    }

    /// A file that only this user reads.
    pub fn secret(file: PathBuf) -> Self {
        Self { is_secret: true, ..Self::new(file) }
    }

    /// Returns its path.
    pub fn path(&self) -> &Path {
        &self.file
    }

    /// Reads it. That it is gone or older is found once: from then on it is as it should be.
    ///
    /// # Errors
    /// The file is damaged, or the disk says something.
    pub fn read(&self) -> io::Result<Found> {
        let mark = self.mark();
        let mut count = lock(&self.count);
        *count = count.max(mark.map_or(0, |(newest, _)| newest));
        if !self.file.is_file() {
            let gone = mark.is_some_and(|(_, kept)| kept);
            if gone {
                self.keep_mark(*count, NONE)?;
            }
            return Ok(if gone { Found::Gone } else { Found::Nothing });
        }
        let file = RealDisk.read(&self.file)?;
        let (written, bytes) = counted(checked(&file)?);
        let older =
            mark.is_some_and(|(newest, kept)| written < newest || (written == newest && !kept));
        *count = count.max(written);
        if older {
            // The copy is the newest from now on, and whatever is written next is newer.
            fs::remove_file(self.mark_file())?;
            return Ok(Found::Older(bytes.to_vec()));
        }
        Ok(Found::Newest(bytes.to_vec()))
    }

    /// Replaces it.
    ///
    /// # Errors
    /// Whatever the disk says; then the one before is still there.
    pub fn write(&self, bytes: &[u8]) -> io::Result<()> {
        let mut count = lock(&self.count);
        *count += 1;
        let file = with_digest(&[format!("{WRITTEN}{count}\n").as_bytes(), bytes].concat());
        match self.is_secret {
            true => write_private(&self.file, &file)?,
            false => RealDisk.write(&self.file, &file)?,
        }
        self.keep_mark(*count, KEPT)
    }

    /// Takes it away.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn remove(&self) -> io::Result<()> {
        if !self.file.is_file() {
            return Ok(());
        }
        self.keep_mark(*lock(&self.count), NONE)?;
        fs::remove_file(&self.file)
    }

    /// Puts it aside under another name, as it is; nothing is missed then.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn put_aside(&self, aside: &Path) -> io::Result<()> {
        self.keep_mark(*lock(&self.count), NONE)?;
        fs::rename(&self.file, aside)
    }

    fn mark_file(&self) -> PathBuf {
        let mut name = self.file.clone().into_os_string();
        name.push(".mark");
        name.into()
    }

    /// The count of the newest, and whether it was kept. A mark that is damaged tells nothing.
    fn mark(&self) -> Option<(u64, bool)> {
        let mark = fs::read(self.mark_file()).ok()?;
        let text = std::str::from_utf8(checked(&mark).ok()?).ok()?;
        let (count, what) = text.trim().split_once(' ')?;
        Some((count.parse().ok()?, what == KEPT))
    }

    fn keep_mark(&self, count: u64, what: &str) -> io::Result<()> {
        replace_whole(&self.mark_file(), &with_digest(format!("{count} {what}\n").as_bytes()))
    }
}

/// The count of what was written, and the rest of it.
fn counted(bytes: &[u8]) -> (u64, &[u8]) {
    let body = bytes.strip_prefix(WRITTEN.as_bytes());
    let line = body.and_then(|body| Some((body, body.iter().position(|byte| *byte == b'\n')?)));
    let read = line.and_then(|(body, end)| {
        let count = std::str::from_utf8(&body[..end]).ok()?.parse().ok()?;
        Some((count, &body[end + 1..]))
    });
    read.unwrap_or((0, bytes))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn folder() -> (tempfile::TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("list");
        (folder, file)
    }

    /// Reads a file as a new start does, which knows nothing but the files.
    fn read(file: &Path) -> Found {
        Counted::new(file.into()).read().unwrap()
    }

    fn newest(text: &str) -> Found {
        Found::Newest(text.into())
    }

    #[test]
    fn what_was_written_last_is_the_newest() {
        let (_folder, file) = folder();
        assert_eq!(read(&file), Found::Nothing);
        for text in ["one", "two", ""] {
            let list = Counted::new(file.clone());
            list.read().unwrap();
            list.write(text.as_bytes()).unwrap();
            assert_eq!((read(&file), read(&file)), (newest(text), newest(text)));
        }
        Counted::new(file.clone()).remove().unwrap();
        assert_eq!(read(&file), Found::Nothing);
    }

    #[test]
    fn one_that_is_gone_or_older_is_noticed_once() {
        let (_folder, file) = folder();
        let list = Counted::new(file.clone());
        list.write(b"one").unwrap();
        let one = fs::read(&file).unwrap();
        list.write(b"two").unwrap();
        let two = fs::read(&file).unwrap();
        fs::write(&file, &one).unwrap();
        assert_eq!((read(&file), read(&file)), (Found::Older(b"one".into()), newest("one")));
        fs::write(&file, &two).unwrap();
        assert_eq!(read(&file), newest("two"));
        let list = Counted::new(file.clone());
        list.read().unwrap();
        list.write(b"three").unwrap();
        fs::remove_file(&file).unwrap();
        assert_eq!((read(&file), read(&file)), (Found::Gone, Found::Nothing));
        fs::write(&file, &two).unwrap();
        assert_eq!(read(&file), Found::Older(b"two".into()));
    }

    /// A kill between the file and its mark; a file of an earlier version; a mark that is torn.
    #[test]
    fn nothing_is_missed_that_was_not_there() {
        let (_folder, file) = folder();
        let list = Counted::new(file.clone());
        list.write(b"one").unwrap();
        let mark = fs::read(list.mark_file()).unwrap();
        list.write(b"two").unwrap();
        fs::write(list.mark_file(), &mark).unwrap();
        assert_eq!(read(&file), newest("two"));
        for torn in [&mark[..0], &mark[..mark.len() / 2], b"99 kept"] {
            fs::write(list.mark_file(), torn).unwrap();
            assert_eq!(read(&file), newest("two"));
        }
        fs::remove_file(list.mark_file()).unwrap();
        fs::write(&file, with_digest(b"[1]")).unwrap();
        assert_eq!(read(&file), newest("[1]"));
        fs::write(&file, "[1]").unwrap();
        assert_eq!(read(&file), newest("[1]"));
    }
}
