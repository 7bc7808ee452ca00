//! Checks of the score.

use super::SCORE;
use super::by::By;
use super::ledger::{Row, SUITES};
use super::score::{Entry, Score, Status};
use super::tests_found::Tests;
use crate::Finding;
use std::collections::BTreeMap;

/// Rows that claim what nothing shows, and suites that lost or gained rows.
pub fn rows(score: &Score, tests: &Tests) -> Vec<Finding> {
    let mut findings = counts(score);
    for (area, id, entry) in score.rows() {
        if !well_formed(&area.suite, id) {
            findings.push(Finding::file(SCORE, format!("{id} is no id of {}", area.suite)));
        }
        findings.extend(entry_findings(id, entry, tests));
    }
    findings
}

/// Rows that the ledger does not know, has in another area, or that are missing here.
pub fn against_ledger(score: &Score, ledger: &[Row]) -> Vec<Finding> {
    let place = |suite: &str, area: &str| format!("[{suite}.{area}]");
    let mut wanted: BTreeMap<&str, String> =
        ledger.iter().map(|row| (row.id.as_str(), place(&row.suite, &row.area))).collect();
    let mut findings = Vec::new();
    for (area, id, _) in score.rows() {
        let here = place(&area.suite, &area.key);
        match wanted.remove(id) {
            None => findings.push(Finding::file(SCORE, format!("{id} is in no ledger"))),
            Some(there) if there != here => {
                let message = format!("{id} stands in {here}, its ledger has it in {there}");
                findings.push(Finding::file(SCORE, message));
            }
            Some(_) => {}
        }
    }
    let missing = wanted.keys().map(|id| Finding::file(SCORE, format!("{id} is missing")));
    findings.extend(missing);
    findings
}

fn counts(score: &Score) -> Vec<Finding> {
    let count = |suite: &str| score.rows().filter(|(area, ..)| area.suite == suite).count();
    let wrong = SUITES.iter().filter(|(suite, rows)| count(suite) != *rows).map(|(suite, rows)| {
        Finding::file(SCORE, format!("{suite} has {} rows, not {rows}", count(suite)))
    });
    let unknown = score.areas.iter().filter(|a| SUITES.iter().all(|(suite, _)| *suite != a.suite));
    let unknown = unknown.map(|a| Finding::file(SCORE, format!("unknown suite {}", a.suite)));
    wrong.chain(unknown).collect()
}

fn well_formed(suite: &str, id: &str) -> bool {
    let prefix = if suite == "opensbp" { "SBP-" } else { "PRO-" };
    id.strip_prefix(prefix).is_some_and(|rest| {
        rest.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'-')
    })
}

fn entry_findings(id: &str, entry: &Entry, tests: &Tests) -> Vec<Finding> {
    let mut findings = Vec::new();
    let explained = entry.why.as_deref().is_some_and(|why| !why.trim().is_empty());
    match entry.status {
        Status::Done if entry.tests.is_empty() => findings.push("is done but names no test"),
        Status::Partial | Status::NotApplicable if !explained => findings.push("says no `why`"),
        Status::NotYet if !entry.tests.is_empty() => findings.push("has tests but is `not yet`"),
        _ => {}
    }
    let mut findings: Vec<Finding> =
        findings.iter().map(|what| Finding::file(SCORE, format!("{id} {what}"))).collect();
    let lost = entry.tests.iter().filter(|test| !tests.contains_key(*test));
    findings.extend(lost.map(|t| Finding::file(SCORE, format!("{id}: there is no test {t}"))));
    if entry.by != By::of_tests(&entry.tests, tests) {
        let message =
            format!("{id}: `by` is not where its tests stand: run `cargo xtask conformance mark`");
        findings.push(Finding::file(SCORE, message));
    }
    findings
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn check(line: &str, expected: &str) {
        let score = Score::read(&format!("[opensbp.lang]\n{line}\n")).unwrap();
        let found = rows(&score, &Tests::from([("known".to_owned(), BTreeSet::from([By::Cli]))]));
        let found: Vec<String> =
            found.into_iter().map(|f| f.message).filter(|m| m.starts_with("SBP")).collect();
        assert_eq!(found.join("; "), expected);
    }

    #[test]
    fn each_claim_needs_its_proof() {
        check("SBP-A = { status = \"done\", by = [\"cli\"], tests = [\"known\"] }", "");
        let typed = "SBP-A: `by` is not where its tests stand: run `cargo xtask conformance mark`";
        check("SBP-A = { status = \"done\", by = [\"browser\"], tests = [\"known\"] }", typed);
        check("SBP-A = { status = \"done\" }", "SBP-A is done but names no test");
        check("SBP-A = { status = \"done\", tests = [\"x\"] }", "SBP-A: there is no test x");
        check("SBP-A = { status = \"partial\" }", "SBP-A says no `why`");
        check("SBP-A = { status = \"n/a\", why = \"no such thing\" }", "");
        check(
            "SBP-A = { status = \"not yet\", by = [\"cli\"], tests = [\"known\"] }",
            "SBP-A has tests but is `not yet`",
        );
        check("SBP_A = { status = \"not yet\" }", "SBP_A is no id of opensbp");
    }

    #[test]
    fn a_lost_row_shows_in_the_count() {
        let score = Score::read("[opensbp.lang]\nSBP-A = { status = \"not yet\" }\n").unwrap();
        let found = rows(&score, &Tests::new());
        assert_eq!(found[0].message, "opensbp has 1 rows, not 776");
    }

    #[test]
    fn the_ledger_is_followed() {
        let row = |id: &str| Row {
            suite: "opensbp".into(),
            area: "flow".into(),
            id: id.into(),
            acceptance: String::new(),
        };
        let score = Score::read(
            "[opensbp.lang]\nSBP-A = { status = \"not yet\" }\nSBP-X = { status = \"not yet\" }\n",
        );
        let found = against_ledger(&score.unwrap(), &[row("SBP-A"), row("SBP-C")]);
        let found: Vec<String> = found.into_iter().map(|f| f.message).collect();
        let moved = "SBP-A stands in [opensbp.lang], its ledger has it in [opensbp.flow]";
        assert_eq!(found, [moved, "SBP-X is in no ledger", "SBP-C is missing"]);
    }
}
