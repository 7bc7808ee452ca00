//! A machine and what is believed of it, kept alike.
//!
//! A run believes what it was told. A machine that is pretended moves its switches by itself, or where somebody does so
//! in its stead; the machine tells it in the moment in which it happens.

use kerf_machine::Lift;
use kerf_machine::{Ahead, Driven, News};
use kerf_model::{Change, Model, WasOn, contact};
use kerf_motion::{Plan, Span};
use kerf_program::{Axes, Axis, HeightLaw};
use kerf_sim::Hands;

/// The machine of a run, and what is believed of it.
pub(crate) struct Tracked<'a> {
    pub model: &'a mut Model,
    pub driven: &'a Driven,
    /// The hands at the machine.
    pub hands: &'a Hands,
}

impl Tracked<'_> {
    /// The machine told that the contact of an input changed at a moment.
    pub fn learn(&mut self, input: u8, on: bool, at_s: f64) {
        let change = Change { input, on, at_s };
        self.model.learn(change);
        self.hands.keep(change);
    }

    /// A plan, or another piece of it, is about to be followed.
    pub fn follows(&mut self, plan: &Plan, t0_s: f64) {
        if !self.model.draws() {
            self.learns_plan(plan, t0_s);
            self.driven.borrow_mut().begin_plan();
        }
    }

    /// Another plan makes the rest of one that is left at a moment.
    pub fn replans(&mut self, plan: &Plan, t0_s: f64, at_s: f64) {
        if !self.model.draws() {
            self.learns_plan(plan, t0_s);
            self.learn_until(at_s);
        }
    }

    /// A machine that repeats tells what it told of the move under way by the plan that is followed now.
    fn learns_plan(&mut self, plan: &Plan, t0_s: f64) {
        let mut driven = self.driven.borrow_mut();
        driven.follows(&Ahead { plan, t0_s, from_s: self.model.clock_s() });
        if driven.facts().repeats {
            self.model.forget();
        }
    }

    /// A move of a plan is made: everything that happened on the way is known. Returns how far height control carried Z.
    pub fn move_made(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>) -> Lift {
        let carried = if self.model.draws() {
            self.model.not_carried()
        } else {
            self.learn_until(t0_s + span.t1_s);
            self.driven.borrow_mut().made(t0_s, plan, span)
        };
        self.model.make(t0_s, plan, span, &carried);
        self.follow_pushes();
        carried.lift
    }

    /// Learns everything that changed up to a moment that is over.
    pub fn learn_until(&mut self, until_s: f64) {
        loop {
            let News { reached_s, input } = self.driven.borrow_mut().passed(until_s);
            let Some((number, active)) = input else { return };
            let on = contact(number, active, &self.model.settings().io);
            self.learn(number, on, reached_s);
        }
    }

    /// Moves the switch of an input now; the next question about the input sees it.
    pub fn press(&mut self, input: u8, on: bool) {
        let now_s = self.model.clock_s();
        if !self.hands.press(Change { input, on, at_s: now_s }) {
            self.learn(input, on, now_s);
        }
        self.advance(now_s);
    }

    /// Lets the clock of what is believed run to a moment.
    pub fn advance(&mut self, to_s: f64) {
        self.learn_until(to_s);
        self.model.advance(to_s);
        self.follow_pushes();
    }

    /// Moves the model by what was pushed at the axes up to now.
    fn follow_pushes(&mut self) {
        let now_s = self.model.clock_s();
        while let Some(push) = self.hands.next_push(now_s) {
            self.model.pushed(push.axis, push.by, push.at_s);
        }
    }

    /// Returns when an input reads a state: now, or later, where that is known. `None` where nobody knows.
    pub fn when(&self, input: u8, on: bool) -> Option<f64> {
        let told = self.model.when_input(input, on);
        told.or_else(|| self.hands.changes_s(input, on, self.model.clock_s()))
    }

    /// Returns when an input changes to a state the next time, where that is known.
    pub fn when_pressed(&self, input: u8, on: bool) -> Option<f64> {
        let (hands, now_s) = (self.hands, self.model.clock_s());
        let is_on = self.model.input(input) == on;
        let rests_s = if is_on { hands.changes_s(input, !on, now_s)? } else { now_s };
        let told = if is_on { None } else { self.model.when_input(input, on) };
        told.or_else(|| hands.changes_s(input, on, rests_s))
    }

    /// The warning passes, and motion begins.
    pub fn begin_motion(&mut self) {
        let until_s = self.model.warn();
        self.advance(until_s);
    }

    /// The next motion begins where torch and height control have carried Z.
    pub fn land(&mut self) {
        self.driven.borrow_mut().land();
        self.model.land_torch();
    }

    /// Z follows the sheet from here on, or does not.
    pub fn control_height(&mut self, law: Option<HeightLaw>) {
        self.model.land_torch();
        if !self.model.draws() {
            let at = self.model.true_position();
            let contacts = self.driven.borrow_mut().height_control(law, &at);
            self.model.senses(&contacts);
        }
    }

    /// The power was off: nothing is on, and the machine stands somewhere. Returns what was on.
    pub fn restart(&mut self, position: Axes) -> WasOn {
        drop(self.driven.borrow_mut().height_control(None, &position));
        self.model.restart(position)
    }

    /// Moves only this motor of an axis from now on; all of them for `None`.
    pub fn move_alone(&mut self, motor: Option<(Axis, usize)>) {
        self.driven.borrow_mut().move_alone(motor);
        self.model.move_alone(motor);
    }

    /// The axis is at zero where it stands.
    pub fn zero(&mut self, axis: Axis) {
        self.driven.borrow_mut().zero(axis, self.model.position()[axis]);
        self.model.zero(axis);
    }
}
