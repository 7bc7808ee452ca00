//! Inputs at which the board itself ends motion: limits, doors, emergency stops. They hang on the latch over all motors, so no
//! computer has a part in it; outputs go off as soon as the link's thread hears of it, and by their watch where it is dead.

use super::machine::{Queued, State};
use super::wiring::{Looked, Wiring};
use kerf_driver_klipper::board::Watched;
use kerf_driver_klipper::mailbox::Request;

/// Time between two looks of the board at an input that is watched, seconds.
pub const LOOK_S: f64 = 1e-4;
/// Time from the change of an input to its report beside the latch at most, seconds.
const REPORTED_S: f64 = 0.05;

/// Switches at which all motors stop and outputs go off: of inputs that are not so already, and those that the board watches
/// in the motion under way. While axes are homed, limits are no end of it.
pub fn guards(wiring: &Wiring, pressed: u8, watched: &[Watched], homes: bool) -> Vec<Watched> {
    let guard = |(bit, input): (usize, &Looked)| {
        let ends = input.ends_motion(homes)?;
        let guard = guard_of(input, ends);
        let is_so = (pressed & (1 << bit) != 0) == ends;
        (!is_so || watched.contains(&guard)).then_some(guard)
    };
    wiring.inputs.iter().enumerate().filter_map(guard).collect()
}

const fn guard_of(input: &Looked, ends: bool) -> Watched {
    Watched { switch: input.switch, opens: ends == input.turned, look_s: LOOK_S, guards: true }
}

/// The reason for which an input ended motion, in words.
fn words(input: &Looked) -> String {
    let kind = if input.limits { "limit" } else { "stop" };
    format!("{kind} input {} stopped it at once, in the board", input.number)
}

/// Advice to whoever released the input.
const HINT: &str = "release it; its counts are known, though a heavy machine may have slipped: the run can be taken up";

impl Queued {
    /// The guards of the motion under way, or of the next.
    pub(super) fn guards(&self, watched: &[Watched]) -> Vec<Watched> {
        let watched = if self.state == State::Rest { &[] } else { watched };
        guards(&self.wiring, self.pressed, watched, self.homing.is_some())
    }

    /// Asks for the states of the inputs: as a row they tell changes alone.
    pub(super) fn learn_inputs(&mut self) {
        self.asked = self.wiring.inputs.iter().map(|it| (it.switch, None)).collect();
        let switches = self.asked.iter().map(|(switch, _)| Request::Switch(*switch));
        switches.for_each(|request| self.port.request(request));
        self.wait_until(|it| it.asked.iter().all(|(_, told)| told.is_some()));
        let asked = std::mem::take(&mut self.asked);
        for (bit, (input, (_, told))) in self.wiring.inputs.iter().zip(asked).enumerate() {
            if told.is_some_and(|is_on| is_on != input.turned) {
                self.pressed |= 1 << bit;
                self.inputs.push_back((input.number, true));
            }
        }
    }

    /// A switch has ended motion at a clock: the run is over there, whatever it told of moves behind that.
    pub(super) fn guarded(&mut self, switch: usize, clock: u64) {
        let homes = self.homing.is_some();
        let mut inputs = self.wiring.inputs.iter();
        let found = inputs.find(|it| it.switch == switch && it.ends_motion(homes).is_some());
        let why = found.map_or_else(|| "an input stopped it at once".into(), words);
        let made_s = self.moment(clock);
        self.fail(why, HINT, false);
        if let Some(fault) = &mut self.fault {
            fault.made_s = fault.made_s.and(made_s).or(made_s);
        }
    }

    /// An input changed to the state in which motion ends: tells so where something moves. The latch has seen it before, but
    /// for one that was watched from too late on.
    pub(super) fn ends_motion(&mut self, number: u8, is_active: bool) -> bool {
        let homes = self.homing.is_some();
        let input = self.wiring.inputs.iter().find(|it| it.number == number);
        let ends = input.filter(|it| it.ends_motion(homes) == Some(is_active)).copied();
        let moves = homes || self.state != State::Rest;
        let Some(input) = ends.filter(|_| moves && self.fault.is_none()) else { return false };
        let now = self.progress.clock.map_or(0, |(now, off)| now - off.min(now));
        let made_s = self.moment(now).map(|now_s| now_s - REPORTED_S);
        self.fail(words(&input), HINT, false);
        if let Some(fault) = &mut self.fault {
            fault.made_s = made_s;
        }
        true
    }

    fn moment(&self, clock: u64) -> Option<f64> {
        match self.state {
            State::Moving(scale, _) => Some(scale.moment(clock)),
            _ => None,
        }
    }
}
