//! The few things that are asked of a disk.

use std::io;
use std::path::{Path, PathBuf};

/// A place where files lie.
pub trait Disk {
    /// The bytes of a file.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// Names in a folder, sorted.
    fn names(&self, folder: &Path) -> io::Result<Vec<String>>;

    /// Tells whether there is such a file.
    fn is_file(&self, path: &Path) -> bool;

    /// Tells whether there is such a folder.
    fn is_folder(&self, path: &Path) -> bool;

    /// The path with symbolic links resolved, as far as it exists.
    fn real_path(&self, path: &Path) -> PathBuf;

    /// Checks that a file could be written there; changes nothing.
    fn may_write(&self, path: &Path) -> io::Result<()>;

    /// Makes a folder and those above it.
    fn make_folder(&mut self, path: &Path) -> io::Result<()>;

    /// Puts a whole file in place: afterwards it is there complete, or as it was before.
    fn write(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()>;

    /// Tells whether a program wrote the file that lies there, in a space of its own.
    fn is_scratch(&self, _: &Path) -> bool {
        false
    }

    /// Adds bytes at the end of a file; makes it where there is none.
    fn append(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()>;
}
