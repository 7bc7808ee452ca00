//! Where events go.

use crate::Event;

/// Takes the events of a run, in order of machine time.
pub trait Sink {
    /// Takes one.
    fn event(&mut self, event: &Event);
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
}
