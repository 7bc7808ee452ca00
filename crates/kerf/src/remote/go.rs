//! A machine that a running server moves by hand.

use super::{Ended, Remote, number_of_run};
use anyhow::Result;
use kerf_wire::ByHand;
use serde_json::json;

/// What to do where a page has the machine.
const BESIDE: &str = "the machine was not moved: a page has it (Give up control), or move it there";

impl Remote {
    /// Moves the machine as whoever drives it, after arming it where that is wanted, and waits for the end.
    pub fn go(&self, way: &ByHand, arm: bool) -> Result<Ended> {
        self.driving(BESIDE, |lease, before| {
            if arm {
                self.act("arm", json!({ "lease": lease }))?;
            }
            self.act("go", json!({ "lease": lease, "way": way }))?;
            self.until_over(number_of_run(before))
        })
    }
}
