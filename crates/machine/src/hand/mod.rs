//! Moves by hand: what a person has the machine do beside jobs and part files (Profiler reference,
//! "Changing the Tool Position").
//!
//! A [`Hand`] is an interpreter like a job: it is stepped, gives commands, and is stopped and goes on by
//! the same table of states.

mod bounds;
mod errand;
mod halting;
mod warm_up;

pub use errand::{Errand, FAR, Held, Keypad, Stretch, cut_move, keypad_settings};
pub use warm_up::{WarmStep, warm_steps};

use crate::driver::Facts;
use crate::lines::Input;
use crate::planning::{CHORDS, hand_settings, rapid_mm_s};
use crate::settings::Configuration;
use crate::state::{Event, State, StopSettings};
use bounds::{Leg, SAME};
use kerf_diag::{Code, Diagnostic};
use kerf_geom::Arc2;
use kerf_program::settings::LinearUnit;
use kerf_program::{
    AXES, Arc as Turn, At, Axes, Axis, Command, Feed, Frame, Halted, Host, Interpreter, Line,
    MoveKind, Settings, Sourced, Status, Step, StoppedBy, Watch,
};
use std::collections::VecDeque;
use std::sync::Arc;

/// An errand being done.
#[derive(Clone, Debug)]
pub struct Hand {
    errand: Errand,
    machine: Arc<Configuration>,
    settings: Arc<Settings>,
    frame: Frame,
    position: Axes,
    /// The range of each axis that the machine tells itself, machine frame.
    reach: [Option<(f64, f64)>; AXES],
    /// Ways still to go.
    legs: VecDeque<Leg>,
    /// Commands of a warm-up that are left; `turns` tells whether its spindle may turn.
    warms: VecDeque<Command>,
    turns: bool,
    /// Legs of the rest of the way, while the machine is stopped.
    rest: Option<VecDeque<Leg>>,
    given: bool,
    begun: bool,
    state: State,
    motions: u64,
    /// Reason for which it is not moving.
    why: Arc<str>,
    /// Message to the operator when it is done.
    note: Option<Arc<str>>,
    over: Option<(Status, Option<Box<Diagnostic>>)>,
}

impl Hand {
    /// An errand of a machine that stands at a position, machine frame.
    pub fn new(errand: Errand, machine: Arc<Configuration>, position: Axes, frame: Frame) -> Self {
        let mut settings = match &errand {
            Errand::Keypad(keypad) => keypad_settings(&machine.program, keypad.speed),
            _ => hand_settings(&machine),
        };
        if let (Errand::Held(held), Some(dynamics)) = (&errand, &mut settings.dynamics) {
            let share = held.accel.clamp(0.01, 1.0);
            dynamics.accel_mm_s2 = dynamics.accel_mm_s2.zip(Axes::default(), |a, _| a * share);
        }
        let mut hand = Self {
            errand,
            settings: Arc::new(settings),
            machine,
            frame,
            position,
            reach: [None; AXES],
            legs: VecDeque::new(),
            warms: VecDeque::new(),
            turns: false,
            rest: None,
            given: false,
            begun: false,
            state: State::Running,
            motions: 0,
            why: Arc::default(),
            note: None,
            over: None,
        };
        hand.legs = hand.ways();
        hand
    }

    /// The same on a machine that tells itself how far its axes reach, machine frame.
    #[must_use]
    pub fn reaching(mut self, reach: [Option<(f64, f64)>; AXES]) -> Self {
        (self.reach, self.note) = (reach, None);
        self.legs = self.ways();
        self
    }

    /// The same on a machine with this spindle: a warm-up takes its speeds from it.
    #[must_use]
    pub fn turning(mut self, facts: &Facts) -> Self {
        let Errand::WarmUp(steps) = &self.errand else { return self };
        if !facts.no_spindle.is_empty() {
            self.why = format!("it has no spindle: {}", facts.no_spindle).into();
            self.over = Some((Status::Failed, Some(self.stopped_for(Code::NotEnabled))));
            return self;
        }
        let told_rpm = if facts.spindle_rpm > 0.0 {
            facts.spindle_rpm
        } else {
            self.machine.board.spindle_rpm
        };
        let greatest_rpm = if self.machine.program.spindle_device { told_rpm } else { 0.0 };
        self.warms = warm_up::commands(steps, greatest_rpm);
        self
    }

