//! Openings of doc comments: a comment begins with what the thing is or does, not with a question word or half a clause.

use crate::{Finding, Tree};
use std::collections::BTreeMap;

/// Words that open a clause instead of a sentence about the thing.
const QUESTIONS: [&str; 14] = [
    "What", "Who", "Whether", "How", "Where", "When", "Why", "Whoever", "Whatever", "Which",
    "So many", "So often", "As it", "Of a",
];

/// The largest share of a crate's doc comments that may open so, percent.
const MOST_PERCENT: usize = 5;

/// The doc comments of a crate.
#[derive(Default)]
struct Count<'a> {
    all: usize,
    /// Path and line of each that opens with a question word.
    questions: Vec<(&'a str, usize)>,
}

/// Findings about crates in which too many doc comments open with a question word.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let mut crates: BTreeMap<&str, Count<'_>> = BTreeMap::new();
    for (path, text) in tree.texts() {
        let Some(name) = crate_of(path) else { continue };
        let count = crates.entry(name).or_default();
        for (line, words) in openings(text) {
            count.all += 1;
            if is_question(words) {
                count.questions.push((path, line));
            }
        }
    }
    crates.iter().filter_map(|(name, count)| finding(name, count)).collect()
}

fn finding(name: &str, Count { all, questions }: &Count<'_>) -> Option<Finding> {
    let (path, line) = *questions.last()?;
    let most = (all * MOST_PERCENT / 100).max(1);
    let many = questions.len();
    let message = format!(
        "{many} of {all} doc comments of `{name}` open with a question word, {most} may: begin with what the thing is or does"
    );
    (many > most).then(|| Finding::line(path, line, message))
}

/// Name of the crate whose source a path is.
fn crate_of(path: &str) -> Option<&str> {
    let (name, rest) = path.strip_prefix("crates/")?.split_once('/')?;
    (rest.starts_with("src/") && path.ends_with(".rs")).then_some(name)
}

/// Line number and text of the first line of each doc comment.
fn openings(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let words = |line: &'_ str| -> bool { comment(line).is_some() };
    let mut inside = false;
    text.lines().enumerate().filter_map(move |(n, line)| {
        let begins = words(line) && !inside;
        inside = words(line);
        begins.then(|| (n + 1, comment(line).unwrap_or_default()))
    })
}

fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let words = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"))?;
    Some(words.trim_start())
}

fn is_question(words: &str) -> bool {
    let ends = |rest: &str| !rest.starts_with(char::is_alphabetic);
    QUESTIONS.iter().any(|question| words.strip_prefix(question).is_some_and(ends))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crate_may_have_few_comments_that_open_with_a_question() {
        let told = |text: &str| {
            let found = check(&Tree::of(&[("crates/a/src/lib.rs", text)]));
            found.iter().map(Finding::to_string).collect::<Vec<_>>()
        };
        let question = "/// Whether it is on.\nfn f() {}\n\n";
        let statement = "/// Number of holes.\n/// What lies behind counts no more.\nfn g() {}\n\n";
        assert!(told(&[question, &statement.repeat(20)].concat()).is_empty());
        let found = told(&[question, question, &statement.repeat(20)].concat());
        assert_eq!(found.len(), 1);
        assert!(
            found[0].starts_with("crates/a/src/lib.rs:4: 2 of 22 doc comments of `a`"),
            "{found:?}"
        );
        assert!(told(&"/// Whatsoever is a word of its own.\nfn f() {}\n".repeat(20)).is_empty());
        assert_eq!(told(&"/// So many lines are kept.\nfn f() {}\n".repeat(20)).len(), 1);
    }
}
