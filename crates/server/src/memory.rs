//! The server's memory and its budget: above it, long work of paired devices is refused with words.

use crate::hub::Hub;
use kerf_wire::Tone;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Weak};
use std::time::Duration;

/// Memory in use from which on long work is refused, bytes.
const TIGHT: u64 = 400 << 20;
/// Time between two looks.
const LOOK: Duration = Duration::from_millis(250);

/// Answer where work is refused.
pub const REFUSED: &str =
    "the server's memory is used up by what it does: ask again when that is done";

/// State of the memory: tight or not.
#[derive(Clone, Debug, Default)]
pub struct Memory(Arc<AtomicBool>);

impl Memory {
    /// Returns `true` while long work is refused.
    pub fn is_tight(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Looks again and again, as long as there is somebody to tell.
    pub async fn watch(self, hub: Weak<Hub>) {
        loop {
            tokio::time::sleep(LOOK).await;
            let Some(hub) = hub.upgrade() else { return };
            self.look(used(), &hub);
        }
    }

    fn look(&self, used: u64, hub: &Hub) {
        let tight = used > TIGHT;
        if self.0.swap(tight, Ordering::Relaxed) != tight {
            let text = if tight {
                "the server's memory is used up: long work of other devices is refused for now"
            } else {
                "the server has memory again"
            };
            hub.say(if tight { Tone::Warning } else { Tone::Note }, text);
        }
    }
}

/// Memory that this process has in use, bytes; 0 where the system does not tell.
fn used() -> u64 {
    let told = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = told.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kib = line.and_then(|text| text.trim().split(' ').next()?.parse::<u64>().ok());
    kib.unwrap_or(0) * 1024
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_wire::Snapshot;

    #[test]
    fn a_budget_that_is_reached_is_told_once_and_again_when_it_is_not() {
        let (hub, memory) = (Hub::new(Snapshot::default()), Memory::default());
        for (used, tight, told) in
            [(0, false, 0), (TIGHT + 1, true, 1), (TIGHT + 2, true, 1), (TIGHT, false, 2)]
        {
            memory.look(used, &hub);
            assert_eq!((memory.is_tight(), hub.read(|now| now.messages.len())), (tight, told));
        }
    }

    #[tokio::test]
    async fn memory_is_looked_at_until_nobody_is_left_to_tell() {
        let (hub, memory) = (Arc::new(Hub::new(Snapshot::default())), Memory::default());
        memory.look(TIGHT + 1, &hub);
        let watch = tokio::spawn(memory.clone().watch(Arc::downgrade(&hub)));
        while memory.is_tight() {
            tokio::time::sleep(LOOK / 10).await;
            assert!(!watch.is_finished(), "it watches on");
        }
        drop(hub);
        watch.await.expect("it ends without a hub");
    }
}
