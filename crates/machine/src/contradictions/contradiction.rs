//! A contradiction in words, with the settings that it is about.

/// Settings that cannot all hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contradiction {
    /// The settings, the one most likely wrong first.
    pub keys: Vec<&'static str>,
    /// The contradiction in words; names the settings.
    pub message: String,
    /// Way to mend it.
    pub hint: &'static str,
}

impl Contradiction {
    pub(super) fn new(
        keys: &[&'static str],
        message: impl Into<String>,
        hint: &'static str,
    ) -> Self {
        Self { keys: keys.into(), message: message.into(), hint }
    }
}
