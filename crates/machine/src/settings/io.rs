//! The card the inputs come from, and the level at which each is active (Profiler reference,
//! "Hardware Input and Output", "PCI Card", "I/O Card").

use super::words;

words! {
    /// Card of the inputs, which decides at which level they are active.
    Card {
        /// No card: a pin that is high is active.
        None = "none",
        /// The PCI card alone: an input is active when pulled to ground.
        Pci = "pci",
        /// With the I/O card: an input is active when positive.
        Io = "io",
    }
}

/// Bits of an input port.
pub const PORT_BITS: usize = 8;

/// Wiring of the inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct IoMap {
    /// The card; it decides at which level inputs are active.
    pub card: Card,
    /// Inputs of port A whose level is turned round beside what the card does, bit 0 first.
    pub invert_a: [bool; PORT_BITS],
    /// The same of port B.
    pub invert_b: [bool; PORT_BITS],
}
