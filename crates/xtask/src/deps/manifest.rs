//! The dependencies that the Cargo manifests of the workspace name.

use crate::Tree;
use anyhow::{Context, Result};
use std::collections::BTreeSet;
use toml::{Table, Value};

const SECTIONS: &[&str] = &["dependencies", "dev-dependencies", "build-dependencies"];

/// The part of a member's manifest that the rules read.
#[derive(Debug)]
pub struct Manifest {
    /// Path of the manifest.
    pub path: String,
    /// Package name.
    pub name: String,
    /// Crates of this workspace it depends on, tests included.
    pub internal: BTreeSet<String>,
    /// Everything else it depends on.
    pub external: BTreeSet<String>,
}

/// The manifests of all members, sorted by path.
pub fn members(tree: &Tree) -> Result<Vec<Manifest>> {
    tree.matching("crates/", "/Cargo.toml").map(|(path, text)| read(path, text)).collect()
}

/// Names of all third-party dependencies of the workspace.
///
/// # Errors
/// When a manifest cannot be read.
pub fn third_party(tree: &Tree) -> Result<BTreeSet<String>> {
    let mut names: BTreeSet<String> =
        members(tree)?.into_iter().flat_map(|manifest| manifest.external).collect();
    let root: Table = tree.text("Cargo.toml").unwrap_or_default().parse().context("Cargo.toml")?;
    let shared = root.get("workspace").and_then(|w| w.get("dependencies"));
    names.extend(keys(shared).filter(|name| !is_internal(name)).map(str::to_owned));
    Ok(names)
}

fn read(path: &str, text: &str) -> Result<Manifest> {
    let table: Table = text.parse().with_context(|| path.to_owned())?;
    let name = table.get("package").and_then(|p| p.get("name")).and_then(Value::as_str);
    let name = name.with_context(|| format!("{path}: no package name"))?.to_owned();
    let (internal, external) = dependencies(&table).partition(|name| is_internal(name));
    Ok(Manifest { path: path.to_owned(), name, internal, external })
}

/// Names in all dependency sections, those for certain targets too.
fn dependencies(table: &Table) -> impl Iterator<Item = String> {
    let targets = table.get("target").and_then(Value::as_table);
    let targets = targets.into_iter().flat_map(Table::values).filter_map(Value::as_table);
    let tables: Vec<&Table> = std::iter::once(table).chain(targets).collect();
    tables.into_iter().flat_map(|table| {
        let sections = SECTIONS.iter().flat_map(|section| keys(table.get(*section)));
        sections.map(str::to_owned).collect::<Vec<_>>()
    })
}

fn keys(value: Option<&Value>) -> impl Iterator<Item = &str> {
    value.and_then(Value::as_table).into_iter().flat_map(|t| t.keys().map(String::as_str))
}

fn is_internal(name: &str) -> bool {
    name == "kerf" || name == "xtask" || name.starts_with("kerf-")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn all_sections_count() {
        let manifest = read(
            "crates/a/Cargo.toml",
            "[package]\nname = \"kerf-a\"\n[dependencies]\nkerf-geom.workspace = true\n\
             [dev-dependencies]\nkerf-sim.workspace = true\n\
             [target.'cfg(unix)'.dependencies]\nlibc = \"1\"\n",
        );
        let manifest = manifest.unwrap();
        assert_eq!(manifest.internal.into_iter().collect::<Vec<_>>(), ["kerf-geom", "kerf-sim"]);
        assert_eq!(manifest.external.into_iter().collect::<Vec<_>>(), ["libc"]);
    }
}
