//! Earlier contents of files that were written over, kept in the data folder.
//!
//! ```text
//!  data/versions/doors/a.sbp/7-1764000000.sbp     what doors/a.sbp was before its 7th save,
//!                                                 since that second
//! ```

use crate::{Disk, RealDisk};
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::UNIX_EPOCH;

/// Earlier contents that are kept of one file.
pub const MOST_VERSIONS: usize = 20;

/// Bytes that those of all files have together; the newest one is kept even if it alone has more.
pub const MOST_VERSION_BYTES: u64 = 256 << 20;

/// An earlier content of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    /// Grows with each save of the file, from 1.
    pub number: u32,
    /// The file had this content since then: seconds since 1970.
    pub changed: u64,
    /// Its length.
    pub bytes: u64,
}

/// The earlier contents of the files of a part folder.
#[derive(Clone, Debug)]
pub struct Versions {
    root: PathBuf,
    most_bytes: u64,
}

/// A version and where it lies.
type Placed = (Version, PathBuf);

impl Versions {
    /// Those that a data folder keeps.
    #[must_use]
    pub fn in_data(data: &Path) -> Self {
        Self { root: data.join("versions"), most_bytes: MOST_VERSION_BYTES }
    }

    /// Keeps the content of a file that is about to be written over; the oldest ones that are too many go.
    ///
    /// # Errors
    /// The file cannot be read, or its copy cannot be written.
    pub fn keep(&self, name: &str, file: &Path) -> io::Result<()> {
        let (bytes, about) = (RealDisk.read(file)?, fs::metadata(file)?);
        let changed = about.modified()?.duration_since(UNIX_EPOCH).map_or(0, |t| t.as_secs());
        let folder = self.folder(name)?;
        let newest = placed(&folder)?.pop();
        // A server that was killed between the copy and the save kept this content already.
        if newest.as_ref().is_some_and(|(_, kept)| RealDisk.read(kept).is_ok_and(|b| b == bytes)) {
            return Ok(());
        }
        let number = newest.map_or(1, |(last, _)| last.number + 1);
        let ending = Path::new(name).extension().unwrap_or_default().to_string_lossy();
        fs::create_dir_all(&folder)?;
        RealDisk.write(&folder.join(format!("{number}-{changed}.{ending}")), &bytes)?;
        self.drop_old(&folder)
    }

    /// Lists what is kept of a file, the newest first.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn list(&self, name: &str) -> io::Result<Vec<Version>> {
        let kept = placed(&self.folder(name)?)?;
        Ok(kept.into_iter().rev().map(|(version, _)| version).collect())
    }

    /// One of them.
    ///
    /// # Errors
    /// None has this number, or the disk does not give it.
    pub fn read(&self, name: &str, number: u32) -> io::Result<Vec<u8>> {
        let kept = placed(&self.folder(name)?)?;
        let wanted = kept.into_iter().find(|(version, _)| version.number == number);
        let none = || io::Error::new(io::ErrorKind::NotFound, "no version has this number");
        RealDisk.read(&wanted.ok_or_else(none)?.1)
    }

    /// Names of the files of which something is kept, in their order.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn names(&self) -> io::Result<Vec<String>> {
        let mut all = Vec::new();
        if self.root.is_dir() {
            below(&self.root, &mut all)?;
        }
        let folders =
            all.iter().filter_map(|(_, place)| place.parent()?.strip_prefix(&self.root).ok());
        let mut names: Vec<String> = folders.map(with_slashes).collect();
        names.sort();
        names.dedup();
        Ok(names)
    }

    /// Ends what is kept of a file.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn forget(&self, name: &str) -> io::Result<()> {
        for (_, kept) in placed(&self.folder(name)?)? {
            fs::remove_file(kept)?;
        }
        Ok(())
    }

    fn folder(&self, name: &str) -> io::Result<PathBuf> {
        let name = Path::new(name);
        let plain = name.components().all(|part| matches!(part, Component::Normal(_)));
        let outside = || io::Error::new(io::ErrorKind::InvalidInput, "no file of the part folder");
        plain.then(|| self.root.join(name)).ok_or_else(outside)
    }

    /// Ends what is too much: of this file first, then the oldest of all, never the newest of all.
    fn drop_old(&self, folder: &Path) -> io::Result<()> {
        let own = placed(folder)?;
        for (_, old) in &own[..own.len().saturating_sub(MOST_VERSIONS)] {
            fs::remove_file(old)?;
        }
        let mut all = Vec::new();
        below(&self.root, &mut all)?;
        all.sort_by_key(|(version, place)| {
            (fs::metadata(place).and_then(|m| m.modified()).ok(), *version)
        });
        let mut total: u64 = all.iter().map(|(version, _)| version.bytes).sum();
        all.pop();
        for (version, old) in all {
            if total <= self.most_bytes {
                break;
            }
            fs::remove_file(old)?;
            total -= version.bytes;
        }
        Ok(())
    }
}

