//! Conditions −u ≤ v ≤ u on the ordinates x of a piece, as the interior-point method sees them: how much is
//! left of each limit, and how far a step may go.
//!
//! The value v is linear in x, and the limit u may be: v = r·x + …, u = t·x + …, with rows r and t of three
//! coefficients each. The slacks, above and below the value, are
//!
//! ```text
//!  s⁺ = u − v,  ∂s⁺/∂x = t − r          s⁻ = u + v,  ∂s⁻/∂x = t + r
//! ```
//!
//! Four conditions stand side by side in a [`Quad`], because a processor then works at several of them at once.

/// A condition that is not met yet is sought with so much of its limit to spare, and so strongly.
const SPARE: f64 = 0.2;
const PULL: f64 = 100.0;

/// Share of the way to the nearest barrier that a step goes at most.
pub(crate) const NEARLY: f64 = 0.95;

/// Number of conditions that stand side by side: the lanes of a processor's register.
pub(crate) const LANES: usize = 4;

/// A number of each of four conditions.
pub(crate) type Quad = [f64; LANES];

/// Rows of four conditions: the coefficients of x₀, of x₁ and of x₂.
pub(crate) type Rows = [Quad; 3];

/// Four conditions −u ≤ v ≤ u at the present ordinates.
pub(crate) struct Conditions<'a> {
    /// v.
    pub value: Quad,
    /// r: how the values change with the ordinates.
    pub value_rows: &'a Rows,
    /// u.
    pub limit: Quad,
    /// t: how the limits change with the ordinates; `None` where they do not.
    pub limit_rows: Option<&'a Rows>,
}

/// Derivatives of a penalty φ by its slack s: of the barrier φ = −ln s they are −1/s and 1/s²; of the parabola
/// that pulls a missed condition back they are k·(s − s₀) and k.
pub(crate) struct Force {
    /// φ′.
    pub first: Quad,
    /// φ″.
    pub second: Quad,
}

impl Conditions<'_> {
    /// Returns `true` if all are met.
    #[inline]
    pub fn kept(&self) -> bool {
        let [above, below] = self.slacks();
        // Counted, not searched, which a processor does at once.
        let met = quad(|i| f64::from(u8::from(above[i] > 0.0 && below[i] > 0.0)));
        sum(&met) == LANES as f64
    }

    /// Returns s⁺ and s⁻; less than zero where the limit is exceeded.
    #[inline]
    fn slacks(&self) -> [Quad; 2] {
        let (value, limit) = (&self.value, &self.limit);
        [quad(|i| limit[i] - value[i]), quad(|i| limit[i] + value[i])]
    }

    /// The forces by s⁺ and by s⁻: of barriers where all conditions are met, with one division for both,
    /// 1/s⁺ = s⁻·1/(s⁺s⁻); else of parabolas where limits are exceeded.
    #[inline]
    pub fn forces(&self, kept: bool) -> [Force; 2] {
        let [above, below] = self.slacks();
        if kept {
            let both = quad(|i| 1.0 / (above[i] * below[i]));
            let barrier = |other: &Quad| {
                let inverse = quad(|i| other[i] * both[i]);
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

    /// Returns the share of a step, at most so much, that can be made with room to spare: a slack s that a whole step
    /// takes by c may lose [`NEARLY`]·s.
    #[inline]
    pub fn room(&self, step: &[f64; 3], most: f64) -> f64 {
        let change = dots(self.value_rows, step);
        let limit = self.limit_rows.map_or([0.0; LANES], |rows| dots(rows, step));
        let slacks = self.slacks();
        let changes = [quad(|i| change[i] - limit[i]), quad(|i| -change[i] - limit[i])];
        let mut room = most;
        for (slack, change) in slacks.iter().zip(&changes) {
            let over = quad(|i| most * change[i] - NEARLY * slack[i]);
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

/// A number of each of four conditions.
#[inline]
pub(crate) fn quad(f: impl Fn(usize) -> f64) -> Quad {
    std::array::from_fn(f)
}

/// The values of rows: r·x.
#[inline]
pub(crate) fn dots(rows: &Rows, x: &[f64; 3]) -> Quad {
    quad(|i| rows[0][i] * x[0] + rows[1][i] * x[1] + rows[2][i] * x[2])
}

/// The sum of the four.
#[inline]
pub(crate) fn sum(v: &Quad) -> f64 {
    (v[0] + v[1]) + (v[2] + v[3])
}
