//! Stops that forbid motion while the operator is asked: one that is pressed then did not stop the machine,
//! and nothing moves and nothing comes on before it is released.

use crate::setup::Setup;
use kerf_machine::lines::Input;
use kerf_program::Host;

/// A stop that forbids motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Forbids {
    /// The emergency stop.
    EmergencyStop,
    /// A stop input, or the open enclosure.
    StopInput,
}

impl Forbids {
    /// Returns the words to the operator.
    pub(crate) const fn text(self) -> &'static str {
        match self {
            Self::EmergencyStop => "release the emergency stop",
            Self::StopInput => "release the stop input",
        }
    }
}

/// Returns the stop that forbids motion now.
pub(crate) fn forbids(setup: &Setup, host: &mut dyn Host) -> Option<Forbids> {
    if host.input(Input::EmergencyStop.number()) == setup.machine.estop.active {
        return Some(Forbids::EmergencyStop);
    }
    setup.settings.io.stop_is_active(host).then_some(Forbids::StopInput)
}
