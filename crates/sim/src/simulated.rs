//! The simulated machine as a run drives it: it makes a plan in its own time.

use kerf_machine::driver::Facts;
use kerf_machine::{Actuator, Driven, Fault, Going, Machine, News};
use kerf_motion::Move;
use kerf_program::AXES;
use std::cell::RefCell;
use std::rc::Rc;

/// Passing of machine time on a machine that is simulated.
pub trait Clock {
    /// Lets time pass from one moment of machine time towards another, seconds, for a moment at most; returns the one that
    /// is reached.
    fn pass(&mut self, from_s: f64, until_s: f64) -> f64;

    /// Returns `true` if a second of machine time takes a second, or longer.
    fn is_real(&self) -> bool {
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

/// A machine that makes every plan exactly, in the time of a clock. Outputs, inputs and frames are those of
/// [`Machine`](crate::Machine), which a run keeps beside it.
#[derive(Debug)]
pub struct Simulated<C> {
    clock: C,
    facts: Facts,
}

impl<C: Clock + 'static> Simulated<C> {
    /// A machine in the time of a clock.
    pub fn new(clock: C) -> Self {
        let facts = Facts { name: "simulated".into(), axes: AXES, ..Facts::default() };
        Self { clock, facts }
    }

    /// The same for a run.
    pub fn driven(clock: C) -> Driven {
        Rc::new(RefCell::new(Self::new(clock)))
    }
}

impl<C: Clock> Simulated<C> {
    fn pass(&mut self, from_s: f64, until_s: f64) -> News {
        News { reached_s: self.clock.pass(from_s, until_s), input: None }
    }
}

impl<C: Clock> Machine for Simulated<C> {
    fn name(&self) -> &str {
        &self.facts.name
    }

    fn facts(&self) -> &Facts {
        &self.facts
    }

    fn is_real(&self) -> bool {
        self.clock.is_real()
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

    fn look(&mut self) {}

    fn settle(&mut self) -> bool {
        false
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
