//! The score itself: reading `docs/conformance.toml`, changing it, writing it back.

use super::by::By;
use super::ledger::Row as LedgerRow;
use super::tests_found::Tests;
use anyhow::{Context, Result};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use toml::{Table, Value};

const HEADER: &str = "\
# The score against the ledgers: a line a row. Status: done, partial (with why), not yet, n/a (with why).
# `make conformance` enters tests named after rows, and by what they show it, and writes conformance.md; status and why
# are set by hand.
";

/// Status of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
pub enum Status {
    /// Shown by tests.
    #[serde(rename = "done")]
    Done,
    /// Some of it works; `why` tells what does not.
    #[serde(rename = "partial")]
    Partial,
    /// Nothing of it works, or nobody has shown it.
    #[serde(rename = "not yet")]
    NotYet,
    /// It has no meaning here; `why` tells.
    #[serde(rename = "n/a")]
    NotApplicable,
}

impl Status {
    /// Every status, in the order of the page.
    pub const ALL: [Self; 4] = [Self::Done, Self::Partial, Self::NotYet, Self::NotApplicable];

    /// The word in the file.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Partial => "partial",
            Self::NotYet => "not yet",
            Self::NotApplicable => "n/a",
        }
    }
}

/// Entry of a row in the score.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Status.
    pub status: Status,
    /// By what its tests show it: follows from where they stand.
    #[serde(default)]
    pub by: Vec<By>,
    /// The tests that show it.
    #[serde(default)]
    pub tests: Vec<String>,
    /// Reason why it is partial or not applicable.
    pub why: Option<String>,
}

/// An area of a suite.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Area {
    /// The suite.
    pub suite: String,
    /// Its key in the ledger.
    pub key: String,
    /// Its heading for people.
    pub title: String,
    /// Its rows, in order.
    pub rows: Vec<(String, Entry)>,
}

/// All areas of all suites.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// The areas, in order.
    pub areas: Vec<Area>,
}

impl Score {
    /// Reads the file.
    ///
    /// # Errors
    /// When it is no TOML, or an entry has an unknown status or field.
    pub fn read(text: &str) -> Result<Self> {
        let table: Table = text.parse()?;
        let mut areas = Vec::new();
        for (suite, inside) in &table {
            for (key, rows) in inside.as_table().with_context(|| format!("[{suite}.…] expected"))?
            {
                areas.push(read_area(suite, key, rows)?);
            }
        }
        Ok(Self { areas })
    }

    /// All rows with their areas, in order.
    pub fn rows(&self) -> impl Iterator<Item = (&Area, &str, &Entry)> {
        self.areas.iter().flat_map(|a| a.rows.iter().map(move |(id, e)| (a, id.as_str(), e)))
    }

    /// The file's text.
    pub fn to_toml(&self) -> String {
        let mut text = HEADER.to_owned();
        for area in &self.areas {
            let Area { suite, key, title, .. } = area;
            let _ = write!(text, "\n[{suite}.{key}]\ntitle = {}\n", quoted(title));
            for (id, entry) in &area.rows {
                let _ = writeln!(text, "{id} = {}", entry_toml(entry));
            }
        }
        text
    }

    /// Enters tests named after rows, and by what those of each row show it; returns how many rows changed.
    pub fn enter_tests(&mut self, tests: &Tests) -> usize {
        let rows = self.areas.iter_mut().flat_map(|area| &mut area.rows);
        rows.filter_map(|(id, entry)| enter(id, entry, tests).then_some(())).count()
    }

    /// Takes over the ledger's rows and order, keeping what is known; returns how many are new.
    pub fn follow(&mut self, ledger: &[LedgerRow]) -> usize {
        let old = std::mem::take(self);
        let mut known: BTreeMap<&str, &Entry> = old.rows().map(|(_, id, e)| (id, e)).collect();
        let mut added = 0;
        for row in ledger {
            let entry = known.remove(row.id.as_str()).cloned().unwrap_or_else(|| {
                added += 1;
                Entry { status: Status::NotYet, by: Vec::new(), tests: Vec::new(), why: None }
            });
            let title = old.area(row).map_or(&row.area, |area| &area.title);
            self.last_area(row, title).rows.push((row.id.clone(), entry));
        }
        added
    }

    fn area(&self, row: &LedgerRow) -> Option<&Area> {
        self.areas.iter().find(|a| a.suite == row.suite && a.key == row.area)
    }

    /// The last area, which is a new one when the row belongs to another.
    fn last_area(&mut self, row: &LedgerRow, title: &str) -> &mut Area {
        let same = self.areas.pop_if(|a| a.suite == row.suite && a.key == row.area);
        let area = same.unwrap_or_else(|| Area {
            suite: row.suite.clone(),
            key: row.area.clone(),
            title: title.to_owned(),
            rows: Vec::new(),
        });
        self.areas.push(area);
        let last = self.areas.len() - 1;
        &mut self.areas[last]
    }
}

