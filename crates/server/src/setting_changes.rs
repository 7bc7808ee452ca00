//! The changes of settings, kept in the data folder: when, which, from what to what, by whom.

use crate::locks::lock;
use kerf_wire::SettingChange;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// It lies under this name in the data folder: a line of JSON for each change, the newest last.
const FILE: &str = "setting-changes.jsonl";

/// Changes that are told; older ones stay in the file.
const TOLD: usize = 200;

/// The history of changes.
#[derive(Debug)]
pub struct SettingChanges {
    place: PathBuf,
    /// One line at a time.
    turn: Mutex<()>,
}

impl SettingChanges {
    /// The history that a data folder keeps.
    pub fn new(data: &Path) -> Self {
        Self { place: data.join(FILE), turn: Mutex::default() }
    }

    /// Adds a change that holds. Returns `false` where the disk refuses.
    pub fn add(&self, change: &SettingChange) -> bool {
        let _turn = lock(&self.turn);
        self.append(change).is_ok()
    }

    fn append(&self, change: &SettingChange) -> io::Result<()> {
        let mut line = serde_json::to_vec(change)?;
        line.push(b'\n');
        fs::create_dir_all(self.place.parent().unwrap_or(Path::new("")))?;
        OpenOptions::new().create(true).append(true).open(&self.place)?.write_all(&line)
    }

    /// Returns the last changes, the newest first. A line that was cut short is left out.
    ///
    /// # Errors
    /// The disk refuses to read.
    pub fn list(&self) -> io::Result<Vec<SettingChange>> {
        let _turn = lock(&self.turn);
        let text = match fs::read_to_string(&self.place) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
            read => read?,
        };
        let lines = text.lines().rev().take(TOLD);
        Ok(lines.filter_map(|line| serde_json::from_str(line).ok()).collect())
    }
}
