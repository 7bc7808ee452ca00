//! Causes of a change of plan on the way.

use crate::OperatorRequest;
use kerf_model::{Halt, HaltCause};

/// Cause of a change of plan on the way.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Interruption {
    /// An input stops motion.
    Input(Halt),
    /// The operator wants something.
    Operator(OperatorRequest),
}

impl Interruption {
    /// Returns `true` if motion slows along its ramp first.
    pub const fn is_ramped(&self) -> bool {
        match self {
            Self::Input(halt) => halt.ramped,
            Self::Operator(_) => true,
        }
    }

    /// Returns `true` for STOP, which may be told until the machine stands.
    pub const fn is_stop(&self) -> bool {
        matches!(self, Self::Operator(OperatorRequest::Stop))
    }

    /// Returns `true` for a stop input, which asks by itself when the machine stands.
    pub const fn asks(&self) -> bool {
        matches!(self, Self::Input(Halt { cause: HaltCause::Stop(_), .. }))
    }
}

/// Returns the halt of a plan that nothing follows any more.
pub(crate) const fn link_lost(t_s: f64) -> Halt {
    Halt { t_s, cause: HaltCause::LinkLost, ramped: false }
}
