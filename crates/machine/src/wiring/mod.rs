//! Bits of the ports, and the terminals of a card on which they come out (Profiler reference, "Hardware
//! Input and Output", "PCI Card", "I/O Card", "Output and Input Pin Configuration"; readings, P-51 to
//! P-57).

mod card;
mod connectors;
mod pci;
mod ports;

pub use ports::{Bit, INPUT_BITS, OUTPUT_BITS, Port, bit};

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

/// Every card.
pub const CARDS: &[Wiring] = &[pci::PCI, card::IO, connectors::BOX];

/// The card of a name.
pub fn wiring(name: &str) -> Option<&'static Wiring> {
    CARDS.iter().find(|card| card.name.eq_ignore_ascii_case(name))
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

const fn at(
    group: &'static str,
    pin: &'static str,
    signal: &'static str,
    note: &'static str,
) -> Terminal {
    Terminal { group, pin, signal, note }
}

#[cfg(test)]
mod tests;
