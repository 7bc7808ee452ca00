//! Pins as a machine's file names them: `gpio17`, `^!PA3`, `tools:PB4` on another board than the first.

use kerf_driver_klipper::setup::{Pin, Pull};

/// The name of the first board, whose pins need none.
pub const FIRST: &str = "main";

/// The boards by whose names pins are read, the first one first.
#[derive(Clone, Debug, PartialEq)]
pub struct Pins {
    /// Their names.
    pub boards: Vec<String>,
}

impl Default for Pins {
    fn default() -> Self {
        Self { boards: vec![FIRST.to_owned()] }
    }
}

impl Pins {
    /// Reads two pins behind each other.
    ///
    /// # Errors
    /// They are no two pins, in words.
    pub fn pair(&self, key: &str, text: &str) -> Result<[Pin; 2], String> {
        let words: Vec<&str> = text.split_whitespace().collect();
        match words[..] {
            [step, dir] => Ok([self.pin(key, step)?, self.pin(key, dir)?]),
            _ => Err(format!(
                "{key} = \"{text}\": name two pins, step and direction: \"gpio0 gpio1\""
            )),
        }
    }

    /// Reads numbers with their pins, with commas between.
    ///
    /// # Errors
    /// An entry is no number with a pin, in words.
    pub fn numbered(&self, key: &str, text: &str) -> Result<Vec<(u8, Pin)>, String> {
        let read = |entry: &str| {
            let wrong = || format!("{key}: \"{entry}\" is no number with its pin, as 1 gpio20 is");
            let (number, name) = entry.split_once(char::is_whitespace).ok_or_else(wrong)?;
            Ok((number.parse().map_err(|_| wrong())?, self.pin(key, name.trim())?))
        };
        entries(text).map(read).collect()
    }

    /// Reads a pin with its signs.
    ///
    /// # Errors
    /// It is no pin, or there is no board of that name, in words.
    pub fn pin(&self, key: &str, text: &str) -> Result<Pin, String> {
        let name = text.trim_start_matches(['!', '^', '~']);
        let signs = &text[..text.len() - name.len()];
        let (board, name) = name.split_once(':').unwrap_or((FIRST, name));
        if name.is_empty() || name.contains(char::is_whitespace) {
            return Err(format!("{key}: \"{text}\" is no pin, as gpio17, PA3 or ^!gpio10 are"));
        }
        let found = self.boards.iter().position(|other| other == board);
        let board = found.ok_or_else(|| {
            format!("{key}: \"{text}\" is on no board that board.others names: \"{board} PORT\"")
        })?;
        let pull = match (signs.contains('^'), signs.contains('~')) {
            (true, _) => Pull::Up,
            (_, true) => Pull::Down,
            _ => Pull::None,
        };
        Ok(Pin { name: name.to_owned(), inverted: signs.contains('!'), pull, board })
    }
}

/// Entries with commas between.
pub fn entries(text: &str) -> impl Iterator<Item = &str> {
    text.split(',').map(str::trim).filter(|entry| !entry.is_empty())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn signs_before_a_pin_turn_it_round_and_pull_it() {
        let pins = Pins::default();
        let told = pins.pin("k", "^!gpio7").unwrap();
        assert_eq!((&*told.name, told.inverted, told.pull), ("gpio7", true, Pull::Up));
        assert_eq!(pins.pin("k", "~PA3").unwrap().pull, Pull::Down);
    }

    #[test]
    fn a_pin_names_its_board() {
        let pins = Pins { boards: vec![FIRST.to_owned(), "tools".to_owned()] };
        let told = pins.pin("k", "!tools:PB4").unwrap();
        assert_eq!((&*told.name, told.inverted, told.board), ("PB4", true, 1));
        assert_eq!(pins.pin("k", "PB4").unwrap().board, 0);
        assert_eq!(pins.pin("k", "main:PB4").unwrap().board, 0);
        assert!(pins.pin("k", "left:PB4").unwrap_err().contains("board.others"));
        assert!(pins.pin("k", "tools:").unwrap_err().contains("no pin"));
    }
}
