//! The generated pages: what writes each, and whether they are fresh.

use crate::{Finding, Tree, book, conformance, endings};
use anyhow::{Context, Result};

/// A page that is made and never edited.
struct Page {
    /// Path of the page.
    path: &'static str,
    /// Function that makes its text.
    text: fn(&Tree) -> Result<String>,
    /// The command that makes it anew.
    command: &'static str,
}

/// The folder of the messages between server and console, for the console.
pub const WIRE: &str = "console/src/wire";

const PAGES: &[Page] = &[
    Page { path: conformance::PAGE, text: conformance::page, command: "make conformance" },
    Page { path: "docs/book/messages.md", text: book::messages, command: "make book" },
    Page { path: "docs/book/states.md", text: book::states, command: "make book" },
    Page {
        path: "docs/book/hand-console-functions.md",
        text: book::functions,
        command: "make book",
    },
    Page { path: "docs/book/commands.md", text: book::commands, command: "make book" },
    Page {
        path: "console/src/wire/messages.ts",
        text: |_| Ok(kerf_wire::typescript()),
        command: "cargo xtask wire",
    },
    Page {
        path: "console/src/wire/fold.json",
        text: |_| Ok(kerf_wire::fold_vectors()?),
        command: "cargo xtask wire",
    },
    Page {
        path: "console/src/wire/endings.ts",
        text: |_| Ok(endings::typescript()),
        command: "cargo xtask wire",
    },
];

/// Pages that differ from what would be written now.
///
/// # Errors
/// When what a page is made from cannot be read.
pub fn check(tree: &Tree) -> Result<Vec<Finding>> {
    let mut findings = Vec::new();
    for page in PAGES {
        if tree.text(page.path) != Some(&(page.text)(tree)?) {
            findings.push(Finding::file(page.path, format!("is stale: run `{}`", page.command)));
        }
    }
    Ok(findings)
}

/// Writes the pages below a path and names them.
///
/// # Errors
/// When what a page is made from cannot be read, or the page not be written.
pub fn write(tree: &Tree, below: &str) -> Result<String> {
    let mut written = Vec::new();
    for page in PAGES.iter().filter(|page| page.path.starts_with(below)) {
        let text = (page.text)(tree)?;
        let path = tree.root().join(page.path);
        path.parent().map_or(Ok(()), std::fs::create_dir_all).context(page.path)?;
        std::fs::write(path, text).context(page.path)?;
        written.push(format!("{}: written", page.path));
    }
    Ok(written.join("\n"))
}
