//! Progress of a run that tells of moves before they are made: what is on record was made for sure.

use std::collections::VecDeque;

/// Moves made, and the share of the next.
type Share = (u64, f64);

/// The shares that were told lately, and the one that is sure.
#[derive(Debug)]
pub(super) struct Lag {
    /// Longest time by which a move is reported before it is made, seconds.
    leads_s: f64,
    now_s: f64,
    sure: Share,
    /// The shares told lately, each with its moment of machine time, and the one told before them.
    told: VecDeque<(f64, Share)>,
    before: Share,
    /// The machine stood last then, seconds.
    stood_s: f64,
}

impl Lag {
    pub const fn new(leads_s: f64, sure: Share) -> Self {
        Self {
            leads_s,
            now_s: 0.0,
            sure,
            told: VecDeque::new(),
            before: sure,
            stood_s: f64::NEG_INFINITY,
        }
    }

    /// Machine time has come to a moment.
    pub fn comes_to(&mut self, now_s: f64) {
        self.now_s = now_s;
        while let Some((told_s, share)) = self.told.front().copied() {
            if told_s + self.leads_s > now_s {
                break;
            }
            self.before = share;
            if told_s > self.stood_s {
                self.sure = share;
            }
            self.told.pop_front();
        }
    }

    /// Notes how far a move is told to be made.
    pub fn tells(&mut self, share: Share) {
        self.told.push_back((self.now_s, share));
    }

    /// The machine stands: what was told is made.
    pub fn stands(&mut self, share: Share) {
        self.tells(share);
        (self.sure, self.stood_s) = (share, self.now_s);
    }

    /// Returns the share that was made at a moment that is not long past.
    pub fn made_until(&self, at_s: f64) -> Share {
        let before = self.told.iter().take_while(|(told_s, _)| *told_s <= at_s);
        before.last().map_or(self.before, |(_, share)| *share)
    }

    /// Returns the share that is made for sure.
    pub const fn sure(&self) -> Share {
        self.sure
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_told_lately_is_not_sure() {
        let mut lag = Lag::new(0.5, (3, 0.0));
        for (at_s, share) in [(0.1, (3, 0.4)), (0.2, (3, 0.8)), (0.3, (4, 0.0)), (0.4, (4, 0.5))] {
            lag.comes_to(at_s);
            lag.tells(share);
        }
        assert_eq!(
            [0.15, 0.3, 0.35].map(|at_s| lag.made_until(at_s)),
            [(3, 0.4), (4, 0.0), (4, 0.0)]
        );
        let mut sure = |at_s| {
            lag.comes_to(at_s);
            lag.sure()
        };
        assert_eq!(
            [sure(0.59), sure(0.61), sure(0.81), sure(0.85)],
            [(3, 0.0), (3, 0.4), (4, 0.0), (4, 0.0)]
        );
        lag.stands((5, 0.0));
        assert_eq!((lag.sure(), lag.made_until(0.41)), ((5, 0.0), (4, 0.5)));
        lag.comes_to(0.95);
        assert_eq!(lag.sure(), (5, 0.0), "what was told before the stand changes nothing");
    }
}
