//! The start of a plasma cut, and what ends one early (Profiler reference, "Plasma Startup
//! Sequence"; readings, P-75, P-85, Events of a job).

use crate::cut::Cut;
use crate::step::{Awaited, Step};
use kerf_machine::lines::{Input, Output};
use std::sync::Arc;

/// Down until the head is too close, up to the initial height, then the arc.
pub(crate) fn start(cut: &Cut<'_>, tool_on: Vec<Step>) -> Vec<Step> {
    let plasma = cut.setup.machine.plasma;
    let arc = Step::Await(Awaited {
        input: Input::EndBottomDelay,
        timeout_s: plasma.arc_timeout_s,
        missing: Some("no arc"),
    });
    let mut steps = tool_on;
    steps.extend([
        Step::Feel(cut.values.heights.bottom_mm),
        Step::AboveFelt(plasma.initial_height_mm),
        Step::Height(cut.height_law().map(Arc::new)),
        Step::Switch(Output::cut(cut.shape.cut), true),
        arc.clone(),
        // Whatever the arc does meanwhile: it has to burn afterwards.
        Step::Wait(plasma.initial_wait_s),
        arc,
    ]);
    steps.extend(cut.beam_follows());
    steps
}
