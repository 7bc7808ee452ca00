//! Round steps for rulers and scales, in the unit a person reads.

use crate::scene::Unit;

/// A ruler's step and how many minor steps it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Distance of numbers, mm.
    pub mm: f64,
    /// Minor steps in it.
    pub minor: u32,
    /// Decimals that its multiples need in the user's unit.
    pub decimals: usize,
}

/// The smallest round step of at least `least_mm`.
///
/// Millimetres go 1, 2, 5; inches below one go 1, 2.5, 5 and above it in the steps of a rule.
pub fn round_step(least_mm: f64, unit: Unit) -> Step {
    let least = least_mm / unit.mm;
    let inches = unit.mm > 2.0;
    let candidates = (-6i32..10).flat_map(|exponent| {
        let steps: [(f64, u32, usize); 3] = if inches && exponent < 0 {
            [(1.0, 5, 0), (2.5, 5, 1), (5.0, 5, 0)]
        } else {
            [(1.0, 5, 0), (2.0, 4, 0), (5.0, 5, 0)]
        };
        steps.map(|(factor, minor, extra)| {
            let decimals = if exponent < 0 { exponent.unsigned_abs() as usize + extra } else { 0 };
            (factor * 10f64.powi(exponent), minor, decimals)
        })
    });
    let rule = [(3.0, 3, 0), (6.0, 6, 0), (12.0, 6, 0), (24.0, 4, 0), (48.0, 4, 0)];
    let on_rule = |v: f64| inches && (4.0..99.0).contains(&v);
    let (value, minor, decimals) = candidates
        .filter(|c| !on_rule(c.0))
        .chain(rule.into_iter().filter(|_| inches))
        .filter(|c| c.0 >= least * (1.0 - 1e-9))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap_or((1.0e10, 5, 0));
    Step { mm: value * unit.mm, minor, decimals }
}

/// The multiples of a step from `low` to `high`, as numbers of steps; at most `most` of them.
pub fn multiples(low: f64, high: f64, step: f64, most: usize) -> impl Iterator<Item = i64> {
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last).take(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round_in_the_users_unit() {
        for (least, unit, value, decimals) in [
            (7.0, Unit::MM, 10.0, 0),
            (10.0, Unit::MM, 10.0, 0),
            (130.0, Unit::MM, 200.0, 0),
            (0.03, Unit::MM, 0.05, 2),
            (5.0, Unit::INCH, 0.25, 2),
            (100.0, Unit::INCH, 6.0, 0),
            (200.0, Unit::INCH, 12.0, 0),
            (2000.0, Unit::INCH, 100.0, 0),
        ] {
            let step = round_step(least, unit);
            assert!((step.mm / unit.mm - value).abs() < 1e-9, "{least}: {step:?}");
            assert_eq!(step.decimals, decimals, "{least}");
        }
    }

    #[test]
    fn multiples_lie_inside() {
        assert_eq!(multiples(-12.0, 20.0, 10.0, 99).collect::<Vec<_>>(), [-1, 0, 1, 2]);
        assert_eq!(multiples(0.0, 1.0e9, 1.0, 5).count(), 5);
    }
}
