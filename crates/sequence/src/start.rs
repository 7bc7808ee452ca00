//! Steps before the first motion: the door, the jigs, the second Start and the choice of the
//! first shape (Profiler reference, "Two Jig Machines", "Using an External Job Start Input").

use crate::Sequence;
use crate::place::{Here, Stage};
use crate::small::{Awaited, Small};
use kerf_machine::Configuration;
use kerf_machine::Word;
use kerf_machine::lines::{Input, Output};
use kerf_machine::state::State;
use kerf_program::job::{Job, JobShape};
use kerf_program::{Command, Sourced, Watch};
use std::sync::Arc;

/// After so long a wait the operator is asked, seconds.
pub(crate) const PATIENCE_S: f64 = 3600.0;

/// Which side of the divider a shape lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Jig {
    /// Left of it.
    One,
    /// Right of it.
    Two,
}

impl Jig {
    /// The side on which a shape lies wholly.
    fn of(shape: &JobShape, job: &Job, machine: &Configuration) -> Option<Self> {
        let bounds = shape.path.bounds();
        let [left, right] = [bounds.min, bounds.max].map(|corner| job.on_table(corner).x);
        let divider = machine.job.divider_mm;
        if right <= divider { Some(Self::One) } else { (left >= divider).then_some(Self::Two) }
    }

    const fn output(self) -> Output {
        match self {
            Self::One => Output::Jig1,
            Self::Two => Output::Jig2,
        }
    }

    const fn input(self) -> Input {
        match self {
            Self::One => Input::Jig1,
            Self::Two => Input::Jig2,
        }
    }

    const fn other(self) -> Self {
        match self {
            Self::One => Self::Two,
            Self::Two => Self::One,
        }
    }
}

/// Tells which shapes of a job are not cut on a machine with two jigs: those that lie on both sides of the divider.
pub fn straddling(job: &Job, machine: &Configuration) -> Vec<String> {
    let both = |shape: &&JobShape| machine.job.two_jigs && Jig::of(shape, job, machine).is_none();
    let told =
        |shape: &JobShape| format!("shape {} lies across the divider and is not cut", shape.number);
    job.shapes.iter().filter(both).map(told).collect()
}

/// State of the wait for the door.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Door {
    /// The job waits until it is shut.
    Waits,
    /// Nothing but that.
    Only,
    /// It was waited for.
    Shut,
}

impl Sequence {
    /// Only waits until the door is shut: something has to be done then, before the job.
    #[must_use]
    pub const fn only_waits_for_door(mut self) -> Self {
        self.door = Door::Only;
        self
    }

    /// The job once the door was waited for.
    #[must_use]
    pub const fn behind_door(mut self) -> Self {
        self.door = Door::Shut;
        self
    }

    /// Returns the steps before the job begins; often none.
    pub(crate) fn before_start(&self) -> Vec<Small> {
        let mut steps = Vec::new();
        if self.machine.job.external_start && self.door != Door::Shut {
            let (input, timeout_s) = (Input::WHome, PATIENCE_S);
            let missing = "close the door";
            steps.push(Small::SayUnless(input, missing));
            steps.push(Small::Await(Awaited { input, timeout_s, missing: Some(missing) }));
        }
        if self.door == Door::Only {
            steps.insert(0, Small::Enter(State::Waiting));
            return steps;
        }
        if self.machine.misc.double_start {
            steps.push(Small::Ask);
        }
        if self.machine.job.two_jigs {
            steps.extend([Small::Switch(Output::JobRunning, true), Small::AwaitJig]);
        }
        if !steps.is_empty() {
            steps.insert(0, Small::Enter(State::Waiting));
        }
        steps
    }

    /// Everything that was waited for is there.
    pub(crate) fn start_now(&mut self) {
        self.stage = Stage::Approach;
        self.steps.extend([Small::Enter(State::Running), Small::Switch(Output::JobRunning, true)]);
        self.steps.extend(self.jig_on());
        self.steps.extend(self.approach(false));
    }

