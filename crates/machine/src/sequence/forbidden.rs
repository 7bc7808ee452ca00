//! Stops that forbid motion while the operator is asked: one that is pressed then did not stop the machine,
//! and nothing moves and nothing comes on before it is released.

use super::Sequence;
use super::small::Small;
use crate::lines::Input;
use crate::state::RELEASE_S;
use kerf_program::Host;
use kerf_program::settings::IoModes;

/// A stop that forbids motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Forbids {
    /// The emergency stop.
    EmergencyStop,
    /// A stop input, or the open enclosure.
    StopInput,
}

impl Forbids {
    /// Returns the words to the operator.
    pub(super) const fn text(self) -> &'static str {
        match self {
            Self::EmergencyStop => "release the emergency stop",
            Self::StopInput => "release the stop input",
        }
    }
}

/// Returns `true` if any stop input is active.
pub(crate) fn stop_input(io: &IoModes, host: &mut dyn Host) -> bool {
    let mut inputs = io.stop_inputs();
    inputs.any(|number| io.stops(number, host.input(number)))
}

impl Sequence {
    /// Returns the stop that forbids motion now.
    pub(super) fn forbids(&self, host: &mut dyn Host) -> Option<Forbids> {
        if host.input(Input::EmergencyStop.number()) == self.machine.estop.active {
            return Some(Forbids::EmergencyStop);
        }
        stop_input(&self.settings.io, host).then_some(Forbids::StopInput)
    }

    /// The operator wanted what is forbidden: he is told, and asked again in a moment.
    pub(super) fn refuse(&mut self, forbids: Forbids) {
        // Whoever does not answer any more does not start it.
        self.halted_before |= std::mem::take(&mut self.marked);
        if self.why.is_empty() {
            self.why = forbids.text().into();
        }
        let again = [Small::Say(forbids.text().into()), Small::Wait(RELEASE_S), Small::Ask];
        for step in again.into_iter().rev() {
            self.steps.push_front(step);
        }
    }
}
