//! The hand of a page at a key that moves the tool for as long as it is held.
//!
//! A page stamps every sign of its hand with the server's clock, as it reckons it from its pings. A sign is as old
//! as its stamp says: one that a link has kept back does not count as fresh. A stamp is believed within bounds: a
//! page whose clock is ahead is set back by as much as it was ever seen to be.

use std::time::Duration;

/// A page whose clock is ahead by more than this is not believed, ms. Half of the difference between the two ways
/// of a link is taken for such a lead.
const MOST_AHEAD_MS: f64 = 100.0;

/// Numbers of jogs grow by at most so much at once: none uses them up.
const STEP: u64 = 1_000_000;

/// A sign of a hand: which jog it holds, and when it did so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// Number of the jog.
    pub seq: u64,
    /// Moment when the key was held for sure, by the server's clock.
    pub at: Duration,
}

/// Reason why a sign of a hand does not count.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum GripError {
    /// Its jog has ended, or a later one has begun.
    #[error("this jog is over already")]
    Over,
    /// Its number is out of reach.
    #[error(
        "the number of a jog is above the one before, by {STEP} at most: count the jogs of a page"
    )]
    Far,
    /// Its page reckons a time that is still to come.
    #[error(
        "the page's clock is ahead of the machine's by {0:.0} ms: let it measure the link by pings, and stamp with \
         the clock that they are answered with"
    )]
    Ahead(f64),
}

/// The hand of a page, as far as the server knows it.
#[derive(Debug, Default)]
pub struct Hand {
    /// The jog with the greatest number that began or ended.
    jog: u64,
    /// The newest sign of it.
    newest: Option<Grip>,
    /// Greatest lead of the page's clock so far, ms.
    ahead_ms: f64,
}

impl Hand {
    /// Returns the age of what a page stamped; stamp and present time are in ms.
    ///
    /// # Errors
    /// It is of a time to come.
    pub fn age(&mut self, clock_ms: f64, now_ms: f64) -> Result<Duration, GripError> {
        let age_ms = now_ms - clock_ms;
        if !age_ms.is_finite() || age_ms < -MOST_AHEAD_MS {
            return Err(GripError::Ahead(-age_ms));
        }
        self.ahead_ms = self.ahead_ms.max(-age_ms);
        Ok(Duration::from_secs_f64((age_ms + self.ahead_ms) / 1e3))
    }

    /// A jog begins; gives the newest sign that it is held, which may have come while it waited.
    ///
    /// # Errors
    /// One that began or ended before has that number or a greater one, or it is out of reach.
    pub fn begins(&mut self, grip: Grip) -> Result<Grip, GripError> {
        if grip.seq > self.jog.saturating_add(STEP) {
            return Err(GripError::Far);
        }
        if grip.seq <= self.jog {
            return Err(GripError::Over);
        }
        self.jog = grip.seq;
        let newest = self.newest.filter(|newest| newest.seq == grip.seq && newest.at > grip.at);
        Ok(newest.unwrap_or(grip))
    }

    /// A key is still held.
    pub fn holds(&mut self, grip: Grip) {
        if self.newest.is_none_or(|newest| newest.seq != grip.seq || newest.at < grip.at) {
            self.newest = Some(grip);
        }
    }

    /// A jog is over: its start, should it still come, is too late.
    pub fn ends(&mut self, seq: u64) {
        if seq <= self.jog.saturating_add(STEP) {
            self.jog = self.jog.max(seq);
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Stamps of a page and the moments when they came, ms; and how old the last one is taken for.
    #[track_caller]
    fn check(came: &[(f64, f64)], expected: Result<u64, GripError>) {
        let mut hand = Hand::default();
        let ages = came.iter().map(|(stamp, now)| hand.age(*stamp, *now));
        let last = ages.last().unwrap();
        assert_eq!(last.map(|age| age.as_secs_f64().mul_add(1e3, 0.5) as u64), expected);
    }

    #[test]
    fn a_sign_is_as_old_as_its_stamp_says() {
        check(&[(1000.0, 1060.0)], Ok(60));
        check(&[(1000.0, 1060.0), (1050.0, 1900.0)], Ok(850));
    }

    #[test]
    fn a_clock_that_is_ahead_is_set_back() {
        check(&[(1040.0, 1000.0)], Ok(0));
        check(&[(1040.0, 1000.0), (1090.0, 1300.0)], Ok(250));
        check(&[(1040.0, 1000.0), (1080.0, 1060.0), (1090.0, 1300.0)], Ok(250));
    }

    #[test]
    fn a_clock_that_is_far_ahead_is_not_believed() {
        check(&[(1400.0, 1000.0)], Err(GripError::Ahead(400.0)));
        let mut hand = Hand::default();
        for stamp in [f64::INFINITY, f64::NAN, f64::NEG_INFINITY] {
            assert!(hand.age(stamp, 1.0).is_err(), "{stamp}");
        }
    }

    fn grip(seq: u64) -> Grip {
        Grip { seq, at: Duration::from_secs(5) }
    }

    #[test]
    fn numbers_grow_and_none_uses_them_up() {
        let mut hand = Hand::default();
        let begins = |hand: &mut Hand, seq| hand.begins(grip(seq)).map(|grip| grip.seq);
        assert_eq!(begins(&mut hand, 1), Ok(1));
        assert_eq!(begins(&mut hand, 1), Err(GripError::Over), "twice");
        hand.ends(2);
        assert_eq!(begins(&mut hand, 2), Err(GripError::Over), "after its own stop");
        assert_eq!(begins(&mut hand, u64::MAX), Err(GripError::Far));
        hand.ends(u64::MAX);
        assert_eq!(begins(&mut hand, 3), Ok(3), "whatever came before");
        assert_eq!(begins(&mut hand, 3 + STEP), Ok(3 + STEP));
    }

    #[test]
    fn a_jog_that_waited_is_held_since_its_newest_sign() {
        let mut hand = Hand::default();
        let (pressed, later) = (grip(4), Duration::from_millis(300));
        let renewed = Grip { seq: 4, at: pressed.at + later };
        hand.holds(renewed);
        hand.holds(pressed);
        assert_eq!(hand.begins(pressed), Ok(renewed));
        let next = Grip { seq: 5, at: pressed.at };
        assert_eq!(hand.begins(next), Ok(next), "a sign of another jog is none of this one");
    }
}
