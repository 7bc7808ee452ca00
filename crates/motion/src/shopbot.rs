//! The ramps of the OpenSBP command reference (section "Ramping", command VR).
//!
//! The model chooses the highest speed of each move and of each joint between moves; the look-ahead
//! ([`fit`]) then sees to it that acceleration suffices. What slows:
//!
//! * the start and end of a stack, a jog on either side, and a change between moves whose speeds
//!   mean different things (XY and Z alone): ramp speed;
//! * a change of direction in XY: the corner rule, for the joint itself and for what the direction
//!   changes around it within the minimum distance, and a full ramp for 43° with a radius under
//!   .25 in;
//! * a change of speed of Z, A, B or C (or of XY against Z, where a feed is along the XYZ path)
//!   above that axis' ramp speed times the 3D threshold: down to the speed at which the change is
//!   just that large, which is ramp speed at the lowest;
//! * an arc, as the curve that it is; a closed circle only by VR's small circle size and a limited
//!   sharpness (see `caps`);
//! * a run between full corners too short to double the ramp speed: ramp speed throughout.

use crate::moves::Move;
use crate::plan::Plan;
use crate::planner::{Model, Planner};
use crate::window::ShopBotPlanner;
use kerf_program::settings::Ramps;

/// Linear ramps between ramp speed and move speed, slowed where the direction changes.
#[derive(Clone, Copy, Debug)]
pub struct ShopBot<'a> {
    /// Ramps as VR sets them.
    pub ramps: &'a Ramps,
}

/// Plans a stack with the ramps of the command reference.
pub fn plan_stack(moves: Vec<Move>, ramps: &Ramps) -> Plan {
    ShopBot { ramps }.plan(moves)
}

impl Model for ShopBot<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        ShopBotPlanner::of(self.ramps, moves).finish().unwrap_or_default()
    }
}
