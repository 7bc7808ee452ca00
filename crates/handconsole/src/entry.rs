//! Numbers that are typed.

use crate::Key;
use std::fmt;

/// Characters that a number has at most.
const LONGEST: usize = 9;

/// A number as far as it is typed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Typed {
    negative: bool,
    /// Digits, and a point perhaps.
    text: String,
}

impl Typed {
    /// Nothing is typed.
    pub const fn is_empty(&self) -> bool {
        self.text.is_empty() && !self.negative
    }

    /// Takes a key: a digit, the point, the sign, which changes with each press, or Stop, which
    /// takes the last character away.
    pub fn press(mut self, key: Key) -> Self {
        match key {
            Key::PlusMinus => self.negative = !self.negative,
            Key::File if !self.text.contains('.') => self.type_in('.'),
            _ => return self.press_whole(key),
        }
        self
    }

    /// The same for whole numbers: neither point nor sign.
    pub fn press_whole(mut self, key: Key) -> Self {
        match key {
            Key::Digit(_) => self.type_in(key.character()),
            Key::Stop if self.text.pop().is_none() => self.negative = false,
            _ => {}
        }
        self
    }

    fn type_in(&mut self, character: char) {
        if self.text.len() < LONGEST {
            self.text.push(character);
        }
    }

    /// The number, when it is one.
    pub fn value(&self) -> Option<f64> {
        let value: f64 = self.text.parse().ok()?;
        Some(if self.negative { -value } else { value })
    }

    /// The whole number, when it is one.
    pub fn whole(&self) -> Option<u32> {
        self.text.parse().ok()
    }
}

impl fmt::Display for Typed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.negative { "-" } else { "" };
        write!(f, "{sign}{}", self.text)
    }
}
