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

/// Two take every event.
impl<A: Sink, B: Sink> Sink for (A, B) {
    fn event(&mut self, event: &Event) {
        self.0.event(event);
        self.1.event(event);
    }
}

impl<S: Sink + ?Sized> Sink for &mut S {
    fn event(&mut self, event: &Event) {
        (**self).event(event);
    }
}

/// Perhaps one takes them.
impl<S: Sink> Sink for Option<S> {
    fn event(&mut self, event: &Event) {
        if let Some(sink) = self {
            sink.event(event);
        }
    }
}
