//! Receivers of events.

use crate::{Event, RunStatus};
use kerf_machine::Going;
use kerf_machine::Lift;
use kerf_model::Model;
use kerf_motion::{Plan, Span};
use kerf_program::{At, Axes, Axis};
use std::sync::Arc;

/// A move that the machine executes, with its plan.
#[derive(Clone, Copy, Debug)]
pub struct ExecutedMove<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// The move's part of it.
    pub span: &'a Span<'a>,
    /// Begin of the plan, seconds of machine time.
    pub t0_s: f64,
    /// The motor that makes it while the others of its axis stand, by its place among them; `None` for all.
    pub alone: Option<(Axis, usize)>,
    /// The distance that height control carries Z beside the plan.
    pub lift: &'a Lift,
    /// It is none of the program: by hand, away from a place where the run stands and back to it.
    pub beside: bool,
}

impl ExecutedMove<'_> {
    /// The place of the axes at a moment of the plan within the move.
    pub fn place(&self, plan_s: f64) -> Axes {
        let mut place = self.plan.at(plan_s).position;
        place[Axis::Z] += self.lift.at(self.t0_s + plan_s);
        place
    }
}

/// Activity of the machine while time passes.
#[derive(Clone, Copy, Debug)]
pub struct Doing<'a> {
    /// The machine as it is before.
    pub machine: &'a Model,
    /// The move that it makes; `None` while it stands.
    pub going: Option<&'a Going<'a>>,
    /// The share of the speed asked for at which the plan has cuts run.
    pub feed: f32,
    /// The files of the run, in the order in which they were opened first.
    pub files: &'a [Arc<str>],
}

impl Doing<'_> {
    /// The file that a place is in; nothing where no file stands for it.
    pub fn file(&self, at: At) -> Option<&Arc<str>> {
        self.files.get(at.file as usize)
    }
}

/// Takes the events of a run, in order of machine time.
pub trait Sink {
    /// Takes one.
    fn event(&mut self, event: &Event);

    /// Tells whether it looks at moves and arcs. Where nobody does they are not described at all, which
    /// matters for programs with a million of them.
    fn looks_at_motion(&self) -> bool {
        true
    }

    /// A move is made: how every axis goes is in its plan.
    fn made(&mut self, _: &ExecutedMove<'_>) {}

    /// A move was made before the run was cut short that is taken up: it is gone through in silence.
    fn made_before(&mut self, _: &ExecutedMove<'_>) {}

    /// Machine time goes on from one moment to another, seconds, while the machine does this. A moment may be told twice.
    fn under_way(&mut self, _doing: &Doing<'_>, _from_s: f64, _to_s: f64) {}

    /// VD was carried out; comments are shown from now on, or not.
    fn displays(&mut self, _comments: bool) {}

    /// The run stands somewhere else: it goes on to other lines, waits, or is over.
    fn run_status(&mut self, _: &RunStatus) {}

    /// Tells whether it looks at where the run stands.
    fn looks_at_status(&self) -> bool {
        false
    }

    /// The variables whose values it wants to see there, with their signs: `&a`, `$b`, `#100`.
    fn watches(&self) -> Vec<String> {
        Vec::new()
    }
}

/// Keeps every event.
impl Sink for Vec<Event> {
    fn event(&mut self, event: &Event) {
        self.push(event.clone());
    }
}

/// Keeps none: for runs of which only the summary is wanted.
impl Sink for () {
    fn event(&mut self, _: &Event) {}

    fn looks_at_motion(&self) -> bool {
        false
    }
}

/// Two take every event.
impl<A: Sink, B: Sink> Sink for (A, B) {
    fn event(&mut self, event: &Event) {
        self.0.event(event);
        self.1.event(event);
    }

    fn looks_at_motion(&self) -> bool {
        self.0.looks_at_motion() || self.1.looks_at_motion()
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        self.0.made(made);
        self.1.made(made);
    }

    fn made_before(&mut self, made: &ExecutedMove<'_>) {
        self.0.made_before(made);
        self.1.made_before(made);
    }

    fn under_way(&mut self, doing: &Doing<'_>, from_s: f64, to_s: f64) {
        self.0.under_way(doing, from_s, to_s);
        self.1.under_way(doing, from_s, to_s);
    }

    fn displays(&mut self, comments: bool) {
        self.0.displays(comments);
        self.1.displays(comments);
    }

    fn run_status(&mut self, standing: &RunStatus) {
        self.0.run_status(standing);
        self.1.run_status(standing);
    }

    fn looks_at_status(&self) -> bool {
        self.0.looks_at_status() || self.1.looks_at_status()
    }

    fn watches(&self) -> Vec<String> {
        [self.0.watches(), self.1.watches()].concat()
    }
}

impl<S: Sink + ?Sized> Sink for &mut S {
    fn event(&mut self, event: &Event) {
        (**self).event(event);
    }

    fn looks_at_motion(&self) -> bool {
        (**self).looks_at_motion()
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        (**self).made(made);
    }

    fn made_before(&mut self, made: &ExecutedMove<'_>) {
        (**self).made_before(made);
    }

    fn under_way(&mut self, doing: &Doing<'_>, from_s: f64, to_s: f64) {
        (**self).under_way(doing, from_s, to_s);
    }

    fn displays(&mut self, comments: bool) {
        (**self).displays(comments);
    }

    fn run_status(&mut self, standing: &RunStatus) {
        (**self).run_status(standing);
    }

    fn looks_at_status(&self) -> bool {
        (**self).looks_at_status()
    }

    fn watches(&self) -> Vec<String> {
        (**self).watches()
    }
}

/// Perhaps one takes them.
impl<S: Sink> Sink for Option<S> {
    fn event(&mut self, event: &Event) {
        if let Some(sink) = self {
            sink.event(event);
        }
    }

    fn looks_at_motion(&self) -> bool {
        self.as_ref().is_some_and(S::looks_at_motion)
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        if let Some(sink) = self {
            sink.made(made);
        }
    }

    fn made_before(&mut self, made: &ExecutedMove<'_>) {
        if let Some(sink) = self {
            sink.made_before(made);
        }
    }

    fn under_way(&mut self, doing: &Doing<'_>, from_s: f64, to_s: f64) {
        if let Some(sink) = self {
            sink.under_way(doing, from_s, to_s);
        }
    }

    fn displays(&mut self, comments: bool) {
        if let Some(sink) = self {
            sink.displays(comments);
        }
    }

    fn run_status(&mut self, standing: &RunStatus) {
        if let Some(sink) = self {
            sink.run_status(standing);
        }
    }

    fn looks_at_status(&self) -> bool {
        self.as_ref().is_some_and(S::looks_at_status)
    }

    fn watches(&self) -> Vec<String> {
        self.as_ref().map(S::watches).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moves_are_told_when_anybody_looks() {
        let (list, nobody) = (Vec::<Event>::new(), None::<Vec<Event>>);
        assert!((list.clone(), ()).looks_at_motion() && ((), list.clone()).looks_at_motion());
        assert!(Some(list).looks_at_motion());
        assert!(!((), nobody).looks_at_motion());
        assert!(!(&mut () as &mut dyn Sink).looks_at_motion());
    }
}
