//! A function is chosen by its number.

use super::table::{DIGITIZE, function};
use crate::entry::Typed;
use crate::next::{Next, To};
use crate::{Key, Screen};

/// The number as far as it is typed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Selecting {
    typed: Typed,
    /// Enter was pressed, and there is no such function.
    refused: bool,
}

impl Selecting {
    /// The number that is meant: 0 before anything is typed.
    fn number(&self) -> String {
        if self.typed.is_empty() { "0".into() } else { self.typed.to_string() }
    }

    pub fn screen(&self) -> Screen {
        let number = self.number();
        let bottom = match function(&number) {
            Some(function) => format!("{number} {}", function.name),
            None if self.refused => format!("{number} ?"),
            None => number,
        };
        Screen::new("Enter function:", bottom)
    }

    pub fn press(self, key: Key) -> Next<Self> {
        match key {
            Key::Enter => match function(&self.number()) {
                Some(function) if function.number == DIGITIZE => Next::to(To::Digitizing),
                Some(function) => Next::to(To::Function(function)),
                None => Next::stay(Self { refused: true, ..self }).beep(),
            },
            Key::Func => Next::default(),
            Key::Digit(_) | Key::File | Key::Stop => {
                let typed = self.typed.press(key);
                Next::stay(Self { typed, refused: false })
            }
            Key::PlusMinus | Key::Start => Next::stay(self),
        }
    }
}
