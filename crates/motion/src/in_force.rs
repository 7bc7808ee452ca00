//! The model of motion that the settings ask for.

use crate::optimal::OptimalPlanner;
use crate::planner::Replanner;
use crate::profiler::ProfilerPlanner;
use crate::retimed::Retimed;
use crate::window::ShopBotPlanner;
use kerf_program::{RampModel, Settings};

/// The planner of the model of motion in force, for a stack that begins under these settings.
pub fn planner(settings: &Settings) -> Box<dyn Replanner> {
    let dynamics = settings.axis_dynamics();
    match settings.model() {
        RampModel::Shopbot => Box::new(ShopBotPlanner::new(&settings.ramps)),
        RampModel::Profiler => Box::new(ProfilerPlanner::new(&dynamics, &settings.smoothing)),
        RampModel::Optimal => Box::new(Retimed::new(OptimalPlanner::new(&dynamics))),
    }
}
