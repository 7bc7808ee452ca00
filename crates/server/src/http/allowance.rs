//! Limit on what a socket may ask: so many messages a second, and a number at once before that.

use tokio::time::{Duration, Instant, sleep_until};

/// Messages that may wait to be asked.
#[derive(Debug)]
pub struct Allowance {
    each: Duration,
    at_once: u32,
    /// Moment when everything that was asked so far is paid for.
    paid: Instant,
}

impl Allowance {
    /// Makes an allowance of so many requests a second, and so many at once.
    pub fn of(a_second: u32, at_once: u32) -> Self {
        Self { each: Duration::from_secs(1) / a_second, at_once, paid: Instant::now() }
    }

    /// Takes one request from the allowance, and waits where there were too many.
    pub async fn take(&mut self) {
        sleep_until(self.due(Instant::now())).await;
    }

    /// One more at a moment: when it may be.
    fn due(&mut self, now: Instant) -> Instant {
        self.paid = self.paid.max(now) + self.each;
        now.max(self.paid - self.each * self.at_once)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn so_many_at_once_and_then_so_many_a_second() {
        let mut allowance = Allowance::of(10, 5);
        let now = Instant::now();
        let waits: Vec<u128> = (0..8).map(|_| (allowance.due(now) - now).as_millis()).collect();
        assert_eq!(waits, [0, 0, 0, 0, 0, 100, 200, 300]);
        let later = now + Duration::from_secs(60);
        assert_eq!(allowance.due(later), later, "who waits may ask again");
    }
}
