//! Names of code in the pages: each that stands with a link is defined in the file behind the link.
//!
//! Two spellings are looked at: `[file](target)` followed by names in back quotes, and a link whose label is such a
//! name. Fields, variants and rows of a table count as definitions.

use super::links::resolve;
use crate::{Finding, Tree};

/// Words of Rust and TypeScript that stand before the name they define.
const DEFINING: [&str; 14] = [
    "fn",
    "struct",
    "enum",
    "trait",
    "type",
    "const",
    "static",
    "mod",
    "union",
    "let",
    "function",
    "class",
    "interface",
    "macro_rules!",
];

/// Names on the pages of `docs` that their file does not define.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let pages = tree.matching("docs/", ".md").filter(|(path, _)| !path.starts_with("docs/book/"));
    pages.flat_map(|(path, text)| check_page(tree, path, text)).collect()
}

fn check_page(tree: &Tree, page: &str, text: &str) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (at, _) in text.match_indices("](") {
        let Some((target, tail)) = text[at + 2..].split_once(')') else { continue };
        let file = resolve(page, target.split('#').next().unwrap_or_default());
        let Some(code) = tree.text(&file).filter(|_| is_code(&file)) else { continue };
        for name in label(&text[..at]).into_iter().chain(names(tail)) {
            if !is_defined(&file, code, name) {
                let line = text[..at].matches('\n').count() + 1;
                findings.push(Finding::line(page, line, format!("{file} defines no `{name}`")));
            }
        }
    }
    findings
}

fn is_code(file: &str) -> bool {
    [".rs", ".ts", ".tsx"].iter().any(|ending| file.ends_with(ending))
}

/// The label of a link, if it is a name in back quotes.
fn label(before: &str) -> Option<&str> {
    let name = before.strip_suffix('`')?.rsplit_once("[`")?.1;
    is_path(name).then_some(name)
}

/// The names in back quotes that follow a link, commas between them.
fn names(mut tail: &str) -> Vec<&str> {
    let mut found = Vec::new();
    while let Some((name, rest)) =
        tail.trim_start().strip_prefix('`').and_then(|t| t.split_once('`'))
    {
        if is_path(name) {
            found.push(name);
        }
        tail = rest.strip_prefix(',').unwrap_or_default();
    }
    found
}

/// Returns `true` for `name` and `Type::name`.
fn is_path(name: &str) -> bool {
    name.split("::").all(|part| !part.is_empty() && part.chars().all(is_word))
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Returns `true` if the file defines the name, and mentions the type that it belongs to.
fn is_defined(file: &str, code: &str, path: &str) -> bool {
    let (owner, name) = path.rsplit_once("::").unwrap_or(("", path));
    let owner = owner.rsplit("::").next().unwrap_or_default();
    let is_type = owner.starts_with(char::is_uppercase);
    let owned = !is_type || occurrences(code, owner).next().is_some();
    owned && (is_module(file, name) || occurrences(code, name).any(|(b, a)| defines(b, a, name)))
}

/// Returns `true` if the file, or the folder that it heads, is the module of this name.
fn is_module(file: &str, name: &str) -> bool {
    let path = file.trim_end_matches(".rs").trim_end_matches("/mod").trim_end_matches("/src/lib");
    path.rsplit('/').next() == Some(name)
}

/// What stands before and behind each occurrence of a word on its line.
fn occurrences<'a>(code: &'a str, word: &'a str) -> impl Iterator<Item = (&'a str, &'a str)> {
    let whole =
        |before: &str, after: &str| !before.ends_with(is_word) && !after.starts_with(is_word);
    code.lines().filter(|line| !line.trim_start().starts_with("//")).flat_map(move |line| {
        let places =
            line.match_indices(word).map(|(at, _)| (&line[..at], &line[at + word.len()..]));
        places.filter(move |(before, after)| whole(before, after))
    })
}

/// Returns `true` if a word between these parts of a line is defined there.
fn defines(before: &str, after: &str, name: &str) -> bool {
    let last = before.split_whitespace().next_back().unwrap_or_default();
    let opens = last.is_empty() || last == "pub" || last.starts_with("pub(");
    let is_variant = name.starts_with(char::is_uppercase)
        && (after.is_empty() || ["(", " {", ",", " ="].iter().any(|a| after.starts_with(a)));
    let is_field = after.starts_with(':') && !after.starts_with("::");
    DEFINING.contains(&last) || opens && (is_variant || is_field)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = "pub struct Tape {\n    pub length: f64,\n}\nimpl Tape {\n    fn cut(&self) {\n        \
        slip(1);\n    }\n}\nenum End {\n    Torn(u8),\n}\n// fn gone() {}\n";

    #[track_caller]
    fn check_words(words: &str, found: &[&str]) {
        let page = format!("One\n{words}.\n");
        let tree = Tree::of(&[("docs/a.md", &page), ("a/tape.rs", CODE)]);
        let told: Vec<String> = check(&tree).iter().map(Finding::to_string).collect();
        let expected: Vec<String> = found
            .iter()
            .map(|name| format!("docs/a.md:2: a/tape.rs defines no `{name}`"))
            .collect();
        assert_eq!(told, expected, "{words}");
    }

    #[test]
    fn what_a_file_defines_may_be_named() {
        check_words("[tape.rs](../a/tape.rs) `Tape::cut`, `Tape::length`, `End::Torn`", &[]);
        check_words("[`cut`](../a/tape.rs) or [`tape`](../a/tape.rs)\n`End`", &[]);
    }

    #[test]
    fn what_a_file_does_not_define_is_told() {
        check_words("[tape.rs](../a/tape.rs) `Tape::slip`, `gone`", &["Tape::slip", "gone"]);
        check_words("[tape.rs](../a/tape.rs) `Roll::cut`", &["Roll::cut"]);
        check_words("[`Tape::wind`](../a/tape.rs)", &["Tape::wind"]);
    }

    #[test]
    fn words_that_are_no_name_are_left_alone() {
        check_words("[tape.rs](../a/tape.rs) of `gone`, [it](../a/tape.rs) `a = 1`", &[]);
    }
}
