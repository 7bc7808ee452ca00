//! The files a program has open under numbers.

use super::Disk;
use kerf_program::{FileMode, HostError};
use std::collections::BTreeMap;
use std::io;
use std::path::PathBuf;

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
    /// Where reading goes on, bytes.
    next: usize,
}

impl OpenFiles {
    /// Opens a file under a number.
    pub fn open(
        &mut self,
        disk: &dyn Disk,
        number: u8,
        path: PathBuf,
        mode: FileMode,
    ) -> Result<(), HostError> {
        let read = |disk: &dyn Disk| {
            let bytes = disk.read(&path).map_err(|e| refused("read", &path, &e))?;
            Ok(String::from_utf8_lossy(&bytes).into_owned())
        };
        let text = match mode {
            FileMode::Input => read(disk)?,
            FileMode::Append if disk.is_file(&path) => read(disk)?,
            // Tells at once when the file cannot be written.
            FileMode::Output | FileMode::Append => {
                disk.may_write(&path).map_err(|e| refused("write", &path, &e))?;
                String::new()
            }
        };
        self.0.insert(number, OpenFile { path, mode, text, next: 0 });
        Ok(())
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

    /// Closes a file; what was written is in place then.
    pub fn close(&mut self, disk: &mut dyn Disk, number: u8) -> Result<(), HostError> {
        let Some(file) = self.0.remove(&number) else { return Ok(()) };
        if file.mode == FileMode::Input {
            return Ok(());
        }
        disk.write(&file.path, file.text.as_bytes()).map_err(|e| refused("write", &file.path, &e))
    }

    fn file(&mut self, number: u8) -> Result<&mut OpenFile, HostError> {
        let missing = || HostError::Refused(format!("file #{number} is not open"));
        self.0.get_mut(&number).ok_or_else(missing)
    }
}

fn refused(what: &str, path: &std::path::Path, error: &io::Error) -> HostError {
    HostError::Refused(format!("cannot {what} {}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::super::MemoryDisk;
    use super::*;

    fn text(disk: &MemoryDisk, path: &str) -> String {
        String::from_utf8(disk.read(path.as_ref()).unwrap_or_default()).unwrap_or_default()
    }

    #[test]
    fn written_text_is_in_place_after_closing() {
        let mut disk = MemoryDisk::new([("a.txt", b"old\n".as_slice())]);
        let mut files = OpenFiles::default();
        assert_eq!(files.open(&disk, 1, "a.txt".into(), FileMode::Append), Ok(()));
        assert_eq!(files.write(1, "new\n"), Ok(()));
        assert_eq!(text(&disk, "a.txt"), "old\n");
        assert_eq!(files.close(&mut disk, 1), Ok(()));
        assert_eq!(text(&disk, "a.txt"), "old\nnew\n");
        assert!(files.write(1, "x").is_err());
    }

    #[test]
    fn lines_come_without_their_ends() {
        let disk = MemoryDisk::new([("a.txt", b"1\r\n\n3".as_slice())]);
        let mut files = OpenFiles::default();
        assert_eq!(files.open(&disk, 2, "a.txt".into(), FileMode::Input), Ok(()));
        let mut next = || files.read_line(2);
        assert_eq!([next(), next(), next()], ["1", "", "3"].map(|l| Ok(l.to_owned())));
        assert_eq!(next(), Err(HostError::EndOfFile));
    }
}
