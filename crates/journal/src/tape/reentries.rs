//! Points at which a run was taken up, and at which it was left while it was stopped.

use super::{Kind, Tape};
use crate::switches::Switches;
use crate::{Placed, progress::Progress};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;

/// Point at which a run was taken up.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Reentered {
    /// Place where the machine stood.
    pub place: Placed,
    /// Share of the move at hand that had been made.
    pub within: f64,
    /// Number of steps that were told before.
    #[serde(default)]
    told: u64,
    /// Switches that somebody has moved since the run was cut short.
    #[serde(default)]
    pub moved: Switches,
    /// All switches as they were left.
    #[serde(default)]
    pub(super) left: Switches,
}

impl Tape {
    /// Tells whether the run was taken up here before, and cut short again.
    pub fn is_reentered(&self) -> bool {
        let told = |kind: &Kind| !matches!(kind, Kind::Reentry | Kind::Left);
        let others = || self.played.iter().any(|(kind, steps)| told(kind) && !steps.is_empty());
        self.next_reentry().is_some_and(|reentry| reentry.told <= self.told || !others())
    }

    /// Tells whether the run is taken up in the middle of the next move: where it was before, or now.
    pub fn reenters_within(&self) -> bool {
        let told = self.next_reentry().filter(|_| self.is_reentered());
        told.map_or(self.is_within(), |told| told.within > 0.0)
    }

    /// The next time at which the run was taken up, when as many moves were made by then as are now.
    fn next_reentry(&self) -> Option<Reentered> {
        let next = self.played.get(&Kind::Reentry).and_then(VecDeque::front);
        let next = next.filter(|step| step.call == self.reached.made)?;
        serde_json::from_value(next.told.clone()).ok()
    }

    /// Returns the point at which the run was taken up when it had come so far, if it was.
    pub fn reentered(&mut self) -> Option<Reentered> {
        if !self.is_reentered() {
            return None;
        }
        // Given up meanwhile, it is where it was.
        self.stood = Some((self.made_before, self.within_before));
        self.is_back();
        self.pop(Kind::Reentry)
    }

    /// Returns `true` if the power went at this place, in an earlier run or in this one. The run that is taken up then
    /// decides what happens between here and the next move.
    pub fn is_open(&mut self) -> bool {
        if self.open || !self.silent {
            return self.open;
        }
        let here = (self.told, self.reached.made);
        let next = self.played.get(&Kind::Left).and_then(VecDeque::front);
        let next = next.filter(|step| step.call == self.reentries);
        if next.is_some_and(|step| <(u64, u64)>::deserialize(&step.told).ok() == Some(here)) {
            self.open = self.pop::<(u64, u64)>(Kind::Left).is_some();
        } else if self.is_last_told() {
            self.open = true;
            self.add(Kind::Left, self.reentries, &here);
        }
        self.open
    }

    fn is_back(&mut self) {
        (self.open, self.reentries) = (false, self.reentries + 1);
    }

    /// The run is taken up, by a machine that stands at a place. Gives how much of the next move is made.
    pub fn reenter(&mut self, place: Placed) -> Reentered {
        // What was told behind what is sure has brought the run to another move, which is made from its beginning.
        let is_there = self.lag.is_none() || self.reached.made == self.made_before;
        let within = if is_there { self.within_before } else { 0.0 };
        let [left, before] = std::mem::take(&mut self.switches);
        let moved = left.iter().filter(|switch| !before.contains(switch)).copied().collect();
        let told = Reentered { place, within, told: self.told, moved, left };
        let made = self.reached.made;
        self.is_back();
        self.add(Kind::Reentry, made, &told);
        let last = self.writing.as_ref().and_then(Progress::last_step);
        self.back = last.map(|last| (last, (made, within)));
        self.reached.place = place;
        self.write();
        self.settle();
        told
    }
}