/// A name as part files have it, whatever the system puts between folders.
fn with_slashes(path: &Path) -> String {
    let parts = path.components().map(|part| part.as_os_str().to_string_lossy());
    parts.collect::<Vec<_>>().join("/")
}

/// The versions in a folder, the oldest first; none where the folder is not there.
fn placed(folder: &Path) -> io::Result<Vec<Placed>> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries?,
    };
    let mut kept: Vec<Placed> =
        entries.flatten().filter_map(|entry| version(&entry.path())).collect();
    kept.sort();
    Ok(kept)
}

/// The version that lies there; nothing where another thing does.
fn version(place: &Path) -> Option<Placed> {
    let about = fs::metadata(place).ok().filter(fs::Metadata::is_file)?;
    let (number, changed) = place.file_stem()?.to_str()?.split_once('-')?;
    let (number, changed) = (number.parse().ok()?, changed.parse().ok()?);
    Some((Version { number, changed, bytes: about.len() }, place.to_owned()))
}

fn below(folder: &Path, all: &mut Vec<Placed>) -> io::Result<()> {
    all.extend(placed(folder)?);
    for entry in fs::read_dir(folder)?.flatten() {
        if entry.file_type()?.is_dir() {
            below(&entry.path(), all)?;
        }
    }
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A part file whose text is saved again and again, what it was being kept.
    struct Saved {
        dir: tempfile::TempDir,
        versions: Versions,
    }

    impl Saved {
        fn new(most_bytes: u64) -> Self {
            let dir = tempfile::tempdir().unwrap();
            let versions = Versions { most_bytes, ..Versions::in_data(&dir.path().join("data")) };
            Self { dir, versions }
        }

        fn save(&self, name: &str, text: &str) {
            let file = self.dir.path().join(name.replace('/', "-"));
            if file.is_file() {
                self.versions.keep(name, &file).unwrap();
            }
            fs::write(&file, text).unwrap();
        }

        fn texts(&self, name: &str) -> Vec<String> {
            let read = |version: Version| self.versions.read(name, version.number).unwrap();
            let texts = self.versions.list(name).unwrap().into_iter().map(read);
            texts.map(|bytes| String::from_utf8(bytes).unwrap()).collect()
        }
    }

    #[test]
    fn what_was_written_over_is_kept_newest_first() {
        let saved = Saved::new(MOST_VERSION_BYTES);
        for text in ["one", "two", "three"] {
            saved.save("doors/a.sbp", text);
        }
        saved.save("a.sbp", "another");
        assert_eq!(saved.texts("doors/a.sbp"), ["two", "one"]);
        assert!(saved.texts("a.sbp").is_empty());
    }

    #[test]
    fn the_last_twenty_are_kept() {
        let saved = Saved::new(MOST_VERSION_BYTES);
        for n in 0..=MOST_VERSIONS + 3 {
            saved.save("a.sbp", &n.to_string());
        }
        let texts = saved.texts("a.sbp");
        assert_eq!((texts.len(), texts[0].as_str(), texts[19].as_str()), (20, "22", "3"));
    }

    #[test]
    fn all_together_have_a_bound_and_the_newest_is_kept() {
        let saved = Saved::new(8);
        for text in ["aaa", "bbb", "ccc", "much longer than all of it", "end"] {
            saved.save("a.sbp", text);
        }
        assert_eq!(saved.texts("a.sbp"), ["much longer than all of it"]);
    }

    #[test]
    fn the_same_content_is_kept_once() {
        let saved = Saved::new(MOST_VERSION_BYTES);
        saved.save("a.sbp", "one");
        let file = saved.dir.path().join("a.sbp");
        saved.versions.keep("a.sbp", &file).unwrap();
        saved.versions.keep("a.sbp", &file).unwrap();
        assert_eq!(saved.texts("a.sbp"), ["one"]);
    }

    #[test]
    fn names_are_told_until_they_are_forgotten() {
        let saved = Saved::new(MOST_VERSION_BYTES);
        assert!(saved.versions.names().unwrap().is_empty());
        for (name, text) in
            [("doors/a.sbp", "one"), ("doors/a.sbp", "two"), ("b.sbp", "one"), ("b.sbp", "two")]
        {
            saved.save(name, text);
        }
        assert_eq!(saved.versions.names().unwrap(), ["b.sbp", "doors/a.sbp"]);
        saved.versions.forget("doors/a.sbp").unwrap();
        assert_eq!(saved.versions.names().unwrap(), ["b.sbp"]);
    }

    #[test]
    fn no_name_leads_out_of_the_folder() {
        let saved = Saved::new(MOST_VERSION_BYTES);
        for name in ["../a.sbp", "/etc/passwd", "a/../../b"] {
            assert!(saved.versions.list(name).is_err(), "{name}");
        }
    }
}
