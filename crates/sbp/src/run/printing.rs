//! PRINT, PRINT # and WRITE #: items into text (handbook, PRINT and WRITE; readings, A-31 … A-35).

use super::{Context, Stop, eval, user_files};
use crate::tree::{Output, Separator};
use kerf_program::Command;

/// Text that PRINT puts between items separated by commas.
const PRINT_GAP: &str = "     ";

/// Text that WRITE puts between items separated by commas.
const WRITE_GAP: &str = ", ";

/// Prints to the message window, or writes to a file when a number is given.
pub(super) fn output(c: &mut Context<'_>, output: &Output) -> Result<(), Stop> {
    let number = match &output.file {
        Some(file) => Some(user_files::file_number(c, file)?),
        None => None,
    };
    let text = output_text(c, output)?;
    c.settle()?;
    match number {
        None => c.emit(Command::Print { text: text.into(), newline: output.newline }),
        Some(number) => {
            let end = if output.newline { "\n" } else { "" };
            user_files::write_file(c, number, &format!("{text}{end}"))?;
        }
    }
    Ok(())
}

fn output_text(c: &mut Context<'_>, output: &Output) -> Result<String, Stop> {
    let items: Result<Vec<_>, _> = output.items.iter().map(|i| eval::eval_text(c, i)).collect();
    let gap = match output.separator {
        Separator::Semicolon => "",
        Separator::Comma if output.write => WRITE_GAP,
        Separator::Comma => PRINT_GAP,
    };
    Ok(items?.join(gap))
}
