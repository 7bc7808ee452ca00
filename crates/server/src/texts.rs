//! Text of the editor that is not saved, kept in the data folder: change of screen, reload and the end of the
//! server lose what was typed in the last half second. A file a draft, so that two are never mixed.

use crate::app::{App, hash, lock, problem};
use crate::files::PartFolder;
use kerf_control::files::{Disk, RealDisk};
use kerf_wire::{Problem, TextDraft, Tone, Why};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// What the files of drafts end with.
const DRAFT: &str = "draft";

/// What those end with that cannot be read.
const UNREAD: &str = "unread";

/// The drafts of the editor.
#[derive(Debug)]
pub struct Texts {
    folder: PathBuf,
    /// One at a time: what was typed last is what stays.
    turn: Mutex<()>,
}

impl Texts {
    /// Those that a data folder keeps.
    pub fn new(data: &Path) -> Self {
        Self { folder: data.join("texts"), turn: Mutex::default() }
    }

    /// Keeps a draft in the place of an earlier one of the same file.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn keep(&self, draft: &TextDraft) -> Result<(), Problem> {
        let _turn = lock(&self.turn);
        let written = || {
            fs::create_dir_all(&self.folder)?;
            RealDisk.write(&self.place(&draft.name), &serde_json::to_vec(draft)?)
        };
        written().map_err(|error: io::Error| {
            let text = format!("what is typed is not kept as a draft: {error}; save it");
            problem(Why::Server, text)
        })
    }

    /// Ends a draft: it was saved, or dropped.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn end(&self, name: &str) -> Result<(), Problem> {
        let _turn = lock(&self.turn);
        match fs::remove_file(self.place(name)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                Err(problem(Why::Server, format!("the draft of {name} stays: {error}")))
            }
            _ => Ok(()),
        }
    }

    /// Every draft, the newest first, each with what became of its file meanwhile.
    ///
    /// # Errors
    /// The folder cannot be read.
    pub fn list(&self, parts: &PartFolder) -> Result<Vec<TextDraft>, Problem> {
        let _turn = lock(&self.turn);
        let failed = |error: io::Error| problem(Why::Server, format!("drafts: {error}"));
        let mut drafts: Vec<_> = self.files().map_err(failed)?;
        drafts.sort_by_key(|file| fs::metadata(file).and_then(|about| about.modified()).ok());
        // What cannot be read was told and put aside when the server began.
        let read = drafts.iter().rev().filter_map(|file| read(file).ok());
        Ok(read.map(|draft| compared(draft, parts)).collect())
    }

    /// Puts those aside that cannot be read; gives where they lie.
    fn put_aside(&self) -> io::Result<Vec<PathBuf>> {
        let damaged = self.files()?.into_iter().filter(|file| read(file).is_err());
        let moved = |file: PathBuf| {
            let aside = file.with_extension(UNREAD);
            fs::rename(&file, &aside).map(|()| aside)
        };
        damaged.map(moved).collect()
    }

    fn files(&self) -> io::Result<Vec<PathBuf>> {
        let entries = match fs::read_dir(&self.folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
            entries => entries?,
        };
        let files = entries.flatten().map(|entry| entry.path());
        Ok(files.filter(|file| file.extension().is_some_and(|it| it == DRAFT)).collect())
    }

    fn place(&self, name: &str) -> PathBuf {
        self.folder.join(hash(name.as_bytes())).with_extension(DRAFT)
    }
}

impl App {
    /// Tells of drafts that cannot be read.
    pub fn tell_texts(&self) {
        let told = match self.texts.put_aside() {
            Ok(aside) => {
                aside.iter().map(|file| format!("it lies in {}", file.display())).collect()
            }
            Err(error) => vec![error.to_string()],
        };
        for why in told {
            let text = format!("text of the editor that was not saved cannot be read: {why}");
            self.hub.say(Tone::Warning, text);
        }
    }
}

fn read(file: &Path) -> io::Result<TextDraft> {
    Ok(serde_json::from_slice(&RealDisk.read(file)?)?)
}

/// A draft that knows whether its file is another by now.
fn compared(draft: TextDraft, parts: &PartFolder) -> TextDraft {
    let present = parts.present(&draft.name).ok().flatten().map(|bytes| hash(&bytes));
    let changed_on_disk = !draft.name.is_empty() && present.unwrap_or_default() != draft.base;
    TextDraft { changed_on_disk, ..draft }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    struct Desk {
        dir: tempfile::TempDir,
        parts: PartFolder,
        texts: Texts,
    }

    fn desk() -> Desk {
        let dir = tempfile::tempdir().unwrap();
        let parts = PartFolder::new(dir.path()).unwrap();
        let texts = Texts::new(&dir.path().join("data"));
        Desk { dir, parts, texts }
    }

    fn draft(name: &str, text: &str, of: &str) -> TextDraft {
        TextDraft {
            name: name.into(),
            text: text.into(),
            ends: "\n".into(),
            base: hash(of.as_bytes()),
            changed_on_disk: false,
        }
    }

    #[test]
    fn each_file_has_its_own_draft_and_the_last_text_stays() {
        let Desk { parts, texts, .. } = &desk();
        for (name, text) in [("a.sbp", "MX"), ("b.sbp", "MY,1"), ("a.sbp", "MX,1")] {
            texts.keep(&draft(name, text, "")).unwrap();
        }
        let mut kept: Vec<_> =
            texts.list(parts).unwrap().into_iter().map(|d| (d.name, d.text)).collect();
        kept.sort();
        assert_eq!(kept, [("a.sbp", "MX,1"), ("b.sbp", "MY,1")].map(|(n, t)| (n.into(), t.into())));
        texts.end("a.sbp").unwrap();
        texts.end("a.sbp").unwrap();
        assert_eq!(texts.list(parts).unwrap().len(), 1);
    }

    #[test]
    fn a_draft_says_that_its_file_was_changed() {
        let Desk { parts, texts, .. } = &desk();
        parts.write("a.sbp", b"MX,1").unwrap();
        texts.keep(&draft("a.sbp", "MX,1\nMX,2", "MX,1")).unwrap();
        let changed = || texts.list(parts).unwrap()[0].changed_on_disk;
        assert!(!changed());
        parts.write("a.sbp", b"MY,7").unwrap();
        assert!(changed());
    }

    #[test]
    fn a_damaged_draft_is_put_aside_and_told() {
        let Desk { dir, parts, texts } = &desk();
        texts.keep(&draft("a.sbp", "MX,1", "")).unwrap();
        fs::write(dir.path().join("data/texts/torn.draft"), "{\"name\":\"b.s").unwrap();
        let aside = texts.put_aside().unwrap();
        assert_eq!(aside, [dir.path().join("data/texts/torn.unread")]);
        assert_eq!(texts.list(parts).unwrap().len(), 1);
    }
}
