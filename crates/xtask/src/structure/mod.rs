//! The structure inside a crate: circles of files that know each other, and types whose methods stand in many files.
//!
//! A file knows another one when it names something that the other defines; the paths are read from the tokens, macros
//! included, and followed through imports, globs and re-exports to the file that defines. Code for tests is left out,
//! and a file that only declares modules and re-exports knows nobody. Calls of methods are not seen.
//!
//! Both rules are ratchets: `allowed.toml` lists per crate what is still above the limit. A new circle is red, and so
//! is a row that allows more than there is.

mod allowed;
mod circles;
mod modules;
mod resolve;
mod syntax;

use crate::{Finding, Tree};
use allowed::Measured;
use anyhow::Result;
use modules::Modules;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// Largest number of files that may know each other in a circle, and over which the methods of a type may be spread.
const MOST_FILES: usize = 3;

/// Files by path, each with those that it knows and the names it takes from them.
type Graph = BTreeMap<String, BTreeMap<String, BTreeSet<String>>>;

/// Findings where the structure of a crate differs from what the table allows.
///
/// # Errors
/// When a source or the table cannot be parsed.
pub fn check(tree: &Tree) -> Result<Vec<Finding>> {
    allowed::compare(tree, &measure(tree)?)
}

/// Tells every circle and every spread type above the limit, with its files and the arrows between them.
///
/// # Errors
/// When a source cannot be parsed.
pub fn listing(tree: &Tree) -> Result<String> {
    let mut text = String::new();
    for (name, measured) in measure(tree)?.iter().filter(|(_, m)| !m.is_empty()) {
        let _ = writeln!(text, "[{name}]\n{measured}");
    }
    Ok(text)
}

fn measure(tree: &Tree) -> Result<BTreeMap<String, Measured>> {
    let names: BTreeSet<&str> =
        tree.matching("crates/", ".rs").filter_map(|(p, _)| p.split('/').nth(1)).collect();
    names
        .into_iter()
        .map(|name| Ok((name.to_owned(), measured(&Modules::read(tree, name)?, name))))
        .collect()
}

fn measured(modules: &Modules, name: &str) -> Measured {
    let folder = format!("crates/{name}/src/");
    let short = |path: &String| path.trim_start_matches(&folder).to_owned();
    let graph = modules.graph();
    let mut measured = Measured::default();
    for circle in circles::circles(&graph).into_iter().filter(|circle| circle.len() > MOST_FILES) {
        measured.arrows.extend(arrows(&graph, &circle).map(|arrow| arrow.replace(&folder, "")));
        measured.circles.push(circle.iter().map(short).collect());
    }
    for ((_, name), files) in modules.impls() {
        let widest: &mut Vec<String> = measured.types.entry(name).or_default();
        if files.len() > widest.len().max(MOST_FILES) {
            *widest = files.iter().map(short).collect();
        }
    }
    measured.types.retain(|_, files| !files.is_empty());
    measured
}

/// The arrows between the files of a circle, in words.
fn arrows<'a>(graph: &'a Graph, circle: &'a [String]) -> impl Iterator<Item = String> + 'a {
    let known = circle
        .iter()
        .flat_map(|from| graph.get(from).into_iter().flatten().map(move |arrow| (from, arrow)));
    known.filter(|(_, (to, _))| circle.contains(to)).map(|(from, (to, names))| {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        format!("{from} -> {to}: {}", names.join(" "))
    })
}
