//! Hashes of traces, recorded before a change of the code and compared after it.
//!
//! A rebuilding that is to change no behaviour changes no trace. `make traces` records the hash of each trace in
//! `target/traces` the first time, and compares with it from then on.

use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::{env, fs};

/// Hashes of traces by the name of what ran.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Traces(BTreeMap<String, String>);

/// The folder that KERF_TRACES names, where hashes are recorded; nothing without it.
pub fn folder() -> Option<PathBuf> {
    let folder = env::var_os("KERF_TRACES").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped: KERF_TRACES names no folder of recorded traces");
    }
    folder
}

impl Traces {
    /// Adds the trace of a run, given as its lines.
    pub fn add(&mut self, name: &str, lines: impl IntoIterator<Item = impl AsRef<str>>) {
        let mut hash = Sha256::new();
        for line in lines {
            hash.update(line.as_ref());
            hash.update("\n");
        }
        let digits = hash.finalize().iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        });
        self.0.insert(name.to_owned(), digits);
    }

    /// Reads lines of a hash and a name.
    fn read(text: &str) -> Self {
        let pair = |line: &str| line.split_once(' ').map(|(hash, name)| (name.into(), hash.into()));
        Self(text.lines().filter_map(pair).collect())
    }

    fn print(&self) -> String {
        self.0.iter().map(|(name, hash)| format!("{hash} {name}\n")).collect()
    }

    /// The names of what has another trace than the recorded one, or is on one side only.
    fn differing(&self, recorded: &Self) -> Vec<String> {
        let names = self.0.keys().chain(recorded.0.keys());
        let mut differ: Vec<String> =
            names.filter(|name| self.0.get(*name) != recorded.0.get(*name)).cloned().collect();
        differ.sort();
        differ.dedup();
        differ
    }

    /// Records them in a file of the folder, or compares with what was recorded there.
    ///
    /// # Panics
    /// Some differ, which are named; or the disk refuses.
    #[track_caller]
    pub fn hold(&self, file: &str) {
        let Some(folder) = folder() else { return };
        let path = folder.join(file);
        let Ok(recorded) = fs::read_to_string(&path) else {
            fs::create_dir_all(&folder).unwrap();
            fs::write(&path, self.print()).unwrap();
            println!("recorded {} traces in {}", self.0.len(), path.display());
            return;
        };
        let differ = self.differing(&Self::read(&recorded));
        assert!(
            differ.is_empty(),
            "{} of {} traces differ: {differ:?}",
            differ.len(),
            self.0.len()
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn traces(runs: &[(&str, &str)]) -> Traces {
        let mut traces = Traces::default();
        runs.iter().for_each(|(name, trace)| traces.add(name, trace.lines()));
        traces
    }

    #[test]
    fn what_is_recorded_is_read_again() {
        let some = traces(&[("a b", "x\ny"), ("c", "")]);
        assert_eq!(Traces::read(&some.print()), some);
        assert!(some.differing(&some).is_empty());
    }

    #[test]
    fn another_trace_and_one_that_is_missing_are_named() {
        let (one, other) = (traces(&[("a", "x"), ("b", "y")]), traces(&[("a", "x\n"), ("c", "z")]));
        assert_eq!(one.differing(&other), ["b", "c"]);
        assert_eq!(traces(&[("a", "x y")]).differing(&traces(&[("a", "x\ny")])), ["a"]);
    }
}
