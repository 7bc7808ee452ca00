//! Rows that speak of what a person sees or presses, and the place where their tests look.
//!
//! A test of the library proves that a rule holds, not that anybody meets it: a dialog may be made and never be
//! drawn. So a row whose acceptance names the mouse, a key, a dialog, a page or a picture needs a test in a browser,
//! and one that names a warning a test in a browser or of the command, which prints it. Rows that use such a word for
//! something else are listed with the reason; rows that lack their test are listed too, in a list that may only
//! become shorter.

use super::by::By;
use super::ledger::Row;
use super::score::{Entry, Score, Status};
use crate::Finding;
use anyhow::Result;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};

/// The lists.
pub const FILE: &str = "docs/conformance-shown.toml";

/// The words for a row of the second list.
pub const NOT_YET: &str = "not yet shown in the browser";

/// Number of rows of the second list: it may become shorter, then this number does, never longer.
const MOST_NOT_YET: usize = 0;

/// Rows that are not yet shown where a person sees them.
pub type Unshown = BTreeSet<String>;

/// Lists of rows that are not shown where their words say.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Shown {
    /// Rows that mean something else by the word, or are seen elsewhere, with the reason.
    elsewhere: BTreeMap<String, String>,
    /// Rows that lack their test.
    pub not_yet: Unshown,
}

/// Part of a person's world of which a row speaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum World {
    /// Something on the screen, or done to it.
    Screen,
    /// A warning, which a terminal shows as well.
    Warning,
}

const SCREEN: &[&str] = &[
    "mouse", "click", "clicks", "drag", "dragged", "lmb", "rmb", "key", "keys", "keyboard",
    "dialog", "dialogs", "dialogue", "page", "pages", "picture", "pictures",
];
const WARNING: &[&str] = &["warning", "warnings", "warns", "warned"];

impl Shown {
    /// Reads the lists.
    ///
    /// # Errors
    /// When they are no TOML.
    pub fn read(text: &str) -> Result<Self> {
        Ok(toml::from_str(text)?)
    }

    /// Rows that are done and whose tests look elsewhere than their words say, and entries of the lists that hold
    /// no longer.
    pub fn check(&self, score: &Score, ledger: &[Row]) -> Vec<Finding> {
        let words: BTreeMap<&str, &str> =
            ledger.iter().map(|row| (row.id.as_str(), row.acceptance.as_str())).collect();
        let lacks = |id: &str, entry: &Entry| words.get(id).is_some_and(|text| lacks(text, entry));
        let lacking: BTreeSet<&str> =
            score.rows().filter(|(_, id, entry)| lacks(id, entry)).map(|(_, id, _)| id).collect();
        let mut findings = Vec::new();
        let mut tell = |text: String| findings.push(Finding::file(FILE, text));
        for id in &lacking {
            if !self.elsewhere.contains_key(*id) && !self.not_yet.contains(*id) {
                tell(format!(
                    "{id} speaks of what a person sees, and no test looks there: add one"
                ));
            }
        }
        let listed = self.elsewhere.keys().chain(&self.not_yet);
        for id in listed.filter(|id| !lacking.contains(id.as_str())) {
            tell(format!("{id} has its test, or needs none: take it off the list"));
        }
        for (id, _) in self.elsewhere.iter().filter(|(_, why)| why.trim().is_empty()) {
            tell(format!("{id} says no reason"));
        }
        let twice = self.elsewhere.keys().filter(|id| self.not_yet.contains(*id));
        twice.for_each(|id| tell(format!("{id} stands in both lists")));
        if self.not_yet.len() != MOST_NOT_YET {
            tell(format!(
                "{} rows are {NOT_YET}, {MOST_NOT_YET} are known: the list only becomes shorter, and MOST_NOT_YET with it",
                self.not_yet.len()
            ));
        }
        findings
    }
}

fn lacks(acceptance: &str, entry: &Entry) -> bool {
    let by = |place| entry.by.contains(&place);
    entry.status == Status::Done
        && match world(acceptance) {
            Some(World::Screen) => !by(By::Browser),
            Some(World::Warning) => !by(By::Browser) && !by(By::Cli),
            None => false,
        }
}

fn world(acceptance: &str) -> Option<World> {
    let words: Vec<String> = acceptance
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .map(str::to_lowercase)
        .collect();
    let has = |list: &[&str]| words.iter().any(|word| list.contains(&word.as_str()));
    match (has(SCREEN), has(WARNING)) {
        (true, _) => Some(World::Screen),
        (false, true) => Some(World::Warning),
        (false, false) => None,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn words_of_a_person_are_found_as_whole_words() {
        assert_eq!(world("A click opens it"), Some(World::Screen));
        assert_eq!(world("Press key 6: warned"), Some(World::Screen));
        assert_eq!(world("No path, warning naming it"), Some(World::Warning));
        assert_eq!(world("The monkey pageant runs at F5"), None);
    }

    #[test]
    fn where_a_test_looks_follows_from_its_file() {
        assert_eq!(By::of_file("console/tests/browser/a.test.ts"), By::Browser);
        assert_eq!(By::of_file("crates/kerf/tests/a.rs"), By::Cli);
        assert_eq!(By::of_file("console/src/draw/a.test.ts"), By::Library);
    }

    /// Returns the findings of a row with these words, shown so, that stands in these lists.
    fn check(words: &str, by: &str, lists: &str) -> Vec<String> {
        let text = format!("[opensbp.lang]\nSBP-A = {{ status = \"done\", by = [\"{by}\"] }}\n");
        let row = Row {
            suite: "opensbp".into(),
            area: "lang".into(),
            id: "SBP-A".into(),
            acceptance: words.into(),
        };
        let shown = Shown::read(lists).unwrap();
        let found = shown.check(&Score::read(&text).unwrap(), &[row]);
        let of_row = found.into_iter().map(|finding| finding.message);
        of_row.filter(|text| text.starts_with("SBP-A")).collect()
    }

    #[test]
    fn a_row_is_shown_where_its_words_say_or_listed() {
        let none = "not-yet = []\n[elsewhere]\n";
        let add = "SBP-A speaks of what a person sees, and no test looks there: add one";
        assert_eq!(check("a click", "library", none), [add]);
        assert_eq!(check("a click", "cli", none), [add]);
        assert_eq!(check("a warning", "library", none), [add]);
        assert_eq!(check("a warning", "cli", none), Vec::<String>::new());
        assert_eq!(check("a click", "browser", none), Vec::<String>::new());
        let listed = "not-yet = [\"SBP-A\"]\n[elsewhere]\n";
        let excused = "not-yet = []\n[elsewhere]\nSBP-A = \"a key of the registry\"\n";
        for lists in [listed, excused] {
            assert_eq!(check("a key", "library", lists), Vec::<String>::new());
            let gone = "SBP-A has its test, or needs none: take it off the list";
            assert_eq!(check("a key", "browser", lists), [gone]);
        }
        let silent = excused.replace("a key of the registry", " ");
        assert_eq!(check("a key", "library", &silent), ["SBP-A says no reason"]);
    }
}
