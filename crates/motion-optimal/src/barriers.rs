//! The conditions on speed, acceleration and jerk over a piece.

use crate::condition::{Conditions, LANES, Quad, Rows, dots, quad};
use crate::pieces::Part;

/// Rows of one ordinate each.
pub(crate) fn diagonal(v: &Quad) -> Rows {
    std::array::from_fn(|k| quad(|lane| if lane == k { v[k] } else { 0.0 }))
}

/// The conditions on the speed: about half of the cap, and not farther than half of it.
pub(crate) fn on_speed<'a>(rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
    let half = quad(|lane| if lane < 3 && rows[lane][lane] > 0.0 { 1.0 } else { 0.0 });
    let value = dots(rows, x);
    let value = quad(|lane| value[lane] - half[lane]);
    Conditions { value, value_rows: rows, limit: [1.0; LANES], limit_rows: None }
}

/// The conditions on the acceleration of an axis.
pub(crate) fn on_accel<'a>(rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
    Conditions { value: dots(rows, x), value_rows: rows, limit: [1.0; LANES], limit_rows: None }
}

/// 1/√x over a part, which is nowhere below its tangent at the mean of x.
///
/// With the mean m = (y₀ + y₁ + y₂)/3 of the ordinates y over the part the tangent is, at an ordinate y,
///
/// ```text
///  u(y) = m^(−1/2)·(3/2 − y/2m),   ∂u/∂y = −½·m^(−3/2),   ∂u/∂m = ¾·m^(−3/2)·(y/m − 1)
/// ```
///
/// and both count, as y and m are linear in x.
pub(crate) struct Unit {
    /// Ordinates of x over the part; what stands in the last lane is no more than their mean.
    pub y: Quad,
    limit: Quad,
    tangent: Rows,
}

impl Unit {
    pub fn new<const N: usize>(part: &Part<N>, x: &[f64; 3]) -> Self {
        let mut y = dots(&part.ordinates, x);
        let third = 1.0 / 3.0;
        let mean = (y[0] + y[1] + y[2]) * third;
        y[3] = mean;
        let (inverse, root) = (1.0 / mean, 1.0 / mean.sqrt());
        let own = -0.5 * root * inverse;
        let others = y.map(|y| 0.75 * root * inverse * (y * inverse - 1.0));
        let tangent = std::array::from_fn(|k| {
            let row = &part.ordinates[k];
            let by_mean = (row[0] + row[1] + row[2]) * third;
            quad(|m| own * row[m] + others[m] * by_mean)
        });
        let limit = y.map(|y| root * (1.5 - 0.5 * y * inverse));
        Self { y, limit, tangent }
    }

    /// The conditions on the jerk of an axis.
    pub fn on_jerk<'a>(&'a self, rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
        Conditions {
            value: dots(rows, x),
            value_rows: rows,
            limit: self.limit,
            limit_rows: Some(&self.tangent),
        }
    }
}
