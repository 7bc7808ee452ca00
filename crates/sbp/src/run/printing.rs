//! PRINT, PRINT # and WRITE #: items into text (handbook, PRINT and WRITE; readings, A-31 … A-35).

use super::{Context, Stop};
use crate::tree::{Output, Separator};
use kerf_program::Command;

/// Text that PRINT puts between items separated by commas.
const PRINT_GAP: &str = "     ";

/// Text that WRITE puts between items separated by commas.
const WRITE_GAP: &str = ", ";

impl Context<'_> {
    /// Prints to the message window, or writes to a file when a number is given.
    pub(super) fn output(&mut self, output: &Output) -> Result<(), Stop> {
        let number = match &output.file {
            Some(file) => Some(self.file_number(file)?),
            None => None,
        };
        let text = self.output_text(output)?;
        self.settle()?;
        match number {
            None => self.emit(Command::Print { text: text.into(), newline: output.newline }),
            Some(number) => {
                let end = if output.newline { "\n" } else { "" };
                self.write_file(number, &format!("{text}{end}"))?;
            }
        }
        Ok(())
    }

    fn output_text(&mut self, output: &Output) -> Result<String, Stop> {
        let items: Result<Vec<_>, _> = output.items.iter().map(|i| self.eval_text(i)).collect();
        let gap = match output.separator {
            Separator::Semicolon => "",
            Separator::Comma if output.write => WRITE_GAP,
            Separator::Comma => PRINT_GAP,
        };
        Ok(items?.join(gap))
    }
}
