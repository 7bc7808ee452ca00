//! Ownership of the machine: one process has it, by the lock of a file.

use super::store::Store;
use super::{JournalError, Memory};
use std::fs::{File, TryLockError};
use std::path::Path;
use std::sync::Arc;

/// Name of the file that is locked by the process that owns the machine.
const OWNER_FILE: &str = "owner.lock";

/// The right to move the machine; ends with the value, or with the process.
#[derive(Debug)]
pub struct Owner {
    store: Arc<Store>,
    memory: Memory,
    _lock: File,
}

impl Owner {
    /// Takes the machine of a journal.
    pub(super) fn new(store: Arc<Store>, memory: Memory) -> Result<Self, JournalError> {
        let path = store.folder().join(OWNER_FILE);
        let file = File::options().create(true).append(true).open(&path);
        let file = file.map_err(|error| JournalError::of_disk(&path, &error))?;
        match file.try_lock() {
            Ok(()) => Ok(Self { store, memory, _lock: file }),
            Err(TryLockError::WouldBlock) => {
                Err(JournalError::Owned { folder: store.folder().to_path_buf() })
            }
            Err(TryLockError::Error(error)) => Err(JournalError::of_disk(&path, &error)),
        }
    }
}

impl Drop for Owner {
    fn drop(&mut self) {
        self.memory.has_seen();
        // What cannot be put into the file itself now is in the one beside it.
        drop(self.store.rest());
    }
}

/// Tells whether a process has the machine of a data folder.
pub(super) fn is_owned(folder: &Path) -> bool {
    let file = File::open(folder.join(OWNER_FILE));
    file.is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
}