/// Tests that carry the name of a row.
fn tests_of<'a>(id: &str, tests: &'a Tests) -> impl Iterator<Item = &'a String> {
    let name = test_name(id);
    let several = format!("{name}__");
    tests.keys().filter(move |n| **n == name || n.starts_with(&several))
}

/// The name a row's test has.
pub fn test_name(id: &str) -> String {
    id.to_lowercase().replace('-', "_")
}

fn read_area(suite: &str, key: &str, rows: &Value) -> Result<Area> {
    let mut area = Area {
        suite: suite.to_owned(),
        key: key.to_owned(),
        title: key.to_owned(),
        rows: Vec::new(),
    };
    for (id, value) in rows.as_table().with_context(|| format!("[{suite}.{key}] expected"))? {
        match value.as_str() {
            Some(title) if id == "title" => area.title = title.to_owned(),
            _ => {
                let entry = value.clone().try_into().with_context(|| id.clone())?;
                area.rows.push((id.clone(), entry));
            }
        }
    }
    Ok(area)
}

/// Adds its tests to a row; whether that changed it.
fn enter(id: &str, entry: &mut Entry, tests: &Tests) -> bool {
    let before = entry.clone();
    let mut all: BTreeSet<String> = entry.tests.drain(..).collect();
    all.extend(tests_of(id, tests).cloned());
    entry.tests = all.into_iter().collect();
    entry.by = By::of_tests(&entry.tests, tests);
    if entry.status == Status::NotYet && !entry.tests.is_empty() {
        entry.status = Status::Done;
    }
    *entry != before
}

fn entry_toml(entry: &Entry) -> String {
    let mut text = format!("{{ status = {}", quoted(entry.status.word()));
    if !entry.by.is_empty() {
        let by: Vec<String> = entry.by.iter().map(|by| quoted(by.word())).collect();
        let _ = write!(text, ", by = [{}]", by.join(", "));
    }
    if !entry.tests.is_empty() {
        let tests: Vec<String> = entry.tests.iter().map(|test| quoted(test)).collect();
        let _ = write!(text, ", tests = [{}]", tests.join(", "));
    }
    if let Some(why) = &entry.why {
        let _ = write!(text, ", why = {}", quoted(why));
    }
    text + " }"
}

fn quoted(text: &str) -> String {
    Value::String(text.to_owned()).to_string()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    const FILE: &str = "\
[opensbp.lang]
title = \"The language\"
SBP-B = { status = \"not yet\" }
SBP-A = { status = \"partial\", by = [\"cli\"], tests = [\"by_hand\"], why = \"no text\" }
";

    fn names(names: &[&str]) -> Tests {
        names.iter().map(|n| ((*n).to_owned(), BTreeSet::from([By::Cli]))).collect()
    }

    #[test]
    fn what_is_read_is_written_back() {
        let score = Score::read(FILE).unwrap();
        assert_eq!(score.to_toml().strip_prefix(HEADER).unwrap().trim_start(), FILE);
    }

    #[test]
    fn tests_named_after_a_row_make_it_done() {
        let mut score = Score::read(FILE).unwrap();
        let found = names(&["sbp_b__once", "sbp_b__twice", "sbp_bc", "by_hand"]);
        assert_eq!(score.enter_tests(&found), 1);
        let (_, _, entry) = score.rows().next().unwrap();
        assert_eq!(entry.status, Status::Done);
        assert_eq!(entry.tests, ["sbp_b__once", "sbp_b__twice"]);
        assert_eq!(entry.by, [By::Cli]);
    }

    #[test]
    fn a_hand_written_status_stays() {
        let mut score = Score::read(FILE).unwrap();
        score.enter_tests(&names(&["sbp_a"]));
        let (_, _, entry) = score.rows().nth(1).unwrap();
        assert_eq!(entry.status, Status::Partial);
        assert_eq!(entry.tests, ["by_hand", "sbp_a"]);
    }

    #[test]
    fn the_ledger_gives_rows_and_order() {
        let row = |id: &str, area: &str| LedgerRow {
            suite: "opensbp".into(),
            area: area.into(),
            id: id.into(),
            acceptance: String::new(),
        };
        let mut score = Score::read(FILE).unwrap();
        let added =
            score.follow(&[row("SBP-A", "lang"), row("SBP-B", "lang"), row("SBP-C", "flow")]);
        assert_eq!(added, 1);
        let ids: Vec<&str> = score.rows().map(|(_, id, _)| id).collect();
        assert_eq!(ids, ["SBP-A", "SBP-B", "SBP-C"]);
        assert_eq!(score.areas[0].title, "The language");
    }

    #[test]
    fn unknown_words_are_refused() {
        assert!(Score::read("[opensbp.lang]\nSBP-A = { status = \"almost\" }").is_err());
        assert!(Score::read("[opensbp.lang]\nSBP-A = { status = \"done\", test = [] }").is_err());
    }
}
