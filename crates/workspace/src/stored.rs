//! Values that survive the end of the program: what SetUsrVal, `$name` and the external control
//! keep under a key; and, read in the same way, what the machine says of itself.

use kerf_journal::{
    Journal, JournalError,
    facts::{Fact, is_fact},
};
use kerf_sbp::{EDITOR, LAST_ERROR, PART_FILE, RECORDED, RECORDING};
use std::collections::BTreeMap;

/// The value that holds where a preview has come to.
pub const PREVIEW: &str = "PreviewPlace";

/// The value that says which job ended early last, and at which of its shapes.
pub(crate) const LAST_SHAPE: &str = "LastShape";

/// Keys that Kerf writes for itself; those of folders have no value of their own.
const OWN: [&str; 9] = [
    PART_FILE, EDITOR, LAST_ERROR, LAST_SHAPE, PREVIEW, RECORDED, RECORDING, "uAppPath", "uUsrPath",
];

/// Tells whether Kerf writes a key for itself, so that nobody writes it over the network. Values of the user, variables
/// of programs and names that other software made up are free.
pub fn is_own(key: &str) -> bool {
    is_fact(key) || OWN.contains(&key)
}

/// Values by key, and the journal that keeps them. Other programs may set them meanwhile.
#[derive(Clone, Debug, Default)]
pub struct Stored {
    /// As they are known here.
    values: BTreeMap<String, String>,
    /// `None` keeps them in memory only.
    journal: Option<Journal>,
    /// Keys whose values are known here only.
    apart: &'static [&'static str],
    /// Reason for which a value could not be kept.
    trouble: Option<String>,
}

impl Stored {
    /// Values that end with the process.
    pub const fn in_memory(values: BTreeMap<String, String>) -> Self {
        Self { values, journal: None, apart: &[], trouble: None }
    }

    /// The values of a journal.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn of(journal: Journal) -> Result<Self, JournalError> {
        let values = journal.registry.values()?.into_iter().collect();
        Ok(Self { values, journal: Some(journal), apart: &[], trouble: None })
    }

    /// Knows the values as they are in the journal now.
    pub fn renew(&mut self) -> Result<(), JournalError> {
        if let Some(journal) = &self.journal {
            let (values, apart) = (journal.registry.values()?, self.apart);
            self.values.retain(|key, _| apart.contains(&key.as_str()));
            let kept = values.into_iter().filter(|(key, _)| !apart.contains(&key.as_str()));
            self.values.extend(kept);
        }
        Ok(())
    }

    /// These keys have no value at first, and whatever they get is known here only.
    pub fn keep_apart(&mut self, keys: &'static [&'static str]) {
        self.apart = keys;
        self.values.retain(|key, _| !keys.contains(&key.as_str()));
    }

    /// Tells whether the value of a key is kept in a journal, and is no fact of the machine.
    pub fn is_kept_value(&self, key: &str) -> bool {
        self.journal.is_some() && !self.is_apart(key) && !is_fact(key)
    }

    fn is_apart(&self, key: &str) -> bool {
        self.apart.contains(&key)
    }

    /// The same values in memory only, for a preview.
    #[must_use]
    pub fn copy(&self) -> Self {
        Self::in_memory(self.values.clone())
    }

    /// The journal that keeps them.
    pub const fn journal(&self) -> Option<&Journal> {
        self.journal.as_ref()
    }

    /// The value of a key, as it is known here.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.values.get(key).map(String::as_str)
    }

    /// Returns the value that somebody else gave a key, if anybody did.
    pub fn news(&self, key: &str) -> Option<Option<String>> {
        let journal = self.journal.as_ref().filter(|_| !self.is_apart(key))?;
        let now = journal.registry.look_up(key).ok()?;
        (now.as_deref() != self.get(key)).then_some(now)
    }

    /// Gives a key a value; `None` removes it.
    pub fn set(&mut self, key: &str, value: Option<&str>) {
        if self.learn(key, value) {
            self.keep(key);
        }
    }

    /// Knows a value from now on, without keeping it; whether it is a new one.
    pub fn learn(&mut self, key: &str, value: Option<&str>) -> bool {
        let before = match value {
            Some(value) => self.values.insert(key.to_owned(), value.to_owned()),
            None => self.values.remove(key),
        };
        before.as_deref() != value
    }

    /// Puts the value of a key into the journal: a fact of the machine where those are.
    pub fn keep(&mut self, key: &str) {
        let journal = self.journal.as_ref().filter(|_| !self.is_apart(key));
        let kept = journal.map(|journal| match Fact::of(key) {
            Some(fact) => journal.registry.state(fact, self.get(key)),
            None => journal.registry.set_value(key, self.get(key)),
        });
        if let Some(Err(error)) = kept {
            self.trouble = Some(error.to_string());
        }
    }

    /// Something could not be kept.
    pub fn tell_trouble(&mut self, trouble: String) {
        self.trouble = Some(trouble);
    }

    /// Returns why a value could not be kept; told once.
    pub fn new_trouble(&mut self) -> Option<String> {
        self.trouble.take()
    }

    /// Knows these values from now on, without keeping them.
    pub fn begin_from(&mut self, values: BTreeMap<String, String>) {
        self.values = values;
    }

    /// Keys and values in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.values.iter().map(|(k, v)| (k.as_str(), v.as_str()))
    }
}
