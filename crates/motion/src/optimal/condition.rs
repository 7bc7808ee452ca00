//! Conditions on the ordinates of a piece, four side by side, as the interior-point method sees them:
//! how much is left of each limit, and how far a step may go.
//!
//! Side by side, because a processor then works at several of them at once.

/// A condition that is not met yet is sought with so much of its limit to spare, and so strongly.
const SPARE: f64 = 0.2;
const PULL: f64 = 100.0;

/// Share of the way to the nearest barrier that a step goes at most.
pub(crate) const NEARLY: f64 = 0.95;

/// Number of conditions that stand side by side.
pub(crate) const LANES: usize = 4;

/// One number of each of them.
pub(crate) type Lanes = [f64; LANES];

/// Their coefficients of x₀, x₁ and x₂.
pub(crate) type Rows = [Lanes; 3];

/// Values, linear in the ordinates, that lie between minus and plus a limit, which may be linear too.
pub(crate) struct Conditions<'a> {
    pub value: Lanes,
    pub rows: &'a Rows,
    pub limit: Lanes,
    /// Coefficients by which the limits change.
    pub tangent: Option<&'a Rows>,
}

/// First and second derivative, by the slack, of what is minimised.
pub(crate) struct Force {
    pub first: Lanes,
    pub second: Lanes,
}

impl Conditions<'_> {
    /// Returns `true` if all are met.
    #[inline]
    pub fn kept(&self) -> bool {
        let [above, below] = self.slacks();
        // Counted, not searched, which a processor does at once.
        let met = lanes(|i| f64::from(u8::from(above[i] > 0.0 && below[i] > 0.0)));
        sum(&met) == LANES as f64
    }

    /// Returns the slack above and below the values; less than zero where the limit is exceeded.
    #[inline]
    fn slacks(&self) -> [Lanes; 2] {
        let (value, limit) = (&self.value, &self.limit);
        [lanes(|i| limit[i] - value[i]), lanes(|i| limit[i] + value[i])]
    }

    /// The forces from above and from below: of logarithmic barriers, or of parabolas where limits are
    /// exceeded.
    #[inline]
    pub fn forces(&self, kept: bool) -> [Force; 2] {
        let [above, below] = self.slacks();
        if kept {
            let both = lanes(|i| 1.0 / (above[i] * below[i]));
            let barrier = |other: &Lanes| {
                let inverse = lanes(|i| other[i] * both[i]);
                Force { first: inverse.map(|v| -v), second: inverse.map(|v| v * v) }
            };
            return [barrier(&below), barrier(&above)];
        }
        [above, below].map(|slack| {
            let forces: [[f64; 2]; LANES] = std::array::from_fn(|i| self.force(slack[i], i));
            Force { first: forces.map(|f| f[0]), second: forces.map(|f| f[1]) }
        })
    }

    fn force(&self, slack: f64, lane: usize) -> [f64; 2] {
        if slack > 0.0 {
            let inverse = slack.recip();
            return [-inverse, inverse * inverse];
        }
        let scale = self.limit[lane].abs().max(SPARE * self.value[lane].abs());
        let second = PULL / (scale * scale);
        [second * (slack - SPARE * scale), second]
    }

    /// Returns the share of a step, at most so much, that can be made with room to spare.
    #[inline]
    pub fn room(&self, step: &[f64; 3], most: f64) -> f64 {
        let change = dots(self.rows, step);
        let limit = self.tangent.map_or([0.0; LANES], |tangent| dots(tangent, step));
        let slacks = self.slacks();
        let changes = [lanes(|i| change[i] - limit[i]), lanes(|i| -change[i] - limit[i])];
        let mut room = most;
        for (slack, change) in slacks.iter().zip(&changes) {
            let over = lanes(|i| most * change[i] - NEARLY * slack[i]);
            // A division only where it tells something new.
            if over[0].max(over[1]).max(over[2].max(over[3])) <= 0.0 {
                continue;
            }
            for (slack, change) in slack.iter().zip(change) {
                if *slack > 0.0 && room * change > NEARLY * slack {
                    room = NEARLY * slack / change;
                }
            }
        }
        room
    }
}

/// A number for each lane.
#[inline]
pub(crate) fn lanes(f: impl Fn(usize) -> f64) -> Lanes {
    std::array::from_fn(f)
}

/// The values of rows.
#[inline]
pub(crate) fn dots(rows: &Rows, x: &[f64; 3]) -> Lanes {
    lanes(|i| rows[0][i] * x[0] + rows[1][i] * x[1] + rows[2][i] * x[2])
}

/// The sum over the lanes.
#[inline]
pub(crate) fn sum(v: &Lanes) -> f64 {
    (v[0] + v[1]) + (v[2] + v[3])
}
