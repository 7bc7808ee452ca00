//! The trait that every printer offers to those who write programs: it takes commands and gives text.
//!
//! The counterpart of [`Interpreter`](crate::Interpreter): OpenSBP and G-code each have a printer, and
//! whoever converts a program works with this trait. What a language has no words for is never left
//! out in silence: it becomes a comment in the text and a [`Lost`] beside it.

use crate::settings::LinearUnit;
use crate::{At, AxisSet, Frame, Sourced};

/// Something that a language has no words for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lost {
    /// The line of the source that it comes from.
    pub at: At,
    /// The part that is not said, as part of a sentence: `output 3 on`.
    pub what: String,
    /// The tool would go another way without it.
    pub is_motion: bool,
}

/// A program that was written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Its text.
    pub text: String,
    /// Parts that the text does not say, in order.
    pub lost: Vec<Lost>,
}

/// A place where a program waits for the operator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hold {
    /// The line that waits.
    pub at: At,
    /// Text for the operator; empty for nothing in particular.
    pub text: String,
    /// An input, 1 … 12, and the state that ends the waiting too.
    pub until: Option<(u8, bool)>,
}

/// A program being written.
pub trait Printer {
    /// Writes a command.
    fn command(&mut self, sourced: &Sourced);

    /// Writes where the zero of some axes comes to lie in the machine, wherever the tool stands.
    fn zero_at(&mut self, at: At, frame: &Frame, axes: AxisSet);

    /// Writes a comment into a line of its own.
    fn comment(&mut self, text: &str);

    /// Writes a comment behind what is written next.
    fn comment_beside(&mut self, text: &str);

    /// Writes a place where the program waits for the operator.
    fn hold(&mut self, hold: &Hold);

    /// Tells which tool the change that begins next puts in.
    fn next_tool(&mut self, name: &str);

    /// Tells of something that is not said.
    fn lose(&mut self, lost: Lost);

    /// Writes the end.
    fn finish(self: Box<Self>) -> Written;
}

/// Decimals of a length in a file, so that a program that is read again lies within 1e-6 mm of the
/// path.
pub const fn length_places(unit: LinearUnit) -> usize {
    match unit {
        LinearUnit::Mm => 7,
        LinearUnit::Inch => 8,
    }
}
