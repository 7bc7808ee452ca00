//! Text of the editor that is not saved, kept in the data folder: change of screen, reload and the end of the
//! server lose what was typed in the last half second.
//!
//! ```text
//!  a page keeps a draft ──► it kept one of this file before, or went on from the one there? ──► that one is replaced
//!                             └─ no: another page types into the file too ──────────────────► both are kept
//! ```

use crate::digested::{checked, hash, with_digest};
use crate::files::{self, PartFolder};
use crate::hub::Hub;
use crate::locks::lock;
use crate::refusal::problem;
use kerf_files::{Disk, RealDisk};
use kerf_wire::{Problem, TextDraft, Tone, Why};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Extension of the files of drafts.
const DRAFT: &str = "draft";

/// Extension of the texts that were typed into, where drafts tell only what was typed.
const BASE: &str = "base";

/// Extension of those that cannot be read.
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

    /// Keeps a draft in the place of the one that its page kept before, or went on from. Tells whether another page
    /// types into the same file.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn keep(&self, draft: &TextDraft, parts: &PartFolder) -> Result<bool, Problem> {
        let _turn = lock(&self.turn);
        if draft.edits.is_some() {
            self.keep_base(draft, parts)?;
        }
        let written = || {
            fs::create_dir_all(&self.folder)?;
            let (adopted, other): (Vec<_>, Vec<_>) = self
                .others_of(draft)?
                .into_iter()
                .partition(|(_, other)| revision(other) == draft.revision);
            let place = self.place(&draft.name, &draft.page);
            RealDisk.write(&place, &with_digest(&serde_json::to_vec(draft)?))?;
            // What a page went on from is in its own draft now.
            adopted.iter().try_for_each(|(file, _)| fs::remove_file(file))?;
            Ok(!other.is_empty())
        };
        written().map_err(|error: io::Error| {
            let text = format!("what is typed is not kept as a draft: {error}; save it");
            problem(files::why(&error), text)
        })
    }

    /// Ends the draft of a page: it was saved, or dropped. Those of other pages stay, and so does one that is another
    /// text by now than whoever ends it has seen.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn end(&self, name: &str, page: &str, seen: Option<&str>) -> Result<(), Problem> {
        let _turn = lock(&self.turn);
        let place = self.place(name, page);
        let is_seen = |seen| read(&place).is_ok_and(|draft| revision(&draft) == seen);
        if seen.is_some_and(|seen| !is_seen(seen)) {
            return Ok(());
        }
        let removed = match fs::remove_file(place) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => self.forget_bases(),
        };
        removed.map_err(|error| problem(Why::Server, format!("the draft of {name} stays: {error}")))
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
        self.files_of(DRAFT)
    }

    fn files_of(&self, extension: &str) -> io::Result<Vec<PathBuf>> {
        let entries = match fs::read_dir(&self.folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
            entries => entries?,
        };
        let files = entries.flatten().map(|entry| entry.path());
        Ok(files.filter(|file| file.extension().is_some_and(|it| it == extension)).collect())
    }

    /// Drafts of the same file that other pages keep.
    fn others_of(&self, draft: &TextDraft) -> io::Result<Vec<(PathBuf, TextDraft)>> {
        let read =
            self.files()?.into_iter().filter_map(|file| Some((file.clone(), read(&file).ok()?)));
        let of = |(_, other): &(PathBuf, TextDraft)| {
            other.name == draft.name && other.page != draft.page
        };
        Ok(read.filter(of).collect())
    }

    fn place(&self, name: &str, page: &str) -> PathBuf {
        // Those of before know no page.
        let of = if page.is_empty() { name.to_owned() } else { format!("{name}\n{page}") };
        self.folder.join(hash(of.as_bytes())).with_extension(DRAFT)
    }
}

impl Texts {
    /// Keeps the text that a draft was typed into, as it is in the part folder now.
    fn keep_base(
        &self,
        TextDraft { name, base, .. }: &TextDraft,
        parts: &PartFolder,
    ) -> Result<(), Problem> {
        let place = self.folder.join(base).with_extension(BASE);
        if base.is_empty() || self.bases().iter().any(|(hash, _)| hash == base) {
            return Ok(());
        }
        let bytes = parts.read(name)?;
        if hash(&bytes) != *base {
            let text = format!(
                "{name} was changed on the disk before anything was typed, and what is typed is not kept as a draft: \
                 save it under another name"
            );
            return Err(problem(Why::File, text));
        }
        let kept = fs::create_dir_all(&self.folder).and_then(|()| RealDisk.write(&place, &bytes));
        kept.map_err(|error| {
            let text =
                format!("what is typed into {name} is not kept as a draft: {error}; save it");
            problem(files::why(&error), text)
        })
    }

