//! A host, a line and a fake board, in simulated time.

use kerf_driver_klipper::board::{Board, Ended, Fault, Home, News, Options, Start};
use kerf_driver_klipper::fake::{Faults, Wired};
use kerf_driver_klipper::queue::{Change, Piece, Step};
use kerf_driver_klipper::setup::{Motor, Pin, Setup, Switched};
use std::ops::{Deref, DerefMut};

/// Grain of virtual time while something may happen, seconds.
pub const GRAIN_S: f64 = 0.001;
/// Length of a piece of motion, seconds.
pub const PIECE_S: f64 = 0.05;

pub struct World {
    wired: Wired,
    pub host: Board,
    pub now_s: f64,
    pub news: Vec<News>,
    /// The host is dead or stalls up to a moment.
    pub stalls_until_s: f64,
    /// Time before its beginning at which the planner offers a piece, seconds.
    pub ahead_s: f64,
}

pub fn motor(n: usize) -> Motor {
    Motor {
        step: Pin::new(&format!("gpio{}", 2 * n)),
        dir: Pin::new(&format!("gpio{}", 2 * n + 1)),
        pulse_s: 1e-7,
        turn_s: 20e-6,
        both_edges: true,
        least_s: 4e-6,
    }
}

/// Three motors, two switches on gpio10 and gpio11, an output on gpio20 with a watch.
pub fn setup() -> Setup {
    Setup {
        motors: (0..3).map(motor).collect(),
        switches: vec![Pin::new("gpio10"), Pin::new("gpio11")],
        outputs: vec![Switched { pin: Pin::new("gpio20"), watch_s: Some(0.4) }],
        ..Setup::default()
    }
}

impl Deref for World {
    type Target = Wired;

    fn deref(&self) -> &Wired {
        &self.wired
    }
}

impl DerefMut for World {
    fn deref_mut(&mut self) -> &mut Wired {
        &mut self.wired
    }
}

impl World {
    pub fn new(seed: u64, faults: Faults, setup: Setup, options: Options) -> Self {
        let (wired, host) = (Wired::new(seed, faults), Board::new(setup, options, 0.0));
        Self { wired, host, now_s: 0.0, news: Vec::new(), stalls_until_s: 0.0, ahead_s: 0.5 }
    }

    /// One that is ready to move.
    pub fn ready(seed: u64, faults: Faults) -> Self {
        let mut world = Self::new(seed, faults, setup(), Options::default());
        world.wait(|news| matches!(news, News::Ready { .. }));
        world
    }

    /// Lets a grain of time go by.
    pub fn pass(&mut self) {
        self.now_s += GRAIN_S;
        let (now_s, host) = (self.now_s, &mut self.host);
        self.wired.pass(now_s, now_s < self.stalls_until_s, |heard| {
            host.receive(heard, now_s);
            host.transmit(now_s).bytes
        });
        while let Some(news) = self.host.news() {
            self.news.push(news);
        }
    }

    pub fn pass_for(&mut self, time_s: f64) {
        let until_s = self.now_s + time_s;
        while self.now_s < until_s {
            self.pass();
        }
    }

    /// Waits for news, and returns them.
    pub fn wait(&mut self, found: impl Fn(&News) -> bool) -> News {
        for _ in 0..60_000 {
            if let Some(at) = self.news.iter().position(&found) {
                return self.news.drain(..=at).next_back().unwrap();
            }
            self.pass();
        }
        panic!("no such news after {} s; {:?}", self.now_s, self.news);
    }

    pub fn wait_end(&mut self) -> (Ended, Vec<i64>) {
        match self.wait(|news| matches!(news, News::Ended { .. } | News::Fault(_))) {
            News::Ended { why, counts } => (why, counts),
            other => panic!("{other:?}"),
        }
    }

    pub fn wait_fault(&mut self) -> Fault {
        match self.wait(|news| matches!(news, News::Fault(_))) {
            News::Fault(fault) => fault,
            other => panic!("{other:?}"),
        }
    }

    /// Makes a whole motion, feeding pieces as a planner does, or until it ends. Returns the end and its counts.
    pub fn make(&mut self, motion: &Motion, homes: &[Home]) -> (Ended, Vec<i64>) {
        let mut feed = self.begin(motion, homes);
        while self.feed(motion, &mut feed) {
            self.pass();
            if self
                .news
                .iter()
                .any(|news| matches!(news, News::Ended { .. } | News::Fault(_) | News::Shutdown(_)))
            {
                break;
            }
        }
        self.wait_end()
    }

    pub fn begin(&mut self, motion: &Motion, homes: &[Home]) -> Feed {
        let start = self.host.start(homes, self.now_s).expect("a board at rest");
        let zero = motion.places(0.0).iter().map(|p| p.round() as i64).collect();
        Feed { start, next: 0, made: zero, planned: vec![Vec::new(); motion.places.len()] }
    }

    /// Feeds a motion in which the host, planner and all, stalls once, some seconds after the call.
    pub fn stalls_at(&mut self, after_s: f64, stall_s: f64, motion: &Motion, feed: &mut Feed) {
        let since_s = self.now_s + after_s;
        while self.now_s < since_s && self.feed(motion, feed) {
            self.pass();
        }
        self.stalls_until_s = self.now_s + stall_s;
        self.pass_for(stall_s);
        while self.feed(motion, feed) {
            self.pass();
        }
    }

