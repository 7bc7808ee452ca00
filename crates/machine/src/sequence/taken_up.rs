//! A job that is taken up after the power was off: nothing is on and the machine stands somewhere, at
//! the height it had or another. The tool rises first; then it is as after a pause.

use super::Sequence;
use super::place::Stage;
use super::small::Small;
use crate::lines::Output;
use crate::state::State;
use kerf_program::{Axis, Halted};

impl Sequence {
    /// Goes on from where the path was left; the machine stands elsewhere.
    pub(super) fn take_up(&mut self, halted: &Halted) {
        if self.is_following() {
            self.keep_place(&Halted { stands: halted.began, ..*halted });
            if self.controlled {
                self.follow_heights(halted.began[Axis::Z]);
            }
        }
        let jig = [Output::Jig1, Output::Jig2].into_iter().find(|output| self.is_on(*output));
        let runs = self.is_on(Output::JobRunning);
        (self.controlled, self.on, self.given) = (false, 0, false);
        self.position = halted.stands;
        let mut steps = vec![Small::RaiseTo(self.travel_mm()), Small::Enter(self.state)];
        steps.extend(runs.then_some(Small::Switch(Output::JobRunning, true)));
        steps.extend(jig.map(|output| Small::Switch(output, true)));
        if self.state == State::Running && self.stage != Stage::Waiting {
            steps.extend(self.come_back());
            self.steps = steps.into();
        } else {
            // Moves beside the path: what is left of them is made from here.
            for step in steps.into_iter().rev() {
                self.steps.push_front(step);
            }
        }
    }
}
