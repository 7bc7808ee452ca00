//! One program of tests a crate, beside those inside the crate: linking one for each file would take longer than all of
//! them run. A file that no program names would never run, and nobody would be told.

use crate::{Finding, Tree};
use std::collections::{BTreeMap, BTreeSet};

/// Files of tests that stand alone without a line in the manifest, or stand in no program.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let mut crates: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (path, _) in tree.matching("crates/", ".rs") {
        let parts = path.split_once("/tests/").filter(|(name, _)| !name.contains("/src/"));
        if let Some((name, file)) = parts.filter(|(_, file)| is_head(file)) {
            crates.entry(name).or_default().insert(file);
        }
    }
    crates.iter().flat_map(|(name, files)| of_crate(tree, name, files)).collect()
}

/// The file a program or a module of it begins with, in the folder of tests.
fn is_head(file: &str) -> bool {
    match file.split_once('/') {
        None => true,
        Some((_, inside)) => inside == "main.rs" || inside == "mod.rs",
    }
}

fn of_crate(tree: &Tree, name: &str, files: &BTreeSet<&str>) -> Vec<Finding> {
    let Some(all) = tree.text(&format!("{name}/tests/all.rs")) else {
        let programs = files.iter().filter(|file| !file.ends_with("/mod.rs"));
        return programs.skip(1).map(|file| found(name, file)).collect();
    };
    let manifest = tree.text(&format!("{name}/Cargo.toml")).unwrap_or_default();
    let named = |file: &&&str| {
        let module = file.split(['/', '.']).next().unwrap_or_default();
        module == "all"
            || all.lines().any(|line| line == format!("mod {module};"))
            || manifest.lines().any(|line| line == format!("name = \"{module}\""))
    };
    files.iter().filter(|file| !named(file)).map(|file| found(name, file)).collect()
}

fn found(name: &str, file: &str) -> Finding {
    let why = "tests of a crate are one program: name the file in `tests/all.rs`; one that must be alone in its process \
               has a `[[test]]` in the manifest and says why";
    Finding::file(format!("{name}/tests/{file}"), why)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(files: &[(&str, &str)]) -> Vec<String> {
        super::check(&Tree::of(files)).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_file_of_tests_that_no_program_names_is_found() {
        let files = [
            ("crates/a/Cargo.toml", "autotests = false\n[[test]]\nname = \"alone\"\n"),
            ("crates/a/tests/all.rs", "mod held;\nmod shop;\n"),
            ("crates/a/src/read/tests/mod.rs", ""),
            ("crates/a/tests/alone/main.rs", ""),
            ("crates/a/tests/alone/shop.rs", ""),
            ("crates/a/tests/forgotten.rs", ""),
            ("crates/a/tests/held.rs", ""),
            ("crates/a/tests/shop/mod.rs", ""),
        ];
        let found = check(&files);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].contains("crates/a/tests/forgotten.rs"), "{found:?}");
    }

    #[test]
    fn a_second_program_of_tests_is_found() {
        let one = ("crates/a/tests/one.rs", "mod shop;\n");
        let shop = ("crates/a/tests/shop/mod.rs", "");
        assert!(check(&[one, shop]).is_empty());
        assert_eq!(check(&[one, shop, ("crates/a/tests/two.rs", "")]).len(), 1);
    }
}
