//! Planning while a program is read: moves go in at one end, finished pieces of plan come out at the
//! other, and only what a later move can still change is kept.
//!
//! ```text
//!  push ──► move … move   ──► take ──► Plan, Plan, …    times go on from piece to piece
//!           the window
//! ```

use crate::moves::Move;
use crate::optimal::OptimalPlanner;
use crate::plan::Plan;
use crate::profiler::ProfilerPlanner;
use crate::shopbot::ShopBotPlanner;
use kerf_program::{RampModel, Settings};

/// Plans one stack of moves, which starts and ends at rest, while it is read.
///
/// The pieces of plan that come out follow each other without a gap; each tells its times from the
/// start of the stack. Put together they do not depend on when pieces were taken.
pub trait Planner {
    /// The next move of the stack.
    fn push(&mut self, made: Move);

    /// The next piece of plan that no later move can change; `None` when more has to be known first.
    fn take(&mut self) -> Option<Plan>;

    /// The stack is complete: the last piece of its plan, which ends at rest; `None` when nothing is
    /// left. Moves pushed later belong to another stack, which begins at time 0.
    fn finish(&mut self) -> Option<Plan>;
}

/// The planner of the model of motion in force, for a stack that begins under these settings.
pub fn planner(settings: &Settings) -> Box<dyn Planner> {
    let dynamics = settings.axis_dynamics();
    match settings.model() {
        RampModel::Shopbot => Box::new(ShopBotPlanner::new(&settings.ramps)),
        RampModel::Profiler => Box::new(ProfilerPlanner::new(&dynamics, &settings.smoothing)),
        RampModel::Optimal => Box::new(OptimalPlanner::new(&dynamics)),
    }
}
