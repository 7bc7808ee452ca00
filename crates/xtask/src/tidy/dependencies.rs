//! Each third-party dependency has its line in `docs/dependencies.md`.

use crate::{Finding, Tree, deps};
use anyhow::Result;
use std::collections::BTreeSet;

const PAGE: &str = "docs/dependencies.md";

/// Dependencies without a line, and lines without a dependency.
pub fn check(tree: &Tree) -> Result<Vec<Finding>> {
    let used = deps::third_party(tree)?;
    let listed = listed(tree.text(PAGE).unwrap_or_default());
    let missing = used.difference(&listed).map(|name| {
        Finding::file(PAGE, format!("`{name}` is used but not listed: say why, licence, health"))
    });
    let stale = listed
        .difference(&used)
        .map(|name| Finding::file(PAGE, format!("`{name}` is listed but no longer used")));
    Ok(missing.chain(stale).collect())
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
            (PAGE, "| `gone` | why | MIT | good |\n"),
        ]);
        let found: Vec<String> = check(&tree).unwrap().into_iter().map(|f| f.message).collect();
        assert_eq!(found.len(), 2);
        assert!(found[0].starts_with("`serde` is used"), "{found:?}");
        assert!(found[1].starts_with("`gone` is listed"), "{found:?}");
    }
}
