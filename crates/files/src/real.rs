//! The disk of the computer.

use crate::{Disk, leftovers};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, fs};
use tempfile::{Builder, NamedTempFile};

/// The disk of the computer.
#[derive(Clone, Copy, Debug, Default)]
pub struct RealDisk;

impl Disk for RealDisk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        fs::read(path)
    }

    fn names(&self, folder: &Path) -> io::Result<Vec<String>> {
        let entries = fs::read_dir(or_here(folder))?;
        let mut names: Vec<String> =
            entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect();
        names.sort();
        Ok(names)
    }

    fn is_file(&self, path: &Path) -> bool {
        path.is_file()
    }

    fn is_folder(&self, path: &Path) -> bool {
        or_here(path).is_dir()
    }

    fn real_path(&self, path: &Path) -> PathBuf {
        let path = or_here(path);
        for ancestor in path.ancestors() {
            if let Ok(real) = fs::canonicalize(or_here(ancestor)) {
                let rest = path.strip_prefix(ancestor).unwrap_or(Path::new(""));
                return if rest.as_os_str().is_empty() { real } else { real.join(rest) };
            }
        }
        env::current_dir().unwrap_or_default().join(path)
    }

    fn may_write(&self, path: &Path) -> io::Result<()> {
        beside(path).map(drop)
    }

    fn make_folder(&mut self, path: &Path) -> io::Result<()> {
        fs::create_dir_all(or_here(path))
    }

    fn write(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        replace(path, bytes, beside(path)).map_err(without_path)
    }

    fn append(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        fs::File::options().create(true).append(true).open(path)?.write_all(bytes)
    }
}

/// Replaces a file: whoever reads it sees the one before or this one, whole. After a power cut it may be either.
///
/// # Errors
/// Whatever the disk says.
pub fn replace_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let replaced = beside(path).and_then(|mut beside| {
        beside.write_all(bytes)?;
        beside.persist(path).map_err(|e| e.error)
    });
    replaced.map(drop).map_err(without_path)
}

/// Replaces a file by one that only this user can read, whoever could read the one before.
///
/// # Errors
/// Whatever the disk says.
pub fn write_private(path: &Path, bytes: &[u8]) -> io::Result<()> {
    replace(path, bytes, secret_beside(path)).map_err(without_path)
}

fn replace(path: &Path, bytes: &[u8], beside: io::Result<NamedTempFile>) -> io::Result<()> {
    let mut beside = beside?;
    beside.write_all(bytes)?;
    beside.as_file().sync_all()?;
    beside.persist(path).map_err(|e| e.error)?;
    Ok(())
}

/// Cuts the name of a file that nobody asked for from what the system said.
fn without_path(error: io::Error) -> io::Error {
    match error.to_string().split_once(" at path ") {
        Some((said, _)) => io::Error::new(error.kind(), said),
        None => error,
    }
}

/// A new file in the folder of another; gone unless it is put in that one's place.
fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let prefix = leftovers::prefix();
    let mut beside = Builder::new();
    let beside = beside.prefix(&prefix).suffix(leftovers::SUFFIX);
    #[cfg(unix)]
    let beside = {
        use std::os::unix::fs::PermissionsExt;
        // As the file had them, or as any new file has them.
        let new = || fs::Permissions::from_mode(0o666);
        beside.permissions(fs::metadata(path).map_or_else(|_| new(), |known| known.permissions()))
    };
    held(beside.tempfile_in(folder_of(path)))
}

/// The same for a file that only its owner reads.
fn secret_beside(path: &Path) -> io::Result<NamedTempFile> {
    let prefix = leftovers::prefix();
    // Temporary files are secret unless they are told otherwise.
    held(Builder::new().prefix(&prefix).suffix(leftovers::SUFFIX).tempfile_in(folder_of(path)))
}

/// The file is locked for as long as it is written: who sweeps the folder leaves it.
fn held(file: io::Result<NamedTempFile>) -> io::Result<NamedTempFile> {
    let file = file?;
    // Without locks its age keeps it.
    #[cfg(unix)]
    drop(file.as_file().try_lock());
    Ok(file)
}

fn folder_of(path: &Path) -> &Path {
    or_here(path.parent().unwrap_or(Path::new("")))
}

/// The folder we are in has an empty name in relative paths.
fn or_here(path: &Path) -> &Path {
    if path.as_os_str().is_empty() { Path::new(".") } else { path }
}
