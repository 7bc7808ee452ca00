//! The seal: how far the journal has come, in a small file beside it.
//!
//! ```text
//!   write ──► journal.db-wal (generation n + 1, on the disk) ──► journal.seal (at least n + 1)
//!   rest  ──► journal.db, the write-ahead file is empty      ──► journal.seal (n + 1, digest of the rows)
//! ```
//!
//! Every change of the journal counts its generation up, in the same transaction. The seal follows behind it,
//! so it never promises more than there is. A journal that is behind its seal has lost changes: its
//! write-ahead file is gone, emptied or torn, or somebody put an older file in its place. An older file below a newer
//! write-ahead file is noticed as well: the seal knows the generation that the file had by itself.

use super::rows::{self, Result, Rows, Table, Trouble, json};
use kerf_files::{private, write_private};
use rusqlite::Connection;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::{self, ErrorKind, Seek, SeekFrom, Write};
use std::path::Path;

/// Name of the file in the data folder.
pub const SEAL_FILE: &str = "journal.seal";

/// Name of the fact.
const GENERATION: &str = "generation";

/// Bytes of a line. Two of them are written in turn, so that one that is torn leaves the other.
const LINE: usize = 85;

/// The changes that a journal has come through.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Mark {
    /// The journal: sixteen hexadecimal digits.
    pub journal: String,
    /// Changes that were made since it began.
    pub generation: u64,
}

/// The promise of the file beside the journal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Seal {
    /// The journal has come so far, or further.
    pub mark: Mark,
    /// The generation that is in the file itself, without the write-ahead file, or a later one.
    pub rested: u64,
    /// The digest of its rows at that generation, where it came to rest there.
    pub digest: Option<u64>,
}

/// The bytes in the place of the seal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Found {
    /// Nothing.
    None,
    /// Bytes that are no seal.
    Broken,
    /// A seal of which a line is damaged: perhaps the newer one.
    Half(Seal),
    /// A seal.
    Sound(Seal),
}

impl Found {
    /// Reads the one of a data folder.
    pub(super) fn in_folder(folder: &Path) -> io::Result<Self> {
        let bytes = match fs::read(folder.join(SEAL_FILE)) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Self::None),
            Err(error) => return Err(error),
        };
        let lines: Vec<Seal> = bytes.chunks(LINE).filter_map(Seal::read).collect();
        let whole = lines.len() == 2 && bytes.len() == 2 * LINE;
        let newest = lines.into_iter().max_by_key(|it| it.mark.generation);
        Ok(newest.map_or(Self::Broken, if whole { Self::Sound } else { Self::Half }))
    }

    /// The seal, when it is one.
    pub(super) const fn seal(&self) -> Option<&Seal> {
        match self {
            Self::Half(seal) | Self::Sound(seal) => Some(seal),
            Self::None | Self::Broken => None,
        }
    }
}

impl Seal {
    /// Writes it into a data folder: after a change the older of two lines, at rest both.
    pub(super) fn write(&self, folder: &Path) -> io::Result<()> {
        let (path, line) = (folder.join(SEAL_FILE), self.line());
        let there = fs::metadata(&path).is_ok_and(|file| file.len() == 2 * LINE as u64);
        if !there {
            return write_private(&path, line.repeat(2).as_bytes());
        }
        private::keep(&path);
        let mut file = File::options().write(true).open(&path)?;
        if self.digest.is_none() {
            file.seek(SeekFrom::Start(self.mark.generation % 2 * LINE as u64))?;
            return file.write_all(line.as_bytes());
        }
        file.write_all(line.repeat(2).as_bytes())?;
        file.sync_all()
    }

    fn line(&self) -> String {
        let Mark { journal, generation } = &self.mark;
        let digest = self.digest.map_or_else(|| "-".repeat(16), |digest| format!("{digest:016x}"));
        let text = format!("{journal:16.16} {generation:020} {:020} {digest}", self.rested);
        format!("{text} {:08x}\n", crc32fast::hash(text.as_bytes()))
    }

