//! The part folder, and nothing outside it.

use crate::names;
use kerf_files::{Disk, RealDisk};
use kerf_wire::{FileInfo, Problem, Why};
use kerf_workspace::MOST_BYTES;
use std::collections::VecDeque;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// Bytes that the head of a file has at most.
const HEAD: u64 = 16 * 1024;

/// Files that a search looks at and finds, at most.
const MOST_LOOKED: usize = 50_000;
const MOST_FOUND: usize = 500;

/// The folder of part files. Names are relative, with `/` between folders.
#[derive(Clone, Debug)]
pub struct PartFolder {
    /// Without links, so that what lies below can be told.
    root: PathBuf,
}

impl PartFolder {
    /// The folder; it has to be there.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn new(root: &Path) -> io::Result<Self> {
        Ok(Self { root: root.canonicalize()? })
    }

    /// The folder.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The path of a file that is there.
    ///
    /// # Errors
    /// The name leads elsewhere, or nothing is there.
    pub fn find(&self, name: &str) -> Result<PathBuf, Problem> {
        let path = self.path(name)?;
        let real = path.canonicalize().map_err(|error| problem(name, &error))?;
        if real.starts_with(&self.root) { Ok(real) } else { Err(outside(name)) }
    }

    /// The path of a file that may be written: its folder has to be there.
    fn place(&self, name: &str) -> Result<PathBuf, Problem> {
        let path = self.path(name)?;
        let (Some(folder), Some(file)) = (path.parent(), path.file_name()) else {
            return Err(outside(name));
        };
        let folder = folder.canonicalize().map_err(|error| problem(name, &error))?;
        let place = folder.join(file);
        // What is there already has its name.
        if !place_is_there(&folder.join(file)) {
            let why = name.split('/').find_map(names::why_not);
            why.map_or(Ok(()), |text| Err(Problem { why: Why::File, text }))?;
        }
        // What is written over may be a link that leads elsewhere.
        let is_link = fs::symlink_metadata(&place).is_ok_and(|m| !m.is_file());
        if folder.starts_with(&self.root) && !is_link { Ok(place) } else { Err(outside(name)) }
    }

    fn path(&self, name: &str) -> Result<PathBuf, Problem> {
        let plain = |part: &str| {
            let signs = ['\\', ':', '\0', '*', '?', '"', '<', '>', '|'];
            !part.is_empty() && !part.starts_with('.') && !part.contains(signs)
        };
        if name.split('/').all(plain) { Ok(self.root.join(name)) } else { Err(outside(name)) }
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// It is not there, is too large, or lies elsewhere.
    pub fn read(&self, name: &str) -> Result<Vec<u8>, Problem> {
        let path = self.find(name)?;
        let length = fs::metadata(&path).map_err(|error| problem(name, &error))?.len();
        if length > MOST_BYTES as u64 {
            return Err(Problem { why: Why::File, text: format!("{name} is too large") });
        }
        fs::read(path).map_err(|error| problem(name, &error))
    }

    /// The bytes of the file under a name; nothing where none is there.
    ///
    /// # Errors
    /// It cannot be read, or the name leads elsewhere.
    pub fn present(&self, name: &str) -> Result<Option<Vec<u8>>, Problem> {
        let is_there = self.place(name)?.is_file();
        is_there.then(|| self.read(name)).transpose()
    }

    /// Returns the time of a file's last change: seconds since 1970.
    ///
    /// # Errors
    /// As of [`PartFolder::read`].
    pub fn changed(&self, name: &str) -> Result<u64, Problem> {
        let about = fs::metadata(self.find(name)?).map_err(|error| problem(name, &error))?;
        Ok(changed(&about))
    }

    /// Words that are others as soon as a file is: its name, its length, the time of its last change.
    ///
    /// # Errors
    /// As of [`PartFolder::read`].
    pub fn stamp(&self, name: &str) -> Result<String, Problem> {
        let about = fs::metadata(self.find(name)?).map_err(|error| problem(name, &error))?;
        let changed = about.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
        Ok(format!("{name} {} {:?}", about.len(), changed))
    }

    /// The first lines of a file: as many as a head has at most.
    ///
    /// # Errors
    /// As of [`PartFolder::read`].
    pub fn head(&self, name: &str) -> Result<String, Problem> {
        let failed = |error: io::Error| problem(name, &error);
        let mut bytes = Vec::new();
        let file = fs::File::open(self.find(name)?).map_err(failed)?;
        file.take(HEAD).read_to_end(&mut bytes).map_err(failed)?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// Writes a file, whole or not at all.
    ///
    /// # Errors
    /// The name leads elsewhere, or the disk refuses.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), Problem> {
        let place = self.place(name)?;
        RealDisk.write(&place, bytes).map_err(|error| problem(name, &error))
    }

    /// Takes a file away.
    ///
    /// # Errors
    /// The name leads elsewhere, or the disk refuses.
    pub fn remove(&self, name: &str) -> Result<(), Problem> {
        let place = self.place(name)?;
        fs::remove_file(place)
            .map_err(|error| Problem { why: Why::File, text: format!("{name}: {error}") })
    }

    /// Lists a folder, folders first; the part folder itself for an empty name.
    ///
    /// # Errors
    /// It is not there or lies elsewhere.
    pub fn list(&self, folder: &str) -> Result<Vec<FileInfo>, Problem> {
        let path = if folder.is_empty() { self.root.clone() } else { self.find(folder)? };
        let entries = fs::read_dir(path).map_err(|error| problem(folder, &error))?;
        let mut files: Vec<FileInfo> =
            entries.flatten().filter_map(|entry| info(folder, &entry)).collect();
        files.sort_by(|a, b| (!a.folder, &a.name).cmp(&(!b.folder, &b.name)));
        Ok(files)
    }

    /// Files of a folder and of those below it that a name is asked for of, the nearest folders first.
    ///
    /// # Errors
    /// As of [`PartFolder::list`].
    pub fn found(
        &self,
        folder: &str,
        fits: impl Fn(&str) -> bool,
    ) -> Result<Vec<FileInfo>, Problem> {
        let mut folders = VecDeque::from([folder.to_owned()]);
        let (mut found, mut looked) = (Vec::new(), 0);
        while let Some(folder) = folders.pop_front() {
            // A folder that nobody may read hides no other one.
            for file in self
                .list(&folder)
                .or_else(|why| if looked == 0 { Err(why) } else { Ok(Vec::new()) })?
            {
                looked += 1;
                match file.folder {
                    true => folders.push_back(file.name),
                    false if fits(&file.name) => found.push(file),
                    false => {}
                }
            }
            if looked > MOST_LOOKED || found.len() > MOST_FOUND {
                break;
            }
        }
        found.truncate(MOST_FOUND);
        Ok(found)
    }

    /// The name of a path below the folder; the path itself when it lies elsewhere.
    pub fn name_of(&self, path: &str) -> String {
        let below = Path::new(path).strip_prefix(&self.root);
        below.map_or_else(|_| path.to_owned(), |name| name.display().to_string())
    }

    /// A sentence in which files are named as pages know them.
    pub fn named_in(&self, text: &str) -> String {
        text.replace(&format!("{}/", self.root.display()), "")
    }
}