    /// A text that was typed into, as it was then.
    ///
    /// # Errors
    /// None is kept that has this hash, or the disk refuses.
    pub fn base(&self, hash: &str) -> Result<Vec<u8>, Problem> {
        let _turn = lock(&self.turn);
        let file = self.bases().into_iter().find(|(own, _)| own == hash).map(|(_, file)| file);
        let none = || problem(Why::File, "no text with this hash was typed into");
        let read = fs::read(file.ok_or_else(none)?);
        read.map_err(|error| problem(Why::Server, format!("the text that was typed into: {error}")))
    }

    /// The texts that were typed into, by their hashes.
    fn bases(&self) -> Vec<(String, PathBuf)> {
        let files = self.files_of(BASE).unwrap_or_default().into_iter();
        let named = |file: PathBuf| Some((file.file_stem()?.to_str()?.to_owned(), file));
        files.filter_map(named).collect()
    }

    /// Takes those away that no draft is of any more.
    fn forget_bases(&self) -> io::Result<()> {
        let drafts: Vec<_> = self.files()?.iter().filter_map(|file| read(file).ok()).collect();
        let is_over =
            |(hash, _): &(String, PathBuf)| drafts.iter().all(|draft| draft.base != *hash);
        self.bases().into_iter().filter(is_over).try_for_each(|(_, file)| fs::remove_file(file))
    }
}

/// Tells of drafts that cannot be read.
pub fn tell_unread(texts: &Texts, hub: &Hub) {
    let told = match texts.put_aside() {
        Ok(aside) => aside.iter().map(|file| format!("it lies in {}", file.display())).collect(),
        Err(error) => vec![error.to_string()],
    };
    for why in told {
        let text = format!("text of the editor that was not saved cannot be read: {why}");
        hub.say(Tone::Warning, text);
    }
}

fn read(file: &Path) -> io::Result<TextDraft> {
    Ok(serde_json::from_slice(checked(&RealDisk.read(file)?)?)?)
}

/// A draft that knows whether its file is another by now.
fn compared(draft: TextDraft, parts: &PartFolder) -> TextDraft {
    let present = parts.present(&draft.name).ok().flatten().map(|bytes| hash(&bytes));
    let changed_on_disk = !draft.name.is_empty() && present.unwrap_or_default() != draft.base;
    TextDraft { changed_on_disk, revision: revision(&draft), ..draft }
}

