//! The file that is open, and the hash by which it is run.

use crate::digested::hash;
use crate::preview::{Called, Preview};
use kerf_wire::{FileParameters, JobChoice};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The file that is open.
#[derive(Clone, Default)]
pub struct Open {
    /// Its name; empty when none is.
    pub name: String,
    /// Its bytes, as they were previewed.
    pub bytes: Arc<[u8]>,
    /// Its bytes before each shape that was added since the job was saved: first as in the file.
    pub unsaved: Vec<Arc<[u8]>>,
    /// Hash by which it is run: that of its name and bytes, of the parameters, and of the files they call as soon as
    /// the preview knows them.
    pub hash: String,
    /// Parameters with which it is run.
    pub parameters: FileParameters,
    /// Choices with which it is cut, when it is a job.
    pub choice: JobChoice,
    /// Key of the preview.
    pub key: String,
    /// The preview, when it is ready.
    pub preview: Option<Arc<Preview>>,
    /// The run of a typed line that it runs in.
    pub run: Option<u32>,
    /// Ends the making of the preview.
    pub given_up: Arc<AtomicBool>,
}

impl Open {
    /// Returns `true` if these are still the bytes of its file.
    pub fn is_of(&self, bytes: &[u8]) -> bool {
        **self.unsaved.first().unwrap_or(&self.bytes) == *bytes
    }

    /// Returns the hash by which it would be run under a name.
    pub fn hash_as(&self, name: &str) -> String {
        let own = hash_of(name, &self.bytes, &self.parameters, &self.choice);
        match &self.preview {
            Some(preview) => job_hash(own, &preview.called),
            None => own,
        }
    }
}

/// Returns the hash by which a file is run: that of its name and bytes, and of parameters or choices other than the
/// usual. Two files with the same text are two files: how one ran is not how the other stands.
pub fn hash_of(
    name: &str,
    bytes: &[u8],
    parameters: &FileParameters,
    choice: &JobChoice,
) -> String {
    let told = if *choice != JobChoice::default() {
        let JobChoice { start, offset, origin, finish, lift } = choice;
        format!("{start:?} {offset} {origin:?} {finish:?} {lift}")
    } else if *parameters != FileParameters::default() {
        let FileParameters { proportion, repetitions, offset, plunge, tabs, plunge_from_zero } =
            parameters;
        format!("{proportion:?} {repetitions} {offset} {plunge} {tabs} {plunge_from_zero}")
    } else {
        String::new()
    };
    hash(&[name.as_bytes(), b"\n", told.as_bytes(), b"\n", bytes].concat())
}

/// Returns the hash by which a file is run: its own, or that of the hashes of all files when it calls others.
fn job_hash(own: String, called: &Called) -> String {
    if called.is_empty() {
        return own;
    }
    let one =
        |(path, bytes): (&PathBuf, &Arc<[u8]>)| format!("{}\n{}\n", path.display(), hash(bytes));
    hash((own + &called.iter().map(one).collect::<String>()).as_bytes())
}
