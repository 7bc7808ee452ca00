//! Every decision of `docs/adr` is in the table of the page that leads to it.

use crate::{Finding, Tree};

const PAGE: &str = "docs/where-is-it-decided.md";

/// Decisions that the page does not link.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let page = tree.text(PAGE).unwrap_or_default();
    let decisions = tree.matching("docs/adr/", ".md");
    let names = decisions.filter_map(|(path, _)| path.strip_prefix("docs/"));
    let numbered = names.filter(|name| name.starts_with("adr/0"));
    let missing = numbered.filter(|name| !page.contains(&format!("({name})")));
    let found = |name| Finding::file(PAGE.to_owned(), format!("its table has no row for {name}"));
    missing.map(found).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decision_without_a_row_is_found() {
        let files = [
            (PAGE, "| [1. Kept](adr/0001-kept.md) | why |\n"),
            ("docs/adr/0001-kept.md", "# 1. Kept\n"),
            ("docs/adr/0002-lost.md", "# 2. Lost\n"),
            ("docs/adr/README.md", "# Decisions\n"),
        ];
        let found: Vec<String> = check(&Tree::of(&files)).iter().map(ToString::to_string).collect();
        assert_eq!(found.len(), 1);
        assert!(found[0].contains("adr/0002-lost.md"), "{found:?}");
    }
}