    /// The same, told in another unit.
    #[must_use]
    pub fn told_in(mut self, unit: LinearUnit) -> Self {
        Arc::make_mut(&mut self.settings).use_linear_unit(unit);
        self
    }

    /// It lasts as long as a key is held.
    const fn is_held(&self) -> bool {
        matches!(self.errand, Errand::Held(_) | Errand::Keypad(_))
    }

    /// A stop ends it for good.
    const fn ends_at_stop(&self) -> bool {
        self.is_held() || matches!(self.errand, Errand::Along(_) | Errand::WarmUp(_))
    }

    fn stop_settings(&self) -> StopSettings {
        StopSettings::profiler(self.machine.pause.raise)
    }

    fn give(&self, command: Command, out: &mut Vec<Sourced>) {
        out.push(Sourced { at: At::default(), command });
    }

    fn end(&mut self, status: Status, why: Option<Box<Diagnostic>>) -> Step {
        self.over = Some((status, why.clone()));
        Step::Done(status, why)
    }

    fn begin(&mut self, out: &mut Vec<Sourced>) -> Step {
        self.begun = true;
        if let Some(why) = self.refusal() {
            return self.end(Status::Failed, Some(why));
        }
        self.give(Command::Settings(self.settings.clone()), out);
        Step::Ran
    }

    /// The next way.
    fn go(&mut self, leg: Leg, out: &mut Vec<Sourced>) {
        let Leg { to, arc } = leg;
        let rapid = || rapid_mm_s(&self.settings, to.minus(self.position));
        let feed = match self.errand {
            Errand::Keypad(_) => Feed::Axis,
            Errand::Held(held) => Feed::Path(held.speed.clamp(0.01, 1.0) * rapid()),
            _ => Feed::Path(rapid()),
        };
        let kind = MoveKind::Jog;
        let command = match arc {
            None => Command::Line(Line { kind, to, feed }),
            Some(Arc2 { centre, sweep_rad, .. }) => {
                let centre = [centre.x, centre.y];
                Command::Arc(Turn {
                    kind,
                    centre,
                    sweep_rad,
                    to,
                    feed,
                    chords: CHORDS,
                    small: false,
                })
            }
        };
        self.motions += 1;
        (self.position, self.given) = (to, true);
        self.give(command, out);
    }

    fn is_at(&self, place: &Axes) -> bool {
        Axis::ALL.into_iter().all(|axis| (place[axis] - self.position[axis]).abs() <= SAME)
    }

    fn carry_on(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        if self.given {
            if host.settle().is_pending() {
                return Step::Waiting;
            }
            self.given = false;
            self.legs.pop_front();
            return Step::Ran;
        }
        if let Some(command) = self.warms.pop_front() {
            self.turns |= matches!(command, Command::Output { .. });
            self.give(command, out);
            return Step::Ran;
        }
        match self.legs.front().copied() {
            Some(leg) if leg.arc.is_none() && self.is_at(&leg.to) => drop(self.legs.pop_front()),
            Some(leg) => self.go(leg, out),
            None if self.rest.is_some() => return self.ask(host, out),
            None if std::mem::take(&mut self.turns) => self.give(warm_up::OFF, out),
            None => {
                if let Some(text) = self.note.take() {
                    self.give(Command::Message { text }, out);
                }
                return self.end(Status::Ok, None);
            }
        }
        Step::Ran
    }
}

