//! The end of a run.

use kerf_diag::Diagnostic;
use kerf_program::Status;

/// The end of a run: what it was, and why. On its way up it is the error of whatever it ends.
#[derive(Debug)]
pub(crate) struct RunEnd {
    pub status: Status,
    pub diagnostic: Option<Box<Diagnostic>>,
}

impl RunEnd {
    /// An end about which there is nothing to tell.
    pub const fn of(status: Status) -> Self {
        Self { status, diagnostic: None }
    }

    /// The same with a hint about what to do.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.diagnostic = self.diagnostic.map(|why| Box::new((*why).hint(hint)));
        self
    }
}

/// Reason for which the commands at hand are not carried out any more.
#[derive(Debug)]
pub(crate) enum Break {
    /// The program goes on elsewhere, and knows: what it gave so far is dropped.
    Interrupted,
    /// The run is over.
    Ended(RunEnd),
}

impl Break {
    /// Fails where the run is over; after an interruption it goes on.
    pub fn unless_ended(told: Result<(), Self>) -> Result<(), RunEnd> {
        match told {
            Ok(()) | Err(Self::Interrupted) => Ok(()),
            Err(Self::Ended(end)) => Err(end),
        }
    }
}

impl From<RunEnd> for Break {
    fn from(end: RunEnd) -> Self {
        Self::Ended(end)
    }
}
