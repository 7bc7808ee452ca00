//! A disk whose writes stay in a scratch space: what a preview writes, it can read again, and
//! nothing of it remains.

use crate::{Disk, MemoryDisk};
use std::io;
use std::path::{Path, PathBuf};

/// At most this much is kept in a scratch space, bytes: a loop that writes must not eat the memory.
const MOST_BYTES: usize = 256 << 20;

/// A disk below and what was written above it.
pub struct Scratch<D> {
    below: D,
    written: MemoryDisk,
    bytes: usize,
}

impl<D: Disk> Scratch<D> {
    /// Nothing written yet.
    pub fn over(below: D) -> Self {
        Self { below, written: MemoryDisk::default(), bytes: 0 }
    }

    /// Returns the disk with the files that were written.
    pub const fn written(&self) -> &MemoryDisk {
        &self.written
    }
}

impl<D: Disk> Disk for Scratch<D> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if self.written.is_file(path) { self.written.read(path) } else { self.below.read(path) }
    }

    fn names(&self, folder: &Path) -> io::Result<Vec<String>> {
        let mut names = self.written.names(folder)?;
        match self.below.names(folder) {
            Ok(below) => names.extend(below),
            Err(error) if names.is_empty() => return Err(error),
            Err(_) => {}
        }
        names.sort();
        names.dedup();
        Ok(names)
    }

    fn is_file(&self, path: &Path) -> bool {
        self.written.is_file(path) || self.below.is_file(path)
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.below.is_folder(path) || self.written.is_folder(path)
    }

    fn real_path(&self, path: &Path) -> PathBuf {
        self.below.real_path(path)
    }

    fn may_write(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn make_folder(&mut self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn write(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.bytes += bytes.len();
        if self.bytes > MOST_BYTES {
            return Err(io::Error::other("too much written for a preview"));
        }
        self.written.write(path, bytes)
    }

    fn is_scratch(&self, path: &Path) -> bool {
        self.written.is_file(path)
    }

    fn append(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let mut all = if self.is_file(path) { self.read(path)? } else { Vec::new() };
        all.extend(bytes);
        self.write(path, &all)
    }
}
