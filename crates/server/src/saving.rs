//! Files of the part folder that are written over: never without leave, and what they were is kept.
//!
//! ```text
//!  drawing, part program, editor, PUT ──► Saves::save ──► leave? ──► Versions::keep ──► PartFolder::write
//!                                             └─ no: Why::Replaces, and nothing is written
//! ```

use crate::digested::hash;
use crate::file_kind::kind_of;
use crate::files::{self, PartFolder};
use crate::locks::lock;
use crate::refusal::problem;
use kerf_files::versions::Versions;
use kerf_wire::{FileAbout, FileInfo, FileKind, FileVersion, Problem, Why};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;

/// Stands for any file that may lie under the name.
const ANY: &str = "*";

/// Leave to write over a file, as the If-Match of HTTP has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Leave {
    /// Only where nothing lies under the name.
    Nothing,
    /// Only where the file there has this hash: it is the one that was read, or that somebody was asked about.
    Of(String),
    /// Over anything that lies there.
    Anything,
}

impl Leave {
    /// The leave that a message carries.
    pub fn of(replaces: Option<&str>) -> Self {
        match replaces {
            None => Self::Nothing,
            Some(ANY) => Self::Anything,
            Some(hash) => Self::Of(hash.into()),
        }
    }

    fn is_for(&self, present: &[u8]) -> bool {
        match self {
            Self::Nothing => false,
            Self::Of(known) => *known == hash(present),
            Self::Anything => true,
        }
    }
}

/// The only way in which a file of the part folder is written over.
#[derive(Debug)]
pub struct Saves {
    versions: Versions,
    /// The hashes of jobs that were made of drawings, by name: those are made anew without a question.
    made: Mutex<BTreeMap<String, String>>,
    /// One at a time: between the look at a file and its replacement nobody else of Kerf writes it.
    turn: Mutex<()>,
}

impl Saves {
    /// Keeps what is written over in a data folder.
    pub fn new(data: &Path) -> Self {
        let versions = Versions::in_data(data);
        Self { versions, made: Mutex::default(), turn: Mutex::default() }
    }

    /// Writes a file, whole or not at all; gives the hash of what lies there now.
    ///
    /// # Errors
    /// Another file lies under the name and there is no leave to replace it, what it was cannot be kept, the
    /// name leads elsewhere, or the disk refuses.
    pub fn save(
        &self,
        parts: &PartFolder,
        name: &str,
        bytes: &[u8],
        leave: &Leave,
    ) -> Result<String, Problem> {
        let _turn = lock(&self.turn);
        if let Some(present) = parts.present(name)? {
            if present == bytes {
                return Ok(hash(bytes));
            }
            if !leave.is_for(&present) {
                return Err(replaces(name, &present));
            }
            self.keep(parts, name)?;
        }
        parts.write(name, bytes)?;
        Ok(hash(bytes))
    }

    /// Keeps the content of a file that is about to be another, or none.
    fn keep(&self, parts: &PartFolder, name: &str) -> Result<(), Problem> {
        self.versions.keep(name, &parts.find(name)?).map_err(|error| {
            let text = format!(
                "{name} stays as it is: its present version cannot be kept in the data folder \
                 ({error}); make room there, or save under another name"
            );
            problem(files::why(&error), text)
        })
    }

    /// Moves a file into the bin: it is gone from the part folder, and what it was is kept as a version.
    ///
    /// # Errors
    /// Nothing lies under the name, there is no leave for what does, or as of [`Saves::save`].
    pub fn delete(&self, parts: &PartFolder, name: &str, leave: &Leave) -> Result<(), Problem> {
        let _turn = lock(&self.turn);
        let present = parts.read(name)?;
        if !leave.is_for(&present) {
            let text =
                format!("{name} is another file by now: look at it again before you delete it");
            return Err(problem(Why::Replaces, text));
        }
        self.keep(parts, name)?;
        parts.remove(name)
    }

