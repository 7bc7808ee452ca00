//! The conditions on speed, acceleration and jerk over a piece.

use super::condition::{Conditions, LANES, Lanes, Rows, dots, lanes};
use super::pieces::Part;

/// Rows of one ordinate each.
pub(crate) fn diagonal(v: &Lanes) -> Rows {
    std::array::from_fn(|k| lanes(|lane| if lane == k { v[k] } else { 0.0 }))
}

/// The conditions on the speed: about half of the cap, and not farther than half of it.
pub(crate) fn on_speed<'a>(rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
    let half = lanes(|lane| if lane < 3 && rows[lane][lane] > 0.0 { 1.0 } else { 0.0 });
    let value = dots(rows, x);
    let value = lanes(|lane| value[lane] - half[lane]);
    Conditions { value, rows, limit: [1.0; LANES], tangent: None }
}

/// The conditions on the acceleration of an axis.
pub(crate) fn on_accel<'a>(rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
    Conditions { value: dots(rows, x), rows, limit: [1.0; LANES], tangent: None }
}

/// 1/√x over a part, which is nowhere below its tangent at the mean of x.
pub(crate) struct Unit {
    /// Ordinates of x over the part; what stands in the last lane is no more than their mean.
    pub y: Lanes,
    limit: Lanes,
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
            lanes(|m| own * row[m] + others[m] * by_mean)
        });
        let limit = y.map(|y| root * (1.5 - 0.5 * y * inverse));
        Self { y, limit, tangent }
    }

    /// The conditions on the jerk of an axis.
    pub fn on_jerk<'a>(&'a self, rows: &'a Rows, x: &[f64; 3]) -> Conditions<'a> {
        Conditions { value: dots(rows, x), rows, limit: self.limit, tangent: Some(&self.tangent) }
    }
}
