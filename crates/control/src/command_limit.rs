//! The bound of a look: a program that goes round for ever on purpose runs on a machine until somebody stops it,
//! and nobody can look at all of it.

use kerf_diag::with_commas;

/// A bound on the commands that are carried out: moves, switches, words to the operator.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CommandLimit {
    /// The most; 0 for no bound.
    most: u64,
    done: u64,
}

impl CommandLimit {
    /// Makes a limit of so many commands; 0 for none.
    pub const fn of(most: u64) -> Self {
        Self { most, done: 0 }
    }

    /// Counts a command; false when it is one too many.
    pub fn takes_one(&mut self) -> bool {
        self.done += 1;
        self.most == 0 || self.done <= self.most
    }

    /// The words for a look that ended, and what to do about it.
    pub fn message(self) -> (String, &'static str) {
        let message = format!(
            "stopped after {} commands: what comes after them was not looked at",
            with_commas(self.most)
        );
        let hint = "is there a loop that never ends? A machine runs it until it is stopped; --max-lines looks further";
        (message, hint)
    }
}