    /// The files in the bin: those of which only earlier contents are left.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn bin(&self, parts: &PartFolder) -> Result<Vec<FileInfo>, Problem> {
        let names = self.versions.names().map_err(|error| unread("the bin", &error))?;
        let mut bin = Vec::new();
        for name in names {
            let last = self.versions(parts, &name)?.into_iter().next();
            if let (Some(last), None) = (last, parts.present(&name)?) {
                let FileVersion { changed, bytes, .. } = last;
                bin.push(FileInfo {
                    name,
                    folder: false,
                    bytes,
                    changed,
                    header: None,
                    part: true,
                    opens: None,
                });
            }
        }
        Ok(bin)
    }

    /// Takes a file out of the bin for good.
    ///
    /// # Errors
    /// It is not in the bin, or the disk refuses.
    pub fn forget(&self, parts: &PartFolder, name: &str) -> Result<(), Problem> {
        if parts.present(name)?.is_some() {
            return Err(problem(Why::File, format!("{name} is not in the bin")));
        }
        self.versions.forget(name).map_err(|error| unread(name, &error))
    }

    /// Writes the job of a drawing. One that was made before, and not touched since, is made anew; any other
    /// file is replaced only when somebody said so.
    ///
    /// # Errors
    /// As of [`Saves::save`].
    pub fn make(
        &self,
        parts: &PartFolder,
        name: &str,
        bytes: &[u8],
        anew: bool,
    ) -> Result<(), Problem> {
        let own = lock(&self.made).get(name).cloned();
        let leave = if anew { Leave::Anything } else { own.map_or(Leave::Nothing, Leave::Of) };
        let hash = self.save(parts, name, bytes, &leave)?;
        lock(&self.made).insert(name.into(), hash);
        Ok(())
    }

    /// The earlier contents of a file, the newest first.
    ///
    /// # Errors
    /// The name leads elsewhere, or the disk refuses.
    pub fn versions(&self, parts: &PartFolder, name: &str) -> Result<Vec<FileVersion>, Problem> {
        parts.present(name)?;
        let kept = self.versions.list(name).map_err(|error| unread(name, &error))?;
        let told = kept.into_iter().map(|kept| FileVersion {
            number: kept.number,
            changed: kept.changed,
            bytes: kept.bytes,
        });
        Ok(told.collect())
    }

    /// One of them.
    ///
    /// # Errors
    /// None has this number, or as of [`Saves::versions`].
    pub fn version(&self, parts: &PartFolder, name: &str, number: u32) -> Result<Vec<u8>, Problem> {
        parts.present(name)?;
        self.versions.read(name, number).map_err(|error| unread(name, &error))
    }

    /// Puts an earlier content in the file's place. That is a save as any other: what lies there is kept.
    ///
    /// # Errors
    /// As of [`Saves::version`] and [`Saves::save`].
    pub fn restore(&self, parts: &PartFolder, name: &str, number: u32) -> Result<String, Problem> {
        let bytes = self.version(parts, name, number)?;
        self.save(parts, name, &bytes, &Leave::Anything)
    }
}

/// Describes the file under a name.
///
/// # Errors
/// Nothing does, or it cannot be read.
pub fn about(parts: &PartFolder, name: &str) -> Result<FileAbout, Problem> {
    let bytes = parts.read(name)?;
    Ok(FileAbout {
        name: name.into(),
        what: what(name, &bytes),
        bytes: bytes.len() as u64,
        changed: parts.changed(name)?,
        hash: hash(&bytes),
    })
}

/// The sort of file, and how much of it: `a part program of 412 lines`.
fn what(name: &str, bytes: &[u8]) -> String {
    let lines = || match String::from_utf8_lossy(bytes).lines().count() {
        1 => "1 line".to_owned(),
        lines => format!("{lines} lines"),
    };
    let is_part = kerf_sbp::is_gcode_name(name) || kerf_workspace::parts::fits("*.sb?", name);
    match kind_of(name) {
        FileKind::Job => "a job: the tool paths of a drawing".into(),
        FileKind::Drawing => "a drawing".into(),
        FileKind::Program if is_part => format!("a part program of {}", lines()),
        FileKind::Program => format!("a file of {}", lines()),
    }
}

fn replaces(name: &str, present: &[u8]) -> Problem {
    let (what, length) = (what(name, present), present.len());
    let text = format!(
        "{name} is there already, {what}, {length} bytes: nothing was written. Choose another name, or \
         say that it may be replaced (over HTTP: If-Match with its hash, or ?replace=1)"
    );
    problem(Why::Replaces, text)
}

fn unread(name: &str, error: &std::io::Error) -> Problem {
    problem(Why::File, format!("versions of {name}: {error}"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(present: Option<&str>, leave: &Leave, saved: Result<&str, Why>) {
        let dir = tempfile::tempdir().unwrap();
        let (parts, saves) =
            (PartFolder::new(dir.path()).unwrap(), Saves::new(&dir.path().join("data")));
        if let Some(text) = present {
            parts.write("a.sbp", text.as_bytes()).unwrap();
        }
        let made = saves.save(&parts, "a.sbp", b"MX,2", leave).map_err(|problem| problem.why);
        assert_eq!(made, saved.map(|text| hash(text.as_bytes())), "{present:?} {leave:?}");
        let left = present.filter(|_| saved.is_err()).unwrap_or("MX,2");
        assert_eq!(parts.read("a.sbp").unwrap(), left.as_bytes());
        let kept = saves.versions(&parts, "a.sbp").unwrap().len();
        let replaced = saved.is_ok() && present.is_some_and(|text| text != "MX,2");
        assert_eq!(kept, usize::from(replaced), "{present:?} {leave:?}");
    }

    #[test]
    fn a_file_is_replaced_with_leave_only() {
        let of = |text: &str| Leave::Of(hash(text.as_bytes()));
        check(None, &Leave::Nothing, Ok("MX,2"));
        check(None, &of("MX,1"), Ok("MX,2"));
        check(Some("MX,1"), &Leave::Nothing, Err(Why::Replaces));
        check(Some("MX,1"), &of("MX,0"), Err(Why::Replaces));
        check(Some("MX,1"), &of("MX,1"), Ok("MX,2"));
        check(Some("MX,1"), &Leave::Anything, Ok("MX,2"));
        check(Some("MX,2"), &Leave::Nothing, Ok("MX,2"));
    }

    #[test]
    fn a_file_is_told_by_its_sort() {
        for (name, text, words) in [
            ("a.sbp", "MX,1\nMX,2\n", "a part program of 2 lines"),
            ("a.nc", "G0 X1\n", "a part program of 1 line"),
            ("a.rsm", "", "a job: the tool paths of a drawing"),
            ("a.dxf", "", "a drawing"),
            ("a.txt", "x\ny\nz", "a file of 3 lines"),
        ] {
            assert_eq!(what(name, text.as_bytes()), words);
        }
    }
}
