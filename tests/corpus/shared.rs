//! Place of what is no part of the project: `shared` beside the checkout or beside one of its parents; `KERF_SHARED` names
//! another one.

use std::path::{Path, PathBuf};

/// A file or folder inside of `shared`, if it is at hand.
pub fn shared(inside: &str) -> Option<PathBuf> {
    let named = std::env::var_os("KERF_SHARED").map(PathBuf::from);
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let around = || here.ancestors().map(|folder| folder.join("shared")).collect();
    let folders: Vec<PathBuf> = named.map_or_else(around, |folder| vec![folder]);
    folders.into_iter().map(|folder| folder.join(inside)).find(|place| place.exists())
}
