//! Openings of doc comments, in crates, their tests and the console: a comment begins with what the thing is or does, not with a question word or half a clause.

use crate::{Finding, Tree};
use std::collections::BTreeMap;

/// Words that open a clause instead of a sentence about the thing.
const QUESTIONS: [&str; 14] = [
    "What", "Who", "Whether", "How", "Where", "When", "Why", "Whoever", "Whatever", "Which",
    "So many", "So often", "As it", "Of a",
];

/// Sources whose doc comments are counted together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Part<'a> {
    /// Source of the crate of that name.
    Crate(&'a str),
    /// Tests of all crates from outside.
    Tests,
    /// Source and tests of the console, without the messages that are made from the server's.
    Console,
}

/// The doc comments of a part.
#[derive(Default)]
struct Count<'a> {
    all: usize,
    /// Path and line of each that opens with a question word.
    questions: Vec<(&'a str, usize)>,
}

/// Findings about parts in which too many doc comments open with a question word.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let mut parts: BTreeMap<Part<'_>, Count<'_>> = BTreeMap::new();
    for (path, text) in tree.texts() {
        let Some(part) = Part::of(path) else { continue };
        let count = parts.entry(part).or_default();
        for (line, words) in part.openings(text) {
            count.all += 1;
            if is_question(words) {
                count.questions.push((path, line));
            }
        }
    }
    parts.iter().filter_map(|(part, count)| finding(*part, count)).collect()
}

fn finding(part: Part<'_>, Count { all, questions }: &Count<'_>) -> Option<Finding> {
    let (path, line) = *questions.last()?;
    let most = (all * part.most_percent() / 100).max(1);
    let (many, name) = (questions.len(), part.name());
    let message = format!(
        "{many} of {all} doc comments of {name} open with a question word, {most} may: begin with what the thing is or does"
    );
    (many > most).then(|| Finding::line(path, line, message))
}

impl<'a> Part<'a> {
    /// Finds the part to which a path belongs.
    fn of(path: &'a str) -> Option<Self> {
        if let Some(rest) = path.strip_prefix("console/") {
            let ours = rest.starts_with("tests/")
                || (rest.starts_with("src/") && !rest.starts_with("src/wire/"));
            return (ours && (path.ends_with(".ts") || path.ends_with(".tsx")))
                .then_some(Self::Console);
        }
        let (name, rest) = path.strip_prefix("crates/")?.split_once('/')?;
        match rest.split_once('/')?.0 {
            _ if !path.ends_with(".rs") => None,
            "src" => Some(Self::Crate(name)),
            "tests" => Some(Self::Tests),
            _ => None,
        }
    }

    fn name(self) -> String {
        match self {
            Self::Crate(name) => format!("`{name}`"),
            Self::Tests => "the crates' tests".into(),
            Self::Console => "the console".into(),
        }
    }

    /// The largest share of doc comments that may open with a question word, percent.
    const fn most_percent(self) -> usize {
        match self {
            Self::Crate(_) => 5,
            Self::Tests | Self::Console => 2,
        }
    }

    /// Line number and text of the first line of each doc comment.
    fn openings(self, text: &str) -> Vec<(usize, &str)> {
        match self {
            Self::Console => openings_in_stars(text),
            Self::Crate(_) | Self::Tests => openings_in_slashes(text),
        }
    }
}

/// Openings of comments whose lines begin with `///` or `//!`.
fn openings_in_slashes(text: &str) -> Vec<(usize, &str)> {
    let mut inside = false;
    let opening = |(n, line): (usize, _)| {
        let words = comment(line);
        let begins = words.filter(|_| !inside);
        inside = words.is_some();
        begins.map(|words| (n + 1, words))
    };
    text.lines().enumerate().filter_map(opening).collect()
}

fn comment(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let words = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"))?;
    Some(words.trim_start())
}

/// Openings of comments between `/**` and `*/`; the words may begin in the line below.
fn openings_in_stars(text: &str) -> Vec<(usize, &str)> {
    let lines: Vec<&str> = text.lines().map(str::trim_start).collect();
    lines
        .iter()
        .enumerate()
        .filter_map(|(n, line)| {
            let words = line.strip_prefix("/**")?.trim_start();
            let below = || lines.get(n + 1).map(|line| line.trim_start_matches(['*', ' ']));
            Some((n + 1, if words.is_empty() { below()? } else { words }))
        })
        .collect()
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

    #[test]
    fn the_crates_tests_and_the_console_may_have_fewer() {
        let told = |path: &str, question: &str, statement: &str| {
            let text = [&question.repeat(3), &*statement.repeat(97)].concat();
            let found = check(&Tree::of(&[(path, &text)]));
            found.iter().map(Finding::to_string).collect::<String>()
        };
        let (asks, says) = ("/// Where it ends.\nfn f() {}\n", "/// End of it.\nfn f() {}\n");
        let found = told("crates/a/tests/all.rs", asks, says);
        assert!(found.contains("3 of 100 doc comments of the crates' tests"), "{found}");
        assert_eq!(told("crates/a/src/lib.rs", asks, says), "");
        let says = "/** End of it. */\nconst a = 1;\n";
        for asks in
            ["/** Where it ends. */\nconst a = 1;\n", "/**\n * Where it ends.\n */\nconst a = 1;\n"]
        {
            for path in ["console/src/a.ts", "console/tests/a.tsx"] {
                let found = told(path, asks, says);
                assert!(found.contains("3 of 100 doc comments of the console"), "{path}: {found}");
            }
            assert_eq!(told("console/src/wire/messages.ts", asks, says), "");
        }
    }
}
