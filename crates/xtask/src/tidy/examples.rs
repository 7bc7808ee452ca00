//! Each numbered example is complete: what it is, the part file, what it must do.

use crate::{Finding, Tree};
use std::collections::BTreeSet;

/// Finds what is missing in the folders of `examples/`.
pub fn check(tree: &Tree) -> Vec<Finding> {
    folders(tree).iter().flat_map(|folder| check_folder(tree, folder)).collect()
}

fn folders(tree: &Tree) -> BTreeSet<String> {
    let inside = tree.matching("examples/", "").filter_map(|(path, _)| {
        let (folder, _) = path["examples/".len()..].split_once('/')?;
        Some(folder.to_owned())
    });
    inside.collect()
}

fn check_folder(tree: &Tree, name: &str) -> Vec<Finding> {
    let folder = format!("examples/{name}");
    let mut findings = Vec::new();
    if !is_numbered(name) {
        findings.push(Finding::file(&folder, "examples are named NN-what-it-shows"));
    }
    for needed in ["README.md", "expected.txt"] {
        if tree.text(&format!("{folder}/{needed}")).is_none() {
            findings.push(Finding::file(&folder, format!("{needed} is missing")));
        }
    }
    if [".sbp", ".nc", ".rsg"].iter().all(|ending| tree.matching(&folder, ending).next().is_none())
    {
        findings.push(Finding::file(&folder, "there is no part file and no drawing"));
    }
    findings
}

fn is_numbered(name: &str) -> bool {
    let digits = name.chars().take_while(char::is_ascii_digit).count();
    digits == 2 && name[digits..].starts_with('-')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(files: &[&str]) -> usize {
        let files: Vec<(&str, &str)> = files.iter().map(|f| (*f, "")).collect();
        check(&Tree::of(&files)).len()
    }

    #[test]
    fn a_complete_example_has_three_files_and_a_number() {
        let all = ["examples/01-a/README.md", "examples/01-a/expected.txt", "examples/01-a/a.sbp"];
        assert_eq!(count(&all), 0);
        assert_eq!(count(&all[..2]), 1);
        assert_eq!(count(&all[1..]), 1);
        assert_eq!(count(&["examples/a/README.md"]), 3);
    }
}
