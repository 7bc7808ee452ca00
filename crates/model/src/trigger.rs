//! The output that Z or A switches (command reference, VC fields 8-12).

use kerf_motion::Plan;
use kerf_program::settings::Trigger;
use kerf_program::{Axes, Axis};

/// Finds when a move switches the triggered output, seconds of the plan, and to which state.
///
/// Only vertical moves trigger: X and Y stand still. Downwards the output comes on when the axis
/// passes the ON threshold, at once when it starts below it; upwards it goes off when the axis passes
/// the OFF threshold.
pub(crate) fn switch(
    plan: &Plan,
    index: usize,
    trigger: &Trigger,
    working_zero: Axes,
) -> Option<(f64, bool)> {
    let made = plan.moves().get(index)?;
    let level = made.from[Axis::X] == made.to[Axis::X] && made.from[Axis::Y] == made.to[Axis::Y];
    if !trigger.active || !level {
        return None;
    }
    let axis = trigger.axis;
    let (from, to) = (made.from[axis], made.to[axis]);
    let on = to < from;
    let working = if on { trigger.on_at_mm } else { trigger.off_at_mm };
    let threshold = working + working_zero[axis];
    let beyond = if on { to < threshold } else { to > threshold };
    let passed = plan.pass_in(index, axis, threshold).map(|pass| pass.t_s);
    (from != to && beyond).then(|| (passed.unwrap_or(plan.span_s(index).0), on))
}
