//! The server that has the machine of a data folder, and where it is reached.
//!
//! A file is locked as long as the server lives: a killed one leaves nothing behind that would have to be cleared.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

const LOCK: &str = "served.lock";
/// The address stands in a file of its own: one that is locked cannot be read everywhere.
const ADDRESS: &str = "served-at.txt";

/// Number of tries to lock: a process that looks whether there is a server holds the lock for a moment.
const LOOKS: u32 = 20;
const MOMENT: Duration = Duration::from_millis(10);

/// The mark of a running server.
pub struct Served {
    _lock: File,
}

impl Served {
    /// Marks a folder as that of the server at an address; nothing where another server has it already.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn begin(folder: &Path, address: &str) -> io::Result<Option<Self>> {
        fs::create_dir_all(folder)?;
        let lock = File::options().create(true).append(true).open(folder.join(LOCK))?;
        for _ in 0..LOOKS {
            match lock.try_lock() {
                Ok(()) => {
                    fs::write(folder.join(ADDRESS), address)?;
                    return Ok(Some(Self { _lock: lock }));
                }
                Err(TryLockError::WouldBlock) => sleep(MOMENT),
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
        Ok(None)
    }
}

/// The address of the server that has the machine of a folder; nothing where none runs.
///
/// # Errors
/// The folder cannot be read.
pub fn address(folder: &Path) -> io::Result<Option<String>> {
    let lock = match File::open(folder.join(LOCK)) {
        Ok(lock) => lock,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    };
    match lock.try_lock_shared() {
        Ok(()) => Ok(None),
        Err(TryLockError::WouldBlock) => fs::read_to_string(folder.join(ADDRESS)).map(Some),
        Err(TryLockError::Error(error)) => Err(error),
    }
}
