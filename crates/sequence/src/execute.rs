//! Carrying out steps: which commands each gives, and when it is over.

use crate::forbidden::{Forbids, forbids};
use crate::place::Along;
use crate::sequence::Sequence;
use crate::setup::SAME_MM;
use crate::sheet::{NOTHING_FELT, feels_nothing};
use crate::start::PATIENCE_S;
use crate::step::Step;
use kerf_geom::Point2;
use kerf_machine::PauseOrder;
use kerf_machine::lines::{Input, Output};
use kerf_machine::planning::rapid_mm_s;
use kerf_machine::state::{RELEASE_S, State};
use kerf_program::{
    Answer, Axes, Axis, Command, Feed, HeightLaw, Host, Line, MoveKind, Question, Sourced,
    Step as Stepped,
};
use std::sync::Arc;
use std::task::Poll;

impl Sequence {
    /// Begins the first step, or sees whether it is over.
    pub(crate) fn carry_on(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Stepped {
        let Some(step) = self.queue.steps.front().cloned() else { return self.advance(out) };
        if step == Step::Ask {
            return self.ask(host);
        }
        if step == Step::GiveUp {
            return self.give_up();
        }
        if let Step::SayUnless(input, text) = step {
            if !host.input(input.number()) {
                self.give(Command::Message { text: text.into() }, out);
            }
            self.queue.pop();
            return Stepped::Ran;
        }
        if !self.queue.given && matches!(step, Step::Lower(_)) && self.sheet.is_simple() {
            if host.settle().is_pending() {
                return Stepped::Waiting;
            }
            if self.feels_nothing(host) {
                self.fault(NOTHING_FELT);
                return Stepped::Ran;
            }
        }
        if self.queue.given {
            if host.settle().is_pending() {
                return Stepped::Waiting;
            }
            if step == Step::Height(None) {
                let z_mm = host.machine_position()[Axis::Z.index()];
                self.sheet.left_at(&mut self.values.heights, z_mm);
                self.head.position[Axis::Z] = z_mm;
                self.tell_heights(out);
            }
            self.queue.pop();
            self.step_over(&step);
            return Stepped::Ran;
        }
        if self.begin_step(&step, out) {
            self.queue.given = true;
        } else {
            self.queue.pop();
        }
        Stepped::Ran
    }

    /// Gives the commands of a step; `true` where it takes time.
    pub(crate) fn begin_step(&mut self, step: &Step, out: &mut Vec<Sourced>) -> bool {
        match step {
            Step::Switch(output, on) => self.switch(*output, *on, out),
            Step::Wait(seconds) => return self.wait(*seconds, out),
            Step::Await(awaited) => return self.look_for(awaited.timeout_s, out),
            Step::AwaitJig => return self.look_for(PATIENCE_S, out),
            Step::Release => return self.look_for(RELEASE_S, out),
            Step::Beam(beam) => self.give(Command::Beam(beam.clone()), out),
            Step::Frequency(hz) => self.give(Command::LaserFrequency { hz: *hz }, out),
            Step::Height(law) => return self.control_height(law.clone(), out),
            Step::TellHeights => {
                self.sheet.cuts_at(&mut self.values.heights, self.head.position[Axis::Z]);
                self.tell_heights(out);
            }
            Step::TellInForce => self.give(Command::InForce(self.values.in_force()), out),
            Step::RestoreHeights => {
                self.values.restore_heights(&self.setup.machine);
                self.tell_heights(out);
            }
            Step::Travel(place) => return self.travel(*place, out),
            Step::Rapid(z) => return self.rapid(Axis::Z, *z, out),
            Step::RaiseTo(z) => {
                return *z > self.head.position[Axis::Z] && self.rapid(Axis::Z, *z, out);
            }
            Step::Plunge(z) | Step::Lower(z) => return self.plunge(*z, out),
            // There already, it is looked at all the same whether the sheet is.
            Step::Feel(z) => return self.plunge(*z, out) || self.look_for(0.0, out),
            Step::AboveFelt(up) => return self.plunge(self.sheet.felt_mm + up, out),
            Step::AboveSensed(up) => return self.plunge(self.sheet.begun_mm + up, out),
            Step::Turn(degrees) => return self.rapid(Axis::C, *degrees, out),
            Step::Hand(axis, to) => return self.rapid(*axis, *to, out),
            Step::Slope => return self.follower(out).slope(),
            Step::Follow => return self.begin_path(out),
            Step::Made => self.progress.here.along = Along::After,
            Step::Clear => self.progress.here.along = Along::Clear,
            Step::Enter(state) => self.enter(*state, out),
            Step::Mark => self.halt_at_mark(out),
            Step::Say(text) => self.give(Command::Message { text: text.clone() }, out),
            Step::Ask | Step::GiveUp | Step::SayUnless(..) => {}
        }
        false
    }

    /// A step that took time is over by itself.
    fn step_over(&mut self, step: &Step) {
        match step {
            Step::Await(awaited) => {
                if let Some(missing) = awaited.missing {
                    self.fault(missing);
                }
            }
            Step::Lower(_) => self.sheet.begun_mm = self.head.position[Axis::Z],
            Step::AwaitJig => self.fault("waiting for a jig"),
            Step::Feel(_) => self.fault("surface not found"),
            _ => {}
        }
    }

    /// Takes an input that the first step waits for; `false` where it waits for another, or for none.
    pub(crate) fn take_input(&mut self, input: Input, began: Axes) -> bool {
        match self.queue.steps.front() {
            Some(Step::Await(awaited)) if awaited.input == input => {}
            Some(Step::Release) if input == Input::EmergencyStop => {}
            Some(Step::AwaitJig) => self.take_jig(input),
            Some(Step::Feel(_)) if input == Input::WHome => self.sheet.felt_mm = began[Axis::Z],
            // What the tool runs on is not the sheet's.
            Some(Step::Lower(_)) if input == Input::ZHigh => self.sheet.begun_mm = began[Axis::Z],
            _ => return false,
        }
        self.queue.pop();
        true
    }

    fn switch(&mut self, output: Output, on: bool, out: &mut Vec<Sourced>) {
        if self.head.switch(output, on) {
            self.give(Command::Output { number: output.number(), on }, out);
        }
    }

    pub(crate) fn tell_heights(&self, out: &mut Vec<Sourced>) {
        self.give(Command::Heights(self.values.heights), out);
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
        self.halt.state = state;
        let why = if state == State::Running { "".into() } else { self.halt.why.clone() };
        self.give(Command::State { name: state.name().into(), why }, out);
    }

    fn halt_at_mark(&mut self, out: &mut Vec<Sourced>) {
        self.halt.marked = true;
        self.halt.why =
            format!("pause mark of shape {}", self.progress.at(&self.setup.job).line).into();
        self.enter(State::Paused, out);
    }

    /// Height control begins or ends; where it ends Z is asked for.
    fn control_height(&mut self, law: Option<Arc<HeightLaw>>, out: &mut Vec<Sourced>) -> bool {
        let ends = self.sheet.control(law.clone(), self.head.position[Axis::Z]);
        if law.is_some() || ends {
            self.give(Command::HeightControl(law), out);
        }
        ends
    }

    fn begin_path(&mut self, out: &mut Vec<Sourced>) -> bool {
        let before = self.head.motions;
        self.follower(out).follow();
        self.head.motions > before
    }

    fn travel(&mut self, place: Point2, out: &mut Vec<Sourced>) -> bool {
        if self.setup.is_over(self.head.position, place) {
            return false;
        }
        let to = self.setup.job.on_table(place);
        let mut axes = self.head.position;
        (axes[Axis::X], axes[Axis::Y]) = (to.x, to.y);
        self.go(MoveKind::Jog, axes, self.rapid_mm_s(axes), out);
        true
    }

    /// One axis as fast as it can.
    fn rapid(&mut self, axis: Axis, to: f64, out: &mut Vec<Sourced>) -> bool {
        if (to - self.head.position[axis]).abs() <= SAME_MM {
            return false;
        }
        let mut axes = self.head.position;
        axes[axis] = to;
        self.go(MoveKind::Jog, axes, self.rapid_mm_s(axes), out);
        true
    }

    fn plunge(&mut self, z: f64, out: &mut Vec<Sourced>) -> bool {
        if (z - self.head.position[Axis::Z]).abs() <= SAME_MM {
            return false;
        }
        let mut axes = self.head.position;
        axes[Axis::Z] = z;
        self.go(MoveKind::Cut, axes, self.values.plunge_mm_s, out);
        true
    }

    fn go(&mut self, kind: MoveKind, to: Axes, mm_s: f64, out: &mut Vec<Sourced>) {
        let line = Line { kind, to, feed: Feed::Path(mm_s) };
        self.follower(out).move_by(Command::Line(line), to);
    }

    /// The operator decides how it goes on.
    fn ask(&mut self, host: &mut dyn Host) -> Stepped {
        match host.ask(&self.question()) {
            Poll::Pending => Stepped::Waiting,
            Poll::Ready(answer) => {
                self.queue.pop();
                let words = match answer {
                    Answer::Text(words) => words,
                    Answer::Button(button) => button.word().to_owned(),
                };
                let forbids = forbids(&self.setup, host);
                match (self.halt.state, forbids) {
                    (State::Emergency, _) => {
                        let pressed = forbids == Some(Forbids::EmergencyStop);
                        self.answered_in_emergency(&words, pressed);
                    }
                    (State::Blocked, _) => self.answered_when_blocked(&words, forbids.is_some()),
                    (_, Some(forbids))
                        if PauseOrder::read(&words).is_some_and(PauseOrder::moves) =>
                    {
                        self.refuse(forbids);
                    }
                    (State::Limited, _) => self.answered_at_limit(&words),
                    _ => self.answered(&words),
                }
                Stepped::Ran
            }
        }
    }

    /// The speed of a straight way at which the first axis reaches its own, mm/s.
    fn rapid_mm_s(&self, to: Axes) -> f64 {
        rapid_mm_s(&self.setup.settings, to.minus(self.head.position))
    }

    fn feels_nothing(&self, host: &mut dyn Host) -> bool {
        let travel_mm = self.values.travel_mm(&self.setup.machine);
        feels_nothing(&self.values.heights, travel_mm, self.head.position[Axis::Z], host)
    }

    /// Returns the question to the operator.
    pub(crate) fn question(&self) -> Question {
        let number = self.progress.at(&self.setup.job).line;
        self.halt.question(&self.setup.machine, self.progress.here.nth, number)
    }
}
