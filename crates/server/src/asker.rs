//! Somebody who asks for something, and when.

use crate::awaited::Awaited;
use crate::machine::Stops;
use kerf_wire::Who;

/// Somebody who asks for something.
#[derive(Clone, Debug)]
pub struct Asker {
    /// The one who asks.
    pub who: Who,
    /// The request, as long as somebody waits for it.
    pub awaited: Awaited,
    /// Stops that had come when it arrived.
    pub stops: Stops,
}

impl Asker {
    /// Somebody asks for something, which has arrived this moment, after so many stops.
    pub fn of(who: &Who, stops: Stops) -> Self {
        Self { who: who.clone(), awaited: Awaited::default(), stops }
    }

    /// The same, who waits for what is asked for until it is given up.
    pub fn awaiting(self, awaited: Awaited) -> Self {
        Self { awaited, ..self }
    }
}
