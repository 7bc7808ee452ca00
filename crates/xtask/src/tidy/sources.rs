//! Sources: an opening essay in each crate, files of a readable size, nothing left undone.

use crate::{Finding, Tree};

/// A file this long is worth splitting.
const LONG_LINES: usize = 600;

/// A file this long is a mistake.
const TOO_LONG_LINES: usize = 900;

/// Findings about single source files.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, text) in tree.texts() {
        findings.extend(private_places(path, text));
        if path.ends_with(".rs") {
            findings.extend(undone(path, text));
            findings.extend(too_long(path, text));
            findings.extend(essay(path, text));
        }
    }
    findings
}

/// Source files that are worth splitting, with their number of lines.
pub fn long_files(tree: &Tree) -> Vec<(&str, usize)> {
    let rust = tree.texts().filter(|(path, _)| path.ends_with(".rs"));
    rust.map(|(path, text)| (path, text.lines().count())).filter(|(_, n)| *n > LONG_LINES).collect()
}

/// A path of somebody's own machine means nothing to anyone else.
fn private_places(path: &str, text: &str) -> Vec<Finding> {
    // Put together so that this file does not find itself.
    let places = [["/wo", "rk/"].concat(), ["/ho", "me/"].concat()];
    each_line(path, text, |line| {
        let hit = places.iter().find(|place| line.contains(place.as_str()))?;
        Some(format!("`{hit}…` is a place on one machine"))
    })
}

fn undone(path: &str, text: &str) -> Vec<Finding> {
    let marks =
        [["to", "do!("].concat(), ["unimple", "mented!("].concat(), ["#[ig", "nore"].concat()];
    each_line(path, text, |line| {
        let hit = marks.iter().find(|mark| line.contains(mark.as_str()))?;
        Some(format!("`{hit}` left behind: finish it or take it out"))
    })
}

fn too_long(path: &str, text: &str) -> Option<Finding> {
    let lines = text.lines().count();
    let message = format!("{lines} lines, more than {TOO_LONG_LINES}: split it");
    (lines > TOO_LONG_LINES).then(|| Finding::file(path, message))
}

fn essay(path: &str, text: &str) -> Option<Finding> {
    let root = path.ends_with("/src/lib.rs") || path.ends_with("/src/main.rs");
    let opens = text.starts_with("//! ");
    (root && !opens).then(|| Finding::line(path, 1, "open the crate with a `//!` on why it exists"))
}

fn each_line(path: &str, text: &str, judge: impl Fn(&str) -> Option<String>) -> Vec<Finding> {
    let lines = text.lines().enumerate();
    lines.filter_map(|(n, line)| Some(Finding::line(path, n + 1, judge(line)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings(path: &str, text: &str) -> Vec<String> {
        check(&Tree::of(&[(path, text)])).iter().map(Finding::to_string).collect()
    }

    #[test]
    fn each_rule_finds_its_breach() {
        let place = ["see /wo", "rk/shared"].concat();
        assert!(findings("docs/a.md", &place)[0].starts_with("docs/a.md:1: "));
        let undone = ["//! A.\nfn f() { to", "do!() }"].concat();
        assert!(findings("crates/a/src/b.rs", &undone)[0].contains(":2: "));
        assert!(findings("crates/a/src/lib.rs", "mod a;\n")[0].contains("`//!`"));
        assert!(findings("crates/a/src/b.rs", &"\n".repeat(901))[0].contains("901 lines"));
    }

    #[test]
    fn a_good_file_has_none() {
        assert!(findings("crates/a/src/lib.rs", "//! What a is for.\n").is_empty());
    }
}
