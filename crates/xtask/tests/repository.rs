//! The rules of the project, as tests of the checkout itself.

use xtask::{Finding, Tree, conformance, deps, pages, structure, tidy};

fn check(rule: impl Fn(&Tree) -> anyhow::Result<Vec<Finding>>) {
    let findings = Tree::here().and_then(|tree| rule(&tree)).expect("the checkout can be read");
    let lines: Vec<String> = findings.iter().map(Finding::to_string).collect();
    assert!(lines.is_empty(), "\n{}\n", lines.join("\n"));
}

#[test]
fn dependencies_point_downwards_and_lower_crates_are_pure() {
    check(deps::check);
}

#[test]
fn the_checkout_is_tidy() {
    check(tidy::check);
}

#[test]
fn no_circle_and_no_spread_type_is_new() {
    check(structure::check);
}

#[test]
fn the_score_is_honest() {
    check(conformance::check);
}

#[test]
fn generated_pages_are_fresh() {
    check(pages::check);
}
