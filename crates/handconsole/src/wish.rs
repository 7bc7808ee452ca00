//! What the console wants done.

use kerf_machine::{Errand, Held};

/// What the console wants done by whoever owns machine and files. Wishes of one key are granted one after the
/// other; when one is refused, those behind it are dropped.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// The machine stops.
    Stop,
    /// It goes on after a hold.
    Resume,
    /// The open job is run.
    Start,
    /// The open question is answered.
    Answer(String),
    /// Somebody has taken note of an alarm.
    Acknowledge,
    /// Whoever has the console drives from now on, and the machine is armed.
    TakeControl,
    /// A job of the current folder is opened.
    Open(String),
    /// The tool moves for as long as the key is held.
    Jog(Held),
    /// The machine does an errand to its end.
    Go(Errand),
    /// A setting of the machine gets a value.
    Set {
        /// Its key.
        key: &'static str,
        /// The value, as it is written in a configuration.
        value: String,
    },
}

impl Wish {
    /// Whether it is only done when the outcome is told, and the console shows it until then.
    pub const fn lasts(&self) -> bool {
        matches!(self, Self::Go(_))
    }
}
