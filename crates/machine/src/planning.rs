//! The planner's settings for jobs and moves by hand, and the speed of a rapid move.

use crate::homing::turns_endlessly;
use crate::settings::Configuration;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Axis, RampModel, Settings};

/// Chords that a machine without arcs makes of a full circle.
pub const CHORDS: u32 = 360;

/// No knife turns so far in its life, degrees.
const ENDLESS_DEG: f64 = 1e12;

/// Returns the settings of the planner for moves by hand. Their ramps are as steep as the axes allow, unless the
/// machine names another model.
pub fn hand_settings(machine: &Configuration) -> Settings {
    planner_settings(machine, machine.program.ramp_model.unwrap_or(RampModel::Profiler))
}

/// Returns the settings of the planner for jobs. Their model of motion is that of part files: one machine moves
/// in one way.
pub fn job_settings(machine: &Configuration) -> Settings {
    planner_settings(machine, machine.program.model())
}

/// Millimetres, a model of motion, nothing that part files switch beside it.
fn planner_settings(machine: &Configuration, model: RampModel) -> Settings {
    let mut settings = machine.program.clone();
    settings.use_linear_unit(LinearUnit::Mm);
    settings.ramp_model = Some(model);
    settings.dynamics = Some(settings.axis_dynamics());
    settings.warning_s = 0.0;
    // Output 4 is no light here.
    settings.io.output4 = -4;
    settings.height.on = false;
    settings.cutter.trigger.active = false;
    if turns_endlessly(machine, Axis::C) {
        (settings.limits.low[Axis::C], settings.limits.high[Axis::C]) = (-ENDLESS_DEG, ENDLESS_DEG);
    }
    settings
}

/// The speed of a straight way at which the first axis reaches its own, mm/s.
pub fn rapid_mm_s(settings: &Settings, way: Axes) -> f64 {
    let length = way.first3().iter().map(|v| v * v).sum::<f64>().sqrt();
    let length = if length > 0.0 { length } else { way.0[3..].iter().map(|v| v.abs()).sum() };
    let own = settings.axis_dynamics().speed_mm_s;
    let time = way.zip(own, |way, own| way.abs() / own).0.into_iter().fold(0.0, f64::max);
    if time > 0.0 { length / time } else { f64::INFINITY }
}
