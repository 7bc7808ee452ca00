//! Reasons why a block does not complete.

use crate::syntax::gathered::Fault;
use crate::syntax::tree::Span;
use kerf_diag::{Code, Diagnostic};
use kerf_program::{HostError, Status};

/// Reason why a block did not complete.
#[derive(Debug)]
pub(super) enum Stop {
    /// The host has no answer yet; nothing has happened.
    Waiting,
    /// The commands given so far are carried out first, then the block begins again.
    Again,
    /// The block cannot be carried out.
    Refused(Box<Refused>),
    /// An error that is told already.
    Failed(Box<Diagnostic>),
    /// The run ends.
    Finished(Status),
}

impl Stop {
    /// Returns `true` for an error.
    pub(super) const fn is_error(&self) -> bool {
        matches!(self, Self::Refused(_) | Self::Failed(_))
    }
}

/// An error of the block at hand, before anybody looked up where that stands.
#[derive(Debug)]
pub(super) struct Refused {
    pub(super) code: Code,
    pub(super) message: String,
    pub(super) hint: String,
    /// Part of the line; `None` for the whole block.
    pub(super) span: Option<Span>,
}

impl From<Refused> for Stop {
    fn from(refused: Refused) -> Self {
        Self::Refused(Box::new(refused))
    }
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Self {
        let Fault { code, span, message, hint } = fault;
        Refused { code, message, hint, span: Some(span) }.into()
    }
}

impl From<HostError> for Stop {
    fn from(error: HostError) -> Self {
        let (code, what) = match error {
            HostError::NotFound(what) => (Code::FileNotFound, what),
            HostError::NotAllowed(what) => (Code::FileNotAllowed, what),
            HostError::EndOfFile => (Code::EndOfFile, "end of file".into()),
            HostError::Disabled(what) | HostError::Refused(what) => (Code::FileError, what),
        };
        fail(code, what, "")
    }
}

/// The error of a block: its code, what is wrong, how to mend it.
pub(super) fn fail<E: From<Refused>>(
    code: Code,
    message: impl Into<String>,
    hint: impl Into<String>,
) -> E {
    E::from(Refused { code, message: message.into(), hint: hint.into(), span: None })
}