    /// The output of the jig that is being cut.
    pub(crate) fn jig_on(&self) -> Option<Small> {
        let jig = self.jig.filter(|_| self.stage != Stage::Waiting)?;
        Some(Small::Switch(jig.output(), true))
    }

    /// Tells which shapes are not cut because they lie on both sides of the divider.
    pub(crate) fn tell_straddling(&self, out: &mut Vec<Sourced>) {
        for text in straddling(&self.job, self.machine.as_ref()) {
            self.give(Command::Message { text: text.into() }, out);
        }
    }

    /// The inputs of the jigs, the one that is preferred first.
    pub(crate) fn jig_watches(&self) -> [Watch; 2] {
        let first = self.jig.map_or_else(|| self.first_jig(), Jig::other);
        [first, first.other()].map(|jig| Watch::level(jig.input().number(), true, 0.0))
    }

    /// The jig that holds the start shape.
    fn first_jig(&self) -> Jig {
        let start = self.whole.shapes.get(self.whole.start.saturating_sub(1));
        start.and_then(|shape| Jig::of(shape, &self.whole, &self.machine)).unwrap_or(Jig::One)
    }

    /// A jig is ready: its shapes are the job until it is done; the first time from the start shape on.
    pub(crate) fn take_jig(&mut self, input: Input) {
        let jig = if input == Input::Jig2 { Jig::Two } else { Jig::One };
        let skipped = if self.jig.is_none() { self.whole.start.saturating_sub(1) } else { 0 };
        let shapes = self.whole.shapes.iter().skip(skipped);
        let mine = shapes
            .filter(|shape| Jig::of(shape, &self.whole, &self.machine) == Some(jig))
            .cloned()
            .collect();
        self.job = Arc::new(Job { shapes: mine, start: 1, ..(*self.whole).clone() });
        (self.jig, self.here) = (Some(jig), Here::default());
    }

    /// The jig is done: the head goes to the finish position, and waits for the next.
    pub(crate) fn next_jig(&mut self) -> bool {
        let Some(jig) = self.jig else { return false };
        self.stage = Stage::Waiting;
        self.steps = [
            self.up(),
            Small::Switch(jig.output(), false),
            Small::Switch(Output::Router, false),
            Small::Travel(self.job.finish.unwrap_or_default()),
            Small::Enter(State::Waiting),
            Small::AwaitJig,
        ]
        .into();
        true
    }

    /// The operator says something before the job begins.
    pub(crate) fn prepared(&mut self, word: Option<Word>) {
        let last = self.job.shapes.len().saturating_sub(1);
        let nth = match word {
            Some(Word::Continue) => {
                // Nothing came for a long time: it is waited for again.
                if !self.why.is_empty() {
                    self.why = Arc::default();
                    self.steps = self.before_start().into();
                }
                return;
            }
            Some(Word::Abort) => return self.abort(),
            Some(Word::Shape(number)) if number > last + 1 => {
                let text = format!("the job has {} shapes", self.job.shapes.len());
                self.steps.extend([Small::Say(text.into()), Small::Ask]);
                return;
            }
            Some(Word::Shape(number)) => number - 1,
            Some(Word::Next) => (self.here.nth + 1).min(last),
            Some(Word::Previous) => self.here.nth.saturating_sub(1),
            Some(word) => {
                self.obey(word);
                self.steps.push_back(Small::Ask);
                return;
            }
            None => self.here.nth,
        };
        self.here.nth = nth;
        if let Some(shape) = self.here.shape(&self.job) {
            // Over it the head comes down to the height of travel: from there it is seen where it would cut.
            let down = Small::Rapid(self.travel_mm());
            self.steps.extend([self.up(), Small::Travel(shape.start()), down]);
        }
        self.steps.push_back(Small::Ask);
    }
}
