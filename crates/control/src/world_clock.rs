//! Machine time by the clock of the world.

use std::time::{Duration, Instant};

/// Between two looks the clock of the world goes on by more than this only where the computer slept, or its clock was
/// put: machine time has waited with it. Looks are 15 ms apart; a busy computer may be late by some tenths of a second.
const LEAP: Duration = Duration::from_secs(1);

/// Machine time that lags behind the world by more than this, seconds, goes on from where it is.
const BEHIND_S: f64 = 0.1;

/// Machine time by the clock of the world, which is looked at often. A clock that leaps forward or goes back moves
/// nothing.
#[derive(Clone, Copy, Debug)]
pub struct WorldClock {
    /// Seconds of machine time in a second; 1 for a real machine.
    rate: f64,
    /// The last look, and machine time then.
    seen: Option<(Instant, f64)>,
}

impl WorldClock {
    /// Makes a clock that starts at its first reading.
    pub const fn new(rate: f64) -> Self {
        Self { rate, seen: None }
    }

    /// Begins anew with the next look.
    pub const fn begin_anew(&mut self) {
        self.seen = None;
    }

    /// Machine time at a moment of the world; `from_s` where it begins.
    pub fn at(&mut self, moment: Instant, from_s: f64) -> f64 {
        let (last, last_s) = self.seen.unwrap_or((moment, from_s));
        let passed = moment.saturating_duration_since(last);
        let passed = if passed > LEAP { Duration::ZERO } else { passed };
        let now_s = last_s + passed.as_secs_f64() * self.rate;
        self.seen = Some((moment, now_s));
        now_s
    }

    /// Lets time pass from one moment of machine time towards another, with one nap of at most so long; returns the moment
    /// that is reached. Where machine time lags behind by more than 0.1 s it does not catch up.
    pub fn pass(
        &mut self,
        from_s: f64,
        until_s: f64,
        most: Duration,
        nap: impl FnOnce(Duration),
    ) -> f64 {
        if self.now(from_s) > from_s + BEHIND_S * self.rate {
            self.begin_anew();
        }
        let left_s = (until_s - self.now(from_s)) / self.rate;
        if left_s > 0.0 {
            nap(most.min(Duration::from_secs_f64(left_s.min(1.0))));
        }
        self.now(from_s).clamp(from_s, until_s)
    }

    /// Machine time now.
    pub fn now(&mut self, from_s: f64) -> f64 {
        self.at(Instant::now(), from_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Looks at moments so many seconds after one, and gives machine times.
    fn times(rate: f64, looks: &[f64]) -> Vec<f64> {
        // Far enough from the beginning of the clock to go back from it.
        let begin = Instant::now() + Duration::from_secs(100_000);
        let mut clock = WorldClock::new(rate);
        let moment = |s: f64| match s < 0.0 {
            true => begin - Duration::from_secs_f64(-s),
            false => begin + Duration::from_secs_f64(s),
        };
        looks.iter().map(|s| (clock.at(moment(*s), 7.0) * 1000.0).round() / 1000.0).collect()
    }

    #[test]
    fn machine_time_follows_the_world() {
        assert_eq!(times(1.0, &[0.0, 0.5, 0.9, 1.9]), [7.0, 7.5, 7.9, 8.9]);
        assert_eq!(times(10.0, &[0.0, 0.5, 1.0]), [7.0, 12.0, 17.0]);
    }

    #[test]
    fn a_clock_that_leaps_by_hours_moves_nothing() {
        // Six hours ahead: the computer slept, or its clock was put.
        assert_eq!(times(1.0, &[0.0, 0.5, 21_600.0, 21_600.5]), [7.0, 7.5, 7.5, 8.0]);
        // Six hours back, and it goes on from there.
        assert_eq!(times(1.0, &[0.0, 0.5, -21_600.0, -21_599.5]), [7.0, 7.5, 7.5, 8.0]);
        // A clock that stands still while the computer sleeps.
        assert_eq!(times(1.0, &[0.0, 0.5, 0.5, 0.5, 1.0]), [7.0, 7.5, 7.5, 7.5, 8.0]);
    }
}
