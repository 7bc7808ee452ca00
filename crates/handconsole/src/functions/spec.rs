//! What a function is: its steps, and what it wants done.

use crate::{ConsoleRequest, View};
use kerf_machine::Errand;
use kerf_program::rounded;

/// One function.
#[derive(Debug)]
pub struct Function {
    /// Its number, with a decimal part perhaps.
    pub number: &'static str,
    /// Its name: with the number and a blank 20 characters at most.
    pub name: &'static str,
    /// Its effect, for the book.
    pub doc: &'static str,
    /// Steps in which it asks for numbers and heights, in this order.
    pub steps: &'static [Step],
    /// Returns what it wants done with the answers; or why that cannot be.
    pub does: fn(&[f64], &View) -> Result<Done, Refusal>,
}

/// Reason why something cannot be, in words that a small screen has room for.
pub type Refusal = String;

/// Requests of a function, and a line about them.
#[derive(Debug)]
pub struct Done {
    /// The requests, in this order.
    pub requests: Vec<ConsoleRequest>,
    /// Text of the second line afterwards, until the next key: 20 characters at most.
    pub says: String,
}

impl Done {
    pub(super) fn saying(self, says: impl Into<String>) -> Self {
        Self { says: says.into(), ..self }
    }
}

impl From<Vec<ConsoleRequest>> for Done {
    fn from(requests: Vec<ConsoleRequest>) -> Self {
        Self { requests, says: String::new() }
    }
}

/// Something that a function asks for.
#[derive(Debug)]
pub enum Step {
    /// A number.
    Number {
        /// Name of the number that is typed, with its unit: 20 characters at most.
        prompt: &'static str,
        /// Returns the present value, shown until something is typed; Enter alone keeps it.
        now: fn(&View) -> Option<f64>,
    },
    /// A height: Z goes there, is moved with the keys 5 and 0 beside the others, and Enter records it.
    Height {
        /// Name of the height that is recorded: 20 characters at most.
        prompt: &'static str,
        /// The errands that go there.
        there: fn(&View) -> Vec<Errand>,
    },
}

/// A number as the screen shows it: to a thousandth, without zeros at its end.
pub fn shown(value: f64) -> String {
    rounded(value, 3).to_string()
}

/// A place to a millionth of a millimetre: places are sums of moves.
pub(super) fn to_millionth(mm: f64) -> f64 {
    rounded(mm, 6)
}
