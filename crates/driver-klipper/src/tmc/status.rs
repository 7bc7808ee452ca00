//! The state of a power stage in words (register DRV_STATUS).

use super::Chip;

/// The condition of a motor driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// All is well.
    Fine,
    /// It is warm, and goes on.
    Warm,
    /// It has switched its motor off; the reason in words.
    Off(&'static str),
}

/// A driver that is not well, between runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trouble {
    /// The name of its motor.
    pub name: String,
    /// It still drives its motor.
    pub drives: bool,
    /// The trouble in words.
    pub words: &'static str,
}

/// It is too hot and has switched off.
const HOT: &str = "it is too hot and has switched its motor off: less current, more air";
/// A coil is shorted.
const SHORT: &str =
    "a coil of its motor is shorted: switch the power off, then look at the plug and the cable";

impl Condition {
    /// Reads the condition of a driver from its register.
    pub const fn of(chip: Chip, register: u32) -> Self {
        // Warm, hot, shorts to ground and to the supply.
        let [warm, hot, short] = match chip {
            Chip::Tmc2208 | Chip::Tmc2209 => [1, 1 << 1, 0b1111 << 2],
            Chip::Tmc2130 => [1 << 26, 1 << 25, 0b11 << 27],
            Chip::Tmc5160 => [1 << 26, 1 << 25, 0b11 << 27 | 0b11 << 12],
        };
        if register & short != 0 {
            Self::Off(SHORT)
        } else if register & hot != 0 {
            Self::Off(HOT)
        } else if register & warm != 0 {
            Self::Warm
        } else {
            Self::Fine
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heat_and_shorts_are_told_of_each_kind() {
        let check = |chip, bit: u32, expected| {
            assert_eq!(Condition::of(chip, 1 << bit), expected, "{chip:?} {bit}");
        };
        for chip in [Chip::Tmc2208, Chip::Tmc2209] {
            check(chip, 0, Condition::Warm);
            check(chip, 1, Condition::Off(HOT));
            check(chip, 5, Condition::Off(SHORT));
            check(chip, 31, Condition::Fine);
        }
        for chip in [Chip::Tmc2130, Chip::Tmc5160] {
            check(chip, 26, Condition::Warm);
            check(chip, 25, Condition::Off(HOT));
            check(chip, 28, Condition::Off(SHORT));
            check(chip, 24, Condition::Fine);
        }
        check(Chip::Tmc5160, 12, Condition::Off(SHORT));
        check(Chip::Tmc2130, 12, Condition::Fine);
    }
}
