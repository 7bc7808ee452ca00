//! The folder of settings files: part files (.sbd) that set a machine (US, UR). Those that come with
//! Kerf are there unless somebody has one of the same name.

use crate::shelf::Shelf;
use kerf_files::MACHINES;
use kerf_program::{HostError, SourceFile};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Its name in the data folder.
const FOLDER: &str = "settings";

/// End of the names of settings files.
const EXTENSION: &str = ".sbd";

impl Shelf {
    /// Names of the settings files there are.
    pub fn settings_files(&self) -> Vec<String> {
        let own = self.names_in_data(FOLDER);
        let own = own.into_iter().filter(|name| name.to_ascii_lowercase().ends_with(EXTENSION));
        let shipped = MACHINES.iter().map(|file| file.name.to_owned());
        let all: BTreeSet<String> = own.chain(shipped).collect();
        all.into_iter().collect()
    }

    /// Keeps a settings file; returns where.
    pub(crate) fn keep_settings(&mut self, name: &str, text: &str) -> Result<String, HostError> {
        let name = plain(name)?;
        let place = format!("{FOLDER}/{name}");
        self.put_data(&place, text).map_err(HostError::Refused)?;
        Ok(PathBuf::from(self.app_path()).join(place).display().to_string())
    }

    /// A settings file: somebody's own, else one that comes with Kerf.
    pub(crate) fn settings_source(&mut self, name: &str) -> Result<SourceFile, HostError> {
        let name = plain(name)?;
        let same = |known: &String| known.eq_ignore_ascii_case(&name);
        if let Some(own) = self.names_in_data(FOLDER).into_iter().find(same) {
            return self.data_source(&format!("{FOLDER}/{own}"));
        }
        let shipped = MACHINES.iter().find(|file| file.name.eq_ignore_ascii_case(&name));
        let missing = || {
            let text =
                format!("there are no settings {name}; {}", self.settings_files().join(", "));
            HostError::NotFound(text)
        };
        let file = shipped.ok_or_else(missing)?;
        Ok(SourceFile { name: file.name.into(), bytes: file.text.as_bytes().into() })
    }
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
