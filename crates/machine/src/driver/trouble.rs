//! Reasons for which a controller stops working.

use std::borrow::Cow;

/// Reason for which a controller does nothing more.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Trouble {
    /// It stopped by itself; whether it knows where it is.
    #[error("alarm {number}: {why}")]
    Alarm {
        /// Its number.
        number: u16,
        /// In words.
        why: Cow<'static, str>,
        /// Steps may be lost.
        lost: bool,
    },
    /// It was locked when it was connected.
    #[error("it is locked: {why}")]
    Locked {
        /// The reason, and the way to end it.
        why: &'static str,
    },
    /// It cannot be driven in the state that it is set to.
    #[error("{why}")]
    Unfit {
        /// The reason, and the way to mend it.
        why: &'static str,
    },
    /// The machine is at another place than ordered, and knows it.
    #[error("{why}: a line was garbled on its way, look at the cable")]
    Elsewhere {
        /// Words for it.
        why: &'static str,
    },
    /// It refused an order.
    #[error("error {number}: {why}")]
    Refused {
        /// Its number; 0 when the order was not even sent.
        number: u16,
        /// In words.
        why: Cow<'static, str>,
    },
    /// The line was gone, and nobody knows how far the controller has come with what was sent; it knows its place.
    #[error("the line was gone for a while, and {why}")]
    Gap {
        /// The reason why the work cannot go on.
        why: &'static str,
    },
    /// The controller restarted during work: its place may be wrong.
    #[error("it was reset while it was at work")]
    Restarted,
}
