//! Presses that come on two ways and count once.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

/// Number of requests within which the same press is recognised.
const KNOWN: usize = 64;

/// The requests of a page that only stopped, whichever way they came. A page counts its requests.
#[derive(Clone, Debug)]
pub struct Presses(Arc<[AtomicU32; KNOWN]>);

impl Default for Presses {
    fn default() -> Self {
        Self(Arc::new([const { AtomicU32::new(0) }; KNOWN]))
    }
}

impl Presses {
    /// Returns `true` if a press has not come on the other way before. One without a number always counts.
    pub fn is_new(&self, id: u32) -> bool {
        id == 0 || self.0[id as usize % KNOWN].swap(id, Ordering::SeqCst) != id
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_press_on_both_ways_counts_once() {
        let presses = Presses::default();
        let other = presses.clone();
        assert!(presses.is_new(4));
        assert!(!other.is_new(4), "the same on the other way");
        assert!(other.is_new(5));
        assert!(other.is_new(3), "an older one that came on no way yet");
        assert!(other.is_new(0) && other.is_new(0), "nobody counted it");
    }
}
