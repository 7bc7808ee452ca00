//! Latches that stop motors: one over all motion, one for each switch that a motor is homed to.
//!
//! A latch that is armed triggers by itself when its deadline passes. The host pushes the deadline along while motion
//! goes on; a host that is dead does not, and the board stops its motors to the tick.

use super::channel::{ARMED, Channel};
use super::news::Ended;
use super::questions::About;
use crate::dictionary::Message;
use crate::orders::{Order, OrderError};
use crate::setup::Object;

/// Reasons with which latches trigger.
pub mod reason {
    /// A switch closed.
    pub const TOUCH: u32 = 1;
    /// The host asked.
    pub const HOST: u32 = 2;
    /// The deadline passed.
    pub const DEADLINE: u32 = 4;
}

/// Time between arming and the first deadline, seconds: the line may need some resends by then.
const FIRST_S: f64 = 0.5;
/// Time between two looks at a switch that is closed, and number of them, seconds.
const SAMPLE_S: f64 = 15e-6;
const SAMPLES: u32 = 4;
/// Parts of the deadline after which it is pushed along.
const AGAIN: f64 = 4.0;

/// A switch and the motors that it stops.
#[derive(Clone, Debug, PartialEq)]
pub struct Home {
    /// Its place among the switches.
    pub switch: usize,
    /// The motors.
    pub motors: Vec<usize>,
    /// It stops them when it opens, instead of when it closes.
    pub opens: bool,
    /// Time between two looks, seconds: at most that of a step.
    pub look_s: f64,
}

/// Latches of a board.
#[derive(Clone, Debug)]
pub struct Latches {
    /// The reason with which each triggered; nothing while it is armed.
    triggered: Vec<Option<u32>>,
    /// Switches that are watched, by their latch, counted from 1.
    pub homes: Vec<Home>,
    /// Moment at which deadlines are pushed along.
    again_s: f64,
    /// They are not: another board of the machine is lost.
    expires: bool,
}

impl Latches {
    pub fn new(count: usize) -> Self {
        Self {
            triggered: vec![Some(0); count],
            homes: Vec::new(),
            again_s: f64::INFINITY,
            expires: false,
        }
    }

    pub fn count(&self) -> usize {
        self.triggered.len()
    }

    /// Deadlines are pushed along no more, or again.
    pub const fn let_expire(&mut self, expires: bool) {
        self.expires = expires;
    }

    /// None is armed.
    pub fn disarmed(&mut self) {
        self.triggered.fill(Some(0));
        self.again_s = f64::INFINITY;
    }

    fn armed(&self) -> Vec<usize> {
        (0..self.count()).filter(|latch| self.triggered.get(*latch) == Some(&None)).collect()
    }

    /// All that have to stop have stopped: the one over all motion, or those of all switches.
    fn over(&self) -> Option<Ended> {
        let reason = |latch: usize| self.triggered.get(latch).copied().flatten();
        if let Some(found) = reason(0) {
            return Some(if found == reason::DEADLINE { Ended::Deadline } else { Ended::Asked });
        }
        let homes: Option<Vec<u32>> = (1..=self.homes.len()).map(reason).collect();
        let homes = homes.filter(|homes| !homes.is_empty())?;
        let touched = homes.iter().all(|reason| *reason == reason::TOUCH);
        Some(if touched { Ended::Touched } else { Ended::Deadline })
    }

    /// Switches that stopped their motors.
    pub fn touched(&self) -> Vec<usize> {
        let touched =
            |(n, _): &(usize, &Home)| self.triggered.get(n + 1) == Some(&Some(reason::TOUCH));
        self.homes.iter().enumerate().filter(touched).map(|(_, home)| home.switch).collect()
    }

