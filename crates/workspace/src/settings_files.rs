//! The folder of settings files: part files (.sbd) that set a machine (US, UR). Those that come with
//! Kerf are there unless somebody has one of the same name.

use kerf_files::MACHINES;
use kerf_program::{HostError, SourceFile};
use std::collections::BTreeSet;

/// Its name in the data folder.
pub(crate) const FOLDER: &str = "settings";

/// End of the names of settings files.
const EXTENSION: &str = ".sbd";

/// Names of the settings files there are, where these lie in the folder.
pub(crate) fn names(own: Vec<String>) -> Vec<String> {
    let own = own.into_iter().filter(|name| name.to_ascii_lowercase().ends_with(EXTENSION));
    let shipped = MACHINES.iter().map(|file| file.name.to_owned());
    let all: BTreeSet<String> = own.chain(shipped).collect();
    all.into_iter().collect()
}

/// A settings file that was looked for.
pub(crate) enum Found {
    /// Somebody's own: its name in the data folder.
    Own(String),
    /// One that comes with Kerf.
    Shipped(SourceFile),
}

/// Looks for a settings file: somebody's own, else one that comes with Kerf.
pub(crate) fn find(own: Vec<String>, name: &str) -> Result<Found, HostError> {
    let name = plain(name)?;
    if let Some(own) = own.iter().find(|known| known.eq_ignore_ascii_case(&name)) {
        return Ok(Found::Own(format!("{FOLDER}/{own}")));
    }
    let Some(file) = MACHINES.iter().find(|file| file.name.eq_ignore_ascii_case(&name)) else {
        let text = format!("there are no settings {name}; {}", names(own).join(", "));
        return Err(HostError::NotFound(text));
    };
    let bytes = file.text.as_bytes().into();
    Ok(Found::Shipped(SourceFile { name: file.name.into(), bytes }))
}

/// The name in the data folder under which a settings file is kept.
pub(crate) fn place(name: &str) -> Result<String, HostError> {
    Ok(format!("{FOLDER}/{}", plain(name)?))
}

/// A name without folders, with its extension.
fn plain(name: &str) -> Result<String, HostError> {
    let name = name.trim();
    if name.is_empty() || name.starts_with('.') || name.contains(['/', '\\', ':', '\0']) {
        return Err(HostError::NotAllowed(format!("'{name}' is no name of a settings file")));
    }
    let has = name.to_ascii_lowercase().ends_with(EXTENSION);
    Ok(if has { name.to_owned() } else { format!("{name}{EXTENSION}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_nowhere_else() {
        for name in ["../x", "a/b", "c:x", "", ".x"] {
            assert!(plain(name).is_err(), "{name}");
        }
        assert_eq!(plain(" Mine ").ok().as_deref(), Some("Mine.sbd"));
    }
}
