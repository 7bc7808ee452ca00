//! One condition on the ordinates of a piece, as the interior-point method sees it: how much is left
//! of a limit, and how far a step may go.

use super::pieces::Row;

/// A condition that is not met yet is sought with so much of its limit to spare, and so strongly.
const SPARE: f64 = 0.2;
const PULL: f64 = 100.0;

/// How far a step goes to the nearest barrier.
pub(crate) const NEARLY: f64 = 0.95;

/// A value, linear in the ordinates, lies between minus and plus a limit, which may be linear too.
pub(crate) struct Condition {
    pub value: f64,
    pub row: Row,
    pub limit: f64,
    /// How the limit changes.
    pub tangent: Option<Row>,
}

impl Condition {
    pub fn kept(&self) -> bool {
        self.value.abs() < self.limit
    }

    /// What is left on the upper and the lower side; below zero where the limit is exceeded.
    pub fn slacks(&self) -> [f64; 2] {
        [self.limit - self.value, self.limit + self.value]
    }

    /// First and second derivative by the slack of what is minimised on a side: a logarithmic barrier,
    /// or a parabola while the limit is exceeded.
    pub fn force(&self, slack: f64) -> [f64; 2] {
        if slack > 0.0 {
            let inverse = slack.recip();
            return [-inverse, inverse * inverse];
        }
        let scale = self.limit.abs().max(SPARE * self.value.abs());
        let second = PULL / (scale * scale);
        [second * (slack - SPARE * scale), second]
    }

    /// How much of a step, at most so much, can be made with room to spare.
    pub fn room(&self, step: &[f64; 3], most: f64) -> f64 {
        let change = dot(&self.row, step);
        let limit = self.tangent.as_ref().map_or(0.0, |tangent| dot(tangent, step));
        let mut room = most;
        for (slack, change) in self.slacks().into_iter().zip([change - limit, -change - limit]) {
            // A division only where it tells something new.
            if slack > 0.0 && room * change > NEARLY * slack {
                room = NEARLY * slack / change;
            }
        }
        room
    }
}

pub(crate) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
