//! The files of the checkout, read once.

use anyhow::{Context, Result};
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

/// Folders that are no part of the project.
const SKIPPED: &[&str] = &["target", ".git", "node_modules", "out", "artifacts", "dist"];

/// One breach of a rule.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Finding {
    /// File, relative to the checkout.
    pub file: String,
    /// Line counted from 1, or 0 for the whole file.
    pub line: usize,
    /// Description of what is wrong and what to do.
    pub message: String,
}

impl Finding {
    /// A finding about a whole file.
    pub fn file(file: impl Into<String>, message: impl Into<String>) -> Self {
        Self { file: file.into(), line: 0, message: message.into() }
    }

    /// A finding about one line, counted from 1.
    pub fn line(file: impl Into<String>, line: usize, message: impl Into<String>) -> Self {
        Self { file: file.into(), line, message: message.into() }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => write!(f, "{}: {}", self.file, self.message),
            line => write!(f, "{}:{line}: {}", self.file, self.message),
        }
    }
}

/// Every text file of a checkout by its path, relative and with forward slashes.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    root: PathBuf,
    texts: BTreeMap<String, String>,
    binaries: Vec<String>,
}

impl Tree {
    /// Reads the checkout that this crate was built in.
    ///
    /// # Errors
    /// When a file or folder cannot be read.
    pub fn here() -> Result<Self> {
        let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
        let root = manifest.ancestors().nth(2).context("the crate lies two folders deep")?;
        Self::read(root)
    }

    /// Reads everything below a folder.
    ///
    /// # Errors
    /// When a file or folder cannot be read.
    pub fn read(root: &Path) -> Result<Self> {
        let mut tree = Self { root: root.to_path_buf(), ..Self::default() };
        tree.add_folder(root)?;
        tree.binaries.sort();
        Ok(tree)
    }

    fn add_folder(&mut self, folder: &Path) -> Result<()> {
        let entries = std::fs::read_dir(folder).with_context(|| folder.display().to_string())?;
        for entry in entries {
            let entry = entry?;
            let name = entry.file_name();
            let kind = entry.file_type()?;
            if kind.is_dir() && !SKIPPED.iter().any(|s| name == *s) {
                self.add_folder(&entry.path())?;
            } else if kind.is_file() && name != ".git" {
                self.add_file(&entry.path())?;
            }
        }
        Ok(())
    }

    fn add_file(&mut self, path: &Path) -> Result<()> {
        let bytes = std::fs::read(path).with_context(|| path.display().to_string())?;
        let relative = path.strip_prefix(&self.root)?.to_string_lossy().replace('\\', "/");
        match String::from_utf8(bytes) {
            Ok(text) => drop(self.texts.insert(relative, text)),
            Err(_) => self.binaries.push(relative),
        }
        Ok(())
    }

    /// Returns the folder of the checkout.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The text of a file.
    pub fn text(&self, path: &str) -> Option<&str> {
        self.texts.get(path).map(String::as_str)
    }

    /// All text files, sorted by path.
    pub fn texts(&self) -> impl Iterator<Item = (&str, &str)> {
        self.texts.iter().map(|(path, text)| (path.as_str(), text.as_str()))
    }

    /// Text files whose path begins and ends like this.
    pub fn matching<'a>(
        &'a self,
        prefix: &'a str,
        suffix: &'a str,
    ) -> impl Iterator<Item = (&'a str, &'a str)> {
        self.texts().filter(move |(p, _)| p.starts_with(prefix) && p.ends_with(suffix))
    }

    /// Returns `true` if a file, or a folder with files in it, exists.
    pub fn exists(&self, path: &str) -> bool {
        let inside = format!("{path}/");
        let mut all = self.texts.keys().chain(&self.binaries);
        all.any(|p| p == path || p.starts_with(&inside))
    }

    /// A tree made of these files, for tests of rules.
    pub fn of(files: &[(&str, &str)]) -> Self {
        let texts = files.iter().map(|(p, t)| (p.to_string(), t.to_string())).collect();
        Self { texts, ..Self::default() }
    }
}
