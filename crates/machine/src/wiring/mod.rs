//! Bits of the ports, and the terminals of a card on which they come out (Profiler reference, "Hardware
//! Input and Output", "PCI Card", "I/O Card", "Output and Input Pin Configuration"; readings, P-51 to
//! P-57).

mod card;
mod connectors;
mod pci;
mod ports;
mod terminal;

pub use ports::{Bit, INPUT_BITS, OUTPUT_BITS, Port, bit};
pub use terminal::{Terminal, Wiring};

/// Every card.
pub const CARDS: &[Wiring] = &[pci::PCI, card::IO, connectors::BOX];

/// The card of a name.
pub fn wiring(name: &str) -> Option<&'static Wiring> {
    CARDS.iter().find(|card| card.name.eq_ignore_ascii_case(name))
}

#[cfg(test)]
mod tests;