/// Which text a draft is.
fn revision(TextDraft { text, edits, .. }: &TextDraft) -> String {
    let told = edits.as_ref().and_then(|edits| serde_json::to_string(edits).ok());
    hash(told.as_ref().unwrap_or(text).as_bytes())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_wire::TextEdit;

    struct Fixture {
        dir: tempfile::TempDir,
        parts: PartFolder,
        texts: Texts,
    }

    fn desk() -> Fixture {
        let dir = tempfile::tempdir().unwrap();
        let parts = PartFolder::new(dir.path()).unwrap();
        let texts = Texts::new(&dir.path().join("data"));
        Fixture { dir, parts, texts }
    }

    fn draft(name: &str, text: &str, of: &str) -> TextDraft {
        TextDraft {
            name: name.into(),
            text: text.into(),
            edits: None,
            ends: "\n".into(),
            base: hash(of.as_bytes()),
            changed_on_disk: false,
            page: String::new(),
            revision: String::new(),
        }
    }

    /// Keeps what a page types into a file, having seen a text of it.
    fn typed(Fixture { texts, parts, .. }: &Fixture, page: &str, text: &str, seen: &str) -> bool {
        let seen = if seen.is_empty() { String::new() } else { hash(seen.as_bytes()) };
        let typed = TextDraft { page: page.into(), revision: seen, ..draft("a.sbp", text, "") };
        texts.keep(&typed, parts).unwrap()
    }

    #[test]
    fn two_pages_that_type_into_one_file_lose_nothing() {
        let desk = &desk();
        let Fixture { parts, texts, .. } = desk;
        let kept = || {
            let mut all: Vec<_> =
                texts.list(parts).unwrap().into_iter().map(|draft| draft.text).collect();
            all.sort();
            all
        };
        assert!(!typed(desk, "1", "MX,1", ""));
        assert!(!typed(desk, "1", "MX,12", ""), "its own is replaced");
        assert!(typed(desk, "2", "MY,1", ""), "another page types too");
        assert!(typed(desk, "1", "MX,123", "") && typed(desk, "2", "MY,12", ""));
        assert_eq!(kept(), ["MX,123", "MY,12"]);
        texts.end("a.sbp", "2", Some(&hash(b"MY,1"))).unwrap();
        assert_eq!(kept().len(), 2, "it is another text by now");
        texts.end("a.sbp", "1", Some(&hash(b"MX,123"))).unwrap();
        assert_eq!(kept(), ["MY,12"]);
        assert!(!typed(desk, "3", "MY,123", "MY,12"), "it went on from the one there");
        assert_eq!(kept(), ["MY,123"]);
    }

    #[test]
    fn each_file_has_its_own_draft_and_the_last_text_stays() {
        let Fixture { parts, texts, .. } = &desk();
        for (name, text) in [("a.sbp", "MX"), ("b.sbp", "MY,1"), ("a.sbp", "MX,1")] {
            texts.keep(&draft(name, text, ""), parts).unwrap();
        }
        let mut kept: Vec<_> =
            texts.list(parts).unwrap().into_iter().map(|d| (d.name, d.text)).collect();
        kept.sort();
        assert_eq!(kept, [("a.sbp", "MX,1"), ("b.sbp", "MY,1")].map(|(n, t)| (n.into(), t.into())));
        texts.end("a.sbp", "", None).unwrap();
        texts.end("a.sbp", "", None).unwrap();
        assert_eq!(texts.list(parts).unwrap().len(), 1);
    }

    #[test]
    fn a_draft_says_that_its_file_was_changed() {
        let Fixture { parts, texts, .. } = &desk();
        parts.write("a.sbp", b"MX,1").unwrap();
        texts.keep(&draft("a.sbp", "MX,1\nMX,2", "MX,1"), parts).unwrap();
        let changed = || texts.list(parts).unwrap()[0].changed_on_disk;
        assert!(!changed());
        parts.write("a.sbp", b"MY,7").unwrap();
        assert!(changed());
    }

    #[test]
    fn what_was_typed_into_a_long_text_is_kept_with_the_text_it_was_then() {
        let Fixture { parts, texts, .. } = &desk();
        let long = |of: &str| TextDraft {
            edits: Some(vec![TextEdit { line: 1, count: 1, lines: vec!["MX,2".into()] }]),
            ..draft("a.sbp", "", of)
        };
        parts.write("a.sbp", b"MX,1").unwrap();
        assert!(texts.keep(&long("MX,0"), parts).is_err(), "that is not what lies there");
        texts.keep(&long("MX,1"), parts).unwrap();
        parts.write("a.sbp", b"MY,7").unwrap();
        texts.keep(&long("MX,1"), parts).unwrap();
        let listed = texts.list(parts).unwrap().remove(0);
        assert!(listed.changed_on_disk && listed.edits.is_some());
        assert_eq!(texts.base(&listed.base).unwrap(), b"MX,1");
        assert!(texts.base("../../a.sbp").is_err());
        texts.end("a.sbp", "", Some(&listed.revision)).unwrap();
        assert!(texts.base(&listed.base).is_err(), "nobody needs it any more");
    }

    #[test]
    fn a_damaged_draft_is_put_aside_and_told() {
        let Fixture { dir, parts, texts } = &desk();
        texts.keep(&draft("a.sbp", "MX,1", ""), parts).unwrap();
        fs::write(dir.path().join("data/texts/torn.draft"), "{\"name\":\"b.s").unwrap();
        let aside = texts.put_aside().unwrap();
        assert_eq!(aside, [dir.path().join("data/texts/torn.unread")]);
        assert_eq!(texts.list(parts).unwrap().len(), 1);
    }
}
