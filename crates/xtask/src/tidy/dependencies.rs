//! Each third-party dependency has its line in `docs/dependencies.md`: crates and, for the console,
//! packages of npm.

use crate::{Finding, Tree, deps};
use anyhow::{Context, Result};
use std::collections::BTreeSet;

const PAGE: &str = "docs/dependencies.md";
const PACKAGES: &str = "console/package.json";

/// Dependencies without a line, and lines without a dependency.
pub fn check(tree: &Tree) -> Result<Vec<Finding>> {
    let mut used = deps::third_party(tree)?;
    used.extend(packages(tree)?);
    let listed = listed(tree.text(PAGE).unwrap_or_default());
    let missing = used.difference(&listed).map(|name| {
        Finding::file(PAGE, format!("`{name}` is used but not listed: say why, licence, health"))
    });
    let stale = listed
        .difference(&used)
        .map(|name| Finding::file(PAGE, format!("`{name}` is listed but no longer used")));
    Ok(missing.chain(stale).collect())
}

/// Packages that the console asks for itself.
fn packages(tree: &Tree) -> Result<BTreeSet<String>> {
    let Some(text) = tree.text(PACKAGES) else { return Ok(BTreeSet::new()) };
    let manifest: serde_json::Value = serde_json::from_str(text).context(PACKAGES)?;
    let lists = ["dependencies", "devDependencies"].map(|list| manifest[list].as_object());
    Ok(lists.into_iter().flatten().flat_map(|list| list.keys().cloned()).collect())
}

/// Names in the first column of the page's tables.
fn listed(page: &str) -> BTreeSet<String> {
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `"));
    rows.filter_map(|row| row.split_once('`')).map(|(name, _)| name.to_owned()).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn both_lists_must_agree() {
        let tree = Tree::of(&[
            ("Cargo.toml", "[workspace.dependencies]\nserde = \"1\"\nkerf-geom = \"0\"\n"),
            (PACKAGES, r#"{ "devDependencies": { "vite": "8" } }"#),
            (PAGE, "| `gone` | why | MIT | good |\n"),
        ]);
        let found: Vec<String> = check(&tree).unwrap().into_iter().map(|f| f.message).collect();
        assert_eq!(found.len(), 3);
        assert!(found[0].starts_with("`serde` is used"), "{found:?}");
        assert!(found[1].starts_with("`vite` is used"), "{found:?}");
        assert!(found[2].starts_with("`gone` is listed"), "{found:?}");
    }
}