    /// Arms the latches for motion that begins at a clock.
    pub fn arm(
        &mut self,
        channel: &mut Channel,
        homes: &[Home],
        clock: u64,
        starts: u64,
        now_s: f64,
    ) -> Result<(), OrderError> {
        self.homes = homes.to_vec();
        self.let_expire(false);
        let first = clock + (FIRST_S * channel.frequency) as u64;
        let report = (channel.options.deadline_s / 2.0 * channel.frequency) as u32;
        for latch in 0..=homes.len() {
            let oid = channel.oid(Object::Latch(latch));
            channel.send(Order::TrsyncStart, [oid, first as u32, report, reason::DEADLINE])?;
        }
        for latch in 0..=homes.len() {
            let oid = channel.oid(Object::Latch(latch));
            for motor in self.held(channel, latch) {
                channel.send(Order::StopOnTrigger, [channel.oid(Object::Motor(motor)), oid])?;
            }
            let timeout = channel.orders.write(Order::TrsyncTimeout, [oid, first as u32])?;
            channel.push(timeout, (latch == homes.len()).then_some(ARMED))?;
            if let Some(triggered) = self.triggered.get_mut(latch) {
                *triggered = None;
            }
        }
        homes.iter().enumerate().try_for_each(|(n, home)| watch(channel, n + 1, home, starts))?;
        // Before the first deadline, however long the later ones are.
        self.again_s = now_s + channel.options.deadline_s.min(FIRST_S / AGAIN);
        Ok(())
    }

    /// Pushes the deadlines along.
    pub fn push_along(
        &mut self,
        channel: &mut Channel,
        clock: u64,
        now_s: f64,
    ) -> Result<(), OrderError> {
        if now_s < self.again_s || self.expires {
            return Ok(());
        }
        self.again_s = now_s + channel.options.deadline_s / AGAIN;
        let deadline = clock + (channel.options.deadline_s * channel.frequency) as u64;
        for latch in self.armed() {
            let oid = channel.oid(Object::Latch(latch));
            channel.hurry(Order::TrsyncTimeout, [oid, deadline as u32])?;
        }
        Ok(())
    }

    /// Triggers the latches, each until it is told that it did.
    pub fn trigger(&mut self, channel: &mut Channel) -> Result<(), OrderError> {
        self.again_s = f64::INFINITY;
        for latch in 0..=self.homes.len() {
            let oid = channel.oid(Object::Latch(latch));
            channel.hurry(Order::TrsyncTrigger, [oid, reason::HOST])?;
            channel.ask(About::Latch(latch), Order::TrsyncTrigger, [oid, reason::HOST])?;
        }
        let switches: Vec<usize> = self.homes.iter().map(|home| home.switch).collect();
        switches.into_iter().try_for_each(|switch| stop_looking(channel, switch))
    }

    /// Reads the state of a latch; tells the end of motion where all that have to stop have stopped.
    pub fn told(&mut self, channel: &mut Channel, message: &Message<'_>) -> Option<Ended> {
        let number = |field| message.number(field).unwrap_or_default();
        let found = (0..self.count()).find(|n| channel.oid(Object::Latch(*n)) == number("oid"));
        let latch = found.filter(|_| number("can_trigger") == 0)?;
        if self.triggered.get(latch) == Some(&None) {
            self.triggered[latch] = Some(number("trigger_reason"));
        }
        channel.questions.answered(About::Latch(latch));
        self.over()
    }

    /// Motors that a latch stops.
    fn held(&self, channel: &Channel, latch: usize) -> Vec<usize> {
        let homes = &self.homes;
        let homed = |motor: &usize| homes.iter().any(|home| home.motors.contains(motor));
        match latch.checked_sub(1).and_then(|n| homes.get(n)) {
            Some(home) => home.motors.clone(),
            None => (0..channel.setup.motors.len()).filter(|motor| !homed(motor)).collect(),
        }
    }
}

/// A switch is looked at no more.
pub fn stop_looking(channel: &mut Channel, switch: usize) -> Result<(), OrderError> {
    channel.send(Order::EndstopHome, [channel.oid(Object::Switch(switch)), 0, 0, 0, 0, 0, 0, 0])
}

/// A switch is looked at from a clock on, and triggers its latch.
fn watch(channel: &mut Channel, latch: usize, home: &Home, starts: u64) -> Result<(), OrderError> {
    let ticks = |time_s: f64| (time_s * channel.frequency).round().max(1.0) as u32;
    let inverted = channel.setup.switches.get(home.switch).is_some_and(|pin| pin.inverted);
    let level = u32::from(inverted == home.opens);
    let [oid, trsync] = [Object::Switch(home.switch), Object::Latch(latch)].map(|o| channel.oid(o));
    let (sample, rest) = (ticks(SAMPLE_S), ticks(home.look_s));
    let looks = [oid, starts as u32, sample, SAMPLES, rest, level, trsync, reason::TOUCH];
    channel.send(Order::EndstopHome, looks)
}
