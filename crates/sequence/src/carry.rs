//! Carrying out small steps: which commands each gives, and when it is over.

use crate::forbidden::Forbids;
use crate::height::NOTHING_FELT;
use crate::place::Along;
use crate::sequence::{SAME_MM, Sequence, bit};
use crate::small::Small;
use crate::start::PATIENCE_S;
use kerf_geom::Point2;
use kerf_machine::Word;
use kerf_machine::lines::{Input, Output};
use kerf_machine::settings::axes::Z2;
use kerf_machine::settings::job::Heads;
use kerf_machine::state::{RELEASE_S, State};
use kerf_program::{
    Answer, Axes, Axis, Command, Feed, HeightLaw, Host, Line, MoveKind, Sourced, Step,
};
use std::sync::Arc;
use std::task::Poll;

impl Sequence {
    /// Begins the first step, or sees whether it is over.
    pub(crate) fn carry_on(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        let Some(small) = self.steps.front().cloned() else { return self.advance(out) };
        if small == Small::Ask {
            return self.ask(host);
        }
        if small == Small::GiveUp {
            return self.give_up();
        }
        if let Small::SayUnless(input, text) = small {
            if !host.input(input.number()) {
                self.give(Command::Message { text: text.into() }, out);
            }
            self.pop();
            return Step::Ran;
        }
        if !self.given && matches!(small, Small::Lower(_)) && self.is_simple() {
            if host.settle().is_pending() {
                return Step::Waiting;
            }
            if self.feels_nothing(host) {
                self.fault(NOTHING_FELT);
                return Step::Ran;
            }
        }
        if self.given {
            if host.settle().is_pending() {
                return Step::Waiting;
            }
            if small == Small::Height(None) {
                self.follow_heights(host.machine_position()[Axis::Z.index()]);
                self.tell_heights(out);
            }
            self.pop();
            self.done(&small);
            return Step::Ran;
        }
        if self.start_small(&small, out) {
            self.given = true;
        } else {
            self.pop();
        }
        Step::Ran
    }

    fn pop(&mut self) {
        self.given = false;
        self.steps.pop_front();
    }

    /// Gives the commands of a step; whether it takes time.
    pub(crate) fn start_small(&mut self, small: &Small, out: &mut Vec<Sourced>) -> bool {
        match small {
            Small::Switch(output, on) => self.switch(*output, *on, out),
            Small::Wait(seconds) => return self.wait(*seconds, out),
            Small::Await(awaited) => return self.look_for(awaited.timeout_s, out),
            Small::AwaitJig => return self.look_for(PATIENCE_S, out),
            Small::Release => return self.look_for(RELEASE_S, out),
            Small::Beam(beam) => self.give(Command::Beam(beam.clone()), out),
            Small::Frequency(hz) => self.give(Command::LaserFrequency { hz: *hz }, out),
            Small::Height(law) => return self.control_height(law.clone(), out),
            Small::TellHeights => {
                self.cuts_here();
                self.tell_heights(out);
            }
            Small::TellInForce => self.give(Command::InForce(self.in_force()), out),
            Small::RestoreHeights => {
                self.restore_heights();
                self.tell_heights(out);
            }
            Small::Travel(place) => return self.travel(*place, out),
            Small::Rapid(z) => return self.rapid(Axis::Z, *z, out),
            Small::RaiseTo(z) => {
                return *z > self.position[Axis::Z] && self.rapid(Axis::Z, *z, out);
            }
            Small::Plunge(z) | Small::Lower(z) => return self.plunge(*z, out),
            // There already, it is looked at all the same whether the sheet is.
            Small::Feel(z) => return self.plunge(*z, out) || self.look_for(0.0, out),
            Small::AboveFelt(up) => return self.plunge(self.felt_mm + up, out),
            Small::AboveSensed(up) => return self.plunge(self.begun_mm + up, out),
            Small::Turn(degrees) => return self.rapid(Axis::C, *degrees, out),
            Small::Hand(axis, to) => return self.rapid(*axis, *to, out),
            Small::Slope => return self.slope(out),
            Small::Follow => return self.begin_path(out),
            Small::Made => self.here.along = Along::After,
            Small::Clear => self.here.along = Along::Clear,
            Small::Enter(state) => self.enter(*state, out),
            Small::Mark => self.halt_at_mark(out),
            Small::Say(text) => self.give(Command::Message { text: text.clone() }, out),
            Small::Ask | Small::GiveUp | Small::SayUnless(..) => {}
        }
        false
    }

    /// A step that took time is over by itself.
    fn done(&mut self, small: &Small) {
        match small {
            Small::Await(awaited) => {
                if let Some(missing) = awaited.missing {
                    self.fault(missing);
                }
            }
            Small::Lower(_) => self.begun_mm = self.position[Axis::Z],
            Small::AwaitJig => self.fault("waiting for a jig"),
            Small::Feel(_) => self.fault("surface not found"),
            _ => {}
        }
    }

    /// The input that a step waits for has come.
    pub(crate) fn came(&mut self, input: Input, began: Axes) -> bool {
        let expected = match self.steps.front() {
            Some(Small::Await(awaited)) => awaited.input == input,
            Some(Small::Feel(_)) => input == Input::WHome,
            Some(Small::Lower(_)) => input == Input::ZHigh,
            Some(Small::AwaitJig) => true,
            Some(Small::Release) => input == Input::EmergencyStop,
            _ => false,
        };
        if expected {
            if matches!(self.steps.front(), Some(Small::Feel(_))) {
                self.felt_mm = began[Axis::Z];
            }
            if matches!(self.steps.front(), Some(Small::Lower(_))) {
                // What the tool runs on is not the sheet's.
                self.begun_mm = began[Axis::Z];
            }
            if self.steps.front() == Some(&Small::AwaitJig) {
                self.take_jig(input);
            }
            self.pop();
        }
        expected
    }

