//! Torch height (command reference, VH): while X and Y move, Z falls as long as input 1 is ON and
//! rises while it is OFF. It rides on top of the planned motion, as what MI moves does.

use super::Machine;
use crate::log::What;
use kerf_motion::{Move, Path};
use kerf_program::{Axis, Independent};

/// The input of the torch's voltage control.
pub(super) const TORCH_INPUT: u8 = 1;

impl Machine {
    /// A move begins, or the machine comes to rest.
    pub(super) fn ride(&mut self, made: Option<&Move>) {
        let riding = made.filter(|made| self.settings.torch_on() && !self.draws() && in_xy(made));
        let rate = self.settings.height.rate;
        self.torch_mm_s = riding.map_or(0.0, |made| rate * made.speed_mm_s);
        self.steer_torch(self.clock_s);
    }

    /// Turns Z down or up by the state of the input.
    pub(super) fn steer_torch(&mut self, t_s: f64) {
        let motion = match self.torch_mm_s {
            still if still <= 0.0 => Independent::Off,
            down if self.input(TORCH_INPUT) => Independent::Rotate(-down),
            up => Independent::Rotate(up),
        };
        if self.torch.motion() != motion {
            self.torch.change(t_s, motion);
            self.log.add(t_s, What::Independent { axis: Axis::Z, motion });
        }
    }

    /// Adds the way that torch and height control have carried Z to the planned position: the next motion begins there.
    pub fn land_torch(&mut self) {
        self.torch_mm_s = 0.0;
        self.steer_torch(self.clock_s);
        self.position[Axis::Z] += self.torch.end(self.clock_s);
        self.position[Axis::Z] += std::mem::take(&mut self.follower).offset_mm;
    }
}

fn in_xy(made: &Move) -> bool {
    let moves = |axis: Axis| made.from[axis] != made.to[axis];
    matches!(made.path, Path::Arc { .. }) || moves(Axis::X) || moves(Axis::Y)
}
