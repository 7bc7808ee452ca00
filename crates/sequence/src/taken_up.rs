//! A job that is taken up after the power was off: nothing is on and the machine stands somewhere, at
//! the height it had or another. The tool rises first; then it is as after a pause.

use crate::Sequence;
use crate::place::Stage;
use crate::small::Small;
use kerf_machine::lines::Output;
use kerf_machine::state::State;
use kerf_program::{Axis, Halted};

impl Sequence {
    /// Returns the outputs that go on when the job is taken up from there, in order.
    pub(crate) fn comes_on_again(&self, halted: &Halted) -> Vec<u8> {
        let mut ahead = self.clone();
        ahead.take_up(halted);
        if ahead.stage == Stage::Approach {
            ahead.steps.extend(ahead.pass_steps());
        }
        let switched = ahead.steps.iter().filter_map(|step| match step {
            Small::Switch(output, true) => Some(output.number()),
            _ => None,
        });
        let mut on = Vec::new();
        for number in switched {
            if !on.contains(&number) {
                on.push(number);
            }
        }
        on
    }

    /// Goes on from where the path was left; the machine stands elsewhere.
    pub(crate) fn take_up(&mut self, halted: &Halted) {
        if self.is_following() {
            self.keep_place(&Halted { stands: halted.began, ..*halted });
        }
        self.heights_left(halted.began[Axis::Z]);
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
