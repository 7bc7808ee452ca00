//! The card of a controller: files that it keeps itself, and runs without whoever drives it.

/// Said where a controller has a slot for a card and none in it.
pub const NO_CARD_IN: &str = "there is no card in it, or none that it can read";

/// Said where the firmware of a controller has a card and takes no files for it on its line.
pub const TAKES_NO_FILES: &str = "its firmware takes no files on this line: build it with YMODEM, or put the file on the card in \
                                  this computer";

/// A file on the card.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CardFile {
    /// Its name, with the folders before it.
    pub name: String,
    /// Its size, bytes.
    pub bytes: u64,
}

/// A file that the controller runs from its card, whoever has begun it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CardJob {
    /// Its name.
    pub name: String,
    /// Share of the file that was read, percent; nothing where it is not told.
    pub percent: Option<f64>,
    /// The line that is made, where the controller tells it.
    pub line: Option<u32>,
}

/// Something to be done on the card.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CardTask {
    /// Tell the files.
    List,
    /// Tell the content of a file.
    Show(String),
    /// Take a file away.
    Delete(String),
    /// Run a file.
    Run(String),
    /// Take a file.
    Upload {
        /// Its name there.
        name: String,
        /// Its content.
        content: Vec<u8>,
    },
}

/// News of a task.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CardNews {
    /// So many bytes of so many are there.
    Going(usize, usize),
    /// It is done; what was asked for is in it.
    Done(CardAnswer),
    /// It is not done, for a reason.
    Failed(String),
}

/// The answer to a task.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CardAnswer {
    /// The files, by their names, where they were asked for.
    pub files: Vec<CardFile>,
    /// The content of a file, where it was asked for.
    pub text: String,
}
