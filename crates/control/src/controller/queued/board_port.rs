//! The port of a board as the machine of a run sees it: requests go in, answers and time come out.

use kerf_driver_klipper::mailbox::{Answer, Progress, Request};
use std::time::Duration;

/// Takes requests for a board and returns its answers; a thread or a test stands behind it.
pub trait BoardPort {
    /// Hands a request over.
    fn request(&mut self, request: Request);

    /// Lets time pass, at most so long and less where something is heard; tells how far the board is and what it answered.
    fn look(&mut self, wait: Duration) -> (Progress, Vec<Answer>);
}
