//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    clippy::unwrap_used,
    non_snake_case
)]

mod corpus;
#[path = "../../../tests/corpus/find.rs"]
mod find;
mod jobs;
mod ledger;
mod random;
mod simulated;
