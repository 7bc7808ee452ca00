//! Everything a reader would trip over.

mod decisions;
mod dependencies;
mod examples;
mod functions;
mod links;
mod named;
mod openings;
mod sources;
mod test_programs;
mod wall_clock;

use crate::{Finding, Tree};
use anyhow::Result;

pub use sources::long_files;

/// All findings of tidiness.
///
/// # Errors
/// When a manifest cannot be read.
pub fn check(tree: &Tree) -> Result<Vec<Finding>> {
    Ok([
        sources::check(tree),
        decisions::check(tree),
        dependencies::check(tree)?,
        examples::check(tree),
        functions::check(tree),
        links::check(tree),
        named::check(tree),
        openings::check(tree),
        test_programs::check(tree),
        wall_clock::check(tree),
    ]
    .concat())
}
