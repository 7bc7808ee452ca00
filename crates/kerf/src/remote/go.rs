//! A machine that a running server moves by hand.

use super::{Ended, Remote, number_of_run};
use anyhow::Result;
use kerf_wire::ByHand;
use serde_json::json;

/// The mend where a page drives the machine.
const BESIDE: &str = "the machine was not moved: a page drives it. Press \"Give up control\" there, or move the machine from that page";

impl Remote {
    /// Moves the machine as whoever drives it, after arming it where that is wanted, and waits for the end.
    pub fn go(&self, way: &ByHand, arm: bool) -> Result<Ended> {
        self.driving(BESIDE, arm, |lease, before| {
            self.act("go", json!({ "lease": lease, "way": way }))?;
            self.until_over(number_of_run(before))
        })
    }
}
