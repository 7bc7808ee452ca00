//! Intensity of a laser beam, a level or a law of the speed.

use crate::flips::{EXACT_S, SLICE_S};
use crate::log::{Log, What};
use kerf_motion::{Plan, Span};
use kerf_program::{Beam, IntensityLaw, MoveKind};

/// The intensity output. While commands are only drawn it has no log, and stays as it is.
#[derive(Clone, Debug)]
pub(super) struct Shine {
    beam: Beam,
    /// Time at which the beam that follows the speed goes off, in the move under way.
    ends_s: Option<f64>,
    /// State of the output: value and burn bit.
    intensity: (u8, bool),
}

impl Default for Shine {
    fn default() -> Self {
        Self { beam: Beam::Off, ends_s: None, intensity: (0, false) }
    }
}

impl Shine {
    pub const fn beam(&self) -> &Beam {
        &self.beam
    }

    /// From a moment on the output does this.
    pub fn set(&mut self, beam: Beam, t_s: f64, log: Option<&mut Log>) {
        let given = match &beam {
            Beam::Off => (0, false),
            Beam::Level { value, burn } => (*value, *burn),
            // At rest.
            Beam::Follow(law) => (law.value(0), false),
        };
        (self.beam, self.ends_s) = (beam, None);
        self.put(t_s, given, log);
    }

    /// Goes off at a moment in the middle of motion.
    pub fn drop_at(&mut self, t_s: f64, log: Option<&mut Log>) {
        if matches!(self.beam, Beam::Follow(_)) {
            // The move under way is told when it is made: up to there it shines.
            self.ends_s = Some(t_s);
        } else {
            self.beam = Beam::Off;
            self.put(t_s, (0, false), log);
        }
    }

    fn put(&mut self, t_s: f64, given: (u8, bool), log: Option<&mut Log>) {
        let Some(log) = log else { return };
        if std::mem::replace(&mut self.intensity, given) != given {
            let (value, burn) = given;
            log.add(t_s, What::Intensity { value, burn });
        }
    }

    /// Follows the speed over one move: a change at every step of the discretized speed.
    pub fn follow(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>, mut log: Option<&mut Log>) {
        let Beam::Follow(law) = self.beam.clone() else { return };
        if span.made.kind == MoveKind::Jog {
            return self.put(t0_s + span.t0_s, (0, false), log);
        }
        let end_s = self.ends_s.unwrap_or(f64::INFINITY);
        for (t_s, index) in index_changes(plan, span) {
            if t0_s + t_s < end_s {
                self.put(t0_s + t_s, (law.value(index), false), log.as_deref_mut());
            }
        }
        if end_s <= t0_s + span.t1_s {
            self.beam = Beam::Off;
            self.put(end_s, (0, false), log);
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
