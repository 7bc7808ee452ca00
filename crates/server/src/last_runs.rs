//! The last run of each file, also of those before Kerf began: they are kept in the data folder.

use crate::digested::{checked, with_digest};
use kerf_files::{Disk, RealDisk};
use kerf_wire::LastRun;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

/// The most files that are remembered; the one whose run is the oldest goes first.
const MOST: usize = 1000;

/// They lie under this name in the data folder.
const FILE: &str = "ran";

/// Remembers how the last run of each file ended, by what the file was run by.
#[derive(Debug, Default)]
pub struct LastRuns {
    runs: Mutex<BTreeMap<String, LastRun>>,
    /// File in which they are kept; none in a hub of a test.
    file: OnceLock<PathBuf>,
}

impl LastRuns {
    /// Keeps them in a data folder from now on, and knows those that are kept there.
    ///
    /// # Errors
    /// They cannot be read: none is known then.
    pub fn keep_in(&self, data: &Path) -> io::Result<()> {
        let file = self.file.get_or_init(|| data.join(FILE));
        if !file.is_file() {
            return Ok(());
        }
        let known =
            RealDisk.read(file).and_then(|bytes| Ok(serde_json::from_slice(checked(&bytes)?)?));
        *self.runs.lock().unwrap_or_else(PoisonError::into_inner) = known?;
        Ok(())
    }

    /// Writes them to the disk.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn keep(&self) -> io::Result<()> {
        let Some(file) = self.file.get() else { return Ok(()) };
        let runs = self.runs.lock().unwrap_or_else(PoisonError::into_inner).clone();
        RealDisk.make_folder(file.parent().unwrap_or(Path::new("")))?;
        RealDisk.write(file, &with_digest(&serde_json::to_vec(&runs)?))
    }

    /// A run is over.
    pub fn put(&self, hash: &str, last: LastRun) {
        let mut runs = self.runs.lock().unwrap_or_else(PoisonError::into_inner);
        runs.insert(hash.to_owned(), last);
        if runs.len() > MOST {
            let oldest = runs.iter().min_by_key(|(_, last)| last.at);
            let oldest = oldest.map(|(hash, _)| hash.clone());
            oldest.map(|hash| runs.remove(&hash));
        }
    }

    /// The last run of a file.
    pub fn of(&self, hash: &str) -> Option<LastRun> {
        self.runs.lock().unwrap_or_else(PoisonError::into_inner).get(hash).cloned()
    }
}

/// The time of the world, seconds since 1970, as a person reads it beside a run: nothing is decided by it.
pub fn now_s() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_known_after_a_restart() {
        let data = tempfile::tempdir().unwrap();
        let (ran, last) =
            (LastRuns::default(), LastRun { ended: "ok".into(), at: 3, line: 2, seconds: 1.5 });
        ran.keep_in(data.path()).unwrap();
        ran.put("a", last.clone());
        ran.keep().unwrap();
        let again = LastRuns::default();
        again.keep_in(data.path()).unwrap();
        assert_eq!(again.of("a"), Some(last));
        std::fs::write(data.path().join(FILE), "{\"a\":").unwrap();
        assert!(LastRuns::default().keep_in(data.path()).is_err());
    }

    #[test]
    fn the_oldest_run_is_forgotten() {
        let ran = LastRuns::default();
        for n in 0..=MOST as u64 {
            ran.put(&format!("{n}"), LastRun { at: n + 1, ..LastRun::default() });
        }
        assert_eq!(ran.of("0"), None);
        assert_eq!(ran.of("1").map(|last| last.at), Some(2));
    }
}
