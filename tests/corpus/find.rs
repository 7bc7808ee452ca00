//! The search for part files and drawings that tests read: the project's own beside this file, and real ones where they
//! are at hand.
//!
//! Real files are no part of the project: they are in the folder `corpus` of [`shared`]. A test that lacks them says that
//! it was skipped.

#![allow(dead_code, clippy::unwrap_used, clippy::print_stdout)]

#[path = "shared.rs"]
mod shared;

use std::path::{Path, PathBuf};

/// The folder of real files of a kind (`sbp`, `gcode`, `dxf`), if it is at hand; says so if not.
pub fn real(kind: &str) -> Option<PathBuf> {
    let found = shared::shared(&format!("corpus/{kind}"));
    if found.is_none() {
        println!("skipped: no real files of kind {kind}");
    }
    found
}

/// The folder of the project's own files of a kind (`sbp`, `gcode`, `dxf`, `svg`).
pub fn own(kind: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus").join(kind)
}

/// The files of a folder, by name.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    // Answers stand beside the part file that asks, and a run by hand leaves its log there.
    let beside = |file: &Path| file.extension().is_some_and(|e| e == "answers" || e == "log");
    files.retain(|file| file.is_file() && !beside(file));
    files.sort();
    files
}

/// The project's own files of a kind, then the real ones.
pub fn all(kind: &str) -> Vec<PathBuf> {
    let real = real(kind).map(|folder| files(&folder)).unwrap_or_default();
    files(&own(kind)).into_iter().chain(real).collect()
}
