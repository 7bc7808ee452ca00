//! The start of a plasma cut, and what ends one early (Profiler reference, "Plasma Startup
//! Sequence"; readings, P-75, P-85, Events of a job).

use crate::Sequence;
use crate::small::{Awaited, Small};
use kerf_machine::lines::{Input, Output};
use kerf_program::job::JobShape;
use std::sync::Arc;

impl Sequence {
    /// Down until the head is too close, up to the initial height, then the arc.
    pub(crate) fn plasma_start(&self, shape: &JobShape) -> Vec<Small> {
        let plasma = self.machine.plasma;
        let arc = Small::Await(Awaited {
            input: Input::EndBottomDelay,
            timeout_s: plasma.arc_timeout_s,
            missing: Some("no arc"),
        });
        let mut steps = self.tool_on(self.tool_of(shape));
        steps.extend([
            Small::Feel(self.heights.bottom_mm),
            Small::AboveFelt(plasma.initial_height_mm),
            Small::Height(self.height_law(shape).map(Arc::new)),
            Small::Switch(Output::cut(shape.cut), true),
            arc.clone(),
            // Whatever the arc does meanwhile: it has to burn afterwards.
            Small::Wait(plasma.initial_wait_s),
            arc,
        ]);
        steps.extend(self.beam_follows(shape));
        steps
    }
}
