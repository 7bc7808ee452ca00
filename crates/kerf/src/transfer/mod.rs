//! Job files sent over a serial line, from the computer where they are made to the one at the machine
//! (Profiler reference, "Sending Files").
//!
//! ```text
//!  Sender   ── Offer: name, size, checksum ──►            Receiver
//!           ◄─ Next 0 ── or Hold: the machine moves ──
//!           ── Block 0 ──►
//!           ◄─ Next 1 ── …                  damaged or lost: the block comes again
//!           ── Stop ──►  ◄─ Stop ──         from either end: nothing is kept
//! ```
//!
//! Both ends are values that take bytes and a time and give bytes; whoever owns the line moves them. Every
//! frame ends with a checksum ([`frame`]); what does not fit it is as good as lost, and what is not answered
//! is sent again. The receiver hands the file over when all of it is there and its checksum is right.

mod frame;
mod receiver;
mod sender;

pub use receiver::Receiver;
pub use sender::Sender;

/// An end that hears nothing for so long gives up, seconds.
const LOST_S: f64 = 8.0;

/// While the machine moves the sender is told so often, seconds.
const HOLD_S: f64 = 1.0;

/// The largest file, bytes: more than a day at 2400 baud.
pub const LARGEST: usize = 1 << 24;

/// State of a transfer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum State {
    /// Nothing has begun: the receiver waits for an offer, the sender for an answer.
    Waiting,
    /// Bytes go over.
    Sending,
    /// The machine moves: nothing goes over until it stands.
    Held,
    /// The file is there.
    Done,
    /// It was stopped, at this end or the other.
    Stopped,
    /// It failed.
    Failed(String),
}

impl State {
    /// Returns `true` if nothing more will happen.
    pub const fn is_over(&self) -> bool {
        matches!(self, Self::Done | Self::Stopped | Self::Failed(_))
    }
}

/// Progress of a transfer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    /// The file.
    pub name: String,
    /// Bytes that are over.
    pub done: usize,
    /// Bytes of the file.
    pub total: usize,
}

#[cfg(test)]
mod tests;
