//! A controller without a protocol: orders arrive as they are, so that tests can spoil them one by one.

use kerf_machine::driver::conformance::CASES;
use kerf_machine::driver::{
    ControllerState, Driver, Garbled, Order, Reply, Sent, Signal, Ticket, is_sound, way_mm,
};
use kerf_program::Axes;
use std::collections::VecDeque;

/// Acceleration with which it gains and loses speed, mm/s².
const ACCEL_MM_S2: f64 = 500.0;

/// Silence after which a driver that still has orders stops by itself, seconds.
const WATCHDOG_S: f64 = 1.0;

/// Time is followed in steps of this, seconds.
const STEP_S: f64 = 0.001;

/// Below this a move is at its end, mm.
const THERE_MM: f64 = 1e-9;

/// A machine that moves straight, order by order.
#[derive(Clone, Debug)]
pub struct Controller {
    clock_s: f64,
    heard_s: f64,
    position: Axes,
    speed_mm_s: f64,
    held: bool,
    /// Slowing down for good.
    stopping: bool,
    outputs: u32,
    row: VecDeque<Sent>,
    taken: Ticket,
    done: Ticket,
    replies: Vec<Reply>,
    made: Vec<Sent>,
}

impl Default for Controller {
    fn default() -> Self {
        Self {
            clock_s: 0.0,
            heard_s: 0.0,
            position: Axes::default(),
            speed_mm_s: 0.0,
            held: false,
            stopping: false,
            outputs: 0,
            row: VecDeque::new(),
            taken: 0,
            done: 0,
            replies: Vec::new(),
            made: Vec::new(),
        }
    }
}

impl Controller {
    /// Returns the orders that were carried out to their end, in order.
    pub fn made(&self) -> &[Sent] {
        &self.made
    }

    /// Returns its place, whether it moves, its outputs and the last order that is done.
    pub fn standing(&self) -> ControllerState {
        let (position, outputs, done) = (self.position, self.outputs, self.done);
        ControllerState { position, moving: self.speed_mm_s > 0.0, outputs, done }
    }

    fn follow(&mut self, now_s: f64) {
        while self.clock_s + STEP_S <= now_s {
            self.clock_s += STEP_S;
            if self.clock_s - self.heard_s > WATCHDOG_S && !self.row.is_empty() {
                self.stopping = true;
            }
            self.step();
        }
    }

    fn step(&mut self) {
        let Some(first) = self.row.front().copied() else { return self.rest() };
        let Order::Move { to, speed_mm_s } = first.order else {
            if let Order::Output { line, on } = first.order {
                if self.stopping {
                    return self.rest();
                }
                self.switch(line, on);
            }
            return self.finish();
        };
        let way = way_mm(self.position, to);
        self.speed_mm_s = self.next_speed(way, speed_mm_s);
        let by = self.speed_mm_s * STEP_S;
        if by >= way - THERE_MM && !self.held && !self.stopping {
            self.position = to;
            self.speed_mm_s = 0.0;
            return self.finish();
        }
        let share = if way > 0.0 { (by / way).min(1.0) } else { 0.0 };
        self.position = self.position.zip(to, |from, to| from + (to - from) * share);
        if self.stopping && self.speed_mm_s == 0.0 {
            self.rest();
        }
    }

    /// The speed of the next step: up to the one wanted, down before the end or when told to.
    fn next_speed(&self, way: f64, wanted: f64) -> f64 {
        let change = ACCEL_MM_S2 * STEP_S;
        if self.held || self.stopping {
            return (self.speed_mm_s - change).max(0.0);
        }
        // The last step of a move is never slower than this.
        let braking = (2.0 * ACCEL_MM_S2 * way).sqrt().max(change);
        wanted.min(self.speed_mm_s + change).min(braking)
    }

    fn switch(&mut self, line: u8, on: bool) {
        let bit = 1 << (line - 1);
        self.outputs = if on { self.outputs | bit } else { self.outputs & !bit };
    }

    fn finish(&mut self) {
        if let Some(sent) = self.row.pop_front() {
            self.done = sent.ticket;
            self.replies.push(Reply::Done(sent.ticket));
            self.made.push(sent);
        }
    }

    /// It stands after a stop: what was not done is forgotten.
    fn rest(&mut self) {
        self.speed_mm_s = 0.0;
        if self.stopping {
            self.row.clear();
            self.outputs = 0;
        }
    }
}

impl Driver for Controller {
    fn send(&mut self, sent: &Sent, now_s: f64) {
        self.follow(now_s);
        self.heard_s = now_s;
        if sent.ticket <= self.done {
            return self.replies.push(Reply::Done(sent.ticket));
        }
        if sent.ticket <= self.taken {
            return self.replies.push(Reply::Taken(sent.ticket));
        }
        if self.stopping || sent.ticket != self.taken + 1 {
            return;
        }
        if !is_sound(&sent.order) {
            return self.replies.push(Reply::Refused(sent.ticket, "no machine can do this"));
        }
        self.taken = sent.ticket;
        self.row.push_back(*sent);
        self.replies.push(Reply::Taken(sent.ticket));
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        self.follow(now_s);
        self.heard_s = now_s;
        match signal {
            Signal::Ask => self.replies.push(Reply::State(self.standing())),
            Signal::Hold => self.held = true,
            Signal::Resume => self.held = false,
            Signal::Stop => self.stopping = true,
            Signal::Feed(_)
            | Signal::Override(_)
            | Signal::ByHand
            | Signal::ToolIn
            | Signal::TouchOff
            | Signal::ToolOff => {}
        }
    }

    fn replies(&mut self, now_s: f64) -> Vec<Result<Reply, Garbled>> {
        self.follow(now_s);
        self.replies.drain(..).map(Ok).collect()
    }
}

#[test]
fn it_holds_what_every_driver_has_to_hold() {
    let failed: Vec<String> = CASES
        .iter()
        .filter_map(|case| {
            let seen = (case.check)(&mut Controller::default()).err()?;
            Some(format!("{}: {seen}", case.name))
        })
        .collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn nobody_heard_from_means_stop() {
    let mut driver = Controller::default();
    let order = Order::Move { to: Axes::xyz(1000.0, 0.0, 0.0), speed_mm_s: 20.0 };
    driver.send(&Sent { ticket: 1, order }, 0.0);
    driver.replies(1.5);
    let stood = driver.standing();
    assert!(!stood.moving && stood.position.0[0] < 25.0);
}
