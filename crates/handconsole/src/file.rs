//! A job is chosen from the current folder.

use crate::next::Next;
use crate::{ConsoleRequest, Key, Screen};

/// So many files the keys 3 and 9 go on.
const PAGE: usize = 5;

/// The jobs of the folder, one of them shown.
#[derive(Clone, Debug)]
pub(crate) struct Choosing {
    files: Vec<String>,
    at: usize,
}

impl Choosing {
    /// Begins with the first of them.
    pub fn new(files: &[String]) -> Self {
        Self { files: files.to_vec(), at: 0 }
    }

    pub fn screen(&self) -> Screen {
        let shown = self.files.get(self.at).map_or("no RSM files", String::as_str);
        Screen::new(format!("Select File ({}):", self.files.len()), shown)
    }

    pub fn press(self, key: Key) -> Next<Self> {
        let last = self.files.len().saturating_sub(1);
        let at = match key {
            Key::Digit(2) => self.at + 1,
            Key::Digit(8) => self.at.saturating_sub(1),
            Key::Digit(3) => self.at + PAGE,
            Key::Digit(9) => self.at.saturating_sub(PAGE),
            Key::Enter => {
                return Next::request(self.files.get(self.at).cloned().map(ConsoleRequest::Open));
            }
            Key::File | Key::Func => return Next::default(),
            _ => self.at,
        };
        Next::stay(Self { at: at.min(last), ..self })
    }
}
