//! The simulated machine as a run drives it: it makes a plan in its own time.

use crate::hands::{Hands, Opened};
use crate::physics::Physics;
use kerf_machine::driver::Facts;
use kerf_machine::homing::Which;
use kerf_machine::{Actuator, Ahead, Fault, Going, LiftOfMove, Machine, News};
use kerf_model::{Change, triggers};
use kerf_motion::{Move, Plan, Span};
use kerf_program::{AXES, Axes, Axis, HeightLaw, Settings};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

/// Passing of machine time on a machine that is simulated.
pub trait Clock {
    /// Lets time pass from one moment of machine time towards another, seconds, for a moment at most; returns the one that
    /// is reached.
    fn pass(&mut self, from_s: f64, until_s: f64) -> f64;

    /// Returns `true` if a second of machine time takes a second, or longer.
    fn in_real_time(&self) -> bool {
        false
    }

    /// Begins anew: what passes from now on passes from the next moment that it is told.
    fn begin_anew(&mut self) {}
}

/// As fast as can be computed.
impl Clock for () {
    fn pass(&mut self, _: f64, until_s: f64) -> f64 {
        until_s
    }
}

/// A machine that makes every plan exactly, in the time of a clock, and tells what its switches and sensors feel.
#[derive(Debug)]
pub struct Simulated<C> {
    clock: C,
    facts: Facts,
    physics: Rc<RefCell<Physics>>,
}

impl<C: Clock + 'static> Simulated<C> {
    /// A machine in the time of a clock.
    pub fn new(clock: C) -> Self {
        let name = "simulated".into();
        let facts = Facts {
            name,
            axes: AXES,
            repeats: true,
            placed_by_record: true,
            inputs_by_hand: true,
            card: true,
            harmless: true,
            ..Facts::default()
        };
        Self { clock, facts, physics: Rc::default() }
    }

    /// The same, which leaves the motion of Z by a torch (VH) to the machine that it stands for.
    #[must_use]
    pub const fn leaving_torch(mut self, leaves: bool) -> Self {
        self.facts.follows_torch = leaves;
        self
    }

    /// The same, opened for runs.
    pub fn opened(clock: C) -> Opened {
        Self::new(clock).open()
    }

    /// Opens it for runs.
    pub fn open(self) -> Opened {
        let hands = self.hands();
        Opened { machine: Rc::new(RefCell::new(self)), hands }
    }
}

impl<C: Clock> Simulated<C> {
    /// The hands at it.
    pub fn hands(&self) -> Hands {
        Hands::reaching(self.physics.clone())
    }

    /// Lets time pass to the next change, or to a moment.
    fn pass(&mut self, from_s: f64, until_s: f64) -> News {
        let due_s = self.physics.borrow().next_s().filter(|due_s| *due_s <= until_s);
        let due_s = due_s.map(|due_s| due_s.max(from_s));
        let reached_s = match due_s {
            Some(due_s) if due_s <= from_s => from_s,
            _ => self.clock.pass(from_s, due_s.unwrap_or(until_s)),
        };
        let told = due_s.filter(|due_s| *due_s <= reached_s);
        let change = told.and_then(|_| self.physics.borrow_mut().tell(reached_s));
        News { reached_s, input: change.map(|change| self.pin(change)) }
    }

    /// The input of a change, and whether it is active from then on.
    fn pin(&self, Change { input, on, .. }: Change) -> (u8, bool) {
        (input, triggers(input, on, &self.physics.borrow().settings().io))
    }
}

impl<C: Clock> Machine for Simulated<C> {
    fn name(&self) -> &str {
        &self.facts.name
    }

    fn facts(&self) -> &Facts {
        &self.facts
    }

    fn in_real_time(&self) -> bool {
        self.clock.in_real_time()
    }

    fn refuses(&self, _: &Move) -> Option<String> {
        None
    }

    fn begin(&mut self) {
        self.clock.begin_anew();
    }

    fn begin_plan(&mut self) {}

    fn set(&mut self, _: &Actuator) {}

    fn advance(&mut self, _: &Going<'_>, from_s: f64, until_s: f64) -> News {
        self.pass(from_s, until_s)
    }

    fn stand(&mut self, from_s: f64, until_s: f64) -> News {
        self.pass(from_s, until_s)
    }

    fn passed(&mut self, until_s: f64) -> News {
        let change = self.physics.borrow_mut().tell(until_s);
        let reached_s = change.map_or(until_s, |change| change.at_s);
        News { reached_s, input: change.map(|change| self.pin(change)) }
    }

    fn use_settings(&mut self, settings: &Arc<Settings>) {
        self.physics.borrow_mut().use_settings(settings.clone());
    }

    fn follows(&mut self, ahead: &Ahead<'_>) {
        self.physics.borrow_mut().foresee(ahead);
    }

    fn made(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>) -> LiftOfMove {
        self.physics.borrow_mut().made(t0_s, plan, span)
    }

    fn height_control(&mut self, law: Option<HeightLaw>, at: &Axes) -> Vec<(u8, bool)> {
        self.physics.borrow_mut().height_control(law, at)
    }

    fn land(&mut self) {
        self.physics.borrow_mut().land();
    }

    fn move_alone(&mut self, motor: Option<(Axis, usize)>) {
        self.physics.borrow_mut().move_alone(motor);
    }

    fn home_switch(&self, axis: Axis, which: Which) -> bool {
        self.physics.borrow().home_switch(axis, which)
    }

    fn zero(&mut self, axis: Axis, place: f64) {
        self.physics.borrow_mut().zero(axis, place);
    }

    fn look(&mut self) {}

    fn settle(&mut self) -> bool {
        false
    }

    fn home(&mut self) {}

    fn halt(&mut self) {}

    fn place(&mut self) -> Option<Axes> {
        None
    }

    fn stop(&mut self, _: &Going<'_>) -> Option<f64> {
        None
    }

    fn feed(&mut self, _: f32) {}

    fn give_up(&mut self) {}

    fn fault(&self) -> Option<&Fault> {
        None
    }
}
