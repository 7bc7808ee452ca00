//! Hands at a simulated machine while a run drives it: they do what no program and no controller does.

use crate::physics::Physics;
use crate::pushes::Push;
use kerf_machine::Driven;
use kerf_model::Change;
use kerf_program::{Axes, Axis};
use std::cell::RefCell;
use std::rc::Rc;

/// Hands at the machine of a run. They reach into a simulated one; of any other they only keep what it told.
#[derive(Clone, Debug, Default)]
pub struct Hands {
    physics: Rc<RefCell<Physics>>,
    reach: bool,
}

impl Hands {
    /// Hands that reach into a machine that has this around.
    pub(crate) const fn reaching(physics: Rc<RefCell<Physics>>) -> Self {
        Self { physics, reach: true }
    }

    /// A run begins, with this around its machine.
    pub fn put(&self, physics: Physics) {
        self.physics.replace(physics);
    }

    /// The run is over: returns what is around the machine.
    pub fn take(&self) -> Physics {
        self.physics.take()
    }

    /// Move the switch of an input at a moment, by its contact: the machine tells of it. Returns `false` where nobody but
    /// the machine itself can.
    pub fn press(&self, change: Change) -> bool {
        if self.reach {
            self.physics.borrow_mut().press(change);
        }
        self.reach
    }

    /// Keep for the next run what a machine told that no hand reaches.
    pub fn keep(&self, change: Change) {
        if !self.reach {
            self.physics.borrow_mut().press(change);
        }
    }

    /// Returns the moment from another on, seconds of machine time, at which an input will read a state anew, where that
    /// is known.
    pub fn changes_s(&self, input: u8, on: bool, from_s: f64) -> Option<f64> {
        let known = self.reach.then(|| self.physics.borrow().changes_s(input, on, from_s));
        known.flatten()
    }

    /// Take the next push of the script up to a moment, seconds of machine time.
    pub fn next_push(&self, to_s: f64) -> Option<Push> {
        self.physics.borrow_mut().pushes.next(to_s)
    }

    /// Returns how far axes are from where they are believed to be, because somebody pushed them, mm or degrees.
    pub fn astray(&self) -> Axes {
        self.physics.borrow().pushes.astray
    }

    /// Push an axis without power so far, away from where it is believed to be.
    pub fn push(&self, axis: Axis, by: f64, believed: Axes) {
        if self.reach {
            self.physics.borrow_mut().pushed(axis, by, believed);
        }
    }
}

/// A machine that is opened for runs, and the hands at it.
#[derive(Clone)]
pub struct Opened {
    /// The machine.
    pub machine: Driven,
    /// The hands at it.
    pub hands: Hands,
}

/// A machine that nobody reaches into.
impl From<Driven> for Opened {
    fn from(machine: Driven) -> Self {
        Self { machine, hands: Hands::default() }
    }
}
