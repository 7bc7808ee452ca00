//! The lower crates take time, seeds, bytes and answers as arguments; this scan finds those that
//! reach for them.
//!
//! It reads the source as text: comments and `#[cfg(test)]` modules are cut away, then names are
//! looked up. Integration tests, examples and benches lie outside `src` and are free.

use crate::{Finding, Tree};

/// Paths below `std::` that lead outside.
const FORBIDDEN_STD: &[&str] = &[
    "fs",
    "net",
    "thread",
    "process",
    "env",
    "time::Instant",
    "time::SystemTime",
    "sync::OnceLock",
    "sync::LazyLock",
    "io::stdin",
    "io::stdout",
    "io::stderr",
];

/// Words that lead outside or make a global.
const FORBIDDEN_WORDS: &[&str] = &[
    "println!",
    "print!",
    "eprintln!",
    "eprint!",
    "Instant::now",
    "SystemTime::",
    "rand::",
    "RandomState",
    "static mut",
    "OnceLock",
    "LazyLock",
    "lazy_static!",
    "thread_local!",
];

/// Finds what the sources of one crate reach for that they may not.
pub fn check(tree: &Tree, folder: &str) -> Vec<Finding> {
    let src = format!("{folder}src/");
    let tests: Vec<String> =
        tree.matching(&src, ".rs").flat_map(|(path, text)| test_modules(path, text)).collect();
    let files = tree.matching(&src, ".rs").filter(|(path, _)| !is_inside(path, &tests));
    files.flat_map(|(path, text)| check_file(path, text)).collect()
}

/// Returns where the modules of their own that a file declares for tests only lie, without `.rs` or `/`.
pub(super) fn test_modules(path: &str, text: &str) -> Vec<String> {
    let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
    let folder = match file {
        "lib.rs" | "main.rs" | "mod.rs" => folder.to_owned(),
        _ => path.trim_end_matches(".rs").to_owned(),
    };
    let lines: Vec<&str> = text.lines().collect();
    let pairs = lines.windows(2).filter(|pair| pair[0] == "#[cfg(test)]");
    let names = pairs.filter_map(|pair| pair[1].strip_suffix(';')?.rsplit_once("mod "));
    names.map(|(_, name)| format!("{folder}/{name}")).collect()
}

pub(super) fn is_inside(path: &str, modules: &[String]) -> bool {
    let below = |rest: &str| rest == ".rs" || rest.starts_with('/');
    modules.iter().any(|module| path.strip_prefix(module.as_str()).is_some_and(below))
}

fn check_file(path: &str, text: &str) -> Vec<Finding> {
    let code = without_tests_and_comments(text);
    let mut findings = Vec::new();
    for (number, line) in code.lines().enumerate() {
        for word in FORBIDDEN_WORDS.iter().filter(|word| has_word(line, word)) {
            findings.push(finding(path, number + 1, word));
        }
        if is_changing_global(line) {
            findings.push(finding(path, number + 1, "static with changing content"));
        }
    }
    for (start, _) in code.match_indices("std::") {
        let number = code[..start].matches('\n').count() + 1;
        for item in imported(&code[start + "std::".len()..]) {
            let hit = FORBIDDEN_STD.iter().find(|bad| begins_path(&item, bad));
            findings.extend(hit.map(|bad| finding(path, number, &format!("std::{bad}"))));
        }
    }
    findings
}

fn finding(path: &str, line: usize, what: &str) -> Finding {
    Finding::line(path, line, format!("`{what}` below level 6: take it as an argument instead"))
}

fn is_changing_global(line: &str) -> bool {
    let item = line.trim_start().trim_start_matches("pub ").trim_start_matches("pub(crate) ");
    let changing = ["Atomic", "Mutex", "RwLock", "Cell<"];
    item.starts_with("static ") && changing.iter().any(|kind| item.contains(kind))
}

/// Returns `true` if the word stands in the line and is not the tail of a longer one.
fn has_word(line: &str, word: &str) -> bool {
    line.match_indices(word)
        .any(|(at, _)| !line[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))
}

