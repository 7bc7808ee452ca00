//! Terminals of cards and boxes, and the bits that come out on them.

use super::ports::{Bit, INPUT_BITS, OUTPUT_BITS};

/// One terminal of a card or of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Terminal {
    /// The connector or the side of the card.
    pub group: &'static str,
    /// The pin's number or the terminal's name.
    pub pin: &'static str,
    /// The bit, a supply, or `not used`.
    pub signal: &'static str,
    /// Further notes.
    pub note: &'static str,
}

/// A card or box with its terminals.
pub struct Wiring {
    /// Its name in commands.
    pub name: &'static str,
    /// Its terminals.
    pub terminals: &'static [Terminal],
    /// Facts for whoever wires it.
    pub notes: &'static [&'static str],
}

impl Terminal {
    /// Port and bit of its signal, if it is one: `A1`.
    pub fn bit(&self) -> Option<&'static Bit> {
        let side: &[Bit] = if self.is_input() { INPUT_BITS } else { OUTPUT_BITS };
        side.iter().find(|bit| bit.name == self.signal)
    }

    fn is_input(&self) -> bool {
        matches!(self.group, "input" | "STOP" | "BDEL-HC") || self.group.ends_with("HOME")
    }
}

pub(super) const fn at(
    group: &'static str,
    pin: &'static str,
    signal: &'static str,
    note: &'static str,
) -> Terminal {
    Terminal { group, pin, signal, note }
}
