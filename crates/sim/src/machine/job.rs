//! Intensity, pulse frequency, jigs: what jobs use beside the switches.

use super::Machine;
use super::height::flips;
use crate::inputs::Change;
use crate::log::What;
use crate::scene::{self, Touch};
use crate::sheet::Sheet;
use kerf_machine::lines::{Input, Output};
use kerf_motion::{Plan, Span};
use kerf_program::{Beam, IntensityLaw, MoveKind, OutputReason};

/// Stretch of time in which speed is taken to only rise or only fall, seconds.
pub(super) const SLICE_S: f64 = 0.001;

/// Precision with which the moment is sought at which the speed passes a step, seconds.
pub(super) const EXACT_S: f64 = 1e-7;

impl Machine {
    /// From here on the intensity output does this.
    pub fn beam(&mut self, beam: Beam) {
        let given = match &beam {
            Beam::Off => (0, false),
            Beam::Level { value, burn } => (*value, *burn),
            // At rest.
            Beam::Follow(law) => (law.value(0), false),
        };
        (self.beam, self.beam_ends_s) = (beam, None);
        self.intensity_at(self.clock_s, given);
    }

    /// The pulse frequency of the laser, Hz.
    pub fn laser_frequency(&mut self, hz: f64) {
        if !self.draws() {
            self.log.add(self.clock_s, What::LaserFrequency(hz));
        }
    }

    /// The same machine with a sheet on its table, or without.
    #[must_use]
    pub const fn with_sheet(mut self, sheet: Option<Sheet>) -> Self {
        self.sheet = sheet;
        self
    }

    /// The same machine with things on its table that switches feel.
    #[must_use]
    pub fn with_touches(mut self, touches: &[Touch]) -> Self {
        self.touches = touches.into();
        let at = self.true_position();
        for input in scene::inputs(touches) {
            if let Some(on) = scene::contact(touches, input, &at) {
                self.inputs.put(input, on);
            }
        }
        self
    }

    /// Foresees what switches will feel on the way.
    fn foreseen_touches(&self, plan: &Plan, t0_s: f64) -> Vec<Change> {
        let change = |input: u8| {
            let felt = |t_s: f64| {
                let at = plan.at(t_s).position;
                scene::contact(&self.touches, input, &at).unwrap_or_default()
            };
            let from_s = (self.clock_s - t0_s).max(0.0);
            let flips = flips(from_s, plan.duration_s(), &felt).into_iter();
            flips.map(move |(t_s, on)| Change { input, at_s: t0_s + t_s, on })
        };
        scene::inputs(&self.touches).into_iter().flat_map(change).collect()
    }

    /// Motion will follow this plan from a moment on: what the sensors will tell is worked out.
    pub fn foresee(&mut self, plan: &Plan, t0_s: f64) {
        if self.draws() {
            return;
        }
        let ticks = self.foreseen_ticks(plan, t0_s);
        let mut all = self.foreseen_switches(plan, t0_s);
        all.extend(self.foreseen_sensors(plan, t0_s, &ticks));
        all.extend(self.foreseen_touches(plan, t0_s));
        all.extend(self.foreseen_faults(&ticks));
        all.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
        self.inputs.foresee(all);
    }

    /// The output of a jig switches its start switch off.
    pub(super) fn release_jig(&mut self, t_s: f64, number: u8, on: bool) {
        let jigs = [(Output::Jig1, Input::Jig1), (Output::Jig2, Input::Jig2)];
        let jig = jigs.into_iter().find(|(output, _)| on && output.number() == number);
        if let Some((_, input)) = jig.filter(|(_, input)| self.input(input.number())) {
            self.inputs.put(input.number(), false);
            self.log.add(t_s, What::Input { number: input.number(), on: false });
        }
    }

    /// Outputs go off at a moment in the middle of motion, and the intensity with them.
    pub fn drop_outputs(&mut self, t_s: f64, outputs: &[u8]) {
        for number in outputs {
            self.output_at(t_s, *number, false, OutputReason::Stop);
        }
        if outputs.is_empty() {
            return;
        }
        if matches!(self.beam, Beam::Follow(_)) {
            // The move under way is told when it is made: up to there it shines.
            self.beam_ends_s = Some(t_s);
        } else {
            self.beam = Beam::Off;
            self.intensity_at(t_s, (0, false));
        }
    }

    fn intensity_at(&mut self, t_s: f64, given: (u8, bool)) {
        if !self.draws() && std::mem::replace(&mut self.intensity, given) != given {
            let (value, burn) = given;
            self.log.add(t_s, What::Intensity { value, burn });
        }
    }

    /// Intensity over one move: a change at every step of the discretized speed.
    pub(super) fn shine(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>) {
        let Beam::Follow(law) = self.beam.clone() else { return };
        if span.made.kind == MoveKind::Jog {
            return self.intensity_at(t0_s + span.t0_s, (0, false));
        }
        let end_s = self.beam_ends_s.unwrap_or(f64::INFINITY);
        for (t_s, index) in index_changes(plan, span) {
            if t0_s + t_s < end_s {
                self.intensity_at(t0_s + t_s, (law.value(index), false));
            }
        }
        if end_s <= t0_s + span.t1_s {
            self.beam = Beam::Off;
            self.intensity_at(end_s, (0, false));
        }
    }
}

/// Finds when the discretized speed of a move changes, seconds of the plan, and to what: the whole of it is the speed
/// that is asked for, as the operator overrides it.
fn index_changes(plan: &Plan, span: &Span<'_>) -> Vec<(f64, u8)> {
    let full_mm_s = span.made.top_mm_s();
    let index = |t_s: f64| IntensityLaw::index(plan.at(t_s).path_speed_mm_s, full_mm_s);
    let first = (span.t0_s, IntensityLaw::index(span.v_entry, full_mm_s));
    let mut changes = vec![first];
    let last = (span.t1_s, IntensityLaw::index(span.v_exit, full_mm_s));
    let steady = span.v_entry == span.v_peak && span.v_peak == span.v_exit;
    let slices = if steady { 1 } else { ((last.0 - first.0) / SLICE_S).ceil().max(1.0) as u64 };
    let mut from = first;
    for slice in 1..=slices {
        let t_s = first.0 + (last.0 - first.0) * slice as f64 / slices as f64;
        let to = if slice == slices { last } else { (t_s, index(t_s)) };
        changes_between(from, to, &index, &mut changes);
        from = to;
    }
    changes
}

/// Every change in a stretch of time in which speed only rises or only falls.
fn changes_between(
    from: (f64, u8),
    to: (f64, u8),
    index: &impl Fn(f64) -> u8,
    changes: &mut Vec<(f64, u8)>,
) {
    if from.1 == to.1 {
        return;
    }
    if to.0 - from.0 <= EXACT_S {
        changes.push(to);
        return;
    }
    let middle_s = 0.5 * (from.0 + to.0);
    let middle = (middle_s, index(middle_s));
    changes_between(from, middle, index, changes);
    changes_between(middle, to, index, changes);
}
