//! Wrong tries to get in, and how long whoever made them waits: one guesses, the others are not held up.

use std::collections::BTreeMap;
use std::time::Duration;

/// The wait after the first wrong try; each further one doubles it.
const FIRST: Duration = Duration::from_secs(1);
/// The longest wait.
const LONGEST: Duration = Duration::from_secs(256);
/// After so long without a try nothing is held against anybody.
const FORGOTTEN: Duration = Duration::from_secs(3600);
/// The most origins that are known; the one that was quiet longest is forgotten for the next.
const MOST: usize = 1000;

/// Wrong tries, by who made them.
#[derive(Debug)]
pub struct Tries<K> {
    wrong: BTreeMap<K, Wrong>,
}

#[derive(Clone, Copy, Debug)]
struct Wrong {
    count: u32,
    last: Duration,
}

impl Wrong {
    fn wait(self) -> Duration {
        let doubled = FIRST.saturating_mul(2_u32.saturating_pow(self.count.saturating_sub(1)));
        doubled.min(LONGEST)
    }
}

impl<K> Default for Tries<K> {
    fn default() -> Self {
        Self { wrong: BTreeMap::new() }
    }
}

impl<K: Ord + Clone> Tries<K> {
    /// Seconds that somebody waits before the next try counts, rounded up; nothing when it counts now.
    pub fn wait_s(&self, who: &K, now: Duration) -> Option<u64> {
        let wrong = self.wrong.get(who)?;
        let left = (wrong.last + wrong.wait()).checked_sub(now)?;
        (!left.is_zero()).then(|| left.as_secs_f64().ceil() as u64)
    }

    /// A try was wrong; tells how many have been.
    pub fn wrong(&mut self, who: &K, now: Duration) -> u32 {
        self.wrong.retain(|_, wrong| now.saturating_sub(wrong.last) < FORGOTTEN);
        let count = self.wrong.get(who).map_or(1, |wrong| wrong.count.saturating_add(1));
        self.wrong.insert(who.clone(), Wrong { count, last: now });
        if self.wrong.len() > MOST {
            let quiet = self.wrong.iter().min_by_key(|(_, wrong)| wrong.last);
            let quiet = quiet.map(|(who, _)| who.clone());
            quiet.map(|who| self.wrong.remove(&who));
        }
        count
    }

    /// A try was right: nothing is held against whoever made it.
    pub fn right(&mut self, who: &K) {
        self.wrong.remove(who);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_wrong_try_doubles_the_wait_of_whoever_made_it() {
        let (mut tries, begin) = (Tries::<&str>::default(), Duration::ZERO);
        assert_eq!(tries.wait_s(&"a", begin), None);
        let mut now = begin;
        for (count, wait) in [(1, 1), (2, 2), (3, 4), (4, 8), (5, 16)] {
            assert_eq!(tries.wrong(&"a", now), count);
            assert_eq!(tries.wait_s(&"a", now), Some(wait));
            assert_eq!(tries.wait_s(&"b", now), None, "others do not wait");
            now += Duration::from_secs(wait);
            assert_eq!(tries.wait_s(&"a", now), None);
        }
        let count = (0..40).map(|_| tries.wrong(&"a", now)).last();
        assert_eq!((count, tries.wait_s(&"a", now)), (Some(45), Some(256)), "not for ever");
        tries.right(&"a");
        assert_eq!(tries.wait_s(&"a", now), None);
    }

    #[test]
    fn what_is_known_of_wrong_tries_is_bounded() {
        let (mut tries, now) = (Tries::<usize>::default(), Duration::ZERO);
        for n in 0..2 * MOST {
            assert_eq!(tries.wrong(&n, now + Duration::from_millis(n as u64)), 1);
        }
        assert_eq!(tries.wrong.len(), MOST);
        tries.wrong(&0, now + FORGOTTEN + Duration::from_secs(10));
        assert_eq!(tries.wrong.len(), 1, "an hour later nobody remembers");
    }
}
