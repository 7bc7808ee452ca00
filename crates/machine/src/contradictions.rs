//! What settings say together: contradictions, refused by name before anything moves.

use crate::Configuration;

/// Settings that cannot all hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contradiction {
    /// The settings.
    pub keys: Vec<&'static str>,
    /// What is wrong.
    pub message: String,
    /// How to mend it.
    pub hint: String,
}

/// Everything that contradicts itself in a configuration.
pub fn contradictions(_configuration: &Configuration) -> Vec<Contradiction> {
    Vec::new()
}
