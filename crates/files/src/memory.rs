//! A disk in memory, for tests and for editors.

use crate::Disk;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

/// A disk in memory. Folders exist as far as files lie in them; the root always does.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MemoryDisk {
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl MemoryDisk {
    /// A disk with these files.
    pub fn new<'a>(files: impl IntoIterator<Item = (&'a str, &'a [u8])>) -> Self {
        let files = files.into_iter().map(|(name, bytes)| (name.into(), bytes.to_vec()));
        Self { files: files.collect() }
    }

    /// Every file, in order of paths.
    pub fn files(&self) -> impl Iterator<Item = (&Path, &[u8])> {
        self.files.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice()))
    }
}

impl Disk for MemoryDisk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.files.get(path).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn names(&self, folder: &Path) -> io::Result<Vec<String>> {
        let inside = self.files.keys().filter_map(|path| {
            let first = path.strip_prefix(folder).ok()?.components().next()?;
            Some(first.as_os_str().to_string_lossy().into_owned())
        });
        let mut names: Vec<String> = inside.collect();
        names.sort();
        names.dedup();
        Ok(names)
    }

    fn is_file(&self, path: &Path) -> bool {
        self.files.contains_key(path)
    }

    fn is_folder(&self, path: &Path) -> bool {
        let inside = |file: &PathBuf| file.starts_with(path) && file != path;
        path.as_os_str().is_empty() || self.files.keys().any(inside)
    }

    fn real_path(&self, path: &Path) -> PathBuf {
        path.to_owned()
    }

    fn may_write(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn make_folder(&mut self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn write(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.files.insert(path.to_owned(), bytes.to_vec());
        Ok(())
    }

    fn append(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.files.entry(path.to_owned()).or_default().extend(bytes);
        Ok(())
    }
}
