//! The lines of files that diagnostics point to. In drawings and jobs they are shapes.

use kerf_diag::Sources;
use kerf_formats::is_drawing;
use kerf_journal::Work;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// Reads files when a line of them is first shown.
#[derive(Debug, Default)]
pub struct FileLines {
    seen: RefCell<BTreeMap<String, Vec<String>>>,
    /// The name and the text of what runs: a file of that name may say something else.
    runs: Option<(Arc<str>, Arc<String>)>,
}

impl FileLines {
    /// Those of what runs, and of every file.
    pub fn of(work: &Work) -> Self {
        let program = match work {
            Work::Part(program) => Some(&program.sbp),
            Work::Job(..) | Work::Hand(..) => None,
        };
        let runs = program.map(|it| (it.name.clone(), it.text.clone()));
        Self { runs, ..Self::default() }
    }

    fn lines(&self, file: &str) -> Vec<String> {
        match &self.runs {
            Some((name, text)) if **name == *file => split(text),
            _ => read_lines(file),
        }
    }
}

impl Sources for FileLines {
    fn line(&self, file: &str, line: u32) -> Option<String> {
        if is_drawing(Path::new(file)) {
            // What is said of the whole file names no shape.
            return (line > 0).then(|| format!("shape {line}"));
        }
        let mut files = self.seen.borrow_mut();
        let lines = files.entry(file.to_owned()).or_insert_with(|| self.lines(file));
        lines.get(line.checked_sub(1)? as usize).cloned()
    }
}

fn read_lines(file: &str) -> Vec<String> {
    let bytes = fs::read(file).unwrap_or_default();
    let text = kerf_diag::decode(bytes.as_slice().into())
        .unwrap_or_else(|_| String::from_utf8_lossy(&bytes).into_owned());
    split(&text)
}

fn split(text: &str) -> Vec<String> {
    text.replace("\r\n", "\n").replace('\r', "\n").lines().map(str::to_owned).collect()
}
