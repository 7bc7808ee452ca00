//! Relation of machine time to the time of the world, and wishes of the operator meanwhile.

use crate::journal::Hurry;
use kerf_machine::{Fault, Going};
use kerf_motion::Move;
use kerf_program::At;
use kerf_sim::Machine;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Wish of the operator about a machine that runs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Wish {
    /// The machine ramps down and lifts the tool; the operator is asked whether the run goes on.
    Stop,
    /// The machine ramps down and stands where it is until the operator resumes.
    Hold,
    /// Cuts run at this share of the speed asked for, from 0.1 to 2 (feed override).
    Feed(f32),
    /// The machine ramps down, and the run is over where it stands; nobody is asked. That is how a
    /// movement ends that somebody held a key for.
    End,
    /// The switch of an input of the simulated machine is moved.
    Input {
        /// Which input.
        number: u8,
        /// Its contact is closed from now on.
        on: bool,
    },
}

/// Activity of the machine while time passes.
#[derive(Clone, Copy, Debug)]
pub struct Doing<'a> {
    /// The machine as it is before.
    pub machine: &'a Machine,
    /// The move that it is about to make; `None` while it stands.
    pub going: Option<Going<'a>>,
    /// The files of the run, in the order in which they were opened first.
    pub files: &'a [Arc<str>],
}

impl Doing<'_> {
    /// The file that a place is in; nothing where no file stands for it.
    pub fn file(&self, at: At) -> Option<&Arc<str>> {
        self.files.get(at.file as usize)
    }
}

/// Says how far machine time may run, and what the operator wants.
pub trait Pace {
    /// Machine time is about to go from one moment to another, seconds; both may be the same. When
    /// the operator wants something before, returns the moment and what it is; asked again from
    /// there, it tells the next.
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)>;

    /// As [`Pace::pass`], for whoever shows what the machine does meanwhile. This is what a run asks.
    fn watch(&mut self, from_s: f64, to_s: f64, _: &Doing<'_>) -> Option<(f64, Wish)> {
        self.pass(from_s, to_s)
    }

    /// Tells whether a second of machine time takes a second.
    fn is_real(&self) -> bool {
        false
    }

    /// Tells whoever waits for a disk while the machine stands that it is to stop.
    fn hurry(&self) -> Option<Hurry> {
        None
    }

    /// The machine stands because of the stop that `pass` told: it is asked what comes next, which
    /// takes no machine time, and does not stop for the same reason again.
    fn heard(&mut self) {}

    /// Another plan, or another piece of it, is about to be followed.
    fn follows(&mut self) {}

    /// The machine is to stop on its way. A machine that slows down by itself tells the moment of the plan
    /// at which it stands, seconds of machine time.
    fn brake(&mut self, _: Going<'_>) -> Option<f64> {
        None
    }

    /// Everything that was planned is made: the machine stands.
    fn stands(&mut self) {}

    /// Tells why a machine cannot make a move, in words; asked before anything of its stack moves.
    fn refuses(&self, _: &Move) -> Option<String> {
        None
    }

    /// Returns the fault for which the machine does nothing more, where it is not the plan that decides that.
    fn failure(&self) -> Option<&Fault> {
        None
    }

    /// The machine is held since a moment. Returns the moment at which the operator resumes; `None`
    /// when instead the run is to end.
    fn resumes(&mut self, _held_s: f64) -> Option<f64> {
        None
    }
}

/// As fast as can be computed, never stopped.
impl Pace for () {
    fn pass(&mut self, _: f64, _: f64) -> Option<(f64, Wish)> {
        None
    }
}

/// As fast as can be computed; the operator stops at a machine time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopAt(pub f64);

impl Pace for StopAt {
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        (to_s > from_s && to_s >= self.0).then_some((self.0.max(from_s), Wish::Stop))
    }

    fn heard(&mut self) {
        self.0 = f64::INFINITY;
    }
}

/// As fast as can be computed; what the operator does is known beforehand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// In order of time; the next one last.
    wishes: Vec<(f64, Wish)>,
    /// The next one last.
    resumes: Vec<f64>,
}

impl Script {
    /// Machine times, seconds, with what the operator wants then; and when a hold ends.
    pub fn new(mut wishes: Vec<(f64, Wish)>, mut resumes: Vec<f64>) -> Self {
        wishes.sort_by(|a, b| b.0.total_cmp(&a.0));
        resumes.sort_by(|a, b| b.total_cmp(a));
        Self { wishes, resumes }
    }
}

impl Pace for Script {
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        let (at_s, wish) = self.wishes.pop_if(|(at_s, _)| to_s > from_s && to_s >= *at_s)?;
        Some((at_s.max(from_s), wish))
    }

    /// A time that passed while the machine ramped down resumes at once.
    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        self.resumes.pop().map(|at_s| at_s.max(held_s))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_script_tells_its_wishes_in_order_and_once() {
        let mut script = Script::new(
            vec![(3.0, Wish::Stop), (1.0, Wish::Hold), (1.0, Wish::Feed(0.5))],
            vec![2.0],
        );
        assert_eq!(script.pass(0.0, 0.9), None);
        let mut seen = Vec::new();
        while let Some((at_s, wish)) = script.pass(0.9, 2.5) {
            seen.push((at_s, wish));
        }
        assert_eq!(seen.len(), 2);
        assert_eq!((script.resumes(2.5), script.resumes(2.5)), (Some(2.5), None));
        assert_eq!(script.pass(2.5, 4.0), Some((3.0, Wish::Stop)));
    }
}
