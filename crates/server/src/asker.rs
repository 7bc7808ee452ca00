//! The origin of a request: the page, script or console, and the time.

use crate::awaited::Awaited;
use crate::machine::StopCount;
use kerf_wire::Who;

/// A page, a script or the hand console that asks for something.
#[derive(Clone, Debug)]
pub struct Asker {
    /// The one who asks.
    pub who: Who,
    /// The request, as long as somebody waits for it.
    pub awaited: Awaited,
    /// Stops that had come when it arrived.
    stops: StopCount,
}

impl Asker {
    /// Somebody asks for something, which has arrived this moment, after so many stops.
    pub fn of(who: &Who, stops: StopCount) -> Self {
        Self { who: who.clone(), awaited: Awaited::default(), stops }
    }

    /// Stops that had come when it arrived.
    pub const fn stops(&self) -> StopCount {
        self.stops
    }

    /// The same, by another page or script.
    pub fn by(self, client: u32) -> Self {
        Self { who: Who { client, ..self.who }, ..self }
    }

    /// The same, who waits for what is asked for until it is given up.
    pub fn awaiting(self, awaited: Awaited) -> Self {
        Self { awaited, ..self }
    }
}