    fn read(line: &[u8]) -> Option<Self> {
        let line = std::str::from_utf8(line).ok()?.strip_suffix('\n')?;
        let (text, sum) = line.rsplit_once(' ')?;
        if format!("{:08x}", crc32fast::hash(text.as_bytes())) != sum {
            return None;
        }
        let mut words = text.split(' ');
        let (journal, generation) = (words.next()?.into(), words.next()?.parse().ok()?);
        let (rested, digest) = (words.next()?.parse().ok()?, words.next()?);
        let mark = Mark { journal, generation };
        Some(Self { mark, rested, digest: u64::from_str_radix(digest, 16).ok() })
    }
}

impl Mark {
    /// Reads it from a journal; `None` of one that nobody has changed since Kerf counts that.
    pub(super) fn of(rows: &Rows<'_>) -> Result<Option<Self>> {
        let text = rows.text(Table::Fact, GENERATION)?;
        let parse = |text: String| serde_json::from_str(&text);
        let damaged = |error| Trouble::Damaged(format!("{GENERATION}: {error}"));
        text.map(parse).transpose().map_err(damaged)
    }

    /// Reads it with the digest of the rows, as both are at one moment.
    pub(super) fn with_digest(connection: &Connection) -> Result<(Option<Self>, u64)> {
        rows::at_once(connection, |rows| Ok((Self::of(rows)?, rows::digest(rows.0)?)))
    }

    /// A change more was made; the first one is made in this journal.
    pub(super) fn count(rows: &Rows<'_>, journal: &str) -> Result<Self> {
        let first = || Self { journal: journal.into(), generation: 0 };
        let before = Self::of(rows)?.unwrap_or_else(first);
        let mark = Self { generation: before.generation.saturating_add(1), ..before };
        mark.put(rows)?;
        Ok(mark)
    }

    /// The journal has come so far.
    pub(super) fn put(&self, rows: &Rows<'_>) -> Result<()> {
        rows.put(Table::Fact, GENERATION, &json(self)?)
    }

    /// Of a journal like no other.
    pub(super) fn new() -> Self {
        let journal = format!("{:016x}", RandomState::new().build_hasher().finish());
        Self { journal, generation: 0 }
    }
}

/// The outcome of comparing a journal with its seal and its copy.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// It is the newest there is.
    Whole,
    /// Nobody can tell.
    Doubtful(String),
    /// It is not.
    Damaged(String),
}

/// A journal that is compared with a seal.
pub(super) struct Reached<'a> {
    /// The changes it has come through.
    pub mark: Option<&'a Mark>,
    /// The digest of its rows.
    pub digest: u64,
    /// Those that are in the file without its write-ahead file, where that can be read.
    pub alone: Option<&'a Mark>,
    /// Those of its copy.
    pub copy: Option<&'a Mark>,
}

