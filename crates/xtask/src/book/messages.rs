//! The page of messages, made from the table of codes.

use crate::Tree;
use anyhow::Result;
use kerf_diag::Severity;
use kerf_diag::codes::{ALL, Explanation};
use std::fmt::Write as _;

const MESSAGES: &str = "\
<!-- Written by `make book` from crates/diag/src/codes.rs. Do not edit. -->

# Messages

Every message has a code that never changes its meaning. `kerf explain CODE` prints what stands here.
An **error** keeps a program from running or going on; a **warning** lets it run, but a person should
look; a **note** is worth knowing.
";

/// Letters of codes, and what they are about.
const ROOMS: &[(&str, &str)] = &[
    ("S", "Reading a part file"),
    ("W", "What `kerf check` warns of"),
    ("G", "G-code"),
    ("R", "Running a program"),
    ("C", "Converting a program"),
    ("F", "Files"),
    ("M", "The machine"),
    ("K", "The machine's configuration"),
    ("J", "The journal"),
];

/// The page of all diagnostic codes.
///
/// # Errors
/// Never; pages share one form.
pub fn messages(_: &Tree) -> Result<String> {
    let mut page = MESSAGES.to_owned();
    for (letter, title) in ROOMS {
        let codes = ALL.iter().filter(|e| e.code.as_str().starts_with(letter));
        let entries: Vec<String> = codes.map(message).collect();
        if !entries.is_empty() {
            let _ = write!(page, "\n## {title}\n{}", entries.concat());
        }
    }
    Ok(page)
}

fn message(entry: &Explanation) -> String {
    let severity = match entry.code.severity() {
        Severity::Error => "Error",
        Severity::Warning => "Warning",
        Severity::Note => "Note",
    };
    let Explanation { code, title, text } = entry;
    format!("\n### {}: {title}\n\n*{severity}.* {text}\n", code.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_on_the_page() -> Result<()> {
        let page = messages(&Tree::default())?;
        for entry in ALL {
            let heading = format!("\n### {}: {}\n", entry.code.as_str(), entry.title);
            assert!(page.contains(&heading), "{heading}");
        }
        Ok(())
    }
}
