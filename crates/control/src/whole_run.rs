//! The preparations of a run and the run itself, told as one.

use kerf_trace::{Event, ExecutedMove, RunStatus, Sink};

/// The parts of a run as one: it begins with the first, and ends with the last.
pub(crate) struct WholeRun<'a> {
    sink: &'a mut dyn Sink,
    begun: bool,
    /// End of the part that is over: that of the run, unless another part follows.
    end: Option<Event>,
}

impl<'a> WholeRun<'a> {
    pub fn new(sink: &'a mut dyn Sink) -> Self {
        Self { sink, begun: false, end: None }
    }

    /// Ends the run: passes on the end of its last part.
    pub fn ends(self) {
        self.end.iter().for_each(|end| self.sink.event(end));
    }
}

impl Sink for WholeRun<'_> {
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

    fn made(&mut self, made: &ExecutedMove<'_>) {
        self.sink.made(made);
    }

    fn made_before(&mut self, made: &ExecutedMove<'_>) {
        self.sink.made_before(made);
    }

    fn under_way(&mut self, doing: &kerf_trace::Doing<'_>, from_s: f64, to_s: f64) {
        self.sink.under_way(doing, from_s, to_s);
    }

    fn displays(&mut self, comments: bool) {
        self.sink.displays(comments);
    }

    fn run_status(&mut self, standing: &RunStatus) {
        self.sink.run_status(standing);
    }

    fn looks_at_status(&self) -> bool {
        self.sink.looks_at_status()
    }

    fn watches(&self) -> Vec<String> {
        self.sink.watches()
    }
}