/// Compares a journal with its seal and its copy, which were read before it.
pub(super) fn compare(journal: &Reached<'_>, found: &Found) -> Verdict {
    let Reached { mark, digest, alone, copy } = *journal;
    let reached = mark.map_or(0, |mark| mark.generation);
    let lacks = |last: u64| match last - reached {
        1 => "its last change".to_owned(),
        n => format!("its last {n} changes"),
    };
    if let Some(seal) = found.seal() {
        let theirs = &seal.mark;
        if mark.is_some_and(|mark| mark.journal != theirs.journal) {
            return Verdict::Damaged("it is the journal of another data folder".into());
        }
        if reached < theirs.generation {
            return Verdict::Damaged(format!(
                "it lacks {}: the write-ahead file journal.db-wal is gone, emptied or damaged, or an older journal was \
                 put in its place",
                lacks(theirs.generation)
            ));
        }
        if reached == theirs.generation && seal.digest.is_some_and(|it| it != digest) {
            return Verdict::Damaged("its rows are not those that Kerf left in it".into());
        }
    }
    let rested = found.seal().map_or(0, |seal| seal.rested);
    if alone.is_some_and(|alone| alone.generation < rested) {
        return Verdict::Damaged("it is older than its write-ahead file".into());
    }
    if let Some(copy) = copy.filter(|copy| copy.generation > reached) {
        let lacks = lacks(copy.generation);
        return Verdict::Damaged(format!("it is older than its copy, and lacks {lacks}"));
    }
    match (found, mark) {
        (Found::Broken, _) => Verdict::Doubtful("is damaged".into()),
        (Found::None, Some(_)) => Verdict::Doubtful("is gone".into()),
        // A line that was torn while it was written is behind the change that it tells of.
        (Found::Half(seal), _) if reached == seal.mark.generation => {
            Verdict::Doubtful("is damaged in part".into())
        }
        _ => Verdict::Whole,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn mark(journal: &str, generation: u64) -> Mark {
        Mark { journal: journal.repeat(16), generation }
    }

    fn sealed(generation: u64, digest: Option<u64>) -> Found {
        Found::Sound(Seal { mark: mark("a", generation), rested: 1, digest })
    }

    #[test]
    fn a_torn_line_leaves_the_other() {
        let folder = tempfile::tempdir().unwrap();
        let seal = |generation, digest| Seal { mark: mark("a", generation), rested: 2, digest };
        assert_eq!(Found::in_folder(folder.path()).unwrap(), Found::None);
        for (generation, digest) in [(1, None), (2, None), (3, Some(7)), (4, None), (5, None)] {
            seal(generation, digest).write(folder.path()).unwrap();
            let found = Found::in_folder(folder.path()).unwrap();
            assert_eq!(found, Found::Sound(seal(generation, digest)));
        }
        let file = folder.path().join(SEAL_FILE);
        let whole = fs::read(&file).unwrap();
        for at in 0..whole.len() {
            let mut torn = whole.clone();
            torn[at] ^= 1;
            fs::write(&file, torn).unwrap();
            let found = Found::in_folder(folder.path()).unwrap();
            let left = if at < LINE { 5 } else { 4 };
            assert_eq!(found, Found::Half(seal(left, None)), "byte {at}");
        }
        fs::write(&file, b"").unwrap();
        assert_eq!(Found::in_folder(folder.path()).unwrap(), Found::Broken);
    }

    #[test]
    fn a_journal_behind_its_seal_or_its_copy_is_damaged() {
        let check = |mark: Option<Mark>, found: Found, copy: Option<Mark>, wanted: &str| {
            let (mark, copy) = (mark.as_ref(), copy.as_ref());
            let said = compare(&Reached { mark, digest: 7, alone: mark, copy }, &found);
            assert!(format!("{said:?}").contains(wanted), "{said:?}: {wanted}");
        };
        let at = |generation| Some(mark("a", generation));
        check(at(5), sealed(5, Some(7)), at(4), "Whole");
        check(at(5), sealed(5, None), None, "Whole");
        check(at(6), sealed(5, Some(8)), None, "Whole");
        check(None, Found::None, None, "Whole");
        check(at(5), sealed(6, None), None, "its last change:");
        check(None, sealed(6, None), None, "its last 6 changes:");
        check(at(5), sealed(5, Some(8)), None, "not those that Kerf left");
        check(Some(mark("b", 9)), sealed(5, None), None, "another data folder");
        check(at(5), sealed(5, None), at(7), "older than its copy");
        let old = Seal { mark: mark("a", 5), rested: 4, digest: None };
        let (five, three) = (mark("a", 5), mark("a", 3));
        let journal = Reached { mark: Some(&five), digest: 7, alone: Some(&three), copy: None };
        let said = format!("{:?}", compare(&journal, &Found::Sound(old)));
        assert!(said.contains("older than its write-ahead file"), "{said}");
        check(at(5), Found::None, None, "Doubtful(\"is gone\")");
        check(at(5), Found::Broken, None, "Doubtful(\"is damaged\")");
        let half =
            |generation| Found::Half(Seal { mark: mark("a", generation), rested: 1, digest: None });
        check(at(5), half(5), None, "Doubtful(\"is damaged in part\")");
        check(at(5), half(4), None, "Whole");
        check(at(5), half(6), None, "its last change:");
    }
}
