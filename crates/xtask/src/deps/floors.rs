//! Floors within a crate: a folder of sources that knows nothing of the rest of its crate.

use super::purity::{is_inside, test_modules, without_tests_and_comments};
use crate::{Finding, Tree};

/// A folder that stands below the rest of its crate, and the module that it is.
const FLOORS: &[(&str, &str)] = &[("crates/sbp/src/syntax/", "syntax")];

/// Every path by which a lower floor names something of its crate outside itself.
pub fn check(tree: &Tree) -> Vec<Finding> {
    FLOORS.iter().flat_map(|(folder, module)| check_floor(tree, folder, module)).collect()
}

fn check_floor(tree: &Tree, folder: &str, module: &str) -> Vec<Finding> {
    let tests: Vec<String> =
        tree.matching(folder, ".rs").flat_map(|(path, text)| test_modules(path, text)).collect();
    let files = tree.matching(folder, ".rs").filter(|(path, _)| !is_inside(path, &tests));
    files.flat_map(|(path, text)| check_file(path, text, folder, module)).collect()
}

fn check_file(path: &str, text: &str, folder: &str, module: &str) -> Vec<Finding> {
    let code = without_tests_and_comments(text);
    let depth = depth(&path[folder.len()..]);
    let mut findings = Vec::new();
    for (number, line) in code.lines().enumerate() {
        let named = line.split("crate::").skip(1);
        let outside = named.filter(|rest| !begins_with(rest, module)).count() > 0;
        let climbs = line.split_whitespace().any(|word| word.matches("super::").count() > depth);
        if outside || climbs {
            let message = format!("`{module}` knows nothing above it: name only `crate::{module}`");
            findings.push(Finding::line(path, number + 1, message));
        }
    }
    findings
}

/// Returns the number of steps up that lead from a file to the module of its floor.
fn depth(file: &str) -> usize {
    let folders = file.matches('/').count();
    if file.ends_with("mod.rs") { folders } else { folders + 1 }
}

/// Returns `true` if a path begins with a name and not with a longer one.
fn begins_with(path: &str, name: &str) -> bool {
    path.strip_prefix(name)
        .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_text(path: &str, text: &str, findings: usize) {
        let path = format!("crates/sbp/src/syntax/{path}");
        let found = check(&Tree::of(&[(&path, text)]));
        assert_eq!(found.len(), findings, "{path}: {text}");
    }

    #[test]
    fn a_lower_floor_names_only_itself() {
        check_text("tree.rs", "use crate::syntax::Value;\n", 0);
        check_text("tree.rs", "use crate::run::Context;\n", 1);
        check_text("tree.rs", "use crate::{Program, syntax::Value};\n", 1);
        check_text("tree.rs", "fn a(c: &mut crate::Context) {}\n", 1);
        check_text("tree.rs", "use crate::syntax_of::Value;\n", 1);
        check_text("tree.rs", "//! as crate::run does\n", 0);
    }

    #[test]
    fn steps_up_stay_on_the_floor() {
        check_text("tree.rs", "use super::Value;\n", 0);
        check_text("mod.rs", "use super::Value;\n", 1);
        check_text("tree.rs", "use super::super::run::Context;\n", 1);
        check_text("reader/mod.rs", "use super::Value;\n", 0);
        check_text("reader/line.rs", "use super::super::Value;\n", 0);
        check_text("reader/line.rs", "use super::super::super::run::Context;\n", 1);
    }

    #[test]
    fn tests_may_run_what_they_read() {
        check_text("tree.rs", "#[cfg(test)]\nmod tests {\n    use crate::testing::run;\n}\n", 0);
    }
}
