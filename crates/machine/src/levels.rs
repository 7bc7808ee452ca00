//! From the levels at the pins to what inputs read (Profiler reference, "PCI Card", "I/O Card";
//! readings, P-57).
//!
//! A pin that nobody drives is open: on the PCI card its level is 1, for nothing pulls it to ground, else 0.
//! An open pin is not active, unless its input is turned round, as one is for a switch that opens.

use crate::lines::port_bit;
use crate::settings::io::{Card, IoMap, PORT_BITS};
use crate::wiring::Port;

/// The eight inverts of a port as a byte, bit 0 lowest.
fn mask(inverts: [bool; PORT_BITS]) -> u8 {
    inverts.iter().enumerate().fold(0, |byte, (place, on)| byte | u8::from(*on) << place)
}

impl IoMap {
    /// Returns what the inputs of a port read when its pins have these levels, a bit each: 1 is active.
    pub fn reads(&self, port: Port, levels: u8) -> u8 {
        let grounded = if self.card == Card::Pci { u8::MAX } else { 0 };
        levels ^ grounded ^ self.open_reads(port)
    }

    /// The levels of the pins at which inputs read so: the way back.
    pub fn levels(&self, port: Port, reads: u8) -> u8 {
        self.reads(port, reads)
    }

    /// Returns what the inputs of a port read when all its pins are open.
    pub fn open_reads(&self, port: Port) -> u8 {
        match port {
            Port::A => mask(self.invert_a),
            Port::B => mask(self.invert_b),
            Port::C => 0,
        }
    }

    /// Returns what a line's input reads at a level of its pin; a line that is no pin of a port reads the level.
    pub fn line_reads(&self, line: u8, level: bool) -> bool {
        port_bit(line).map_or(level, |(port, place)| {
            self.reads(port, u8::from(level) << place) & (1 << place) != 0
        })
    }

    /// The level at which the input of a line reads so: the way back.
    pub fn line_level(&self, line: u8, reads: bool) -> bool {
        self.line_reads(line, reads)
    }

    /// Returns what a line's input reads while its pin is open.
    pub fn open_line_reads(&self, line: u8) -> bool {
        port_bit(line).is_some_and(|(port, place)| self.open_reads(port) & (1 << place) != 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(card: Card, inverted: Option<usize>, levels: u8, expected: u8) {
        let mut map = IoMap { card, ..IoMap::default() };
        inverted.into_iter().for_each(|place| map.invert_a[place] = true);
        assert_eq!(map.reads(Port::A, levels), expected);
        assert_eq!(map.levels(Port::A, expected), levels);
    }

    #[test]
    fn pro_io_levels() {
        check(Card::None, None, 0x04, 0x04);
        check(Card::Pci, None, 0xFB, 0x04);
        check(Card::Io, None, 0x04, 0x04);
        check(Card::Io, Some(2), 0x00, 0x04);
        check(Card::Pci, Some(2), 0xFF, 0x04);
    }

    #[test]
    fn pro_io_pci_i_elec() {
        let notes =
            crate::wiring::wiring("pci").map(|card| card.notes.join(" ")).unwrap_or_default();
        assert!(notes.contains("opto-isolated, 1 kOhm for 12 V, active when pulled to ground"));
        check(Card::Pci, None, 0b1111_1110, 1);
    }

    #[test]
    fn pins_that_nobody_drives_are_open() {
        let mut map = IoMap { card: Card::Pci, ..IoMap::default() };
        let line = crate::lines::Input::XHome.number();
        assert!(map.line_reads(line, false) && !map.line_reads(line, true));
        assert!(!map.open_line_reads(line) && map.line_level(line, false));
        map.invert_a[2] = true;
        assert!(map.open_line_reads(line) && map.line_reads(line, true));
        assert!(map.line_reads(3, true) && !map.open_line_reads(3), "no pin of a port");
    }

    #[test]
    fn pro_io_io_in_elec() {
        let notes =
            crate::wiring::wiring("io").map(|card| card.notes.join(" ")).unwrap_or_default();
        assert!(
            notes.contains("8, positive switching (pnp), +15 V supply, filtered, opto-isolated")
        );
        check(Card::Io, None, 1, 1);
    }
}
