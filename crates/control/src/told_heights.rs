//! The heights in force, as they are told: ZSurface and ZTop go with Z while it follows the sheet
//! (Profiler reference, "Automatic Height Control").

use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_journal::RunOptions;
use kerf_machine::lines::Input;
use kerf_program::job::Heights;
use kerf_program::{Gauge, HeightLaw};
use kerf_sequence::Sequence;
use kerf_sim::Sheet;
use kerf_trace::{Event, Sink};
use std::sync::Arc;

/// Heights that were told last, and the law by which they go with Z.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ToldHeights {
    heights: Heights,
    law: Option<HeightLaw>,
}

impl ToldHeights {
    /// These heights hold from now on.
    pub const fn hold(&mut self, heights: Heights) {
        self.heights = heights;
    }

    /// Height control begins, or ends.
    pub const fn follow(&mut self, law: Option<HeightLaw>) {
        self.law = law;
    }

    /// The heights now that height control has brought the tool to a height.
    pub fn at(&self, z_mm: f64) -> Heights {
        self.law.map_or(self.heights, |law| law.carried(self.heights, z_mm))
    }
}

/// The event that tells them.
pub(crate) const fn event(heights: Heights, t: f64) -> Event {
    let Heights { top_mm: top, surface_mm: surface, bottom_mm: bottom } = heights;
    Event::Heights { top, surface, bottom, t }
}

/// Returns `true` if anything tells how high the head is: a sheet, or a script that moves the switches.
fn is_sensed(law: &HeightLaw, options: &RunOptions) -> bool {
    let scripted = |input: Input| options.inputs.iter().any(|it| it.input == input.number());
    let simple = matches!(law.gauge, Gauge::Simple { .. });
    options.sheet.is_some() || simple && (scripted(Input::ZHigh) || scripted(Input::ZLow))
}

/// Tells before anything moves that height control will sense nothing.
pub(crate) fn tell_no_sheet(
    job: &Arc<str>,
    sequence: &Sequence,
    options: &RunOptions,
    sink: &mut dyn Sink,
) {
    if sequence.follows_sheet().is_none_or(|law| is_sensed(&law, options)) {
        return;
    }
    let message = "height control is on (height.on), and no sheet lies on the simulated table";
    let why = Diagnostic::new(Code::NoSheet, SourcePlace::line(job.clone(), 0), message.to_owned());
    let hint = if options.program.preview {
        "planned over a flat sheet, the tool cutting at ZSurface; --sheet lays another"
    } else {
        "the job pauses where the sensor is needed first; --sheet lays one, height.on = false does without"
    };
    sink.event(&Event::Diag(Box::new(why.hint(hint))));
}

/// The sheet that is taken to lie there where a job is only planned: flat, the tool cutting at ZSurface.
pub(crate) fn planned_sheet(sequence: &Sequence, preview: bool) -> Option<Sheet> {
    let law = sequence.follows_sheet().filter(|_| preview)?;
    Some(Sheet::followed_at(sequence.heights().surface_mm, &law))
}
