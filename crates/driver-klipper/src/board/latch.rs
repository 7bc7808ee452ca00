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
    /// A switch closed that stops its motors.
    pub const TOUCH: u32 = 1;
    /// The host asked.
    pub const HOST: u32 = 2;
    /// The deadline passed.
    pub const DEADLINE: u32 = 4;
    /// The first of the switches changed, and it is watched for all motors; those behind it count up.
    pub const WATCH: u32 = 16;
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

/// Motors that stop by switches of their own.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Holds {
    /// Those of switches of this board.
    pub homes: Vec<Home>,
    /// Those of switches of other boards, a list each: whoever hears those triggers the latch.
    pub away: Vec<Vec<usize>>,
}

impl Holds {
    /// No motor has a switch of its own.
    pub const fn is_empty(&self) -> bool {
        self.homes.is_empty() && self.away.is_empty()
    }

    /// Number of their latches, behind the one over all motion.
    const fn count(&self) -> usize {
        self.homes.len() + self.away.len()
    }

    /// The lists of motors, in the order of the latches.
    fn motors(&self) -> impl Iterator<Item = &Vec<usize>> {
        self.homes.iter().map(|home| &home.motors).chain(&self.away)
    }
}

/// A switch at whose change all motors stop that no switch of their own does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watched {
    /// Its place among the switches.
    pub switch: usize,
    /// It stops them when it opens, instead of when it closes.
    pub opens: bool,
    /// Time between two looks, seconds: at most that of a step.
    pub look_s: f64,
    /// Outputs go off with it: a limit, a door, an emergency stop.
    pub guards: bool,
}

/// Latches of a board.
#[derive(Clone, Debug)]
pub struct Latches {
    /// The reason with which each triggered; nothing while it is armed.
    triggered: Vec<Option<u32>>,
    /// Switches that stop motors of their own, by their latch, counted from 1.
    pub holds: Holds,
    /// Switches that stop all motors.
    watched: Vec<Watched>,
    /// Moment at which deadlines are pushed along.
    again_s: f64,
    /// They are not: another board of the machine is lost.
    expires: bool,
}

impl Latches {
    pub fn new(count: usize) -> Self {
        Self {
            triggered: vec![Some(0); count],
            holds: Holds::default(),
            watched: Vec::new(),
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
            return Some(match found {
                reason::DEADLINE => Ended::Deadline,
                reason::WATCH..
                    if self.watched.iter().any(|it| it.guards && reason_of(it) == found) =>
                {
                    Ended::Guarded
                }
                reason::WATCH.. => Ended::Touched,
                _ => Ended::Asked,
            });
        }
        let holds: Option<Vec<u32>> = (1..=self.holds.count()).map(reason).collect();
        holds.filter(|holds| !holds.is_empty())?;
        Some(if self.is_sought() { Ended::Touched } else { Ended::Deadline })
    }

    /// The switch of a home was touched.
    pub fn has_touched(&self, home: usize) -> bool {
        self.triggered.get(home + 1) == Some(&Some(reason::TOUCH))
    }

    /// Every switch that stops motors of its own was touched, and there is one.
    pub fn is_sought(&self) -> bool {
        !self.holds.is_empty() && (0..self.holds.count()).all(|n| self.has_touched(n))
    }

    /// A switch of another board was touched: its motors here stop.
    pub fn touch_away(&mut self, channel: &mut Channel, away: usize) -> Result<(), OrderError> {
        let latch = 1 + self.holds.homes.len() + away;
        let asked = channel.questions.has(|about| about == About::Latch(latch));
        if asked || self.triggered.get(latch) != Some(&None) {
            return Ok(());
        }
        Self::trigger_one(channel, latch, reason::TOUCH)
    }

    fn trigger_one(channel: &mut Channel, latch: usize, why: u32) -> Result<(), OrderError> {
        let oid = channel.oid(Object::Latch(latch));
        channel.hurry(Order::TrsyncTrigger, [oid, why])?;
        channel.ask(About::Latch(latch), Order::TrsyncTrigger, [oid, why])
    }

    /// Switches that stopped motors.
    pub fn touched(&self) -> Vec<usize> {
        let reason = |latch: usize| self.triggered.get(latch).copied().flatten();
        let touched = |(n, _): &(usize, &Home)| reason(n + 1) == Some(reason::TOUCH);
        let homes =
            self.holds.homes.iter().enumerate().filter(touched).map(|(_, home)| home.switch);
        let watched = reason(0).and_then(|reason| reason.checked_sub(reason::WATCH));
        homes.chain(watched.map(|switch| switch as usize)).collect()
    }

