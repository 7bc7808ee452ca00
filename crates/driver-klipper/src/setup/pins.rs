//! Pins: their names are the board's.

use super::SetupError;
use crate::dictionary::Dictionary;
use crate::orders::OrderError;
use std::collections::BTreeMap;

/// A resistor at an input.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pull {
    /// None.
    #[default]
    None,
    /// To the supply.
    Up,
    /// To ground, where the chip can.
    Down,
}

impl Pull {
    /// The board's number for it.
    pub const fn number(self) -> u32 {
        match self {
            Self::None => 0,
            Self::Up => 1,
            Self::Down => u32::MAX,
        }
    }
}

/// A pin of a board.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pin {
    /// Its name in the board's dictionary: `gpio17`, `PA3`.
    pub name: String,
    /// Low means on.
    pub inverted: bool,
    /// Resistor, at inputs.
    pub pull: Pull,
}

impl Pin {
    /// A pin by its name, high when on.
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }
}

/// Pins that have a task.
pub struct Pins {
    reserved: BTreeMap<String, String>,
    taken: Vec<u32>,
}

impl Pins {
    /// Those that the board has use of itself.
    pub fn new(board: &Dictionary) -> Self {
        let mut reserved = BTreeMap::new();
        for (by, pins) in board.texts().filter(|(name, _)| name.starts_with("RESERVE_PINS_")) {
            for pin in pins.split(',') {
                reserved.insert(
                    pin.trim().to_owned(),
                    by.trim_start_matches("RESERVE_PINS_").to_owned(),
                );
            }
        }
        Self { reserved, taken: Vec::new() }
    }

    /// Gives a pin a task, and returns its number.
    pub fn take(&mut self, board: &Dictionary, name: &str) -> Result<u32, SetupError> {
        if let Some(by) = self.reserved.get(name) {
            return Err(SetupError::Reserved { pin: name.to_owned(), by: by.clone() });
        }
        let number = board.number("pin", name).map_err(OrderError::from)?;
        if self.taken.contains(&number) {
            return Err(SetupError::Twice(name.to_owned()));
        }
        self.taken.push(number);
        Ok(number)
    }
}
