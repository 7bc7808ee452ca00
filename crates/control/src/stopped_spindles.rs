//! Spindles and axes that turn or move by themselves, and stop with a stop input.

use kerf_program::{Axis, Independent};

/// Spindles that turned and axes that moved by themselves, until they may again.
#[derive(Clone, Debug, Default)]
pub(crate) struct StoppedSpindles {
    /// Outputs of spindles.
    pub spindles: Vec<u8>,
    /// Axes with their motion.
    pub alone: Vec<(Axis, Independent)>,
}

impl StoppedSpindles {
    /// Returns `true` if nothing turned or moved by itself.
    pub const fn is_empty(&self) -> bool {
        self.spindles.is_empty() && self.alone.is_empty()
    }

    /// These too, each once.
    pub fn add(&mut self, spindles: Vec<u8>, alone: Vec<(Axis, Independent)>) {
        for number in spindles {
            if !self.spindles.contains(&number) {
                self.spindles.push(number);
            }
        }
        for (axis, motion) in alone {
            if self.alone.iter().all(|(other, _)| *other != axis) {
                self.alone.push((axis, motion));
            }
        }
    }
}
