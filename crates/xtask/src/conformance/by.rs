//! Places where a test looks at what it shows.

use super::tests_found::Tests;
use serde::Deserialize;
use std::collections::BTreeSet;

/// Level at which a test looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum By {
    /// At the page, in a browser.
    Browser,
    /// At the command, from outside.
    Cli,
    /// At the functions behind them.
    Library,
}

impl By {
    /// Returns the level at which the tests of a file look.
    pub fn of_file(path: &str) -> Self {
        if path.starts_with("console/tests/browser/") {
            Self::Browser
        } else if path.starts_with("crates/kerf/tests/") {
            Self::Cli
        } else {
            Self::Library
        }
    }

    /// Returns the levels at which these tests look, each once.
    pub fn of_tests(names: &[String], tests: &Tests) -> Vec<Self> {
        let places: BTreeSet<Self> =
            names.iter().filter_map(|name| tests.get(name)).flatten().copied().collect();
        places.into_iter().collect()
    }

    /// The word in the score.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Browser => "browser",
            Self::Cli => "cli",
            Self::Library => "library",
        }
    }
}
