//! The table of what is still above the limit, held against what is measured.

use crate::{Finding, Tree};
use anyhow::{Context, Result};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fmt;

const TABLE: &str = "crates/xtask/src/structure/allowed.toml";

/// Circles and spread types of a crate that are above the limit.
#[derive(Debug, Default)]
pub struct Measured {
    /// Files of each circle, the largest first.
    pub circles: Vec<Vec<String>>,
    /// Arrows between their files, in words.
    pub arrows: Vec<String>,
    /// Files with an `impl` of each type.
    pub types: BTreeMap<String, Vec<String>>,
}

impl Measured {
    pub fn is_empty(&self) -> bool {
        self.circles.is_empty() && self.types.is_empty()
    }
}

impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for circle in &self.circles {
            writeln!(f, "a circle of {}: {}", circle.len(), circle.join(" "))?;
        }
        for arrow in &self.arrows {
            writeln!(f, "  {arrow}")?;
        }
        for (name, files) in &self.types {
            writeln!(f, "`impl {name}` in {}: {}", files.len(), files.join(" "))?;
        }
        Ok(())
    }
}

/// A crate's rows of the table.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Allowed {
    /// Numbers of files of circles, the largest first.
    circles: Vec<usize>,
    /// Numbers of files with an `impl` of a type.
    impls: BTreeMap<String, usize>,
}

/// Findings where the table and the measured structure differ.
pub fn compare(tree: &Tree, measured: &BTreeMap<String, Measured>) -> Result<Vec<Finding>> {
    let table: BTreeMap<String, Allowed> =
        toml::from_str(tree.text(TABLE).unwrap_or_default()).context(TABLE)?;
    let (none, nothing) = (Measured::default(), Allowed::default());
    let mut findings = Vec::new();
    for name in measured.keys().chain(table.keys().filter(|name| !measured.contains_key(*name))) {
        let (there, allowed) =
            (measured.get(name).unwrap_or(&none), table.get(name).unwrap_or(&nothing));
        findings.extend(compare_circles(name, &there.circles, &allowed.circles));
        findings.extend(compare_types(name, &there.types, &allowed.impls));
    }
    Ok(findings)
}

fn compare_circles(name: &str, there: &[Vec<String>], allowed: &[usize]) -> Vec<Finding> {
    let sizes: Vec<usize> = there.iter().map(Vec::len).collect();
    let is_more = |at: usize| sizes[at] > allowed.get(at).copied().unwrap_or(0);
    let more: Vec<usize> = (0..sizes.len()).filter(|at| is_more(*at)).collect();
    let found = more.iter().map(|at| {
        let (files, n) = (&there[*at], sizes[*at]);
        let message = format!("{n} files know each other in a circle, 3 may: {}", files.join(" "));
        Finding::file(format!("crates/{name}/src/{}", files[0]), message)
    });
    let stale = (more.is_empty() && sizes != allowed)
        .then(|| stale(name, format!("circles = {allowed:?}, there are {sizes:?}")));
    found.chain(stale).collect()
}

fn compare_types(
    name: &str,
    there: &BTreeMap<String, Vec<String>>,
    allowed: &BTreeMap<String, usize>,
) -> Vec<Finding> {
    let number = |of: &str| there.get(of).map_or(0, Vec::len);
    let more =
        there.iter().filter(|(of, files)| files.len() > allowed.get(*of).copied().unwrap_or(0));
    let found = more.map(|(of, files)| {
        let message = format!(
            "`impl {of}` stands in {} files, in 3 it may: {}",
            files.len(),
            files.join(" ")
        );
        Finding::file(format!("crates/{name}/src/{}", files[0]), message)
    });
    let less = allowed.iter().filter(|(of, allowed)| number(of) < **allowed);
    let stale = less
        .map(|(of, allowed)| stale(name, format!("{of} = {allowed}, there are {}", number(of))));
    found.chain(stale).collect()
}

fn stale(name: &str, row: String) -> Finding {
    Finding::file(TABLE, format!("allows {name} more than there is: {row}; only shrink it"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(table: &str, circle: usize, of: &[(&str, usize)], expected: &[&str]) {
        let files = |n: usize| (0..n).map(|i| format!("{i}.rs")).collect::<Vec<_>>();
        let circles = if circle > 0 { vec![files(circle)] } else { Vec::new() };
        let types = of.iter().map(|(name, n)| ((*name).to_owned(), files(*n))).collect();
        let measured =
            [("a".to_owned(), Measured { circles, types, ..Measured::default() })].into();
        let found = compare(&Tree::of(&[(TABLE, table)]), &measured).unwrap();
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (finding, expected) in found.iter().zip(expected) {
            assert!(finding.to_string().contains(expected), "{finding} lacks {expected}");
        }
    }

    #[test]
    fn more_than_allowed_is_found() {
        check("", 4, &[], &["crates/a/src/0.rs: 4 files know each other"]);
        check("[a]\ncircles = [4]", 5, &[], &["5 files know each other"]);
        check("[a]\nimpls = { T = 4 }", 0, &[("T", 5)], &["`impl T` stands in 5 files"]);
        check("[a]\nimpls = { T = 4 }", 0, &[("T", 4), ("U", 4)], &["`impl U` stands in 4 files"]);
        check("[a]\ncircles = [4]\nimpls = { T = 5 }", 4, &[("T", 5)], &[]);
    }

    #[test]
    fn a_row_that_allows_more_than_there_is_is_found() {
        check("[a]\ncircles = [5]", 4, &[], &["circles = [5], there are [4]"]);
        check("[a]\ncircles = [4, 4]", 4, &[], &["circles = [4, 4], there are [4]"]);
        check("[a]\nimpls = { T = 5 }", 0, &[("T", 4)], &["T = 5, there are 4"]);
        check("[b]\ncircles = [4]", 0, &[], &["allows b more than there is"]);
    }
}
