//! The states that an interrupt goes back to.
//!
//! A program is read ahead of the machine. While handlers are armed, the state right after each
//! step that moved is kept, so that the handler finds everything as it was behind the interrupted
//! move. The tab filter gives moves later than their lines are read; hence each motion command is
//! kept with the step that it comes from.

use super::Core;
use kerf_program::Step;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;

/// States of a run, oldest first.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Past {
    /// Number of a step, and the state right after it.
    states: VecDeque<(u64, Core)>,
    /// Number of a motion command, and the step it comes from.
    motions: VecDeque<(u64, u64)>,
}

impl Past {
    /// Keeps what a step did; forgets everything when nothing can be interrupted any more.
    pub(super) fn keep(&mut self, core: &mut Core, number: u64, step: &Step) {
        let given_by = std::mem::take(&mut core.given.given_by);
        if core.handlers.watches.is_empty() || core.given.settled {
            self.clear();
        }
        if core.handlers.watches.is_empty() {
            return;
        }
        let first = core.given.motions + 1 - given_by.len() as u64;
        let moved = !given_by.is_empty();
        self.motions.extend((first..).zip(given_by));
        if *step != Step::Waiting && (moved || core.cutting.tabs.is_some()) {
            self.states.push_back((number, core.clone()));
        }
    }

    /// The state right after the line of a motion command, or of the next one that is known.
    pub(super) fn after(&self, motion: u64) -> Option<&Core> {
        let (_, step) = self.motions.iter().find(|(number, _)| *number >= motion)?;
        self.states.iter().find(|(number, _)| number >= step).map(|(_, core)| core)
    }

    /// Forgets what lies before a motion command that was carried out.
    pub(super) fn forget(&mut self, motion: u64) {
        let mut needed = None;
        while let Some((number, step)) = self.motions.front() {
            needed = Some(*step);
            if *number > motion {
                break;
            }
            self.motions.pop_front();
        }
        while self.states.front().is_some_and(|(number, _)| needed.is_some_and(|n| *number < n)) {
            self.states.pop_front();
        }
    }

    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        self.states.clear();
        self.motions.clear();
    }

    /// Returns the number of states that are kept.
    pub(super) fn len(&self) -> usize {
        self.states.len()
    }

    /// The states themselves.
    pub(super) fn states_mut(&mut self) -> impl Iterator<Item = &mut Core> {
        self.states.iter_mut().map(|(_, core)| core)
    }
}
