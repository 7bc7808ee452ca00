//! The beginning of a session: a board is joined, and its own words are read.

use super::news::Fault;
use super::session::SILENCE_S;
use crate::dictionary::Dictionary;
use crate::identify::Identify;
use crate::link::{Heard, Join, Link, Outgoing};

/// A board whose words are not known yet.
pub enum Greeting {
    /// It is asked for the number that it expects.
    Joining(Join),
    /// Its dictionary is read.
    Identifying(Box<(Link, Identify)>),
}

impl Greeting {
    pub fn new(now_s: f64) -> Self {
        Self::Joining(Join::new(now_s))
    }

    /// Reads bytes; returns the line and the words of the board once these are whole.
    pub fn receive(
        &mut self,
        bytes: &[u8],
        now_s: f64,
    ) -> Result<Option<(Link, Dictionary)>, Fault> {
        match self {
            Self::Joining(join) => {
                if let Some(expected) = join.receive(bytes, now_s) {
                    let link = Link::new(expected);
                    *self = Self::Identifying(Box::new((link, Identify::new(now_s))));
                }
                Ok(None)
            }
            Self::Identifying(pair) => {
                let (link, identify) = pair.as_mut();
                for heard in link.receive(bytes, now_s) {
                    let Heard::Message(message) = heard else { continue };
                    if let Some(dictionary) = identify.heard(&message, now_s)? {
                        return Ok(Some((link.clone(), dictionary)));
                    }
                }
                Ok(None)
            }
        }
    }

    /// Returns the bytes to be written now.
    pub fn transmit(&mut self, now_s: f64) -> Result<Outgoing, Fault> {
        match self {
            Self::Joining(join) if join.is_vain(now_s) => Err(Fault::NoBoard),
            Self::Joining(join) => Ok(Outgoing { bytes: join.transmit(now_s), replaces: false }),
            Self::Identifying(pair) => {
                let (link, identify) = pair.as_mut();
                if identify.is_vain(now_s) {
                    return Err(Fault::Unanswered("identify"));
                }
                let asked = identify.ask(now_s).is_none_or(|question| link.send(question, None));
                let silent = !asked || link.silent_s(now_s) > SILENCE_S;
                if silent { Err(Fault::Silent) } else { Ok(link.transmit(now_s)) }
            }
        }
    }

    /// A board has answered: whatever comes then comes from it.
    pub const fn has_answered(&self) -> bool {
        matches!(self, Self::Identifying(_))
    }

    pub fn due_s(&self) -> f64 {
        match self {
            Self::Joining(join) => join.due_s(),
            Self::Identifying(pair) => pair.0.due_s().min(pair.1.due_s()),
        }
    }
}
