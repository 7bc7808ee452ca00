//! Files that the command line names, read.

use crate::exit::Usage;
use anyhow::{Result, bail};
use kerf_workspace::MOST_BYTES;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// The bytes of a file, within reason.
pub fn bytes(file: &Path) -> Result<Vec<u8>> {
    if file.is_dir() {
        bail!(Usage(format!("{} is a folder, not a file", file.display())));
    }
    let cannot = |e: io::Error| Usage(format!("cannot read {}: {e}", file.display()));
    let most = MOST_BYTES as u64;
    let mut bytes = Vec::new();
    // A device or a pipe may never end.
    let opened = fs::File::open(file).map_err(cannot)?;
    opened.take(most + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() > MOST_BYTES {
        bail!(Usage(format!("{} is too large", file.display())));
    }
    Ok(bytes)
}

/// The text of a file.
pub fn text(file: &Path) -> Result<String> {
    Ok(String::from_utf8_lossy(&bytes(file)?).into_owned())
}
