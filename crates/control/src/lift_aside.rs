//! A tool that the operator takes out of the cut while a program waits for him: a part is turned, a tool is
//! changed, a clamp is in the way.
//!
//! ```text
//!  PAUSE: tool in the cut ─► lift: what turns stops, up to Safe-Z ─► jog … ─► OK: spindle, over it, down
//! ```
//!
//! The way back is that from a stop. A program whose question is answered with a refusal most often ends there:
//! then the tool stays away, and goes back only when the program moves on.

use crate::hand_words::Aside;
use crate::run_end::RunEnd;
use crate::stopping::RunStops;
use kerf_machine::state::{Effect, State};
use kerf_program::{Answer, Axis, Button, Interpreter};

/// Returns `true` if a program that gets this answer goes on, as far as its buttons say.
const fn goes_on(answer: &Answer) -> bool {
    !matches!(answer, Answer::Button(Button::Cancel | Button::Abort | Button::No))
}

/// The tool is moved while a program waits; where it comes back to is kept. What ends the run meanwhile is told
/// by [`Stops::heeded`].
pub(crate) fn set_aside<I: Interpreter>(stops: &mut RunStops<'_, I>, aside: Aside) {
    if stops.station.world.model.draws() {
        return;
    }
    let ahead = stops.station.mover.position();
    // A stop on the way ends it there: the question that is open says what follows.
    let state = std::mem::replace(&mut stops.state, State::Paused);
    if !std::mem::replace(&mut stops.away, true) {
        stops.carry_out(Effect::KeepPlace);
        stops.carry_out(Effect::Halt);
    }
    match aside {
        Aside::Lift => {
            stops.carry_out(Effect::SpindleOff);
            stops.station.world.tell_log();
            stops.carry_out(Effect::Raise);
        }
        Aside::Jog(jog) => stops.station.jog(jog),
    }
    come_back_over(stops);
    // The program is still where it waits.
    if stops.state == State::Paused {
        stops.state = state;
    }
    stops.station.mover.set_position(ahead);
}

/// Brings the tool back after the question during which the operator moved it.
pub(crate) fn goes_back_after<I: Interpreter>(stops: &mut RunStops<'_, I>) -> Result<(), RunEnd> {
    let goes_on = stops.station.world.answer.as_ref().is_some_and(goes_on);
    if goes_on { back_in_the_cut(stops) } else { Ok(()) }
}

/// The tool goes back to where the program left it, if it was taken away.
pub(crate) fn back_in_the_cut<I: Interpreter>(stops: &mut RunStops<'_, I>) -> Result<(), RunEnd> {
    if !std::mem::take(&mut stops.away) {
        return Ok(());
    }
    let ahead = stops.station.mover.position();
    stops.carry_out(Effect::ComeBack);
    stops.station.mover.set_position(ahead);
    stops.heeded()
}

/// The way back is no lower than Safe-Z, nor than where the tool is.
fn come_back_over<I: Interpreter>(stops: &mut RunStops<'_, I>) {
    let safe_mm = stops.station.lift_mm().unwrap_or(f64::NEG_INFINITY);
    stops.kept.lifted_mm = safe_mm.max(stops.station.world.model.position()[Axis::Z]);
}
