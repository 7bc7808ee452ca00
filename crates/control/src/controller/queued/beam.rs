//! An output whose share of time follows the speed: the power of a laser.
//!
//! ```text
//!  speed │   ╱────────╲          share │   ┌┘‾‾‾‾‾‾‾‾└┐
//!        │  ╱          ╲      ─►       │  ┌┘          └┐     changes go with the steps, also with those of the way to rest
//!        └─╱────────────╲──►           └──┘            └──►
//! ```

use kerf_driver_klipper::mailbox::Set;
use kerf_program::IntensityLaw;
use std::sync::Arc;

/// Time for which a share holds at the least, seconds.
const SLICE_S: f64 = 0.001;
/// Levels above none.
const FULL: f64 = 127.0;

/// Law by which the share follows the speed.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// So much at the speed that is asked for, and in proportion below it.
    Proportional(f64),
    /// By a table of intensities.
    Table(Arc<IntensityLaw>),
}

impl Law {
    /// The share at a pace: the speed as a share of what is asked for, nothing in a jog.
    pub fn share(&self, pace: Option<f64>) -> f64 {
        let Some(pace) = pace else { return 0.0 };
        let index = IntensityLaw::index(pace, 1.0);
        match self {
            Self::Proportional(most) => most * f64::from(index) / FULL,
            Self::Table(law) => level(law.value(index)),
        }
    }
}

/// The share of an intensity 0 … 127.
pub fn level(value: u8) -> f64 {
    f64::from(value) / FULL
}

/// An output that follows the speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Follow {
    /// Its place among the outputs.
    output: usize,
    law: Law,
    /// The share that was told last.
    told: Option<f64>,
}

impl Follow {
    /// An output that follows from now on.
    pub const fn new(output: usize, law: Law) -> Self {
        Self { output, law, told: None }
    }

    /// Its changes between two moments, in order.
    pub fn changes(
        &mut self,
        [from_s, to_s]: [f64; 2],
        pace: impl Fn(f64) -> Option<f64>,
        clock: impl Fn(f64) -> u64,
    ) -> Vec<Set> {
        let slices = ((to_s - from_s) / SLICE_S).ceil().max(1.0) as u32;
        let length_s = (to_s - from_s) / f64::from(slices);
        let begins = (0..slices).map(|n| from_s + f64::from(n) * length_s);
        let shares = begins.map(|t_s| (t_s, self.law.share(pace(t_s + 0.5 * length_s))));
        let told = &mut self.told;
        let changed = shares.filter(|(_, share)| told.replace(*share) != Some(*share));
        changed.map(|(t_s, share)| Set { output: self.output, share, clock: clock(t_s) }).collect()
    }

    /// It goes off at a clock, where the machine stands: whatever its law says of no speed.
    pub fn off(&mut self, clock: u64) -> Set {
        self.told = Some(0.0);
        Set { output: self.output, share: 0.0, clock }
    }
}
