//! Stops that forbid motion while the operator is asked: one that is pressed then did not stop the machine,
//! and nothing moves and nothing comes on before it is released.

use crate::Sequence;
use crate::small::Small;
use kerf_machine::lines::Input;
use kerf_machine::state::RELEASE_S;
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

impl Sequence {
    /// Returns the stop that forbids motion now.
    pub(crate) fn forbids(&self, host: &mut dyn Host) -> Option<Forbids> {
        if host.input(Input::EmergencyStop.number()) == self.machine.estop.active {
            return Some(Forbids::EmergencyStop);
        }
        self.settings.io.stop_is_active(host).then_some(Forbids::StopInput)
    }

    /// The operator wanted what is forbidden: he is told, and asked again in a moment.
    pub(crate) fn refuse(&mut self, forbids: Forbids) {
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
