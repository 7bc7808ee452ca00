//! The lines of files that diagnostics point to. In drawings and jobs they are shapes.

use crate::drawings;
use kerf_diag::Sources;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Reads files when a line of them is first shown.
#[derive(Debug, Default)]
pub struct FileLines(RefCell<BTreeMap<String, Vec<String>>>);

impl Sources for FileLines {
    fn line(&self, file: &str, line: u32) -> Option<String> {
        if drawings::is_drawing(Path::new(file)) {
            return Some(format!("shape {line}"));
        }
        let mut files = self.0.borrow_mut();
        let lines = files.entry(file.to_owned()).or_insert_with(|| read_lines(file));
        lines.get(line.checked_sub(1)? as usize).cloned()
    }
}

fn read_lines(file: &str) -> Vec<String> {
    let bytes = fs::read(file).unwrap_or_default();
    let text = kerf_diag::decode(bytes.as_slice().into())
        .unwrap_or_else(|_| String::from_utf8_lossy(&bytes).into_owned());
    text.replace("\r\n", "\n").replace('\r', "\n").lines().map(str::to_owned).collect()
}
