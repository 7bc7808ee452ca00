//! Findings of the reading of a file.

use serde::Serialize;
use std::collections::BTreeMap;

/// Weight of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Weight {
    /// Good to know.
    Note,
    /// Something of the file was left out or read otherwise than it is written.
    Warning,
}

/// Something a person should know about a file that was read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Line of the file, counted from 1; in a binary file the byte.
    pub line: u32,
    /// Column of the line, counted from 1; 0 where lines have none that help.
    pub column: u32,
    /// Weight of the finding.
    pub weight: Weight,
    /// Description of what was found and what was done about it.
    pub text: String,
}

impl Finding {
    /// Makes a finding that concerns the whole file.
    pub fn of_file(weight: Weight, text: impl Into<String>) -> Self {
        Self { line: 0, column: 0, weight, text: text.into() }
    }
}

/// Findings of one kind beyond this many are only counted: a file with a million mistakes is told in
/// a page.
const MOST_OF_A_KIND: usize = 20;

/// Findings in the order of the file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Findings {
    list: Vec<Finding>,
    seen: BTreeMap<&'static str, usize>,
    skipped: BTreeMap<String, usize>,
}

impl Findings {
    /// Adds a warning. `kind` groups those that are alike.
    pub fn warn(&mut self, kind: &'static str, line: u32, text: impl Into<String>) {
        self.add_at(kind, (line, 0), Weight::Warning, text.into());
    }

    /// Adds a note.
    pub fn note(&mut self, kind: &'static str, line: u32, text: impl Into<String>) {
        self.add_at(kind, (line, 0), Weight::Note, text.into());
    }

    /// Tells whether one more of a kind would be told, and not only counted.
    pub fn wants(&self, kind: &'static str) -> bool {
        self.seen.get(kind).is_none_or(|seen| *seen < MOST_OF_A_KIND)
    }

    /// Adds a finding at a line and a column.
    pub fn add_at(
        &mut self,
        kind: &'static str,
        (line, column): (u32, u32),
        weight: Weight,
        text: String,
    ) {
        let seen = self.seen.entry(kind).or_default();
        *seen += 1;
        if *seen <= MOST_OF_A_KIND {
            self.list.push(Finding { line, column, weight, text });
        }
    }

    /// Counts an entity that Kerf does not draw.
    pub fn skip(&mut self, name: &str) {
        *self.skipped.entry(name.to_owned()).or_default() += 1;
    }

    /// Lists what was skipped, as the manual's report has it: `skipped: HATCH 1, TEXT 4`.
    pub fn skipped(&self) -> Option<String> {
        let counts: Vec<_> =
            self.skipped.iter().map(|(name, count)| format!("{name} {count}")).collect();
        (!counts.is_empty()).then(|| format!("skipped: {}", counts.join(", ")))
    }

    /// All findings, closed by those that tell how many more there were and what was skipped.
    pub fn finish(mut self) -> Vec<Finding> {
        let more: usize = self.seen.values().map(|n| n.saturating_sub(MOST_OF_A_KIND)).sum();
        if more > 0 {
            let text = format!("and {more} more of the same");
            self.list.push(Finding::of_file(Weight::Warning, text));
        }
        if let Some(text) = self.skipped() {
            self.list.push(Finding::of_file(Weight::Note, text));
        }
        self.list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn findings_alike_are_counted() {
        let mut findings = Findings::default();
        (1..=25).for_each(|line| findings.warn("number", line, "no number"));
        findings.skip("TEXT");
        findings.skip("HATCH");
        findings.skip("TEXT");
        let told = findings.finish();
        assert_eq!(told.len(), 22);
        assert_eq!(told[20].text, "and 5 more of the same");
        assert_eq!(told[21].text, "skipped: HATCH 1, TEXT 2");
    }
}
