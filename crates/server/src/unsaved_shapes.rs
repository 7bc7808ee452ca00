//! Shapes that were digitized into the open job and are not saved, kept in the data folder: who ends the server, or
//! its computer, loses none of them. They are there again when the job is opened.

use crate::digested::{checked, with_digest};
use crate::hub::Hub;
use crate::open::Open;
use crate::part_files::PartFiles;
use crate::refusal::problem;
use kerf_files::{Disk, RealDisk};
use kerf_import::job_file;
use kerf_wire::{Problem, Tone, Why};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;

/// They lie under this name in the data folder.
const FILE: &str = "added.draft";

/// By the name of each job what it was before each shape, first as in its file, and last as it is with all of them.
type Added = BTreeMap<String, Vec<String>>;

/// Shapes that were digitized into jobs and are not saved.
pub struct UnsavedShapes {
    pub hub: Arc<Hub>,
    pub files: Arc<PartFiles>,
    /// The data folder.
    pub data: PathBuf,
}

impl UnsavedShapes {
    /// Tells of the jobs to which an earlier server had added shapes.
    pub fn tell(&self) {
        match self.read_added() {
            Ok(added) => added.keys().for_each(|name| {
                let text = format!(
                    "{name}: shapes were digitized into it that were not saved when Kerf ended; they are there again \
                     when it is opened"
                );
                self.hub.say(Tone::Note, text);
            }),
            Err(error) => {
                let (file, aside) = (self.added_file(), self.added_file().with_extension("unread"));
                let lies = fs::rename(&file, &aside).map_or(file, |()| aside);
                let text = format!("{}; they lie in {}", unread(&error), lies.display());
                self.hub.say(Tone::Warning, text);
            }
        }
    }

    /// Keeps what was added to the open job; nothing any more where all of it is saved or was taken back.
    pub fn keep(&self, open: &Open) {
        let states = open.unsaved.iter().chain([&open.bytes]);
        let texts = states.map(|bytes| String::from_utf8_lossy(bytes).into_owned());
        let stack = (!open.unsaved.is_empty()).then(|| texts.collect());
        if let Err(error) = self.write_added(&open.name, stack) {
            let text =
                format!("what is digitized into a job is only kept until Kerf ends: {error}");
            self.hub.say(Tone::Warning, text);
        }
    }

    /// A job that is opened has the shapes again that were added to it. Where its file is another by now, the job
    /// with them is put beside it.
    ///
    /// # Errors
    /// It cannot be put there.
    pub fn restore(&self, mut open: Open) -> Result<Open, Problem> {
        let added = self.read_added().map(|mut added| added.remove(&open.name));
        let mut stack = match added {
            Ok(Some(stack)) => stack,
            Ok(None) => return Ok(open),
            Err(error) => {
                self.hub.say(Tone::Warning, unread(&error));
                return Ok(open);
            }
        };
        let Some(last) = stack.pop() else { return Ok(open) };
        if stack.first().is_some_and(|first| *open.bytes == *first.as_bytes()) {
            open.unsaved = stack.into_iter().map(|text| text.into_bytes().into()).collect();
            open.bytes = last.into_bytes().into();
        } else {
            self.put_beside(&open.name, &last)?;
        }
        Ok(open)
    }

    fn put_beside(&self, name: &str, job: &str) -> Result<(), Problem> {
        let stem = name.strip_suffix(job_file::EXTENSION).unwrap_or(name).trim_end_matches('.');
        let numbered = |n: u32| match n {
            1 => format!("{stem}-digitized.{}", job_file::EXTENSION),
            n => format!("{stem}-digitized-{n}.{}", job_file::EXTENSION),
        };
        let free = (1..10_000).map(numbered).find(|name| self.files.folder.find(name).is_err());
        let free = free.ok_or_else(|| problem(Why::File, "there is no name for the job"))?;
        self.files.folder.write(&free, job.as_bytes())?;
        self.files.changed();
        let text = format!(
            "{name} was changed since shapes were digitized into it: the job with them is {free}"
        );
        self.hub.say(Tone::Warning, text);
        // It lies in its own file now; where the draft cannot be rewritten it is put there once more.
        drop(self.write_added(name, None));
        Ok(())
    }

    fn added_file(&self) -> PathBuf {
        self.data.join(FILE)
    }

    fn read_added(&self) -> io::Result<Added> {
        let file = self.added_file();
        if !file.is_file() {
            return Ok(Added::new());
        }
        Ok(serde_json::from_slice(checked(&RealDisk.read(&file)?)?)?)
    }

    fn write_added(&self, name: &str, stack: Option<Vec<String>>) -> io::Result<()> {
        let mut added = self.read_added()?;
        let before = match stack {
            Some(stack) => added.insert(name.into(), stack),
            None => added.remove(name),
        };
        match added.is_empty() {
            true if before.is_none() => Ok(()),
            true => fs::remove_file(self.added_file()),
            false => RealDisk.write(&self.added_file(), &with_digest(&serde_json::to_vec(&added)?)),
        }
    }
}

fn unread(error: &io::Error) -> String {
    format!("shapes that were digitized into jobs and not saved cannot be read: {error}")
}
