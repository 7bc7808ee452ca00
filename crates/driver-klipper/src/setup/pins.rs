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
    /// Its board, where a machine has several: 0 for the first.
    pub board: usize,
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
    /// Those of them that are of a bus.
    shared: Vec<u32>,
    /// Inputs that are looked at, each as a switch, in a row, or as both.
    looked_at: Vec<(u32, Look)>,
}

/// A way to look at an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// As a switch that stops motors.
    Switch,
    /// In the row of inputs.
    Row,
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
        Self { reserved, taken: Vec::new(), shared: Vec::new(), looked_at: Vec::new() }
    }

    /// Gives a pin a task, and returns its number.
    pub fn take(&mut self, board: &Dictionary, name: &str) -> Result<u32, SetupError> {
        let number = self.number(board, name)?;
        let looked_at = self.looked_at.iter().any(|(other, _)| *other == number);
        if looked_at || self.taken.contains(&number) {
            return Err(SetupError::Twice(name.to_owned()));
        }
        self.taken.push(number);
        Ok(number)
    }

    /// Returns the number of a pin of a bus, which several chips have in common and nothing else.
    pub fn share(&mut self, board: &Dictionary, name: &str) -> Result<u32, SetupError> {
        let number = self.number(board, name)?;
        if !self.shared.contains(&number) {
            self.take(board, name)?;
            self.shared.push(number);
        }
        Ok(number)
    }

    /// Returns the number of an input. One pin may be a switch and stand in the row of inputs as well.
    pub fn look_at(
        &mut self,
        board: &Dictionary,
        name: &str,
        look: Look,
    ) -> Result<u32, SetupError> {
        let number = self.number(board, name)?;
        if self.taken.contains(&number) || self.looked_at.contains(&(number, look)) {
            return Err(SetupError::Twice(name.to_owned()));
        }
        self.looked_at.push((number, look));
        Ok(number)
    }

    fn number(&self, board: &Dictionary, name: &str) -> Result<u32, SetupError> {
        if let Some(by) = self.reserved.get(name) {
            return Err(SetupError::Reserved { pin: name.to_owned(), by: by.clone() });
        }
        Ok(board.number("pin", name).map_err(OrderError::from)?)
    }
}
