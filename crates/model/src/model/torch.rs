//! Torch height (command reference, VH): while X and Y move, Z falls as long as input 1 is ON and
//! rises while it is OFF. It rides on top of the planned motion, as what MI moves does.

use crate::independent::Spin;
use crate::log::{Log, What};
use kerf_program::{Axis, Independent};

/// Motion of Z by the torch, beside the plan.
#[derive(Clone, Debug, Default)]
pub(super) struct Torch {
    spin: Spin,
    /// Speed of that motion now, mm/s, upwards or downwards.
    mm_s: f64,
}

impl Torch {
    /// Z rides at this speed from here on, mm/s, as soon as it is steered; 0 for not at all.
    pub const fn ride(&mut self, mm_s: f64) {
        self.mm_s = mm_s;
    }

    /// Returns `true` if Z does not move, and steering does not make it.
    pub fn rests(&self) -> bool {
        self.mm_s <= 0.0 && !self.spin.moves()
    }

    /// Turns Z down while the input is on, or up.
    pub fn steer(&mut self, t_s: f64, on: bool, log: &mut Log) {
        let motion = match self.mm_s {
            still if still <= 0.0 => Independent::Off,
            down if on => Independent::Rotate(-down),
            up => Independent::Rotate(up),
        };
        if self.spin.motion() != motion {
            self.spin.change(t_s, motion);
            log.add(t_s, What::Independent { axis: Axis::Z, motion });
        }
    }

    /// Returns how far it has carried Z, mm.
    pub fn displacement(&self, t_s: f64) -> f64 {
        self.spin.displacement(t_s)
    }

    /// Ends its motion; returns how far it has carried Z, mm.
    pub fn end(&mut self, t_s: f64) -> f64 {
        self.spin.end(t_s)
    }
}
