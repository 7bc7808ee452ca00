//! The board's clock, as far as the host can know it.
//!
//! A board counts ticks of its own crystal in 32 bits. Each answer to `get_clock` says that its clock had a value
//! some time between sending and receiving: a box that the true line passes through. The estimate is the line of
//! least squares through the middles of narrow boxes; it serves to tell the time in the board now, never to change
//! what was planned in ticks.
//!
//! ```text
//!  clock │                     ┌──╱┐
//!        │           ┌──╱┐     └─╱─┘   box: sent … received
//!        │   ┌──╱┐   └─╱─┘
//!        │   └─╱─┘
//!        └────────────────────────────► host's seconds
//! ```

use std::collections::VecDeque;

/// Exchanges that are kept.
const KEPT: usize = 60;
/// Round trips longer than the shortest one by more than this are left out, seconds.
const LONGER_S: f64 = 0.000_1;
/// Least number of exchanges that a line is drawn through.
const FEW: usize = 8;
/// Farthest that a crystal is off, as a share.
const CRYSTAL: f64 = 200e-6;
/// Farthest that any clock is off; taken until a crystal's line is long enough.
const ANY: f64 = 0.02;
/// Length of a line from which it shows a crystal, seconds.
const LONG_S: f64 = 10.0;
/// Time between the first exchanges, seconds, and between later ones: a time that beats with no other period.
const PACES_S: [f64; 2] = [0.05, 0.4919];
/// Distance from its box at which an answer is not believed, seconds.
const FAR_S: f64 = 0.002;
/// Answers in a row that are not believed before the line is drawn anew.
const STRAYS: u32 = 3;
/// Questions in a row without an answer of use after which the time in the board will not be known: 10 s.
const VAIN: u32 = 200;

/// A question for the clock and its answer.
#[derive(Clone, Copy, Debug)]
struct Exchange {
    sent_s: f64,
    received_s: f64,
    clock: u64,
}

impl Exchange {
    fn trip_s(&self) -> f64 {
        self.received_s - self.sent_s
    }

    fn middle_s(&self) -> f64 {
        0.5 * (self.sent_s + self.received_s)
    }
}

/// The clock of one board.
#[derive(Clone, Debug)]
pub struct Clock {
    /// Ticks a second as the board tells them.
    nominal: f64,
    /// Newest value that was told, without end.
    newest: u64,
    exchanges: VecDeque<Exchange>,
    strays: u32,
    /// Questions since the last answer that was of use.
    unheard: u32,
    /// Enough was heard once: a line that is drawn anew keeps its slope until it is long enough again.
    known: bool,
    /// Ticks a second as measured.
    rate: f64,
    /// A moment, and the clock then.
    anchor: (f64, f64),
    /// Half of the narrowest box, seconds.
    half_s: f64,
    /// Moment of the last question, and of the next.
    asked_s: f64,
    ask_s: f64,
}

impl Clock {
    /// A board with so many ticks a second, whose clock had a value, without end, when it answered at a moment.
    pub fn new(nominal: f64, uptime: u64, now_s: f64) -> Self {
        let anchor = (now_s, uptime as f64);
        let (exchanges, rate) = (VecDeque::new(), nominal);
        Self {
            nominal,
            newest: uptime,
            exchanges,
            strays: 0,
            unheard: 0,
            known: false,
            rate,
            anchor,
            half_s: 1.0,
            asked_s: f64::NEG_INFINITY,
            ask_s: now_s,
        }
    }

    /// Returns `true` once in a while: the clock is to be asked for now.
    pub fn asks(&mut self, now_s: f64) -> bool {
        let due = now_s >= self.ask_s;
        if due {
            self.unheard = self.unheard.saturating_add(1);
            self.asked_s = now_s;
            self.ask_s = now_s + PACES_S[usize::from(self.exchanges.len() >= FEW)];
        }
        due
    }

    /// The next question comes as soon as the last one has had time for its answer.
    pub fn hurry(&mut self) {
        self.ask_s = self.ask_s.min(self.asked_s + PACES_S[0]);
    }

