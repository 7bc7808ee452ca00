//! One condition on the ordinates of a piece, as the interior-point method sees it: how much is left
//! of a limit, and how far a step may go.

use super::pieces::Row;

/// Room given to a condition that is not met yet, as a share of its value.
const RELAXED: f64 = 0.25;

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

    /// What is left on the upper and the lower side. While a limit is exceeded it counts as higher.
    pub fn slacks(&self) -> [f64; 2] {
        [slack(self.limit, self.value), slack(self.limit, -self.value)]
    }

    /// How much of a step, at most so much, can be made with room to spare.
    pub fn room(&self, step: &[f64; 3], most: f64) -> f64 {
        let change = dot(&self.row, step);
        let limit = self.tangent.as_ref().map_or(0.0, |tangent| dot(tangent, step));
        let mut room = most;
        for (slack, change) in self.slacks().into_iter().zip([change - limit, -change - limit]) {
            // A division only where it tells something new.
            if room * change > NEARLY * slack {
                room = NEARLY * slack / change;
            }
        }
        room
    }
}

/// What a value leaves of its limit, or of a higher one while it exceeds it.
fn slack(limit: f64, value: f64) -> f64 {
    if value < limit { limit - value } else { RELAXED * value.abs().max(limit.abs()) }
}

pub(crate) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
