//! The part folder as pages write into it: contents that are replaced are kept, and pages are told.

use crate::files::PartFolder;
use crate::hub::Hub;
use crate::saving::{Leave, Saves};
use kerf_wire::{Change, Problem};
use std::sync::Arc;

/// The part folder, and how files of it are written.
pub struct PartFiles {
    /// The folder.
    pub folder: PartFolder,
    /// Writes its files.
    pub saves: Saves,
    /// Told of changes.
    pub hub: Arc<Hub>,
}

impl PartFiles {
    /// Writes a file of the part folder, and tells pages; gives the hash of what lies there now.
    ///
    /// # Errors
    /// As of [`Saves::save`].
    pub fn save(&self, name: &str, bytes: &[u8], leave: &Leave) -> Result<String, Problem> {
        let saved = self.saves.save(&self.folder, name, bytes, leave)?;
        self.changed();
        Ok(saved)
    }

    /// Files of the part folder may have changed.
    pub fn changed(&self) {
        self.hub.changing(|now| vec![Change::Files { files: now.files + 1 }]);
    }
}
