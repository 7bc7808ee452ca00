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
    let cannot = |e: io::Error| Usage(format!("cannot read {}: {}", file.display(), why(file, &e)));
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

/// Tells why a file cannot be read; of one that is not there also which one may be meant.
pub fn why(file: &Path, error: &io::Error) -> String {
    if error.kind() != io::ErrorKind::NotFound {
        return error.to_string();
    }
    let folder = file.parent().filter(|it| !it.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = fs::read_dir(folder) else {
        return format!("there is no folder {}", folder.display());
    };
    let names = entries.flatten().filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<String> = names.collect();
    names.sort();
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.into());
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let meant = kerf_diag::did_you_mean(&name, names.iter().map(String::as_str));
    let meant = meant.map_or_else(String::new, |meant| format!("; {meant}"));
    format!("there is no such file in {}{meant}", folder.display())
}

/// The text of a file.
pub fn text(file: &Path) -> Result<String> {
    Ok(String::from_utf8_lossy(&bytes(file)?).into_owned())
}
