//! The last run of each file since Kerf began.

use kerf_wire::LastRun;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

/// So many files are remembered; the one whose run is the oldest goes first.
const MOST: usize = 1000;

/// Remembers how the last run of each file ended, by what the file was run by.
#[derive(Debug, Default)]
pub struct Ran(Mutex<BTreeMap<String, LastRun>>);

impl Ran {
    /// A run is over.
    pub fn put(&self, hash: &str, last: LastRun) {
        let mut runs = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        runs.insert(hash.to_owned(), last);
        if runs.len() > MOST {
            let oldest = runs.iter().min_by_key(|(_, last)| last.at);
            let oldest = oldest.map(|(hash, _)| hash.clone());
            oldest.map(|hash| runs.remove(&hash));
        }
    }

    /// The last run of a file.
    pub fn of(&self, hash: &str) -> Option<LastRun> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).get(hash).cloned()
    }
}

/// The time of the world, seconds since 1970, as a person reads it beside a run: nothing is decided by it.
pub fn now_s() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_run_is_forgotten() {
        let ran = Ran::default();
        for n in 0..=MOST as u64 {
            ran.put(&format!("{n}"), LastRun { at: n + 1, ..LastRun::default() });
        }
        assert_eq!(ran.of("0"), None);
        assert_eq!(ran.of("1").map(|last| last.at), Some(2));
    }
}
