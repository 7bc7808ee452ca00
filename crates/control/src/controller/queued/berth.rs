//! The place where a board lies: requests go there, answers and time come from there.

use kerf_driver_klipper::mailbox::{Answer, Progress, Request};
use std::time::Duration;

/// A board that something else feeds with bytes.
pub trait Berth {
    /// Hands a request over.
    fn request(&mut self, request: Request);

    /// Lets time pass, at most so long and less where something is heard; tells how far the board is and what it answered.
    fn look(&mut self, wait: Duration) -> (Progress, Vec<Answer>);
}
