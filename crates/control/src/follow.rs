//! A piece of plan as it is followed, move by move, and left for another one where something stops it.

use crate::OperatorRequest;
use crate::interruption::Interruption;
use crate::station::Station;
use kerf_machine::{Going, Watch};
use kerf_model::{Halt, HaltCause, Watched, pin};
use kerf_motion::{Plan, Replanner, Stop};
use kerf_program::settings::IoModes;
use kerf_program::{Axes, Interpreter};

/// A piece of plan that was left on the way.
pub(crate) struct LeftPlan {
    /// Place in the piece where it was left.
    pub stop: Stop,
    /// Its cause.
    pub why: Interruption,
    /// Place of the machine when the cause came.
    pub began: Axes,
}

/// Follows a piece of plan, move by move, to its end or to where it is left for another.
pub(crate) fn follow_plan<I: Interpreter>(
    station: &mut Station<'_, I>,
    mut plan: Plan,
) -> Option<LeftPlan> {
    let t0_s = station.stack.running.as_ref()?.t0_s;
    let watched = station.watched(t0_s);
    let watches = pins(&watched, t0_s, &station.world.model.settings().io);
    station.world.tracked().follows(&plan, t0_s);
    if watches.is_empty() {
        station.take_waiting_feed();
    }
    let mut left: Option<LeftPlan> = None;
    let mut index = 0;
    while let Some(span) = plan.span(index) {
        if left.is_none() && station.is_taken_up() {
            station.stand_back(&plan.moves()[index..]);
            return None;
        }
        station.carry_out_marks();
        let [_, end_s] = station.moments(t0_s, [span.t0_s, span.t1_s]);
        match &left {
            Some(LeftPlan { stop, why, .. }) => {
                let (until, part) = (plan.moves().len(), stop.part(index));
                let going = Going { plan: &plan, index, t0_s, until, part, watches: &[] };
                station.slow_down(*why, end_s, going);
            }
            None => {
                let until = index.saturating_add(station.stack.before_mark());
                let (part, watches) = (1.0, &*watches);
                let going = Going { plan: &plan, index, t0_s, until, part, watches };
                let ask = Station::ask_pace;
                let met = station.meet(end_s, &watched, Some(&going), ask);
                if let Some((t_s, turn)) = met {
                    if let Interruption::Operator(OperatorRequest::Feed(share)) = turn
                        && station.leaves_plan(share, watches)
                    {
                        continue;
                    }
                    if station.overtakes(turn) {
                        station.stand_back(&plan.moves()[index..]);
                        return None;
                    }
                    let Some(turn) = station.hold_on_path(turn, &going) else {
                        continue;
                    };
                    let began = plan.at((t_s - t0_s).max(0.0)).position;
                    let stops = !matches!(turn, Interruption::Operator(OperatorRequest::Feed(_)));
                    let stood_s = if stops { station.brake(&going) } else { None };
                    let at_s = (stood_s.unwrap_or(t_s) - t0_s).max(0.0);
                    let running = station.stack.running.as_mut()?;
                    let (made, stop) =
                        replan(running.planner.as_mut(), plan, at_s, turn, stood_s.is_none())?;
                    if let Interruption::Input(Halt { cause: HaltCause::Watch(index), .. }) = turn {
                        station.drop_outputs(t_s, index);
                    }
                    station.world.tracked().replans(&made, t0_s, t_s);
                    (plan, left) = (made, Some(LeftPlan { stop, why: turn, began }));
                    continue;
                }
            }
        }
        station.make_one(&plan, &span, t0_s, false);
        if left.as_ref().is_none_or(|left| index < left.stop.whole()) {
            station.stack.made_one(span.made);
        }
        index += 1;
    }
    left
}

/// The piece as it is made when it is left, and where that is; with a ramp, unless the machine has
/// slowed down by itself.
fn replan(
    planner: &mut dyn Replanner,
    piece: Plan,
    t_s: f64,
    turn: Interruption,
    ramps: bool,
) -> Option<(Plan, Stop)> {
    match turn {
        Interruption::Operator(OperatorRequest::Feed(share)) => planner.feed(piece, t_s, share),
        // A switch stops nothing by itself.
        Interruption::Operator(OperatorRequest::Input { .. }) => None,
        Interruption::Input(_)
        | Interruption::Operator(
            OperatorRequest::Stop
            | OperatorRequest::Hold
            | OperatorRequest::End
            | OperatorRequest::GiveUp,
        ) => planner.stop(piece, t_s, turn.is_ramped() && ramps),
    }
}

/// Inputs at whose change the machine stands at once, as their pins are reported; what slows down along a ramp needs no
/// exact place.
fn pins(watched: &[Watched], t0_s: f64, io: &IoModes) -> Vec<Watch> {
    let at_once = watched.iter().filter(|watch| !watch.ramped);
    let heeded = at_once.filter(|watch| watch.level_from_s.is_none_or(|from_s| from_s <= t0_s));
    heeded.map(|w| Watch { input: w.input, active: pin(w.input, w.on, io) }).collect()
}
