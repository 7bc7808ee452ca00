//! Files that grow while a command runs: traces, signals, readings.
//!
//! A note in the data folder holds the length and the check number of what was written so far. By it the file of a
//! command that was killed is told from one that somebody edited afterwards.

use crc32fast::Hasher;
use std::fs::{self, File};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// Notes lie in this folder of the data folder.
const NOTES: &str = "being-written";

/// A file that grows, with its note.
pub struct Streamed {
    file: File,
    /// `None` where it cannot be kept: whoever replaces the file is asked.
    note: Option<File>,
    written: State,
}

/// Length and check number of what was written.
#[derive(Clone, Debug, Default)]
struct State {
    bytes: u64,
    sum: Hasher,
}

impl State {
    fn add(&mut self, bytes: &[u8]) {
        self.sum.update(bytes);
        self.bytes += bytes.len() as u64;
    }

    /// The state as a note has it: a line that is always as long, so that one takes the place of another.
    fn line(&self) -> String {
        format!("{:020} {:08x}\n", self.bytes, self.sum.clone().finalize())
    }
}

impl Streamed {
    /// Makes a file; the note lies in the data folder, where there is one.
    ///
    /// # Errors
    /// The disk does not take the file.
    pub fn create(path: &Path, data: Option<&Path>) -> io::Result<Self> {
        let note = data.and_then(|data| {
            fs::create_dir_all(data.join(NOTES)).ok()?;
            File::create(note_of(path, data)).ok()
        });
        let written = State::default();
        let mut streamed = Self { file: File::create(path)?, note, written: written.clone() };
        streamed.keep_note(&written);
        Ok(streamed)
    }

    /// Notes the state of the file, and the one that it is about to have: a command may be killed before it or behind.
    fn keep_note(&mut self, next: &State) {
        let text = self.written.line() + &next.line();
        let kept = |mut file: &File| file.rewind().and_then(|()| file.write_all(text.as_bytes()));
        self.note = self.note.take().filter(|file| kept(file).is_ok());
    }
}

impl Write for Streamed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut next = self.written.clone();
        next.add(bytes);
        self.keep_note(&next);
        let count = self.file.write(bytes)?;
        self.written.add(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Tells whether a file is as the command left it that was killed while it wrote it.
pub fn is_as_left(path: &Path, data: &Path) -> bool {
    let Ok(note) = fs::read_to_string(note_of(path, data)) else { return false };
    state_of(path).is_ok_and(|now| note.split_inclusive('\n').any(|known| known == now.line()))
}

/// Forgets the note of a file: the command that wrote it is over.
pub fn forget(path: &Path, data: &Path) {
    // A note that stays tells no more than what Kerf wrote there once.
    drop(fs::remove_file(note_of(path, data)));
}

fn state_of(path: &Path) -> io::Result<State> {
    let (mut file, mut state, mut part) = (File::open(path)?, State::default(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut part)? {
            0 => return Ok(state),
            count => state.add(&part[..count]),
        }
    }
}

fn note_of(path: &Path, data: &Path) -> PathBuf {
    let place = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let name = crc32fast::hash(place.as_os_str().as_encoded_bytes());
    data.join(NOTES).join(format!("{name:08x}"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_was_edited_is_not_as_it_was_left() {
        let folder = tempfile::tempdir().unwrap();
        let (path, data) = (folder.path().join("a.jsonl"), folder.path().join("data"));
        assert!(!is_as_left(&path, &data), "nothing was written");
        let mut file = Streamed::create(&path, Some(&data)).unwrap();
        assert!(is_as_left(&path, &data), "nothing is in it yet");
        for text in ["one\n", "two\n"] {
            file.write_all(text.as_bytes()).unwrap();
            assert!(is_as_left(&path, &data), "{text}");
        }
        let other = folder.path().join("b.jsonl");
        fs::copy(&path, &other).unwrap();
        assert!(!is_as_left(&other, &data), "that is another file");
        fs::write(&path, "one\n").unwrap();
        assert!(is_as_left(&path, &data), "it was killed before the second line");
        for edited in ["one\ntwo", "one\ntwo\nthree\n", "one\nTwo\n", ""] {
            fs::write(&path, edited).unwrap();
            assert!(!is_as_left(&path, &data), "{edited}");
        }
        fs::write(&path, "one\ntwo\n").unwrap();
        assert!(is_as_left(&path, &data));
        forget(&path, &data);
        assert!(!is_as_left(&path, &data), "the command is over");
    }
}
