//! The files that a program has opened.

use crate::syntax::Value;
use kerf_program::FileMode;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Open files by number, from 1.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct UserFiles([Option<UserFile>; 9]);

/// A file of the user that is open.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct UserFile {
    pub(crate) path: Arc<str>,
    pub(crate) mode: FileMode,
    /// Fields of the last line read that were not taken yet.
    pub(crate) fields: Vec<Value>,
}

impl UserFiles {
    /// The file that is open under a number.
    pub(crate) fn get(&self, number: u8) -> Option<&UserFile> {
        self.0.get(usize::from(number).checked_sub(1)?)?.as_ref()
    }

    /// The same, to be changed.
    pub(crate) fn get_mut(&mut self, number: u8) -> Option<&mut UserFile> {
        self.0.get_mut(usize::from(number).checked_sub(1)?)?.as_mut()
    }

    /// Opens a file under a number from 1 to 9.
    pub(crate) fn put(&mut self, number: u8, file: UserFile) {
        if let Some(place) = self.0.get_mut(usize::from(number).wrapping_sub(1)) {
            *place = Some(file);
        }
    }

    /// Takes a file out that is no longer open.
    pub(crate) fn take(&mut self, number: u8) -> Option<UserFile> {
        self.0.get_mut(usize::from(number).checked_sub(1)?)?.take()
    }
}
