//! A fake board, with both ways of its line, in simulated time.

use super::{Board, Faults, Line};

/// Time that a piece needs on the line, one way, seconds.
const DELAY_S: f64 = 0.0007;

#[derive(Clone, Debug)]
pub struct Wired {
    pub fake: Board,
    pub there: Line,
    pub back: Line,
}

impl Wired {
    /// A board that keeps no record of its edges.
    pub fn new(seed: u64, faults: Faults) -> Self {
        let line = |n| Line::new(seed * 2 + n, faults, DELAY_S);
        let mut fake = Board::of_seed(seed);
        fake.records = false;
        Self { fake, there: line(0), back: line(1) }
    }

    /// Lets the board's time go on to a moment. The host hears what has come and says what is to be written; one that
    /// `sleeps` does neither.
    pub fn pass(&mut self, now_s: f64, sleeps: bool, host: impl FnOnce(&[u8]) -> Vec<u8>) {
        let clock = self.fake.clock_at(now_s);
        self.fake.run_to(clock);
        let come = self.there.take(now_s);
        self.fake.feed(&come);
        let said = self.fake.take();
        self.back.put(&said, now_s);
        if !sleeps {
            let out = host(&self.back.take(now_s));
            self.there.put(&out, now_s);
        }
    }

    /// A piece needs so long there, and so long back, from now on.
    pub fn delay(&mut self, delay_s: f64) {
        (self.there.delay_s, self.back.delay_s) = (delay_s, delay_s);
    }

    /// What the line does from now on.
    pub fn spoil(&mut self, faults: Faults) {
        (self.there.faults, self.back.faults) = (faults, faults);
    }
}
