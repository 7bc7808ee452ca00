//! Preparations of a run, which are a part of it for whoever looks: the door, the question where the machine is,
//! homing. Each is a run of its own on the machine. The clock goes on from one to the next, what was counted is
//! counted on, and there is one beginning and one end.

use crate::Summary;
use kerf_program::settings::LinearUnit;
use kerf_trace::{Event, Made, Sink, Standing, Tally};
use serde::{Deserialize, Serialize};

/// State that a run goes on from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Before {
    /// Machine time at which it was over, seconds.
    pub(crate) ends_s: f64,
    moves: u64,
    jog_mm: f64,
    jog_s: f64,
    wait_s: f64,
    /// State of the wait for the door of a job.
    pub(crate) door: Door,
    /// The unit in which it is told, where that is not the machine's own.
    #[serde(skip)]
    pub(crate) unit: Option<LinearUnit>,
}

/// State of the wait for the door of a job.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Door {
    /// The job waits for it.
    #[default]
    Waits,
    /// Nothing is done but waiting for it.
    Only,
    /// It was waited for.
    Shut,
}

impl Before {
    /// Another part of it is over.
    pub(crate) const fn went_on(&mut self, summary: &Summary) {
        let Tally { moves, jog_mm, jog_s, wait_s, .. } = summary.tally;
        (self.ends_s, self.moves) = (summary.seconds, moves);
        (self.jog_mm, self.jog_s, self.wait_s) = (jog_mm, jog_s, wait_s);
    }

    /// Returns the tally so far.
    pub(crate) fn tally(&self) -> Tally {
        let mut tally = Tally::default();
        (tally.moves, tally.jog_mm) = (self.moves, self.jog_mm);
        (tally.jog_s, tally.wait_s) = (self.jog_s, self.wait_s);
        tally
    }

    /// The same, seeing so far to the door.
    pub(crate) const fn seeing_to(mut self, door: Door) -> Self {
        self.door = door;
        self
    }

    /// The same, told in a unit.
    pub(crate) const fn told_in(mut self, unit: Option<LinearUnit>) -> Self {
        self.unit = unit;
        self
    }
}

/// The parts of a run as one: it begins with the first, and ends with the last.
pub(crate) struct Whole<'a> {
    sink: &'a mut dyn Sink,
    begun: bool,
    /// End of the part that is over: that of the run, unless another part follows.
    end: Option<Event>,
}

impl<'a> Whole<'a> {
    pub fn new(sink: &'a mut dyn Sink) -> Self {
        Self { sink, begun: false, end: None }
    }

    /// No other part follows.
    pub fn ends(self) {
        self.end.iter().for_each(|end| self.sink.event(end));
    }
}

impl Sink for Whole<'_> {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Start { .. } if std::mem::replace(&mut self.begun, true) => self.end = None,
            Event::End(_) => self.end = Some(event.clone()),
            _ => self.sink.event(event),
        }
    }

    fn looks_at_motion(&self) -> bool {
        self.sink.looks_at_motion()
    }

    fn made(&mut self, made: &Made<'_>) {
        self.sink.made(made);
    }

    fn made_before(&mut self, made: &Made<'_>) {
        self.sink.made_before(made);
    }

    fn under_way(&mut self, doing: &kerf_trace::Doing<'_>, from_s: f64, to_s: f64) {
        self.sink.under_way(doing, from_s, to_s);
    }

    fn displays(&mut self, comments: bool) {
        self.sink.displays(comments);
    }

    fn standing(&mut self, standing: &Standing) {
        self.sink.standing(standing);
    }

    fn looks_at_standing(&self) -> bool {
        self.sink.looks_at_standing()
    }

    fn watches(&self) -> Vec<String> {
        self.sink.watches()
    }
}
