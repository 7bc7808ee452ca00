//! The outcome of a case on a board.

use std::fmt;

/// The outcome of a case on a board.
pub enum Outcome {
    /// It holds; with a word about how.
    Held(String),
    /// It was not put to the test, and why.
    NotTried(String),
    /// The board told why it does nothing more.
    NotHeld(String),
    /// It gave a wrong answer.
    Wrong(String),
}

impl Outcome {
    /// Returns `true` if the board has failed.
    pub const fn fails(&self) -> bool {
        matches!(self, Self::NotHeld(_) | Self::Wrong(_))
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Held(how) if how.is_empty() => f.write_str("held"),
            Self::Held(how) => write!(f, "held: {how}"),
            Self::NotTried(why) => write!(f, "not tried: {why}"),
            Self::NotHeld(why) => write!(f, "not held: {why}"),
            Self::Wrong(why) => write!(f, "WRONG: {why}"),
        }
    }
}
