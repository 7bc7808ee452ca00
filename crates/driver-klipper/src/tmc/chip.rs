//! Kinds of motor drivers.

/// A kind of motor driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chip {
    /// TMC2208 and TMC2225, on a wire without addresses.
    Tmc2208,
    /// TMC2209 and TMC2226, on a wire with four addresses.
    Tmc2209,
    /// TMC2130, with a chip select.
    Tmc2130,
    /// TMC5160 and TMC2160, with a chip select and transistors of their own.
    Tmc5160,
}

impl Chip {
    /// The names that people give, each with the chip whose registers it has.
    pub const NAMES: [(&'static str, Self); 7] = [
        ("tmc2208", Self::Tmc2208),
        ("tmc2209", Self::Tmc2209),
        ("tmc2130", Self::Tmc2130),
        ("tmc5160", Self::Tmc5160),
        ("tmc2225", Self::Tmc2208),
        ("tmc2226", Self::Tmc2209),
        ("tmc2160", Self::Tmc5160),
    ];

    /// The chip of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(own, _)| own.eq_ignore_ascii_case(name)).map(|(_, chip)| *chip)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, chip)| *chip == self).map_or("", |(name, _)| *name)
    }

    /// It has a chip select, and no wire.
    pub const fn has_select(self) -> bool {
        matches!(self, Self::Tmc2130 | Self::Tmc5160)
    }

    /// The register whose highest byte is the version of the chip (IOIN).
    pub const fn version_register(self) -> u8 {
        if self.has_select() { 0x04 } else { 0x06 }
    }

    /// Version of the chip.
    const fn version(self) -> u8 {
        match self {
            Self::Tmc2208 => 0x20,
            Self::Tmc2209 => 0x21,
            Self::Tmc2130 => 0x11,
            Self::Tmc5160 => 0x30,
        }
    }

    /// The chip whose version a register tells.
    pub fn of_version(register: u32) -> Option<Self> {
        let version = (register >> 24) as u8;
        [Self::Tmc2208, Self::Tmc2209, Self::Tmc2130, Self::Tmc5160]
            .into_iter()
            .find(|chip| chip.version() == version)
    }

    /// Resistance of its sense resistors on usual modules, ohms.
    pub const fn usual_ohms(self) -> f64 {
        match self {
            Self::Tmc5160 => 0.075,
            _ => 0.11,
        }
    }
}