/// Returns `true` if `item` is the path `bad` or lies below it.
fn begins_path(item: &str, bad: &str) -> bool {
    item.strip_prefix(bad)
        .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
}

/// The paths a text begins with: one, or all of a `{…}` group, nested groups spelled out.
fn imported(text: &str) -> Vec<String> {
    let stop = |c: char| !(c.is_alphanumeric() || c == '_' || c == ':');
    let head = &text[..text.find(stop).unwrap_or(text.len())];
    let Some(inner) = text[head.len()..].strip_prefix('{') else {
        return vec![head.to_owned()];
    };
    let items = split_group(inner);
    items.iter().flat_map(|i| imported(i)).map(|tail| format!("{head}{tail}")).collect()
}

/// The items of a group whose opening brace was read, split at its own commas.
fn split_group(inner: &str) -> Vec<&str> {
    let (mut depth, mut from, mut items) = (0, 0, Vec::new());
    for (at, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                items.push(inner[from..at].trim());
                from = at + 1;
                if c == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    items
}

/// The text with comments and test modules blanked, line numbers kept.
///
/// The code is formatted, so a test module at the outer level ends at a `}` in the first column.
pub(super) fn without_tests_and_comments(text: &str) -> String {
    let (mut in_tests, mut code) = (false, String::new());
    for line in text.lines() {
        in_tests |= line == "#[cfg(test)]";
        if !in_tests {
            code.push_str(line.split("//").next().unwrap_or_default());
        }
        in_tests &= line != "}" && !(line.contains("mod ") && line.ends_with(';'));
        code.push('\n');
    }
    code
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_text(text: &str, expected: &[&str]) {
        let tree = Tree::of(&[("crates/a/src/lib.rs", text)]);
        let found: Vec<String> = check(&tree, "crates/a/").iter().map(|f| f.to_string()).collect();
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, part) in found.iter().zip(expected) {
            assert!(found.contains(part), "{found} lacks {part}");
        }
    }

    #[test]
    fn finds_what_leads_outside() {
        check_text("use std::fs::File;\n", &["lib.rs:1: `std::fs`"]);
        check_text("\nuse std::{fmt, fs};\n", &["lib.rs:2: `std::fs`"]);
        check_text("use std::{time::{Duration, Instant}};\n", &["`std::time::Instant`"]);
        check_text("fn a() { println!(\"x\") }\n", &["`println!`"]);
        check_text("static mut COUNT: u32 = 0;\n", &["`static mut`"]);
        check_text("pub static N: Mutex<u32> = Mutex::new(0);\n", &["changing content"]);
    }

    #[test]
    fn leaves_the_innocent_alone() {
        check_text("use std::fmt;\nuse std::time::Duration;\n", &[]);
        check_text("// std::fs is not for us\n/// println! neither\n", &[]);
        check_text("fn a() { pretty_println!() }\n", &[]);
        check_text("use std::format;\nuse std::environment;\nstatic N: u32 = 0;\n", &[]);
    }

    #[test]
    fn files_of_test_modules_are_free() {
        let outside = "use std::fs;\n";
        let found = |declares: &str| {
            let lib = ("crates/a/src/lib.rs", declares);
            let files = [lib, ("crates/a/src/b.rs", outside), ("crates/a/src/b/c.rs", outside)];
            check(&Tree::of(&files), "crates/a/").len()
        };
        assert_eq!(found("#[cfg(test)]\nmod b;\n"), 0);
        assert_eq!(found("#[cfg(test)]\npub(crate) mod b;\n"), 0);
        assert_eq!(found("mod b;\n"), 2);
        assert_eq!(found("#[cfg(test)]\nmod bb;\n"), 2);
    }

    #[test]
    fn test_modules_are_free_but_what_follows_is_not() {
        check_text("#[cfg(test)]\nmod tests {\n    use std::fs;\n}\n", &[]);
        check_text("#[cfg(test)]\nmod tests;\n\nuse std::fs;\n", &["lib.rs:4"]);
    }
}