impl Interpreter for Hand {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        match &self.over {
            Some(_) if std::mem::take(&mut self.turns) => {
                self.give(warm_up::OFF, out);
                Step::Ran
            }
            Some((status, why)) => Step::Done(*status, why.clone()),
            None if !self.begun => self.begin(out),
            None => self.carry_on(host, out),
        }
    }

    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        for _ in 0..lines.max(1) {
            match self.step(host, out) {
                Step::Ran => {}
                other => return other,
            }
        }
        Step::Ran
    }

    /// Only the emergency stop is watched: it ends a move by hand for good.
    fn interrupt(&mut self, _: &Watch, _: Option<u64>, position: Axes) {
        self.position = position;
        self.why = "emergency stop".into();
        self.over = Some((Status::Stopped, Some(self.stopped_for(Code::InputStop))));
    }

    fn takes_stops(&self) -> bool {
        true
    }

    /// A key is let go for good, and a way that is followed ends; every other way is kept.
    fn stopped(&mut self, by: StoppedBy, halted: &Halted) {
        let (event, why) = match by {
            StoppedBy::Operator | StoppedBy::PowerCut => (Event::Stop, String::new()),
            StoppedBy::Input(n) => (Event::StopInput, format!("stopped by stop input {n}")),
            StoppedBy::Limit(n) => (Event::Limit, format!("stopped by limit input {n}")),
        };
        self.why = why.into();
        if self.ends_at_stop() {
            (self.position, self.legs, self.given) = (halted.stands, VecDeque::new(), false);
            self.warms.clear();
            match event {
                Event::Stop => self.over = Some((Status::Ended, None)),
                _ if self.is_held() => self.note = Some(self.why.clone()),
                _ => {
                    let limit = event == Event::Limit;
                    let status = if limit { Status::Limit } else { Status::Stopped };
                    self.over = Some((status, Some(self.stopped_for(Code::InputStop))));
                }
            }
            return;
        }
        self.halt(event, halted);
    }

    fn nudge(&mut self, _: Axes) {}

    fn carried_out(&mut self, _: u64) {}

    fn stop(&mut self, _: &mut dyn Host, _: &mut Vec<Sourced>) -> Step {
        self.end(Status::Stopped, None)
    }

    fn limit(&mut self, _: &mut dyn Host, _: &mut Vec<Sourced>) -> Step {
        self.end(Status::Limit, None)
    }

    /// The emergency stop.
    fn watches(&self) -> Vec<Watch> {
        let input = Input::EmergencyStop.number();
        vec![Watch::level(input, self.machine.estop.active, 0.0)]
    }

    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        (file == 0).then(|| self.errand.name().into())
    }

    fn call_stack(&self) -> Vec<At> {
        vec![At::default()]
    }

    fn motions(&self) -> u64 {
        self.motions
    }

    fn lines(&self) -> u64 {
        0
    }

    fn settings(&self) -> &Arc<Settings> {
        &self.settings
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn position(&self) -> Axes {
        self.position
    }

    fn variables(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::AXES;

    #[test]
    fn a_place_is_counted_from_the_job_origin_or_from_the_tool() {
        let mut machine = Configuration::default();
        machine.job.origin_mm = [100.0, 200.0];
        let machine = Arc::new(machine);
        let place: [_; AXES] = [Some(10.0), Some(20.0), Some(-3.0), None, None, None];
        for (relative, flat, ways) in [
            (false, false, [[110.0, 220.0, -3.0]; 2]),
            (false, true, [[110.0, 220.0, 4.0], [110.0, 220.0, -3.0]]),
            (true, true, [[11.0, 22.0, 4.0], [11.0, 22.0, 1.0]]),
        ] {
            let errand = Errand::To { place, relative, flat };
            let here = Axes::xyz(1.0, 2.0, 4.0);
            let hand = Hand::new(errand, machine.clone(), here, Frame::default());
            let to = hand.legs.iter().map(|leg| leg.to.first3());
            assert_eq!(to.collect::<Vec<_>>(), ways, "{relative} {flat}");
            assert_eq!(hand.variables(), [], "nothing in it has a name");
        }
    }
}
