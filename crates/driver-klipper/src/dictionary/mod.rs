//! A board's own dictionary: its commands and answers with their numbers, its pins, its constants, its reasons.
//!
//! Numbers, order of fields, even fields differ from build to build. So nothing of a message is known but its name
//! and the fields that Kerf means; everything else is looked up here, once, when a board is joined.

mod encoder;
mod format;
mod message;
mod read;

pub use encoder::{EncodeError, Encoder, Wanted};
pub use format::{Field, Format, Kind};
pub use message::{Message, Value};

use crate::wire::vlq;
use std::collections::BTreeMap;

/// The reason for which a dictionary is of no use.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DictionaryError {
    /// It has no end.
    #[error("the board's dictionary has no end: this is another program than Klipper's for boards")]
    TooLong,
    /// Not a zlib stream.
    #[error("the board's dictionary cannot be unpacked: flash its firmware anew")]
    Packed,
    /// Not as a dictionary has to be.
    #[error("the board's dictionary cannot be read ({0}): flash its firmware anew")]
    Content(String),
    /// A command is missing or has other fields.
    #[error("the board's firmware has no command `{name}` with {fields}: flash a newer one")]
    Command {
        /// Name of the command.
        name: &'static str,
        /// Fields that were looked for.
        fields: String,
    },
    /// An answer is missing or lacks a field.
    #[error("the board's firmware has no answer `{name}` with {fields}: flash a newer one")]
    Answer {
        /// Name of the answer.
        name: &'static str,
        /// Fields that were looked for.
        fields: String,
    },
    /// A pin or another word of the board is missing.
    #[error("the board has no {kind} `{word}`")]
    Word {
        /// Name of the enumeration.
        kind: String,
        /// The word.
        word: String,
    },
}

/// The dictionary of a board.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dictionary {
    /// Name and version of the program in the board.
    version: String,
    commands: BTreeMap<String, Format>,
    responses: BTreeMap<u32, Format>,
    numbers: BTreeMap<String, f64>,
    texts: BTreeMap<String, String>,
    enumerations: BTreeMap<String, BTreeMap<String, u32>>,
}

impl Dictionary {
    /// Reads a dictionary as boards send it: JSON in a zlib stream.
    ///
    /// # Errors
    ///
    /// It is none.
    pub fn read(packed: &[u8]) -> Result<Self, DictionaryError> {
        read::dictionary(packed)
    }

    /// Version of the program in the board.
    pub fn version(&self) -> &str {
        &self.version
    }

    /// Finds a command by its name and the fields that are meant, and returns the way to write it.
    ///
    /// # Errors
    ///
    /// The board has no such command, or it has other fields.
    pub fn command(&self, wanted: &Wanted) -> Result<Encoder, DictionaryError> {
        let format = self.commands.get(wanted.name);
        format.and_then(|format| Encoder::new(format, wanted)).ok_or_else(|| {
            DictionaryError::Command { name: wanted.name, fields: wanted.fields.join(", ") }
        })
    }

    /// Makes sure that the board has an answer of that name with these fields at least.
    ///
    /// # Errors
    ///
    /// It has none, or a field is missing.
    pub fn answer(&self, wanted: &Wanted) -> Result<(), DictionaryError> {
        let has = |format: &&Format, field: &str| format.fields.iter().any(|it| it.name == field);
        let mut named = self.responses.values().filter(|format| format.name == wanted.name);
        let found = named.any(|format| wanted.fields.iter().all(|field| has(&format, field)));
        let fields = || wanted.fields.join(", ");
        found
            .then_some(())
            .ok_or_else(|| DictionaryError::Answer { name: wanted.name, fields: fields() })
    }

    /// Returns `true` where the board has a command of that name.
    pub fn has_command(&self, name: &str) -> bool {
        self.commands.contains_key(name)
    }

    /// Reads a message of the board; nothing where its number is unknown or its fields do not fill it.
    pub fn message(&self, mut bytes: &[u8]) -> Option<Message<'_>> {
        let number = vlq::take(&mut bytes)?;
        Message::read(self.responses.get(&number)?, bytes)
    }

    /// Returns a constant that is a number.
    pub fn constant(&self, name: &str) -> Option<f64> {
        self.numbers.get(name).copied()
    }

    /// Returns a constant that is a text.
    pub fn text(&self, name: &str) -> Option<&str> {
        self.texts.get(name).map(String::as_str)
    }

    /// Returns the constants that are texts, with their names.
    pub fn texts(&self) -> impl Iterator<Item = (&str, &str)> {
        self.texts.iter().map(|(name, text)| (name.as_str(), text.as_str()))
    }

    /// Returns the words of an enumeration in the order of their numbers.
    pub fn words(&self, kind: &str) -> Vec<&str> {
        let mut words: Vec<_> = self.enumerations.get(kind).into_iter().flatten().collect();
        words.sort_by_key(|(_, number)| **number);
        words.into_iter().map(|(word, _)| word.as_str()).collect()
    }

    /// Returns the number of a word in an enumeration: of a pin, a bus.
    ///
    /// # Errors
    ///
    /// There is none.
    pub fn number(&self, kind: &str, word: &str) -> Result<u32, DictionaryError> {
        let found = self.enumerations.get(kind).and_then(|words| words.get(word)).copied();
        found.ok_or_else(|| DictionaryError::Word { kind: kind.to_owned(), word: word.to_owned() })
    }

    /// Returns the word of a number in an enumeration.
    pub fn word(&self, kind: &str, number: u32) -> Option<&str> {
        let words = self.enumerations.get(kind)?;
        words.iter().find(|(_, n)| **n == number).map(|(word, _)| word.as_str())
    }
}
