//! The names of all tests, read from the sources.
//!
//! Formatted Rust is regular enough to be read line by line: a test is the `fn` that follows a
//! `#[test]`; a table of rows is a `rows! {` whose entries begin with the test's name. A test of the
//! console is an `it("` whose words begin with the name, or with several and commas between.

use super::by::By;
use crate::Tree;
use std::collections::{BTreeMap, BTreeSet};

/// Tests by name, each with where it looks: a name may stand in several places.
pub type Tests = BTreeMap<String, BTreeSet<By>>;

/// All tests in the workspace's crates and in the console.
pub fn names(tree: &Tree) -> Tests {
    let rust = tree.matching("crates/", ".rs").map(|(path, text)| (path, of_file(text)));
    let page = tree.matching("console/", ".test.ts").map(|(path, text)| (path, of_page(text)));
    let mut tests = Tests::new();
    for (path, names) in rust.chain(page) {
        let by = By::of_file(path);
        for name in names {
            tests.entry(name).or_default().insert(by);
        }
    }
    tests
}

/// Names in a file of the console's tests: only those of rows, the others are sentences.
fn of_page(text: &str) -> Vec<String> {
    let words = text.lines().filter_map(|line| line.trim().strip_prefix("it(\""));
    let names = words.map(|words| words.split(':').next().unwrap_or_default());
    names.flat_map(|names| names.split(", ").filter_map(row)).collect()
}

fn of_file(text: &str) -> Vec<String> {
    let mut names = Vec::new();
    let (mut after_mark, mut in_rows) = (false, false);
    for line in text.lines().map(str::trim) {
        after_mark |= line == "#[test]";
        in_rows = (in_rows || line == "rows! {") && line != "}";
        if let Some(name) = function(line).filter(|_| after_mark) {
            names.push(name);
            after_mark = false;
        } else if in_rows {
            names.extend(row(line));
        }
    }
    names
}

fn function(line: &str) -> Option<String> {
    let (_, tail) = line.split_once("fn ")?;
    Some(identifier(tail)).filter(|name| !name.is_empty())
}

/// The name an entry of a table begins with.
fn row(line: &str) -> Option<String> {
    let name = identifier(line);
    (name.starts_with("sbp_") || name.starts_with("pro_")).then_some(name)
}

fn identifier(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_marked_functions_and_tables() {
        let text = "fn helper() {}\n#[test]\n#[should_panic]\nfn one() {\n    fn inner() {}\n}\n\
                    rows! {\n    sbp_cmd_mx: \"MX,1\" => \"x\";\n}\nfn sbp_helper() {}\n";
        assert_eq!(of_file(text), ["one", "sbp_cmd_mx"]);
        let page = "it(\"sbp_con_stop: stops\", async () => {\n  it(\"is a sentence\", () => {});\n\
             it(\"pro_a, pro_b: two, pro_c too\", () => {\n";
        assert_eq!(of_page(page), ["sbp_con_stop", "pro_a", "pro_b"]);
    }
}
