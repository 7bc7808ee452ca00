//! A board that is only asked who it is: nothing of it is configured, and nothing moves.

use super::greeting::Greeting;
use super::news::Fault;
use crate::dictionary::Dictionary;
use crate::link::{Heard, Link, Outgoing};
use crate::orders::{Order, Orders};

/// Time after which an answer counts as lost, seconds.
const PATIENCE_S: f64 = 0.25;
/// Questions without an answer after which there is none.
const TRIES: u32 = 8;

/// The configuration that a board holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// None since it was powered.
    None,
    /// One with this check number.
    Some(u32),
    /// The board is shut down; the reason is told with the next session.
    ShutDown,
}

/// A board that has told who it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Introduced {
    /// Its words.
    pub dictionary: Dictionary,
    /// Its configuration.
    pub held: Held,
}

/// A board on its way to be known. Moments are seconds on the owner's clock.
pub struct Introduction {
    phase: Phase,
}

enum Phase {
    Greeting(Greeting),
    Asking(Box<Asking>),
    Over(Option<Result<Introduced, Fault>>),
}

/// The configuration is asked for.
struct Asking {
    link: Link,
    dictionary: Dictionary,
    ask_s: f64,
    tries: u32,
}

impl Introduction {
    /// Begins to look for a board on a line with so many bits a second; nothing over USB.
    pub fn new(now_s: f64) -> Self {
        Self { phase: Phase::Greeting(Greeting::new(now_s)) }
    }

    /// Reads bytes that came.
    pub fn receive(&mut self, bytes: &[u8], now_s: f64) {
        let next = match &mut self.phase {
            Phase::Greeting(greeting) => greeting.receive(bytes, now_s).transpose().map(|found| {
                found.map(|(link, dictionary)| {
                    Phase::Asking(Box::new(Asking { link, dictionary, ask_s: now_s, tries: 0 }))
                })
            }),
            Phase::Asking(asking) => {
                asking.receive(bytes, now_s).map(|introduced| Ok(Phase::Over(Some(Ok(introduced)))))
            }
            Phase::Over(_) => None,
        };
        if let Some(next) = next {
            self.phase = next.unwrap_or_else(|fault| Phase::Over(Some(Err(fault))));
        }
    }

    /// Returns the bytes to be written now.
    pub fn transmit(&mut self, now_s: f64) -> Outgoing {
        let out = match &mut self.phase {
            Phase::Greeting(greeting) => greeting.transmit(now_s),
            Phase::Asking(asking) => asking.transmit(now_s),
            Phase::Over(_) => Ok(Outgoing::default()),
        };
        out.unwrap_or_else(|fault| {
            self.phase = Phase::Over(Some(Err(fault)));
            Outgoing::default()
        })
    }

    /// A board has answered. From then on silence ends it, however long the board takes to tell who it is.
    pub const fn has_answered(&self) -> bool {
        match &self.phase {
            Phase::Greeting(greeting) => greeting.has_answered(),
            _ => true,
        }
    }

    /// Takes the end: who the board is, or the reason for which that is unknown.
    pub fn take(&mut self) -> Option<Result<Introduced, Fault>> {
        match &mut self.phase {
            Phase::Over(told) => told.take(),
            _ => None,
        }
    }
}

impl Asking {
    fn receive(&mut self, bytes: &[u8], now_s: f64) -> Option<Introduced> {
        let held = self.link.receive(bytes, now_s).into_iter().find_map(|heard| {
            let Heard::Message(bytes) = heard else { return None };
            let message = self.dictionary.message(&bytes).filter(|it| it.name() == "config")?;
            let number = |field| message.number(field).unwrap_or_default();
            Some(match (number("is_shutdown"), number("is_config")) {
                (0, 0) => Held::None,
                (0, _) => Held::Some(number("crc")),
                _ => Held::ShutDown,
            })
        })?;
        Some(Introduced { dictionary: self.dictionary.clone(), held })
    }

    fn transmit(&mut self, now_s: f64) -> Result<Outgoing, Fault> {
        if now_s >= self.ask_s {
            let question = Orders::new(&self.dictionary).write(Order::Config, [])?;
            self.tries += 1;
            if self.tries > TRIES || !self.link.send(question, None) {
                return Err(Fault::Unanswered("get_config"));
            }
            self.ask_s = now_s + PATIENCE_S;
        }
        Ok(self.link.transmit(now_s))
    }
}
