//! Rights of every caller: every cell of the table is tried against a server, and the page of the book is what it
//! said.

mod rows;
mod table;
mod walk;
mod workshop;

use std::path::PathBuf;
use workshop::Workshop;

/// The page, from the crate's folder.
fn page() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/who-may-what.md")
}

/// Set to write the page anew.
const WRITES: &str = "KERF_WRITE_PAGES";

#[test]
fn what_the_book_says_of_who_may_what_is_so() {
    let mut workshop = Workshop::open(20.0);
    let mut parts = Vec::new();
    for (title, rows) in rows::parts() {
        let tried: Vec<table::Line> =
            rows.iter().map(|row| table::Line::tried(&mut workshop, row)).collect();
        parts.push((title, tried));
    }
    let now = table::page(&parts);
    if std::env::var_os(WRITES).is_some() {
        std::fs::write(page(), &now).unwrap();
    }
    let said = std::fs::read_to_string(page()).unwrap_or_default();
    let differs: Vec<_> = now.lines().filter(|line| !said.lines().any(|it| it == *line)).collect();
    assert!(
        differs.is_empty() && said == now,
        "{WRITES}=1 writes the page; it differs in {differs:#?}"
    );
    table::check(&parts);
}
