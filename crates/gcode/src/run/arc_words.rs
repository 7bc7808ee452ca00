//! The words of G2 and G3.

use crate::syntax::gathered::Gathered;

/// The words of an arc.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArcWords {
    pub(super) clockwise: bool,
    /// I, J, K.
    pub(super) offsets: [Option<f64>; 3],
    pub(super) radius: Option<f64>,
    pub(super) turns: f64,
}

impl ArcWords {
    pub(super) fn of(g: &Gathered, clockwise: bool) -> Self {
        Self {
            clockwise,
            offsets: [g.get(b'I'), g.get(b'J'), g.get(b'K')],
            radius: g.get(b'R'),
            turns: g.get(b'P').unwrap_or(1.0),
        }
    }

    /// I, J and K, when all are given and nothing else.
    pub(super) fn all_offsets(&self) -> Option<[f64; 3]> {
        let [Some(i), Some(j), Some(k)] = self.offsets else { return None };
        (self.radius.is_none() && self.turns == 1.0).then_some([i, j, k])
    }
}
