//! A function is chosen by its number.

use super::table::DIGITIZE;
use super::{Stepping, function};
use crate::console::{Mode, Next};
use crate::entry::Typed;
use crate::{Key, Screen, View};

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

    pub fn press(self, key: Key, view: &View) -> Next {
        match key {
            Key::Enter => match function(&self.number()) {
                Some(function) if function.number == DIGITIZE => {
                    Next::to(Mode::Digitizing(Box::default()))
                }
                Some(function) => Stepping::begin(function, view),
                None => Next::to(Mode::Selecting(Self { refused: true, ..self })).beep(),
            },
            Key::Func => Next::default(),
            Key::Digit(_) | Key::File | Key::Stop => {
                let typed = self.typed.press(key);
                Next::to(Mode::Selecting(Self { typed, refused: false }))
            }
            Key::PlusMinus | Key::Start => Next::to(Mode::Selecting(self)),
        }
    }
}
