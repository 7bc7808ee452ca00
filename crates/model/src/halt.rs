//! Inputs that stop motion.

use crate::inputs::{self, Duty, Inputs};
use kerf_program::settings::IoModes;
use std::collections::BTreeSet;

/// A change of an input that a program waits for (ON INPUT).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched {
    /// Its number.
    pub input: u8,
    /// Fires when the input changes to this state.
    pub on: bool,
    /// Motion slows along its ramp first, else it stops at once.
    pub ramped: bool,
    /// From this machine time on the state alone fires, and nothing before; without it every change
    /// to the state does.
    pub level_from_s: Option<f64>,
}

/// A moment at which motion is stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Halt {
    /// Time at which the input changed, seconds of machine time.
    pub t_s: f64,
    /// Cause of the halt.
    pub cause: HaltCause,
    /// Motion slows along its ramp.
    pub ramped: bool,
}

/// Cause for which motion is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HaltCause {
    /// A watched input changed; the index into the list of watches.
    Watch(usize),
    /// A limit input was triggered; its number.
    Limit(u8),
    /// A stop input was triggered; its number.
    Stop(u8),
    /// The controller does not answer any more: it slows down by itself.
    LinkLost,
    /// A motor has stalled.
    Stall,
}

/// Inputs that stop a machine beside stops and watched ones.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Heeds<'a> {
    /// Limits; where nothing moves they have nothing to stop.
    pub limits: bool,
    /// Motors that stall.
    pub stalls: bool,
    /// Limit switches that do not stop.
    pub past: &'a BTreeSet<u8>,
}

impl Heeds<'_> {
    fn limit(&self, input: u8) -> bool {
        self.limits && !self.past.contains(&input)
    }
}

/// The first change of the script, not later than a time, or the first state that is looked at from
/// a moment on, that stops motion. The inputs are left as they are.
pub(crate) fn first(
    inputs: &Inputs,
    until_s: f64,
    modes: &IoModes,
    watches: &[Watched],
    heeds: Heeds<'_>,
) -> Option<Halt> {
    let level = first_level(inputs, until_s, modes, watches);
    let change = first_change(inputs, until_s, modes, watches, heeds);
    match (level, change) {
        (Some(level), Some(change)) if change.t_s <= level.t_s => Some(change),
        (level, change) => level.or(change),
    }
}

fn first_level(
    inputs: &Inputs,
    until_s: f64,
    modes: &IoModes,
    watches: &[Watched],
) -> Option<Halt> {
    let halt = |(i, watch): (usize, &Watched)| {
        let from_s = watch.level_from_s?;
        let t_s = inputs.when(watch.input, watch.on, from_s, modes)?;
        let cause = HaltCause::Watch(i);
        (t_s <= until_s).then_some(Halt { t_s, cause, ramped: watch.ramped })
    };
    let halts = watches.iter().enumerate().filter_map(halt);
    halts.min_by(|a, b| a.t_s.total_cmp(&b.t_s))
}

fn first_change(
    inputs: &Inputs,
    until_s: f64,
    modes: &IoModes,
    watches: &[Watched],
    heeds: Heeds<'_>,
) -> Option<Halt> {
    let mut inputs = inputs.clone();
    while let Some(change) = inputs.step(until_s, modes) {
        let triggered = inputs::triggers(change.input, change.on, modes);
        let cause = match inputs::duty(change.input, modes) {
            Duty::Stop if triggered => Some(HaltCause::Stop(change.input)),
            Duty::Cable if triggered => Some(HaltCause::LinkLost),
            Duty::Stall if triggered && heeds.stalls => Some(HaltCause::Stall),
            Duty::Limit if triggered && heeds.limit(change.input) => {
                Some(HaltCause::Limit(change.input))
            }
            _ => watching(change.input, change.on, modes, watches).map(HaltCause::Watch),
        };
        if let Some(cause) = cause {
            let ramped = match cause {
                HaltCause::Watch(i) => watches[i].ramped,
                HaltCause::Limit(_) | HaltCause::Stall => false,
                HaltCause::LinkLost => true,
                HaltCause::Stop(number) => number != inputs::STOP_INPUT,
            };
            return Some(Halt { t_s: change.at_s, cause, ramped });
        }
    }
    None
}

fn watching(input: u8, closed: bool, modes: &IoModes, watches: &[Watched]) -> Option<usize> {
    let on = inputs::signal(input, closed, modes);
    let fires = |w: &Watched| w.level_from_s.is_none() && w.input == input && w.on == on;
    watches.iter().position(fires)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Change;
    use kerf_program::Settings;

    const ALL: Heeds<'_> = Heeds { limits: true, stalls: true, past: &BTreeSet::new() };

    fn check(input: u8, on: bool, mode: u8, watched: bool, expected: Option<HaltCause>) {
        let mut modes = Settings::default().io;
        modes.inputs[usize::from(input) - 1] = mode;
        let inputs = Inputs::new(vec![Change { input, at_s: 1.0, on }]);
        let watch = Watched { input, on, ramped: true, level_from_s: None };
        let watches = if watched { vec![watch] } else { Vec::new() };
        let halt = first(&inputs, 5.0, &modes, &watches, ALL);
        assert_eq!(halt.map(|h| h.cause), expected, "input {input} to {on}, mode {mode}");
        assert_eq!(first(&inputs, 0.9, &modes, &watches, ALL), None);
    }

    #[test]
    fn modes_say_which_change_stops() {
        use HaltCause::{Limit, Stop, Watch};
        check(2, true, 0, false, None);
        check(2, true, 0, true, Some(Watch(0)));
        check(2, true, 1, true, Some(Limit(2)));
        check(2, false, 1, true, Some(Watch(0)));
        check(2, false, 2, false, Some(Limit(2)));
        check(5, true, 3, false, Some(Stop(5)));
        check(5, false, 4, false, Some(Stop(5)));
        check(4, false, 0, false, Some(Stop(4)));
        check(4, true, 0, false, None);
    }

    #[test]
    fn limits_can_be_switched_off_and_overridden() {
        let mut modes = Settings::default().io;
        modes.inputs[1] = 1;
        let inputs = Inputs::new(vec![Change { input: 2, at_s: 1.0, on: true }]);
        assert!(first(&inputs, 5.0, &modes, &[], ALL).is_some());
        assert!(first(&inputs, 5.0, &modes, &[], Heeds { limits: false, ..ALL }).is_none());
        let past = |input: u8| {
            let past = BTreeSet::from([input]);
            first(&inputs, 5.0, &modes, &[], Heeds { past: &past, ..ALL }).is_none()
        };
        assert!(past(2) && !past(3), "one switch that is overridden leaves the others");
        modes.limits_active = false;
        assert!(first(&inputs, 5.0, &modes, &[], ALL).is_none());
    }
}
