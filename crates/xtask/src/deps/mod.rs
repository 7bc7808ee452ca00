//! Which crate and which floor of a crate may know which, and what the lower crates may not touch.

mod floors;
mod manifest;
mod purity;
mod rooms;

use crate::{Finding, Tree};
use anyhow::Result;
use manifest::Manifest;

pub use manifest::third_party;
pub use rooms::{Half, ROOMS, Room};

/// Every arrow that points the wrong way, between crates and between the floors of one, and every lower crate that reaches for the outside.
///
/// # Errors
/// When a manifest cannot be read.
pub fn check(tree: &Tree) -> Result<Vec<Finding>> {
    let mut findings = Vec::new();
    for manifest in manifest::members(tree)? {
        match rooms::room(&manifest.name) {
            Some(room) => check_crate(tree, &manifest, &room, &mut findings),
            None => findings.push(Finding::file(
                &manifest.path,
                format!("{} has no level: add it to ROOMS in xtask", manifest.name),
            )),
        }
    }
    findings.extend(floors::check(tree));
    Ok(findings)
}

fn check_crate(tree: &Tree, manifest: &Manifest, room: &Room, findings: &mut Vec<Finding>) {
    for name in &manifest.internal {
        if let Some(other) = rooms::room(name)
            && let Err(reason) = rooms::may_know(room, &other)
        {
            let message = format!("{} must not depend on {name}: {reason}", manifest.name);
            findings.push(Finding::file(&manifest.path, message));
        }
    }
    if room.level < rooms::OUTSIDE {
        let folder = manifest.path.trim_end_matches("Cargo.toml");
        findings.extend(purity::check(tree, folder));
    }
}
