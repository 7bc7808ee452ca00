//! Real part files, from the people who made the language and from shops that used it.
//!
//! The files are nobody's part of this project; they are looked for beside the checkout
//! (`shared/corpus`, or where KERF_SHARED says), and without them nothing is tested here. What each
//! one needs and what has to come of it is a line of `files.txt`; what it names and the corpus does
//! not have is a line of `stand_ins.txt`.

mod bench;
mod row;
mod tree;

use crate::find;
use bench::{Ended, run, run_restored};
use kerf_ledger::traces::{self, Traces};
use row::{Row, rows};
use std::fmt::Write as _;
use std::path::PathBuf;
use tree::Tree;

/// The folder of part files, with the list of where each came from beside it.
fn corpus() -> Option<PathBuf> {
    find::real("sbp").and_then(|folder| Some(folder.parent()?.to_owned()))
}

/// Runs every line of the list through a claim and tells all that do not hold.
fn every(claim: impl Fn(&Tree, &Row) -> Result<(), String>) {
    let Some(corpus) = corpus() else { return };
    let tree = Tree::build(&corpus);
    let mut told = String::new();
    for row in rows() {
        if let Err(why) = claim(&tree, &row) {
            let _ = writeln!(told, "{}: {why}", row.file);
        }
    }
    assert!(told.is_empty(), "\n{told}");
}

#[test]
fn every_file_of_the_corpus_has_a_line() {
    let Some(corpus) = corpus() else { return };
    let tree = Tree::build(&corpus);
    let rows = rows();
    let without: Vec<&str> =
        tree.files().filter(|file| !rows.iter().any(|row| row.file == *file)).collect();
    assert!(without.is_empty(), "files without a line: {without:?}");
    let gone: Vec<&str> =
        rows.iter().map(|row| row.file).filter(|f| !tree.files().any(|g| g == *f)).collect();
    assert!(gone.is_empty(), "lines without a file: {gone:?}");
}

#[test]
fn files_end_as_their_line_says() {
    every(|tree, row| {
        let ended = run(tree, row);
        if ended.is_as(row) { Ok(()) } else { Err(ended.difference(row)) }
    });
}

/// With KERF_TRACES: the trace of each file is the recorded one.
#[test]
fn traces_are_the_recorded_ones() {
    let (Some(corpus), Some(_)) = (corpus(), traces::folder()) else { return };
    let (tree, mut traces) = (Tree::build(&corpus), Traces::default());
    for row in rows() {
        // Where the folders lie is none of the run's doing.
        let root = tree.root().display().to_string();
        let lines = run(&tree, &row).trace.into_iter().map(|line| line.replace(&root, ""));
        traces.add(row.file, lines);
    }
    traces.hold("corpus.txt");
}

#[test]
fn files_of_the_maker_run_to_their_end() {
    let Some(corpus) = corpus() else { return };
    let tree = Tree::build(&corpus);
    let whole = |file: &str| {
        let ends = |row: &Row| matches!(row.expected.as_str(), "ok" | "ended" | "limit R014");
        rows().iter().any(|row| row.file == file && ends(row))
    };
    let own = tree.files().filter(|file| file.starts_with("fablab-5ax__"));
    let not: Vec<&str> = own.filter(|file| !whole(file)).collect();
    assert!(not.is_empty(), "{not:?}");
}

#[test]
fn the_same_file_gives_the_same_trace() {
    every(|tree, row| same(&run(tree, row), &run(tree, row)));
}

#[test]
fn a_run_that_is_saved_and_restored_at_every_look_does_the_same() {
    every(|tree, row| same(&run(tree, row), &run_restored(tree, row)));
}

fn same(one: &Ended, other: &Ended) -> Result<(), String> {
    if one.trace == other.trace {
        return Ok(());
    }
    let pairs = one.trace.iter().zip(&other.trace);
    let differing = pairs.filter(|(a, b)| a != b).map(|(a, b)| format!("{a}\n  {b}")).next();
    Err(differing.unwrap_or_else(|| "one trace is longer".into()))
}

/// Counts, for whoever wants to know: `cargo test -p kerf-ledger --test all corpus::counts -- --nocapture`.
#[test]
fn counts() {
    let Some(corpus) = corpus() else { return };
    let tree = Tree::build(&corpus);
    let rows = rows();
    let ends = |end: &str| rows.iter().filter(|row| row.expected.starts_with(end)).count();
    println!("files read: {}", tree.files().count());
    println!("runs: {}, to their end: {}", rows.len(), ends("ok") + ends("ended"));
    println!("endless by intention, ended by the bound on lines: {}", ends("limit R014"));
    println!("with a diagnostic that ends them: {}", ends("failed"));
}
