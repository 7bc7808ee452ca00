//! Preparations of a run, which are a part of it for whoever looks: the door, the question where the machine is,
//! homing. Each is a run of its own on the machine. The clock goes on from one to the next, what was counted is
//! counted on, and there is one beginning and one end.

use kerf_program::settings::LinearUnit;
use kerf_trace::{Summary, Tally};
use serde::{Deserialize, Serialize};

/// State that a run goes on from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CarriedOver {
    /// Machine time at which it was over, seconds.
    pub ends_s: f64,
    moves: u64,
    jog_mm: f64,
    jog_s: f64,
    wait_s: f64,
    /// State of the wait for the door of a job.
    pub door: Door,
    /// The unit in which it is told, where that is not the machine's own.
    #[serde(skip)]
    pub unit: Option<LinearUnit>,
}

/// State of the wait for the door of a job.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Door {
    /// The job waits for it.
    #[default]
    Waits,
    /// Nothing is done but waiting for it.
    Only,
    /// It was waited for.
    Shut,
}

impl CarriedOver {
    /// Another part of it is over.
    pub const fn went_on(&mut self, summary: &Summary) {
        let Tally { moves, jog_mm, jog_s, wait_s, .. } = summary.tally;
        (self.ends_s, self.moves) = (summary.seconds, moves);
        (self.jog_mm, self.jog_s, self.wait_s) = (jog_mm, jog_s, wait_s);
    }

    /// Returns the tally so far.
    pub fn tally(&self) -> Tally {
        let mut tally = Tally::default();
        (tally.moves, tally.jog_mm) = (self.moves, self.jog_mm);
        (tally.jog_s, tally.wait_s) = (self.jog_s, self.wait_s);
        tally
    }

    /// The same, seeing so far to the door.
    pub const fn seeing_to(mut self, door: Door) -> Self {
        self.door = door;
        self
    }

    /// The same, told in a unit.
    pub const fn told_in(mut self, unit: Option<LinearUnit>) -> Self {
        self.unit = unit;
        self
    }
}
