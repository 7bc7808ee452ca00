//! A driver that misbehaves: replies come late, get lost, come twice or cannot be read, and orders
//! get lost on the way. What does is drawn from a seed, so that a failure can be played again.

use crate::controller::Controller;
use kerf_machine::driver::{
    Driver, Garbled, Link, LinkNews, LinkState, Order, Reply, Sent, Signal,
};
use kerf_program::{Axes, Axis};
use kerf_sim::random::SeededRandom;

/// Rates at which things go wrong, of a hundred.
#[derive(Clone, Copy, Debug, Default)]
pub struct Faults {
    /// Orders and signals that never arrive.
    pub orders_lost: u32,
    /// Replies that never arrive.
    pub lost: u32,
    /// Replies that come twice.
    pub twice: u32,
    /// Replies that cannot be read.
    pub garbled: u32,
    /// Replies that come late.
    pub late: u32,
    /// By so much at most, seconds.
    pub late_s: f64,
}

/// A driver behind a bad line.
#[derive(Clone, Debug)]
pub struct Unreliable<D> {
    inner: D,
    faults: Faults,
    chance: SeededRandom,
    /// Replies on their way, with the time at which they arrive.
    on_the_way: Vec<(f64, Result<Reply, Garbled>)>,
}

impl<D> Unreliable<D> {
    /// A driver whose line is as bad as this.
    pub const fn new(inner: D, faults: Faults, seed: u64) -> Self {
        Self { inner, faults, chance: SeededRandom::new(seed), on_the_way: Vec::new() }
    }

    /// The driver behind the line.
    pub const fn inner(&self) -> &D {
        &self.inner
    }
}

impl<D: Driver> Driver for Unreliable<D> {
    fn send(&mut self, sent: &Sent, now_s: f64) {
        if !self.chance.in_percent(self.faults.orders_lost) {
            self.inner.send(sent, now_s);
        }
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        if !self.chance.in_percent(self.faults.orders_lost) {
            self.inner.signal(signal, now_s);
        }
    }

    fn replies(&mut self, now_s: f64) -> Vec<Result<Reply, Garbled>> {
        let faults = self.faults;
        for reply in self.inner.replies(now_s) {
            if self.chance.in_percent(faults.lost) {
                continue;
            }
            let reply = if self.chance.in_percent(faults.garbled) { Err(Garbled) } else { reply };
            let late = if self.chance.in_percent(faults.late) { self.chance.share() } else { 0.0 };
            let arrives_s = now_s + late * faults.late_s;
            if self.chance.in_percent(faults.twice) {
                self.on_the_way.push((arrives_s, reply.clone()));
            }
            self.on_the_way.push((arrives_s, reply));
        }
        let (due, rest) = self.on_the_way.drain(..).partition(|(at_s, _)| *at_s <= now_s);
        self.on_the_way = rest;
        let due: Vec<(f64, _)> = due;
        due.into_iter().map(|(_, reply)| reply).collect()
    }
}

/// A program of moves and outputs drawn from a seed.
fn program(seed: u64) -> Vec<Order> {
    let mut chance = SeededRandom::new(seed);
    let order = |chance: &mut SeededRandom| match chance.in_percent(30) {
        true => Order::Output { line: 1 + (chance.share() * 8.0) as u8, on: chance.in_percent(50) },
        false => {
            let to = Axes::xyz(chance.share() * 9.0, chance.share() * 9.0, 0.0);
            Order::Move { to, speed_mm_s: 5.0 + chance.share() * 40.0 }
        }
    };
    (0..25).map(|_| order(&mut chance)).collect()
}

/// Runs a program over a line; what was made, what was told to be done, and how it ended.
fn run(faults: Faults, seed: u64) -> (Vec<Order>, usize, Link<Unreliable<Controller>>) {
    let mut link = Link::new(Unreliable::new(Controller::default(), faults, seed));
    for order in program(seed) {
        link.order(order);
    }
    let (mut now_s, mut done) = (0.0, 0);
    while !link.is_idle() && now_s < 600.0 {
        now_s += 0.005;
        done += link.poll(now_s).iter().filter(|told| matches!(told, LinkNews::Done(_))).count();
    }
    let made = link.driver().inner().made().iter().map(|sent| sent.order).collect();
    (made, done, link)
}

#[test]
fn every_order_is_made_once_and_in_order_over_a_bad_line() {
    let bad = Faults { orders_lost: 15, lost: 20, twice: 20, garbled: 15, late: 30, late_s: 0.6 };
    let mut again = 0;
    for seed in 0..60 {
        let (made, done, link) = run(bad, seed);
        assert_eq!(link.state(), LinkState::Up, "seed {seed}");
        assert_eq!(made, program(seed), "seed {seed}");
        assert_eq!(done, made.len(), "seed {seed}: each told once");
        again += link.troubles().again;
    }
    assert!(again > 0, "nothing went wrong");
}

#[test]
fn a_good_line_needs_nothing_twice() {
    let (made, done, link) = run(Faults::default(), 1);
    assert_eq!((made.len(), done), (25, 25));
    assert_eq!((link.troubles().again, link.troubles().garbled), (0, 0));
}

#[test]
fn a_dead_line_is_noticed_and_the_machine_stops_by_itself() {
    let mut link = Link::new(Unreliable::new(Controller::default(), Faults::default(), 1));
    link.order(Order::Move { to: Axes::xyz(500.0, 0.0, 0.0), speed_mm_s: 20.0 });
    let mut now_s = 0.0;
    let mut states = Vec::new();
    while now_s < 16.0 {
        now_s += 0.005;
        if now_s > 2.0 {
            link.driver().faults = Faults { orders_lost: 100, lost: 100, ..Faults::default() };
        }
        states
            .extend(link.poll(now_s).into_iter().filter(|told| matches!(told, LinkNews::State(_))));
    }
    assert_eq!(states, [LinkNews::State(LinkState::Lost)]);
    assert_eq!(link.order(Order::Output { line: 1, on: true }), None, "nothing more is sent");
    let stood = link.driver().inner().standing();
    assert!(!stood.moving && stood.position[Axis::X] < 80.0, "{stood:?}");
}

#[test]
fn a_refusal_ends_it() {
    let mut link = Link::new(Controller::default());
    link.order(Order::Move { to: Axes::xyz(f64::NAN, 0.0, 0.0), speed_mm_s: 20.0 });
    let told: Vec<LinkNews> = (1..100).flat_map(|i| link.poll(f64::from(i) * 0.01)).collect();
    assert!(matches!(told[..], [LinkNews::State(LinkState::Refused(1, _))]), "{told:?}");
}
