//! Steps before the first motion: the door, the jigs, the second Start and the choice of the
//! first shape (Profiler reference, "Two Jig Machines", "Using an External Job Start Input").

use crate::setup::Setup;
use kerf_machine::Configuration;
use kerf_machine::lines::{Input, Output};
use kerf_program::Watch;
use kerf_program::job::{Job, JobShape};

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
    pub fn of(shape: &JobShape, job: &Job, machine: &Configuration) -> Option<Self> {
        let bounds = shape.path.bounds();
        let [left, right] = [bounds.min, bounds.max].map(|corner| job.on_table(corner).x);
        let divider = machine.job.divider_mm;
        if right <= divider { Some(Self::One) } else { (left >= divider).then_some(Self::Two) }
    }

    pub const fn output(self) -> Output {
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Door {
    /// The job waits until it is shut.
    #[default]
    Waits,
    /// Nothing but that.
    Only,
    /// It was waited for.
    Shut,
}

/// What a start waits for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Start {
    pub door: Door,
    /// The jig being cut, or cut last.
    pub jig: Option<Jig>,
}

impl Start {
    /// The inputs of the jigs, the one that is preferred first.
    pub fn jig_watches(&self, setup: &Setup) -> [Watch; 2] {
        let first = self.jig.map_or_else(|| first_jig(setup), Jig::other);
        [first, first.other()].map(|jig| Watch::level(jig.input().number(), true, 0.0))
    }
}

/// The jig that holds the start shape.
fn first_jig(setup: &Setup) -> Jig {
    let start = setup.whole.shapes.get(setup.whole.start.saturating_sub(1));
    start.and_then(|shape| Jig::of(shape, &setup.whole, &setup.machine)).unwrap_or(Jig::One)
}
