//! The dialects of the language.

use serde::{Deserialize, Serialize};

/// Which reading of the language holds where programs differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Dialect {
    /// The manuals and the files that shipped with the machines.
    #[default]
    Sb3,
    /// Files written for the maker's open successor.
    Fabmo,
    /// The manuals to the letter: doubtful spellings are errors.
    Strict,
}
