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

use crate::ahead::Ahead;
use crate::caps::{BLOCK, Caps};
use crate::fit::Fit;
use crate::moves::Move;
use crate::plan::Plan;
use crate::planner::Planner;
use crate::surge::Runs;
use kerf_program::settings::Ramps;

/// A model of motion: decides how fast a stack of moves is run.
pub trait Model {
    /// Plans a stack. It starts and ends at rest.
    fn plan(&self, moves: Vec<Move>) -> Plan;
}

/// Linear ramps between ramp speed and move speed, slowed where the direction changes.
#[derive(Clone, Copy, Debug)]
pub struct ShopBot<'a> {
    /// What VR says.
    pub ramps: &'a Ramps,
}

/// Plans a stack with the ramps of the command reference.
pub fn plan_stack(moves: Vec<Move>, ramps: &Ramps) -> Plan {
    ShopBot { ramps }.plan(moves)
}

impl Model for ShopBot<'_> {
    fn plan(&self, moves: Vec<Move>) -> Plan {
        let mut planner = ShopBotPlanner::new(self.ramps);
        planner.ahead.moves = moves;
        planner.finish().unwrap_or_default()
    }
}

/// Plans a stack with the ramps of the command reference while it is read.
///
/// What is kept: the moves within the minimum distance, those of a run between full corners that may
/// still prove short, and those on which the tool may have to slow for what comes; and a block, so
/// that the work for a move does not depend on how often pieces are taken.
#[derive(Clone, Debug)]
pub struct ShopBotPlanner {
    ramps: Ramps,
    ahead: Ahead,
    caps: Caps,
    runs: Runs,
    fit: Fit,
    /// The next piece is looked for when so many moves are known.
    enough: usize,
}

impl ShopBotPlanner {
    /// For a stack that is planned with these ramps.
    pub fn new(ramps: &Ramps) -> Self {
        Self {
            ramps: *ramps,
            ahead: Ahead::default(),
            caps: Caps::new(ramps, BLOCK),
            runs: Runs::new(ramps),
            fit: Fit::default(),
            enough: BLOCK,
        }
    }

    fn piece(&mut self, complete: bool) -> Option<Plan> {
        let Self { ahead, caps, runs, fit, .. } = self;
        caps.walk(ahead);
        if complete {
            caps.finish(ahead);
        }
        let settled = if complete { ahead.moves.len() } else { caps.settled(ahead) };
        let capped = runs.hold_short(ahead, settled, complete);
        let plan = fit.take(ahead, capped, complete)?;
        runs.left(plan.moves.len());
        Some(plan)
    }
}

impl Planner for ShopBotPlanner {
    fn push(&mut self, made: Move) {
        self.ahead.moves.push(made);
    }

    fn take(&mut self) -> Option<Plan> {
        if self.ahead.moves.len() < self.enough {
            return None;
        }
        let plan = self.piece(false);
        // What stays is looked at again: twice as many make up for it.
        self.enough = BLOCK.max(2 * self.ahead.moves.len());
        plan
    }

    fn finish(&mut self) -> Option<Plan> {
        let plan = self.piece(true);
        *self = Self::new(&self.ramps);
        plan
    }
}
