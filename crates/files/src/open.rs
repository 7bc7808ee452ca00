//! The files a program has open under numbers.

use crate::Disk;
use kerf_program::{FileMode, HostError};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

/// At most this much may be written into one file, bytes: a loop that writes must not eat the memory.
const MOST_BYTES: usize = 256 << 20;

/// Files by number. What is written is put in place when the file is closed, whole.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OpenFiles(BTreeMap<u8, OpenFile>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct OpenFile {
    path: PathBuf,
    mode: FileMode,
    text: String,
    /// Place at which reading goes on, bytes.
    next: usize,
}

impl OpenFiles {
    /// Opens a file that holds these bytes under a number.
    pub fn open(&mut self, number: u8, path: PathBuf, mode: FileMode, bytes: &[u8]) {
        let text = String::from_utf8_lossy(bytes).into_owned();
        self.0.insert(number, OpenFile { path, mode, text, next: 0 });
    }

    /// Appends text to a file that is open for writing.
    pub fn write(&mut self, number: u8, text: &str) -> Result<(), HostError> {
        let file = self.file(number)?;
        if file.mode == FileMode::Input {
            return Err(HostError::Refused(format!("file #{number} is open for reading")));
        }
        if file.text.len() + text.len() > MOST_BYTES {
            return Err(HostError::Refused(format!("too much written to file #{number}")));
        }
        file.text.push_str(text);
        Ok(())
    }

    /// The next line of a file that is open for reading, without its end.
    pub fn read_line(&mut self, number: u8) -> Result<String, HostError> {
        let file = self.file(number)?;
        if file.mode != FileMode::Input {
            return Err(HostError::Refused(format!("file #{number} is open for writing")));
        }
        let rest = &file.text[file.next..];
        if rest.is_empty() {
            return Err(HostError::EndOfFile);
        }
        let line = rest.split_inclusive('\n').next().unwrap_or_default();
        file.next += line.len();
        Ok(line.trim_end_matches(['\r', '\n']).to_owned())
    }

    /// Closes a file; of one that was written, where its text belongs.
    pub fn take(&mut self, number: u8) -> Option<(PathBuf, String)> {
        let file = self.0.remove(&number)?;
        (file.mode != FileMode::Input).then_some((file.path, file.text))
    }

    fn file(&mut self, number: u8) -> Result<&mut OpenFile, HostError> {
        let missing = || HostError::Refused(format!("file #{number} is not open"));
        self.0.get_mut(&number).ok_or_else(missing)
    }
}

/// Returns the bytes that a file holds when it is opened.
pub fn to_open(disk: &dyn Disk, path: &Path, mode: FileMode) -> Result<Vec<u8>, HostError> {
    if mode == FileMode::Input || mode == FileMode::Append && disk.is_file(path) {
        return disk.read(path).map_err(|e| refused("read", path, &e));
    }
    // Tells at once when the file cannot be written.
    disk.may_write(path).map_err(|e| refused("write", path, &e))?;
    Ok(Vec::new())
}

/// Makes the folder of a file that is opened for writing, where it is not there yet.
pub fn make_way(disk: &mut dyn Disk, path: &Path) -> Result<(), HostError> {
    match path.parent() {
        Some(folder) if !disk.is_folder(folder) => {
            disk.make_folder(folder).map_err(|e| refused("make the folder", folder, &e))
        }
        _ => Ok(()),
    }
}

fn refused(what: &str, path: &Path, error: &io::Error) -> HostError {
    HostError::Refused(format!("cannot {what} {}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MemoryDisk;

    #[test]
    fn written_text_goes_to_the_disk_when_the_file_is_closed() {
        let disk = MemoryDisk::new([("a.txt", b"old\n".as_slice())]);
        let mut files = OpenFiles::default();
        let old = to_open(&disk, Path::new("a.txt"), FileMode::Append).unwrap_or_default();
        files.open(1, "a.txt".into(), FileMode::Append, &old);
        assert_eq!(files.write(1, "new\n"), Ok(()));
        assert_eq!(files.take(1), Some(("a.txt".into(), "old\nnew\n".into())));
        assert!(files.write(1, "x").is_err() && files.take(1).is_none());
    }

    #[test]
    fn a_folder_is_made_for_a_file_that_is_written() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("Tools/Now/new.txt");
        assert_eq!(make_way(&mut crate::RealDisk, &path), Ok(()));
        assert!(path.parent().is_some_and(Path::is_dir) && !path.exists());
        assert_eq!(make_way(&mut crate::RealDisk, &path), Ok(()), "it is there already");
        Ok(())
    }

    #[test]
    fn lines_come_without_their_ends() {
        let mut files = OpenFiles::default();
        files.open(2, "a.txt".into(), FileMode::Input, b"1\r\n\n3");
        let mut next = || files.read_line(2);
        assert_eq!([next(), next(), next()], ["1", "", "3"].map(|l| Ok(l.to_owned())));
        assert_eq!(next(), Err(HostError::EndOfFile));
        assert_eq!(files.take(2), None, "nothing was written");
    }
}