fn info(folder: &str, entry: &fs::DirEntry) -> Option<FileInfo> {
    let (name, data) = (entry.file_name().into_string().ok()?, entry.metadata().ok()?);
    if name.starts_with('.') {
        return None;
    }
    Some(FileInfo {
        name: if folder.is_empty() { name } else { format!("{folder}/{name}") },
        folder: data.is_dir(),
        bytes: data.len(),
        changed: changed(&data),
        header: None,
        part: false,
        opens: None,
    })
}

fn changed(about: &fs::Metadata) -> u64 {
    let since = about.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
    since.map_or(0, |time| time.as_secs())
}

fn outside(name: &str) -> Problem {
    let text = format!("'{name}' is no name of a file in the part folder");
    Problem { why: Why::File, text }
}

fn place_is_there(place: &Path) -> bool {
    fs::symlink_metadata(place).is_ok()
}

fn problem(name: &str, error: &io::Error) -> Problem {
    if why(error) == Why::Server {
        return Problem { why: Why::File, text: format!("{name}: {error}") };
    }
    let text = format!(
        "{name} is not written, it is as it was before: the disk is full; make room ({error})"
    );
    Problem { why: Why::Full, text }
}

/// The sort of reason for which a disk refuses to write: it is full, or something else.
pub fn why(error: &io::Error) -> Why {
    use io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
    match error.kind() {
        StorageFull | FileTooLarge | QuotaExceeded => Why::Full,
        _ => Why::Server,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn folder() -> (tempfile::TempDir, PartFolder) {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir_all(dir.path().join("parts/doors")).unwrap();
        fs::write(dir.path().join("parts/doors/a.sbp"), "MX,1").unwrap();
        fs::write(dir.path().join("secret.txt"), "x").unwrap();
        let parts = PartFolder::new(&dir.path().join("parts")).unwrap();
        (dir, parts)
    }

    #[test]
    fn names_below_the_folder_are_read_and_written() {
        let (_dir, parts) = folder();
        assert_eq!(parts.read("doors/a.sbp").unwrap(), b"MX,1");
        parts.write("doors/b.sbp", b"MY,1").unwrap();
        let names: Vec<_> = parts.list("doors").unwrap().into_iter().map(|f| f.name).collect();
        assert_eq!(names, ["doors/a.sbp", "doors/b.sbp"]);
        assert!(parts.list("").unwrap()[0].folder);
    }

    #[test]
    fn files_are_found_in_folders_below() {
        let (_dir, parts) = folder();
        parts.write("ab.sbp", b"").unwrap();
        let found = |folder: &str, word: &str| -> Vec<String> {
            let found = parts.found(folder, |name| name.contains(word)).unwrap();
            found.into_iter().map(|file| file.name).collect()
        };
        assert_eq!(found("", "a"), ["ab.sbp", "doors/a.sbp"]);
        assert_eq!(found("doors", "a"), ["doors/a.sbp"]);
        assert!(parts.found("windows", |_| true).is_err());
    }

    #[test]
    fn no_name_leads_out_of_the_folder() {
        let (dir, parts) = folder();
        let absolute = dir.path().join("secret.txt").display().to_string();
        for name in [
            "../secret.txt",
            "doors/../../secret.txt",
            &absolute,
            "",
            ".",
            "..",
            "doors//a.sbp",
            "/",
            "doors\\..\\..\\secret.txt",
            "C:\\x",
            "c:x",
            "./doors/a.sbp",
            ".hidden",
            "a\0b",
            "doors/",
        ] {
            assert!(parts.read(name).is_err(), "read {name}");
            assert!(parts.write(name, b"y").is_err(), "write {name}");
        }
        assert_eq!(fs::read(dir.path().join("secret.txt")).unwrap(), b"x");
    }

    #[cfg(unix)]
    #[test]
    fn links_do_not_lead_out_either() {
        let (dir, parts) = folder();
        let link = |to: &str, name: &str| {
            std::os::unix::fs::symlink(dir.path().join(to), dir.path().join("parts").join(name))
                .unwrap();
        };
        link("secret.txt", "link.txt");
        link("", "up");
        for name in ["link.txt", "up/secret.txt", "up/new.txt"] {
            assert!(parts.read(name).is_err(), "read {name}");
            assert!(parts.write(name, b"y").is_err(), "write {name}");
        }
        assert_eq!(fs::read(dir.path().join("secret.txt")).unwrap(), b"x");
        assert!(!dir.path().join("new.txt").exists());
    }
}
