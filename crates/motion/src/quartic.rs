//! The way of one axis over a short stretch of time as a polynomial of degree 4.
//!
//! Time runs from −1 to 1 over the stretch. The polynomial passes through five places of the motion, at −1, −√½, 0, √½
//! and 1 (Chebyshev's points of the second kind), where its greatest error is nearly the least possible. A ramp with
//! jerk is of degree 3 and is met exactly; on an arc what is left falls with the fifth power of the stretch.

use std::f64::consts::FRAC_1_SQRT_2;

/// Moments at which the motion is looked at.
pub(crate) const NODES: [f64; 5] = [-1.0, -FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2, 1.0];
/// Moments between them, one in each gap, at which motion and polynomial are compared.
pub(crate) const CHECKS: [f64; 4] = [-0.9, -0.4, 0.4, 0.9];
/// Most steps of a search: halving alone needs so many for the exactness of a double.
const SEARCH: usize = 64;

/// Coefficients, the constant one first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quartic([f64; 5]);

impl Quartic {
    /// The polynomial through the places at [`NODES`].
    pub fn through([a, b, c, d, e]: [f64; 5]) -> Self {
        // Even and odd parts are independent: values at ±1 and ±√½ give two unknowns each.
        let [even, even_near] = [0.5 * (a + e) - c, 0.5 * (b + d) - c];
        let [odd, odd_near] = [0.5 * (e - a), 0.5 * (d - b) / FRAC_1_SQRT_2];
        let [c1, c3] = [2.0 * odd_near - odd, 2.0 * (odd - odd_near)];
        let [c2, c4] = [4.0 * even_near - even, 2.0 * even - 4.0 * even_near];
        Self([c, c1, c2, c3, c4])
    }

    /// The place at a time.
    pub fn at(&self, x: f64) -> f64 {
        let [a, b, c, d, e] = self.0;
        a + x * (b + x * (c + x * (d + x * e)))
    }

    /// Speed at a time.
    pub fn speed(&self, x: f64) -> f64 {
        let [_, b, c, d, e] = self.0;
        b + x * (2.0 * c + x * (3.0 * d + x * 4.0 * e))
    }

    /// Half the acceleration at a time.
    fn bend(&self, x: f64) -> f64 {
        let [_, _, c, d, e] = self.0;
        c + x * (3.0 * d + x * 6.0 * e)
    }

    /// The time at which it turns round, where its speed has opposite signs at both ends.
    pub fn turn(&self) -> Option<f64> {
        let [mut low, mut high] = [-1.0, 1.0];
        let begin = self.speed(low);
        if begin * self.speed(high) >= 0.0 {
            return None;
        }
        for _ in 0..SEARCH {
            let middle = 0.5 * (low + high);
            if self.speed(middle) * begin > 0.0 { low = middle } else { high = middle }
        }
        Some(high)
    }

    /// The time within a span at which it passes a place, sought from a guess on by Newton's steps, and by halving where
    /// one leads out of the span. It goes one way in the span, forward or back.
    pub fn passes(&self, place: f64, forward: bool, span: [f64; 2], guess: f64, exact: f64) -> f64 {
        let [mut low, mut high] = span;
        let mut x = guess.clamp(low, high);
        for _ in 0..SEARCH {
            let (off, speed) = (place - self.at(x), self.speed(x));
            if (off > 0.0) == forward {
                low = x
            } else {
                high = x
            }
            let step = off / speed;
            let next = x + step;
            if next >= low && next <= high {
                // The error behind a step of Newton is bend / speed · step².
                if step * step * self.bend(x).abs() <= exact * speed.abs() {
                    return next;
                }
                x = next;
            } else if high - low <= exact {
                return high;
            } else {
                x = 0.5 * (low + high);
            }
        }
        high
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(f: impl Fn(f64) -> f64) -> Quartic {
        Quartic::through(NODES.map(f))
    }

    #[test]
    fn a_polynomial_of_degree_four_is_met() {
        let f = |x: f64| 3.0 - x + 0.5 * x * x + 2.0 * x.powi(3) - 0.25 * x.powi(4);
        let quartic = of(f);
        for x in CHECKS {
            assert!((quartic.at(x) - f(x)).abs() < 1e-14, "{x}");
            assert!((quartic.speed(x) - (-1.0 + x + 6.0 * x * x - x.powi(3))).abs() < 1e-13, "{x}");
        }
    }

    #[test]
    fn a_place_is_passed_when_the_motion_is_there() {
        let f = |x: f64| 100.0 * (x + 0.1 * x * x);
        for forward in [true, false] {
            let sign = if forward { 1.0 } else { -1.0 };
            let quartic = of(|x| sign * f(x));
            for guess in [-1.0, 0.3, 1.0] {
                let x = quartic.passes(sign * f(0.25), forward, [-1.0, 1.0], guess, 1e-12);
                assert!((x - 0.25).abs() < 1e-12, "{x} from {guess}");
            }
        }
    }

    #[test]
    fn a_place_is_found_right_behind_a_turn_and_never_outside_the_span() {
        let quartic = of(|x| x * x);
        assert!(quartic.turn().is_some_and(|x| x.abs() < 1e-15));
        let x = quartic.passes(1e-8, true, [0.0, 1.0], 1.0, 1e-13);
        assert!((x - 1e-4).abs() < 1e-12, "{x}");
        assert_eq!(quartic.passes(-1e-3, true, [0.0, 1.0], 0.5, 1e-12).max(1e-12), 1e-12);
        assert_eq!(of(|x| x + 2.0).turn(), None);
    }
}
