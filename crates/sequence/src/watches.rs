//! Inputs that end the step at hand, or that must not change during it.

use crate::queue::Queue;
use crate::setup::Setup;
use crate::sheet::Sheet;
use crate::start::Start;
use crate::step::Step;
use kerf_machine::State;
use kerf_machine::lines::{Input, Output};
use kerf_program::Watch;

/// Returns the inputs that are watched now: those of the step at hand, and the emergency stop.
pub(crate) fn of(
    setup: &Setup,
    start: &Start,
    sheet: &Sheet,
    queue: &Queue,
    state: State,
) -> Vec<Watch> {
    let step = queue.steps.front();
    let mut watches = step.map_or(Vec::new(), |step| of_step(setup, start, sheet, step));
    if !matches!(state, State::Emergency | State::EmergencyStopping) {
        watches.push(emergency(setup));
    }
    watches
}

/// Returns the inputs that the step at hand waits for, or that must not change during it.
fn of_step(setup: &Setup, start: &Start, sheet: &Sheet, step: &Step) -> Vec<Watch> {
    let (arc, close) = (Input::EndBottomDelay.number(), Input::WHome.number());
    match step {
        Step::Await(awaited) => vec![Watch::level(awaited.input.number(), true, 0.0)],
        Step::AwaitJig => start.jig_watches(setup).into(),
        Step::Release => vec![release(setup)],
        Step::Lower(_) => vec![
            Watch::level(Input::ZHigh.number(), false, 0.0),
            Watch::level(Input::HeightSilent.number(), true, 0.0),
        ],
        Step::Feel(_) => vec![Watch::level(close, true, 0.0)],
        Step::Follow => {
            let mut watches = Vec::new();
            if setup.machine.plasma.use_sequence {
                watches.push(Watch::level(arc, false, setup.machine.plasma.debounce_s));
                watches.push(Watch::level(close, true, 0.0));
            }
            let faults = sheet.faults().iter();
            watches.extend(faults.map(|(input, _)| Watch::level(input.number(), true, 0.0)));
            watches
        }
        _ => Vec::new(),
    }
}

/// The emergency stop: cut outputs go off at once, the rest when the machine stands.
fn emergency(setup: &Setup) -> Watch {
    let cuts = [Output::Cut1, Output::Cut2, Output::Cut3];
    let (input, active) = (Input::EmergencyStop.number(), setup.machine.estop.active);
    let drops = cuts.into_iter().map(Output::number).collect();
    Watch { drops, ..Watch::level(input, active, 0.0) }
}

/// The emergency stop is released.
fn release(setup: &Setup) -> Watch {
    Watch::level(Input::EmergencyStop.number(), !setup.machine.estop.active, 0.0)
}
