//! Causes of a change of plan on the way.

use crate::OperatorRequest;
use kerf_sim::{Halt, HaltCause};

/// Cause of a change of plan on the way.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Turn {
    /// An input stops motion.
    Input(Halt),
    /// The operator wants something.
    Operator(OperatorRequest),
}

/// The cause for which a machine slows down, as far as what is told meanwhile depends on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slows {
    /// STOP, which may be told until the machine stands.
    pub by_stop: bool,
    /// A stop input, which asks by itself when the machine stands.
    pub asks: bool,
}

impl Slows {
    pub const fn for_turn(turn: &Turn) -> Self {
        Self {
            by_stop: matches!(turn, Turn::Operator(OperatorRequest::Stop)),
            asks: matches!(turn, Turn::Input(Halt { cause: HaltCause::Stop(_), .. })),
        }
    }
}

/// Returns the halt of a plan that nothing follows any more.
pub(crate) const fn link_lost(t_s: f64) -> Halt {
    Halt { t_s, cause: HaltCause::LinkLost, ramped: false }
}
