//! The heights in force, as they are told: ZSurface and ZTop go with Z while it follows the sheet
//! (Profiler reference, "Automatic Height Control").

use crate::{Event, RunOptions, Sink};
use kerf_diag::{Code, Diagnostic, Place};
use kerf_machine::lines::Input;
use kerf_machine::sequence::Sequence;
use kerf_program::job::Heights;
use kerf_program::{Gauge, HeightLaw};
use kerf_sim::Sheet;
use std::sync::Arc;

/// Heights in force, and what they are measured by: the height of the tool, and as soon as a sensor reads, the
/// sheet itself, which Z comes after.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Carried {
    heights: Heights,
    /// What they held for, Z of the machine frame, mm.
    held_at_mm: f64,
    /// The gap that was read last, mm.
    gap_mm: Option<f64>,
}

impl Carried {
    /// Heights that hold while the tool is at a height.
    pub const fn told(heights: Heights, z_mm: f64) -> Self {
        Self { heights, held_at_mm: z_mm, gap_mm: None }
    }

    /// The heights under a tool at a height over the sheet; the first that is read is what they were told for.
    pub fn read(&mut self, z_mm: f64, gap_mm: f64) -> Heights {
        if self.gap_mm.replace(gap_mm).is_none() {
            self.held_at_mm = z_mm - gap_mm;
        }
        self.at(z_mm)
    }

    /// The heights now that height control has brought the tool elsewhere.
    pub fn at(&self, z_mm: f64) -> Heights {
        let Heights { top_mm, surface_mm, bottom_mm } = self.heights;
        let by = z_mm - self.gap_mm.unwrap_or(0.0) - self.held_at_mm;
        Heights { top_mm: top_mm + by, surface_mm: surface_mm + by, bottom_mm }
    }
}

/// The event that tells them.
pub(crate) const fn event(heights: Heights, t: f64) -> Event {
    let Heights { top_mm: top, surface_mm: surface, bottom_mm: bottom } = heights;
    Event::Heights { top, surface, bottom, t }
}

/// Whether anything tells how high the head is: a sheet, or a script that moves the switches.
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
    let why = Diagnostic::new(Code::NoSheet, Place::line(job.clone(), 0), message.to_owned());
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
