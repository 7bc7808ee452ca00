//! Somebody pushes the machine by hand.
//!
//! Motors with power hold their axes. Without power an axis can be pushed, and nobody but the
//! simulation knows: the controller goes on believing that the axis is where it was.

use kerf_program::{Axes, Axis};
use serde::{Deserialize, Serialize};

/// An axis is pushed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Push {
    /// The axis.
    pub axis: Axis,
    /// Time of the push, seconds of machine time.
    pub at_s: f64,
    /// Distance of the push, mm or degrees.
    pub by: f64,
}

/// Pushes still to come, and what all others came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Pushes {
    /// The next one last.
    script: Vec<Push>,
    /// Distance of each axis from where the controller believes it, mm or degrees.
    pub astray: Axes,
}

impl Pushes {
    /// Follows a script from here on; pushes at no finite time, or of no finite length, are left out.
    pub fn follow(&mut self, mut script: Vec<Push>) {
        script.retain(|push| push.at_s.is_finite() && push.by.is_finite());
        script.sort_by(|a, b| b.at_s.total_cmp(&a.at_s));
        self.script = script;
    }

    /// The next push up to a time.
    pub fn next(&mut self, to_s: f64) -> Option<Push> {
        let due = self.script.last().is_some_and(|push| push.at_s <= to_s);
        due.then(|| self.script.pop()).flatten()
    }
}