    /// Time between two looks at a switch that stopped motors, seconds.
    pub fn look_s(&self, switch: usize) -> Option<f64> {
        let homes = self.holds.homes.iter().map(|home| (home.switch, home.look_s));
        let watched = self.watched.iter().map(|it| (it.switch, it.look_s));
        let mut looks = homes.chain(watched).filter(|_| self.touched().contains(&switch));
        looks.find(|(other, _)| *other == switch).map(|(_, look_s)| look_s)
    }

    /// Has these switches stop all motors, from a clock on where they move, and those no more that did before. One that did
    /// already is not looked away from.
    pub fn watch(
        &mut self,
        channel: &mut Channel,
        watched: &[Watched],
        moves_from: Option<u64>,
    ) -> Result<(), OrderError> {
        let before = std::mem::replace(&mut self.watched, watched.to_vec());
        let Some(clock) = moves_from else { return Ok(()) };
        let mut over = before.iter().filter(|it| !self.watched.contains(it));
        over.try_for_each(|it| stop_looking(channel, it.switch))?;
        let mut fresh = self.watched.iter().filter(|it| !before.contains(it));
        fresh.try_for_each(|it| look_at(channel, 0, *it, [clock as u32, reason_of(it)]))
    }

    /// Arms the latches for motion that begins at a clock.
    pub fn arm(
        &mut self,
        channel: &mut Channel,
        holds: &Holds,
        [clock, starts]: [u64; 2],
        now_s: f64,
    ) -> Result<(), OrderError> {
        self.holds = holds.clone();
        let many = holds.count();
        self.let_expire(false);
        let first = clock + (FIRST_S * channel.frequency) as u64;
        let report = (channel.options.deadline_s / 2.0 * channel.frequency) as u32;
        for latch in 0..=many {
            let oid = channel.oid(Object::Latch(latch));
            channel.send(Order::TrsyncStart, [oid, first as u32, report, reason::DEADLINE])?;
        }
        for latch in 0..=many {
            let oid = channel.oid(Object::Latch(latch));
            for motor in self.held(channel, latch) {
                channel.send(Order::StopOnTrigger, [channel.oid(Object::Motor(motor)), oid])?;
            }
            let timeout = channel.orders.write(Order::TrsyncTimeout, [oid, first as u32])?;
            channel.push(timeout, (latch == many).then_some(ARMED))?;
            if let Some(triggered) = self.triggered.get_mut(latch) {
                *triggered = None;
            }
        }
        for (n, home) in holds.homes.iter().enumerate() {
            let Home { switch, opens, look_s, .. } = *home;
            let clock_and_reason = [starts as u32, reason::TOUCH];
            let watched = Watched { switch, opens, look_s, guards: false };
            look_at(channel, n + 1, watched, clock_and_reason)?;
        }
        let mut watched = self.watched.iter();
        watched.try_for_each(|it| look_at(channel, 0, *it, [starts as u32, reason_of(it)]))?;
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
        for latch in 0..=self.holds.count() {
            Self::trigger_one(channel, latch, reason::HOST)?;
        }
        let homes = self.holds.homes.iter().map(|home| home.switch);
        let mut switches = homes.chain(self.watched.iter().map(|it| it.switch));
        switches.try_for_each(|switch| stop_looking(channel, switch))
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
        let homed = |motor: &usize| self.holds.motors().any(|motors| motors.contains(motor));
        match latch.checked_sub(1).and_then(|n| self.holds.motors().nth(n)) {
            Some(motors) => motors.clone(),
            None => (0..channel.setup.motors.len()).filter(|motor| !homed(motor)).collect(),
        }
    }
}

/// The reason with which a watched switch triggers the latch of all motors.
const fn reason_of(watched: &Watched) -> u32 {
    reason::WATCH + watched.switch as u32
}

/// A switch is looked at no more.
pub fn stop_looking(channel: &mut Channel, switch: usize) -> Result<(), OrderError> {
    channel.send(Order::EndstopHome, [channel.oid(Object::Switch(switch)), 0, 0, 0, 0, 0, 0, 0])
}

/// A switch is looked at from a clock on, and triggers a latch with a reason.
fn look_at(
    channel: &mut Channel,
    latch: usize,
    watched: Watched,
    [clock, reason]: [u32; 2],
) -> Result<(), OrderError> {
    let Watched { switch, opens, look_s, .. } = watched;
    let ticks = |time_s: f64| (time_s * channel.frequency).round().max(1.0) as u32;
    let inverted = channel.setup.switches.get(switch).is_some_and(|pin| pin.inverted);
    let level = u32::from(inverted == opens);
    let [oid, trsync] = [Object::Switch(switch), Object::Latch(latch)].map(|o| channel.oid(o));
    let (sample, rest) = (ticks(SAMPLE_S), ticks(look_s));
    let looks = [oid, clock, sample, SAMPLES, rest, level, trsync, reason];
    channel.send(Order::EndstopHome, looks)
}
