//! The rules this project keeps about itself, and the pages made from its own tables.
//!
//! Each rule is a function from the [`Tree`] of the checkout to a list of [`Finding`]s: [`deps`]
//! for the direction of dependencies and the purity of the lower crates, [`tidy`] for everything a
//! reader would trip over, [`conformance`] for the score against the ledgers of the manuals, [`pages`] for
//! generated pages, [`structure`] for circles of files. They run as ordinary tests (`crates/xtask/tests/repository.rs`), so `cargo test` is enough to
//! find out, and as `cargo xtask check` when only the rules are wanted. [`run_tests`] runs the tests of the workspace side by side.
//!
//! Generated pages are written by the same code that checks them.

mod book;
pub mod conformance;
pub mod deps;
mod endings;
pub mod pages;
pub mod run_tests;
pub mod structure;
pub mod tidy;
mod tree;

pub use tree::{Finding, Tree};
