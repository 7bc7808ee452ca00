//! Commands that other software passes in: the value `uCommand` (programming handbook, Registry
//! Interface; readings, A-47).
//!
//! One command of two letters with its parameters is carried out once, when no file runs, and the
//! value is empty from then on. What was left there before the start is not carried out.

use crate::Workspace;
use crate::system_log::{clock, mode_word};
use kerf_journal::{Journal, JournalError};
use kerf_program::Settings;

/// Key of the command.
pub const COMMAND: &str = "uCommand";

/// The name of what is carried out, where a line of it is told.
pub const NAME: &str = "uCommand";

/// Forgets a command that was left there before the start.
///
/// # Errors
/// If the journal cannot be written.
pub fn forget(journal: &Journal) -> Result<(), JournalError> {
    match journal.registry.value(COMMAND)? {
        Some(_) => journal.registry.set_value(COMMAND, None),
        None => Ok(()),
    }
}

/// The command that was passed in, which is taken away; nothing when there is none. `Err` with words
/// for the log when it is no single command.
///
/// # Errors
/// If the journal cannot be read or written.
pub fn take(journal: &Journal) -> Result<Option<Result<String, String>>, JournalError> {
    let Some(text) = journal.registry.value(COMMAND)? else { return Ok(None) };
    journal.registry.set_value(COMMAND, None)?;
    let command = text.trim();
    if command.is_empty() {
        return Ok(None);
    }
    Ok(Some(single(command)))
}

/// A command of two letters with its parameters, as it is carried out; `Err` with words where it is none.
///
/// # Errors
/// It is several lines, or no command.
pub fn single(command: &str) -> Result<String, String> {
    let mut letters = command.chars().take_while(char::is_ascii_alphabetic);
    let two = letters.by_ref().count() == 2;
    let known = two && command.get(..2).is_some_and(|l| kerf_sbp::table::find(l).is_some());
    if command.lines().count() > 1 || !known {
        return Err(format!("one command of two letters expected, not '{command}'"));
    }
    Ok(command.to_owned())
}

/// Logs that a command that other software passed in was not carried out, and why: an item of one line. `draws`: the
/// machine is in preview.
pub fn log_refused(workspace: &mut Workspace, settings: &Settings, draws: bool, why: &str) {
    let words: Vec<_> = why.split([',', ' ', '\n', '\r']).filter(|it| !it.is_empty()).collect();
    let head = format!("{COMMAND},{},{}", mode_word(draws), clock(0.0));
    workspace.log_with(settings, &head, &words.join(" "));
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn sbp_ctl_reg_ucommand_form() {
        let folder = tempfile::tempdir().unwrap();
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let pass = |text: &str| {
            journal.registry.set_value(COMMAND, Some(text)).unwrap();
            let taken = take(&journal).unwrap();
            assert_eq!(journal.registry.value(COMMAND).unwrap(), None, "it is taken away");
            taken
        };
        for good in ["FP,a.sbp,,,,,2", "mx 2", "ST"] {
            assert_eq!(pass(good), Some(Ok(good.to_owned())));
        }
        for bad in ["MX,2\nMY,2", "&a=2", "GOTO x", "PRINT 1", "QQ,1", "é"] {
            assert!(matches!(pass(bad), Some(Err(_))), "{bad}");
        }
        assert_eq!((pass("  "), take(&journal).unwrap()), (None, None));
    }
}
