//! `cargo xtask`: the rules of the project and its generated pages, by hand.

use anyhow::{Result, bail};
use std::process::ExitCode;
use xtask::{Finding, Tree, conformance, deps, pages, run_tests, structure, tidy};

const USAGE: &str = "usage: cargo xtask COMMAND
  check              all rules below
  deps               direction of dependencies, purity of the lower crates
  tidy               file sizes, links, examples, the list of dependencies
  structure          circles of files, types with methods in many files: lists them all
  test               builds and runs every test program, as many side by side as there are processors
  conformance check  docs/conformance.toml against the ledgers and the tests
  conformance mark   sets the rows whose tests exist to done
  conformance page   writes docs/conformance.md
  conformance sync   adds rows of the ledgers that are missing
  book               writes the generated pages of docs/book
  wire               writes the TypeScript of the messages between server and console";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match run(&words) {
        Ok(findings) => report(&findings),
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::from(2)
        }
    }
}

fn run(words: &[&str]) -> Result<Vec<Finding>> {
    let tree = Tree::here()?;
    Ok(match words {
        ["check"] => check(&tree)?,
        ["deps"] => deps::check(&tree)?,
        ["tidy"] => {
            tell_long_files(&tree);
            tidy::check(&tree)?
        }
        ["structure"] => {
            eprint!("{}", structure::listing(&tree)?);
            structure::check(&tree)?
        }
        ["test"] => run_tests::run(&tree)?,
        ["conformance", "check"] => conformance::check(&tree)?,
        ["conformance", "mark"] => written(conformance::mark(&tree)?),
        ["conformance", "page"] => written(pages::write(&tree, conformance::PAGE)?),
        ["book"] => written(pages::write(&tree, "docs/book/")?),
        ["wire"] => written(pages::write(&tree, pages::WIRE)?),
        ["conformance", "sync"] => written(conformance::sync(&tree)?),
        _ => bail!("{USAGE}"),
    })
}

fn tell_long_files(tree: &Tree) {
    for (path, lines) in tidy::long_files(tree) {
        eprintln!("{path}: {lines} lines, worth splitting");
    }
}

fn check(tree: &Tree) -> Result<Vec<Finding>> {
    let rules = [deps::check, tidy::check, structure::check, conformance::check, pages::check];
    let findings: Result<Vec<_>> = rules.iter().map(|rule| rule(tree)).collect();
    Ok(findings?.concat())
}

fn written(what: String) -> Vec<Finding> {
    eprintln!("{what}");
    Vec::new()
}

fn report(findings: &[Finding]) -> ExitCode {
    for finding in findings {
        eprintln!("{finding}");
    }
    if findings.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
