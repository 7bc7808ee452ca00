//! A switch of the simulated machine that somebody moves while a question is open: an answer to it,
//! which is asked again afterwards unless it waits for that very switch.

use std::fmt;

/// A switch that is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Press {
    /// Which input.
    pub number: u8,
    /// Its contact is closed from now on.
    pub on: bool,
}

impl Press {
    /// Reads `switch 3 1`.
    pub fn read(words: &str) -> Option<Self> {
        let mut words = words.split(' ');
        let (command, number, on) = (words.next()?, words.next()?, words.next()?);
        let on = match on {
            "0" => false,
            "1" => true,
            _ => return None,
        };
        let number = number.parse().ok()?;
        (command == "switch" && words.next().is_none()).then_some(Self { number, on })
    }
}

impl fmt::Display for Press {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "switch {} {}", self.number, u8::from(self.on))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let press = Press { number: 12, on: true };
        assert_eq!(Press::read(&press.to_string()), Some(press));
        for words in ["", "switch", "switch 1", "switch 1 2", "switch x 1", "switch 1 1 1"] {
            assert_eq!(Press::read(words), None, "{words}");
        }
    }
}
