//! Everything around a run that it reaches: values, folders, other programs.

use kerf_files::Folders;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Values, folders and programs that a run reaches, as it finds them.
#[derive(Clone, Debug)]
pub struct Surroundings {
    /// Values that programs had kept.
    pub values: BTreeMap<String, String>,
    /// Folders of its files.
    pub folders: Folders,
    /// Effect of SHELL.
    pub shell: Shell,
}

/// Effect of SHELL.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Shell {
    /// It is refused.
    #[default]
    Refused,
    /// It is allowed, but starts nothing: a preview.
    Skipped,
    /// It starts programs.
    Started,
}