    /// Offers the next piece when its time comes; false once all are offered.
    pub fn feed(&mut self, motion: &Motion, feed: &mut Feed) -> bool {
        let many = (motion.lasts_s / PIECE_S).ceil() as usize;
        let Some((clock, _)) = self.host.clock(self.now_s) else { return true };
        while feed.next < many {
            let from_s = feed.next as f64 * PIECE_S;
            let due = feed.start.clock as f64 + (from_s - self.ahead_s) * feed.start.ticks_per_s;
            if due > clock as f64 {
                return true;
            }
            let last = feed.next + 1 == many;
            let piece = motion.piece(feed, from_s, (from_s + PIECE_S).min(motion.lasts_s), last);
            if self.host.offer(&piece).is_err() {
                return false;
            }
            feed.next += 1;
        }
        false
    }
}

/// The way through a motion.
pub struct Feed {
    pub start: Start,
    pub next: usize,
    made: Vec<i64>,
    /// Steps of each motor as they were planned.
    pub planned: Vec<Vec<Step>>,
}

/// Places of motors, steps, over time.
pub struct Motion {
    pub places: Vec<Box<dyn Fn(f64) -> f64>>,
    pub lasts_s: f64,
    /// Times at which the output goes on and off.
    pub switches_s: Vec<(f64, u32)>,
}

impl Motion {
    /// Motors that go there and back, each at a pace of its own; steps.
    pub fn waves(steps: f64, lasts_s: f64) -> Self {
        let wave = |turns: f64| -> Box<dyn Fn(f64) -> f64> {
            Box::new(move |t: f64| {
                let s = (t / lasts_s).clamp(0.0, 1.0);
                let s = s * s * s * (10.0 + s * (6.0 * s - 15.0));
                steps * (s * turns * std::f64::consts::PI).sin()
            })
        };
        Self { places: vec![wave(2.0), wave(3.5), wave(0.5)], lasts_s, switches_s: Vec::new() }
    }

    /// The first motor goes straight to a place, steps.
    pub fn straight(steps: f64, lasts_s: f64) -> Self {
        let place = move |t: f64| {
            let s = (t / lasts_s).clamp(0.0, 1.0);
            steps * s * s * s * (10.0 + s * (6.0 * s - 15.0))
        };
        let rest = || -> Box<dyn Fn(f64) -> f64> { Box::new(|_| 0.0) };
        Self { places: vec![Box::new(place), rest(), rest()], lasts_s, switches_s: Vec::new() }
    }

    fn places(&self, t_s: f64) -> Vec<f64> {
        self.places.iter().map(|place| place(t_s)).collect()
    }

    fn piece(&self, feed: &mut Feed, from_s: f64, to_s: f64, last: bool) -> Piece {
        let clock = |t: f64| feed.start.clock as f64 + t * feed.start.ticks_per_s;
        let mut made = feed.made.clone();
        let steps: Vec<Vec<Step>> = self
            .places
            .iter()
            .zip(&mut made)
            .map(|(place, made)| stepped(made, from_s, to_s, place, clock))
            .collect();
        let mut behind = made.clone();
        // Slowing down on the path: it goes on for half of the time that it takes.
        let slow_s = 0.08;
        let slow = |t: f64| {
            let u = t - to_s;
            to_s + u - u * u / (2.0 * slow_s)
        };
        let tail: Vec<Vec<Step>> = if last {
            Vec::new()
        } else {
            self.places
                .iter()
                .zip(&mut behind)
                .map(|(place, made)| stepped(made, to_s, to_s + slow_s, &|t| place(slow(t)), clock))
                .collect()
        };
        let change = |(t_s, value): &(f64, u32)| Change {
            output: 0,
            clock: clock(*t_s) as u64,
            value: *value,
        };
        let changes = self
            .switches_s
            .iter()
            .filter(|(t_s, _)| (from_s..to_s).contains(t_s))
            .map(change)
            .collect();
        let ends = clock(to_s).ceil() as u64;
        let rests = clock(to_s + slow_s).ceil() as u64;
        feed.made = made;
        feed.planned.iter_mut().zip(&steps).for_each(|(all, new)| all.extend(new));
        Piece { steps, changes, ends, tail, rests, ..Piece::default() }
    }
}

/// Steps of a motor that has made some, from one time to another.
fn stepped(
    made: &mut i64,
    from_s: f64,
    to_s: f64,
    place: &dyn Fn(f64) -> f64,
    clock: impl Fn(f64) -> f64,
) -> Vec<Step> {
    let (mut found, mut since_s) = (Vec::new(), from_s);
    let many = ((to_s - from_s) / 0.000_25).ceil() as usize;
    for n in 1..=many {
        let until_s = if n == many { to_s } else { from_s + n as f64 * 0.000_25 };
        loop {
            let (at, half) = (place(until_s), *made as f64);
            let forward = at > half + 0.5;
            if !forward && at >= half - 0.5 {
                break;
            }
            let half = if forward { half + 0.5 } else { half - 0.5 };
            let (mut low, mut high) = (since_s, until_s);
            for _ in 0..18 {
                let middle = 0.5 * (low + high);
                if (place(middle) > half) == forward { high = middle } else { low = middle }
            }
            *made += if forward { 1 } else { -1 };
            found.push(Step { clock: clock(high), forward, count: 1 });
            since_s = high;
        }
        since_s = until_s;
    }
    found
}
