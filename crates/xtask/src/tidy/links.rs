//! Links between the Markdown pages lead somewhere.

use crate::{Finding, Tree};

/// Links to files that are not there.
pub fn check(tree: &Tree) -> Vec<Finding> {
    tree.matching("", ".md").flat_map(|(path, text)| check_page(tree, path, text)).collect()
}

fn check_page(tree: &Tree, path: &str, text: &str) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut fenced = false;
    for (number, line) in text.lines().enumerate() {
        fenced ^= line.trim_start().starts_with("```");
        for target in if fenced { Vec::new() } else { targets(line) } {
            if !leads_somewhere(tree, path, target) {
                let message = format!("the link to {target} leads nowhere");
                findings.push(Finding::line(path, number + 1, message));
            }
        }
    }
    findings
}

/// Returns the targets of the links of a line, inline code left out.
fn targets(line: &str) -> Vec<&str> {
    let prose = line.split('`').step_by(2);
    prose
        .flat_map(|part| part.split("](").skip(1).filter_map(|tail| tail.split(')').next()))
        .collect()
}

fn leads_somewhere(tree: &Tree, page: &str, target: &str) -> bool {
    let outside = target.contains("://") || target.starts_with("mailto:");
    let file = target.split('#').next().unwrap_or_default();
    outside || file.is_empty() || tree.exists(&resolve(page, file))
}

/// The path of a link, seen from the page that has it.
pub(super) fn resolve(page: &str, link: &str) -> String {
    let folder = page.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut parts: Vec<&str> = folder.split('/').filter(|p| !p.is_empty()).collect();
    for part in link.trim_end_matches('/').split('/') {
        match part {
            "." => {}
            ".." => drop(parts.pop()),
            name => parts.push(name),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_link(link: &str, good: bool) {
        let page = format!("see [it]({link}) there");
        let tree = Tree::of(&[("docs/a/page.md", &page), ("docs/b.md", ""), ("README.md", "")]);
        assert_eq!(check(&tree).is_empty(), good, "{link}");
    }

    #[test]
    fn links_are_resolved_from_their_page() {
        check_link("../b.md", true);
        check_link("../b.md#part", true);
        check_link("../../README.md", true);
        check_link("..", true);
        check_link("#here", true);
        check_link("https://example.org/x", true);
        check_link("b.md", false);
        check_link("../c.md", false);
    }

    #[test]
    fn code_is_no_link() {
        let tree = Tree::of(&[("a.md", "`[x](y)`\n```\n[x](y)\n```\n")]);
        assert_eq!(check(&tree), []);
    }
}
