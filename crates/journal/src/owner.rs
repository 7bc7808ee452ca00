//! Ownership of the machine: one process has it, by the lock of a file.

use super::store::Store;
use super::{JournalError, Memory};
use std::fs::{File, TryLockError};
use std::path::Path;
use std::sync::Arc;
use std::thread::sleep;
use std::time::Duration;

/// Name of the file that is locked by the process that owns the machine.
const OWNER_FILE: &str = "owner.lock";

/// The lock is tried so often, with this pause: somebody who only looks at it holds it for an instant, and so may a program that is
/// just being started.
const TRIES: u32 = 40;
const PAUSE: Duration = Duration::from_millis(5);

/// The right to move the machine; ends with the value, or with the process.
#[derive(Debug)]
pub struct Owner {
    store: Arc<Store>,
    memory: Memory,
    lock: File,
}

impl Owner {
    /// Takes the machine of a journal.
    pub(super) fn new(store: Arc<Store>, memory: Memory) -> Result<Self, JournalError> {
        let path = store.folder().join(OWNER_FILE);
        let file = File::options().create(true).append(true).open(&path);
        let file = file.map_err(|error| JournalError::of_disk(&path, &error))?;
        match locked(&file) {
            Ok(()) => Ok(Self { store, memory, lock: file }),
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
        // Closing it is not enough: a program that is just being started has it open, too.
        drop(self.lock.unlock());
    }
}

/// Locks a file that nobody has for longer than an instant.
fn locked(file: &File) -> Result<(), TryLockError> {
    for _ in 1..TRIES {
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => sleep(PAUSE),
            other => return other,
        }
    }
    file.try_lock()
}

/// Tells whether a process has the machine of a data folder.
pub(super) fn is_owned(folder: &Path) -> bool {
    let file = File::open(folder.join(OWNER_FILE));
    file.is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Journal;

    #[test]
    fn whoever_looks_whether_the_machine_is_taken_is_waited_for() {
        let dir = tempfile::tempdir().expect("a folder");
        let journal = Journal::open(dir.path()).expect("a journal").0;
        drop(journal.own().expect("nobody has it"));
        let looks = File::open(dir.path().join(OWNER_FILE)).expect("the file");
        looks.try_lock().expect("nobody has it");
        std::thread::scope(|scope| {
            scope.spawn(move || {
                sleep(Duration::from_millis(30));
                drop(looks);
            });
            assert!(journal.own().is_ok());
        });
    }

    #[test]
    fn two_do_not_own_one_machine() {
        let dir = tempfile::tempdir().expect("a folder");
        let [one, other] = [(); 2].map(|()| Journal::open(dir.path()).expect("a journal").0);
        let owner = one.own().expect("nobody has it");
        assert!(matches!(other.own(), Err(JournalError::Owned { .. })));
        drop(owner);
        assert!(other.own().is_ok());
    }
}
