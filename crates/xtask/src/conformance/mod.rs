//! The score against the ledgers: which rows of the manuals work, shown by which tests.
//!
//! `docs/conformance.toml` is the only place where the score is kept: a line a row, in the order of
//! the ledgers. Tests named after a row (`SBP-CMD-MX` is shown by `sbp_cmd_mx`, or by several tests
//! `sbp_cmd_mx__…`) are found and entered by [`mark`], with where they look: in a browser, at the command, at the
//! library; `docs/conformance.md` is written from it. [`shown`] holds rows that speak of what a person sees to tests that
//! look there.

mod by;
mod check;
mod ledger;
mod page;
mod score;
mod shown;
mod tests_found;

use crate::{Finding, Tree};
use anyhow::{Context, Result};
use score::Score;

const SCORE: &str = "docs/conformance.toml";
/// The page for users.
pub const PAGE: &str = "docs/conformance.md";
const NOTES: &str = "docs/conformance-notes.md";

/// Everything wrong with the score: unknown, missing or unproven rows.
///
/// # Errors
/// When the score or a ledger cannot be read.
pub fn check(tree: &Tree) -> Result<Vec<Finding>> {
    let score = read(tree)?;
    let tests = tests_found::names(tree);
    let mut findings = check::rows(&score, &tests);
    match ledger::beside()? {
        Some(ledger) => {
            findings.extend(check::against_ledger(&score, &ledger));
            findings.extend(shown(tree)?.check(&score, &ledger));
        }
        None => eprintln!("skipped: no ledger beside the checkout"),
    }
    Ok(findings)
}

/// Enters the tests named after rows; their rows become done unless a hand has said otherwise.
///
/// # Errors
/// When the score cannot be read or written.
pub fn mark(tree: &Tree) -> Result<String> {
    let mut score = read(tree)?;
    let changed = score.enter_tests(&tests_found::names(tree));
    write(tree, SCORE, &score.to_toml())?;
    Ok(format!("{SCORE}: {changed} rows changed"))
}

/// The page for users, made from the score and the hand-written notes.
///
/// # Errors
/// When the score cannot be read.
pub fn page(tree: &Tree) -> Result<String> {
    let unshown = shown(tree)?.not_yet;
    Ok(page::write(&read(tree)?, &unshown, tree.text(NOTES).unwrap_or_default()))
}

/// Adds rows that the ledger has and the score lacks, in the ledger's order.
///
/// # Errors
/// When there is no ledger, or the score cannot be read or written.
pub fn sync(tree: &Tree) -> Result<String> {
    let ledger = ledger::beside()?.context("there is no ledger beside the checkout")?;
    let mut score = Score::read(tree.text(SCORE).unwrap_or_default())?;
    let added = score.follow(&ledger);
    write(tree, SCORE, &score.to_toml())?;
    Ok(format!("{SCORE}: {added} rows added"))
}

fn shown(tree: &Tree) -> Result<shown::Shown> {
    let text = tree.text(shown::FILE).with_context(|| format!("{} is missing", shown::FILE))?;
    shown::Shown::read(text).with_context(|| shown::FILE)
}

fn read(tree: &Tree) -> Result<Score> {
    Score::read(tree.text(SCORE).with_context(|| format!("{SCORE} is missing"))?)
}

fn write(tree: &Tree, path: &str, text: &str) -> Result<()> {
    std::fs::write(tree.root().join(path), text).with_context(|| path.to_owned())
}