    pub(crate) fn give(&self, command: Command, out: &mut Vec<Sourced>) {
        out.push(Sourced { at: self.at(), command });
    }

    /// Gives a motion that ends at a position.
    pub(crate) fn move_by(&mut self, mut command: Command, to: Axes, out: &mut Vec<Sourced>) {
        let to = self.with_second_head(to);
        match &mut command {
            Command::Line(line) => line.to = to,
            Command::Arc(arc) => arc.to = to,
            _ => {}
        }
        self.motions += 1;
        self.position = to;
        self.give(command, out);
    }

    /// The same place with the second head beside the first, where both cut. What it is adjusted by is in
    /// its zero since it was homed.
    fn with_second_head(&self, mut to: Axes) -> Axes {
        if self.machine.job.heads == Heads::Both && to[Axis::Z] != self.position[Axis::Z] {
            to[Z2] = to[Axis::Z];
        }
        to
    }

    fn switch(&mut self, output: Output, on: bool, out: &mut Vec<Sourced>) {
        if self.is_on(output) != on {
            self.on ^= bit(output);
            self.give(Command::Output { number: output.number(), on }, out);
        }
    }

    pub(crate) fn tell_heights(&self, out: &mut Vec<Sourced>) {
        self.give(Command::Heights(self.heights), out);
    }

    fn wait(&self, seconds: f64, out: &mut Vec<Sourced>) -> bool {
        let waits = seconds > 0.0;
        if waits {
            self.give(Command::Wait { seconds }, out);
        }
        waits
    }

    /// Time passes until an input comes. Without any time it is looked at once.
    fn look_for(&self, seconds: f64, out: &mut Vec<Sourced>) -> bool {
        self.give(Command::Wait { seconds: seconds.max(0.0) }, out);
        true
    }

    fn enter(&mut self, state: State, out: &mut Vec<Sourced>) {
        self.state = state;
        let why = if state == State::Running { "".into() } else { self.why.clone() };
        self.give(Command::State { name: state.name().into(), why }, out);
    }

    fn halt_at_mark(&mut self, out: &mut Vec<Sourced>) {
        self.marked = true;
        self.why = format!("pause mark of shape {}", self.at().line).into();
        self.enter(State::Paused, out);
    }

    /// Height control begins or ends; where it ends Z is asked for.
    fn control_height(&mut self, law: Option<Arc<HeightLaw>>, out: &mut Vec<Sourced>) -> bool {
        let ends = law.is_none() && self.controlled;
        if law.is_some() || ends {
            self.controlled = law.is_some();
            self.law = law.clone().or_else(|| self.law.take());
            self.begun_mm = if ends { self.begun_mm } else { self.position[Axis::Z] };
            self.give(Command::HeightControl(law), out);
        }
        ends
    }

    fn begin_path(&mut self, out: &mut Vec<Sourced>) -> bool {
        let before = self.motions;
        self.follow(out);
        self.motions > before
    }

    fn travel(&mut self, place: Point2, out: &mut Vec<Sourced>) -> bool {
        if self.is_at(place) {
            return false;
        }
        let to = self.job.on_table(place);
        let mut axes = self.position;
        (axes[Axis::X], axes[Axis::Y]) = (to.x, to.y);
        self.go(MoveKind::Jog, axes, self.rapid_mm_s(axes), out);
        true
    }

    /// One axis as fast as it can.
    fn rapid(&mut self, axis: Axis, to: f64, out: &mut Vec<Sourced>) -> bool {
        if (to - self.position[axis]).abs() <= SAME_MM {
            return false;
        }
        let mut axes = self.position;
        axes[axis] = to;
        self.go(MoveKind::Jog, axes, self.rapid_mm_s(axes), out);
        true
    }

    fn plunge(&mut self, z: f64, out: &mut Vec<Sourced>) -> bool {
        if (z - self.position[Axis::Z]).abs() <= SAME_MM {
            return false;
        }
        let mut axes = self.position;
        axes[Axis::Z] = z;
        self.go(MoveKind::Cut, axes, self.plunge_mm_s, out);
        true
    }

    fn go(&mut self, kind: MoveKind, to: Axes, mm_s: f64, out: &mut Vec<Sourced>) {
        let line = Line { kind, to, feed: Feed::Path(mm_s) };
        self.move_by(Command::Line(line), to, out);
    }

    /// The speed of a straight way at which the first axis reaches its own.
    pub(crate) fn rapid_mm_s(&self, to: Axes) -> f64 {
        kerf_machine::planning::rapid_mm_s(&self.settings, to.minus(self.position))
    }

    /// The operator decides how it goes on.
    fn ask(&mut self, host: &mut dyn Host) -> Step {
        match host.ask(&self.question()) {
            Poll::Pending => Step::Waiting,
            Poll::Ready(answer) => {
                self.pop();
                let words = match answer {
                    Answer::Text(words) => words,
                    Answer::Button(button) => button.word().to_owned(),
                };
                let forbids = self.forbids(host);
                match (self.state, forbids) {
                    (State::Emergency, _) => {
                        let pressed = forbids == Some(Forbids::EmergencyStop);
                        self.answered_in_emergency(&words, pressed);
                    }
                    (State::Blocked, _) => self.answered_when_blocked(&words, forbids.is_some()),
                    (_, Some(forbids)) if Word::read(&words).is_some_and(Word::moves) => {
                        self.refuse(forbids);
                    }
                    (State::Limited, _) => self.answered_at_limit(&words),
                    _ => self.answered(&words),
                }
                Step::Ran
            }
        }
    }
}
