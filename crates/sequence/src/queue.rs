//! The steps still to do.

use crate::step::Step;
use kerf_machine::State;
use std::collections::VecDeque;

/// Steps in order, the first of them perhaps begun.
#[derive(Clone, Debug, Default)]
pub(crate) struct Queue {
    pub steps: VecDeque<Step>,
    /// The commands of the first of them were given.
    pub given: bool,
}

impl Queue {
    /// The first step is over.
    pub fn pop(&mut self) {
        self.given = false;
        self.steps.pop_front();
    }

    /// Puts steps in front of all others.
    pub fn push_front(
        &mut self,
        steps: impl IntoIterator<Item = Step, IntoIter: DoubleEndedIterator>,
    ) {
        for step in steps.into_iter().rev() {
            self.steps.push_front(step);
        }
    }

    /// Returns `true` while the path is being made.
    pub fn is_following(&self) -> bool {
        self.given && self.steps.front() == Some(&Step::Follow)
    }

    /// Returns `true` while the head is on its way in the plane.
    pub fn is_travelling(&self) -> bool {
        self.given && matches!(self.steps.front(), Some(Step::Travel(_)))
    }

    /// Drops everything but what an earlier stop switches off.
    pub fn keep_stop(&mut self, state: State) {
        self.given = false;
        self.steps.retain(|step| step.belongs_to_stop(state));
    }
}
