//! Requests of the operator about a run, in the order in which they come.

use kerf_journal::Hurry;
use kerf_machine::driver::Override;
use serde::{Deserialize, Serialize};

/// Request of the operator about a machine that runs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum OperatorRequest {
    /// The machine ramps down and lifts the tool; the operator is asked whether the run goes on.
    Stop,
    /// The machine ramps down and stands where it is until the operator resumes.
    Hold,
    /// Cuts run at this share of the speed asked for, from 0.1 to 2 (feed override).
    Feed(f32),
    /// The machine ramps down, and the run is over where it stands; nobody is asked. That is how a
    /// movement ends that somebody held a key for.
    End,
    /// The run is given up where it is held: the machine stays there, and nobody is asked.
    GiveUp,
    /// The switch of an input of the simulated machine is moved.
    Input {
        /// Which input.
        number: u8,
        /// Its contact is closed from now on.
        on: bool,
    },
}

/// Queue of the operator's requests. Nothing in it waits.
pub trait Requests {
    /// Takes the first request that comes from one moment of machine time to another, seconds; both may be the same. One
    /// that somebody makes just now comes at the first of them. Asked again from there, it gives the next.
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)>;

    /// Takes what the operator has turned up to a moment of machine time, seconds, and what the plan is not changed by.
    fn turned(&mut self, _now_s: f64) -> Option<Override> {
        None
    }

    /// Tells whoever waits for a disk while the machine stands that it is to stop.
    fn hurry(&self) -> Option<Hurry> {
        None
    }

    /// The machine stands because of the stop that was taken: the operator is asked what comes next, and the machine does
    /// not stop for the same reason again.
    fn heard(&mut self) {}

    /// The machine is held since a moment. Returns the moment at which the operator resumes; `None`
    /// when instead the run is to end.
    fn resumes(&mut self, _held_s: f64) -> Option<f64> {
        None
    }
}

/// A queue without requests.
impl Requests for () {
    fn take(&mut self, _: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        None
    }
}

/// The operator stops the machine at a machine time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopAt(pub f64);

impl Requests for StopAt {
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        (to_s > from_s && to_s >= self.0).then_some((self.0.max(from_s), OperatorRequest::Stop))
    }

    fn heard(&mut self) {
        self.0 = f64::INFINITY;
    }
}

/// Requests that are known beforehand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// In order of time; the next one last.
    requests: Vec<(f64, OperatorRequest)>,
    /// The next one last.
    resumes: Vec<f64>,
    /// The next one last.
    turns: Vec<(f64, Override)>,
}

impl Script {
    /// Machine times, seconds, with what the operator asks for then; and when a hold ends.
    pub fn new(mut requests: Vec<(f64, OperatorRequest)>, mut resumes: Vec<f64>) -> Self {
        requests.sort_by(|a, b| b.0.total_cmp(&a.0));
        resumes.sort_by(|a, b| b.total_cmp(a));
        Self { requests, resumes, turns: Vec::new() }
    }

    /// The same, with what else the operator turns at machine times, seconds.
    #[must_use]
    pub fn turning(mut self, mut turns: Vec<(f64, Override)>) -> Self {
        turns.sort_by(|a, b| b.0.total_cmp(&a.0));
        self.turns = turns;
        self
    }
}

impl Requests for Script {
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        let due = |(at_s, _): &mut (f64, OperatorRequest)| to_s > from_s && to_s >= *at_s;
        let (at_s, request) = self.requests.pop_if(due)?;
        Some((at_s.max(from_s), request))
    }

    fn turned(&mut self, now_s: f64) -> Option<Override> {
        self.turns.pop_if(|(at_s, _)| now_s >= *at_s).map(|(_, turned)| turned)
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
    fn a_script_gives_its_requests_in_order_and_once() {
        let requests = vec![
            (3.0, OperatorRequest::Stop),
            (1.0, OperatorRequest::Hold),
            (1.0, OperatorRequest::Feed(0.5)),
        ];
        let mut script = Script::new(requests, vec![2.0]);
        assert_eq!(script.take(0.0, 0.9), None);
        let mut seen = Vec::new();
        while let Some((at_s, request)) = script.take(0.9, 2.5) {
            seen.push((at_s, request));
        }
        assert_eq!(seen.len(), 2);
        assert_eq!((script.resumes(2.5), script.resumes(2.5)), (Some(2.5), None));
        assert_eq!(script.take(2.5, 4.0), Some((3.0, OperatorRequest::Stop)));
    }
}