    /// Newest value that the board told: its clock is at least there, whatever the estimate says.
    pub const fn newest(&self) -> u64 {
        self.newest
    }

    /// Reads an answer whose question went out at an unknown moment: it tells how far the clock is at least.
    pub fn told(&mut self, clock: u32) {
        self.newest = self.newest.max(self.unwrapped(clock));
    }

    /// Moment of the next question.
    pub const fn due_s(&self) -> f64 {
        self.ask_s
    }

    /// Enough was heard to tell the time in the board.
    pub const fn is_known(&self) -> bool {
        self.known
    }

    /// It was asked for so often without an answer of use that it will not be known.
    pub const fn is_vain(&self) -> bool {
        !self.known && self.unheard > VAIN
    }

    /// Returns a clock of 32 bits without end: the one nearest to the newest that was told.
    pub fn unwrapped(&self, clock: u32) -> u64 {
        let later = clock.wrapping_sub(self.newest as u32) as i32;
        self.newest.wrapping_add_signed(i64::from(later))
    }

    /// Reads an answer to a question that went out once.
    pub fn heard(&mut self, sent_s: f64, received_s: f64, clock: u32) {
        self.unheard = 0;
        let clock = self.unwrapped(clock);
        self.newest = self.newest.max(clock);
        let exchange = Exchange { sent_s, received_s, clock };
        if self.is_known() && self.is_stray(&exchange) {
            self.strays += 1;
            if self.strays < STRAYS {
                return;
            }
            self.exchanges.clear();
        }
        self.strays = 0;
        self.exchanges.push_back(exchange);
        if self.exchanges.len() > KEPT {
            self.exchanges.pop_front();
        }
        self.fit();
    }

    /// Clock of the board at a moment.
    pub fn at(&self, t_s: f64) -> f64 {
        self.anchor.1 + (t_s - self.anchor.0) * self.rate
    }

    /// Moment at which the board's clock has a value.
    pub fn moment_s(&self, clock: f64) -> f64 {
        self.anchor.0 + (clock - self.anchor.1) / self.rate
    }

    /// Ticks a second, as measured.
    pub const fn rate(&self) -> f64 {
        self.rate
    }

    /// Farthest that [`at`](Self::at) is off near the newest answer, seconds.
    pub const fn off_s(&self) -> f64 {
        self.half_s
    }

    fn is_stray(&self, exchange: &Exchange) -> bool {
        let moment_s = self.moment_s(exchange.clock as f64);
        moment_s < exchange.sent_s - FAR_S || moment_s > exchange.received_s + FAR_S
    }

    fn fit(&mut self) {
        let shortest_s = self.exchanges.iter().map(Exchange::trip_s).fold(f64::INFINITY, f64::min);
        let narrow = |e: &&Exchange| e.trip_s() <= shortest_s + LONGER_S;
        let kept: Vec<Exchange> = self.exchanges.iter().filter(narrow).copied().collect();
        let (Some(first), Some(last)) = (kept.first(), kept.last()) else { return };
        let count = kept.len() as f64;
        let (from_s, from) = (first.middle_s(), first.clock);
        let points = kept.iter().map(|e| (e.middle_s() - from_s, e.clock as f64 - from as f64));
        let (sum_t, sum_c) = points.clone().fold((0.0, 0.0), |(t, c), p| (t + p.0, c + p.1));
        let (mean_t, mean_c) = (sum_t / count, sum_c / count);
        let spread: f64 = points.clone().map(|(t, _)| (t - mean_t).powi(2)).sum();
        let both: f64 = points.map(|(t, c)| (t - mean_t) * (c - mean_c)).sum();
        let off = if last.middle_s() - from_s > LONG_S { CRYSTAL } else { ANY };
        if self.exchanges.len() >= FEW || !self.known {
            let rate = if spread > 0.0 { both / spread } else { self.nominal };
            self.rate = rate.clamp(self.nominal * (1.0 - off), self.nominal * (1.0 + off));
        }
        self.known |= self.exchanges.len() >= FEW;
        self.anchor = (from_s + mean_t, from as f64 + mean_c);
        self.half_s = 0.5 * shortest_s + LONGER_S;
    }
}
