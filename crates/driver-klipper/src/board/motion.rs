//! Motion of a session: armed, fed, ended, and counted.

use super::latch::Home;
use super::learn::Learning;
use super::news::{Ended, Fault, News};
use super::questions::About;
use super::session::{Session, Told};
use crate::orders::{Order, OrderError};
use crate::queue::{Change, Piece, Refused, Release};
use crate::setup::Object;
use std::collections::VecDeque;

/// Shortest time between the wish to move and the first step, seconds.
const FIRST_S: f64 = 0.25;
/// Time between two looks at the queue, seconds.
const LOOK_S: f64 = 0.005;
/// Time behind the last step after which it has surely been made, seconds.
const SETTLED_S: f64 = 0.01;

/// The reason for which something cannot be done now.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotNow {
    /// There is no board.
    #[error("no board is connected")]
    Absent,
    /// It is not known well enough yet, or it moves.
    #[error("the board is busy: wait until it stands")]
    Busy,
    /// Nothing moves.
    #[error("nothing moves")]
    Rest,
    /// It is shut down.
    #[error("the board is shut down: clear that first")]
    Shutdown,
    /// It cannot be told.
    #[error(transparent)]
    Order(#[from] OrderError),
}

/// The beginning of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Clock at which the first piece begins.
    pub clock: u64,
    /// Ticks a second, as measured: times of a plan become clocks by it.
    pub ticks_per_s: f64,
}

/// The state of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Nothing moves.
    Rest,
    /// Latches are being armed; no step goes out before they are.
    Arming,
    /// Steps go out.
    Moving,
    /// Latches are being triggered.
    Ending(Ended),
    /// Counts are being read.
    Reading(Ended),
}

impl Session {
    pub fn start(&mut self, homes: &[Home], now_s: f64) -> Result<Start, NotNow> {
        let Some((now, _)) = self.now(now_s) else { return Err(NotNow::Busy) };
        let starts = now + (self.lead.full_s().max(FIRST_S) * self.frequency) as u64;
        self.start_at(homes, starts, now_s)
    }

    /// Motion begins at a clock that is far enough ahead.
    pub fn start_at(&mut self, homes: &[Home], starts: u64, now_s: f64) -> Result<Start, NotNow> {
        if self.shutdown {
            return Err(NotNow::Shutdown);
        }
        let known = self.now(now_s).filter(|_| self.is_ready() && self.motion == Motion::Rest);
        let Some(((now, _), clock)) = known.zip(self.clock.as_ref()) else {
            return Err(NotNow::Busy);
        };
        let ticks_per_s = clock.rate();
        self.arm(homes, now, starts, now_s)?;
        self.queue.start(starts, &self.counts);
        self.motion = Motion::Arming;
        Ok(Start { clock: starts, ticks_per_s })
    }

    pub fn offer(&mut self, piece: &Piece) -> Result<(), Refused> {
        match self.motion {
            Motion::Arming | Motion::Moving => self.queue.offer(piece),
            _ => Err(Refused::Stopping),
        }
    }

    pub fn withdraw(&mut self) -> Result<u64, NotNow> {
        match self.motion {
            Motion::Arming | Motion::Moving if !self.queue.is_stopping() => {
                Ok(self.queue.withdraw())
            }
            _ => Err(NotNow::Rest),
        }
    }

    /// The latches are armed: the way is free.
    pub fn armed(&mut self) {
        if self.motion == Motion::Arming {
            self.motion = Motion::Moving;
        }
    }

    /// Feeds the board with what is due, and ends motion that is over.
    pub fn move_on(&mut self, now_s: f64) -> Told {
        if !self.is_ready() || self.shutdown {
            return Ok(());
        }
        let Some((now, off)) = self.now(now_s) else { return Ok(()) };
        self.lead.looked(now_s);
        if self.motion == Motion::Moving {
            self.push_along(now, now_s)?;
        }
        let moves = self.motion != Motion::Arming;
        match self.queue.release(now, off, &self.lead, moves) {
            Ok(releases) => releases.into_iter().try_for_each(|release| self.release(release))?,
            Err(_) => self.stop(Ended::Late)?,
        }
        let settled = self.queue.ends() + off + (SETTLED_S * self.frequency) as u64;
        if self.motion == Motion::Moving && self.queue.is_sent() && now > settled {
            self.motion = Motion::Ending(Ended::Rested);
            self.trigger()?;
        }
        Ok(())
    }

    /// Drops all motion at once.
    pub fn stop(&mut self, why: Ended) -> Result<(), OrderError> {
        if !matches!(self.motion, Motion::Arming | Motion::Moving) {
            return Ok(());
        }
        self.link.forget();
        self.queue.dropped();
        self.motion = Motion::Ending(why);
        self.trigger()
    }

    /// A latch has triggered by itself, or all of them as they were told.
    pub fn stopped(&mut self, why: Ended) -> Result<(), OrderError> {
        match self.motion {
            Motion::Arming | Motion::Moving => self.stop(why),
            Motion::Ending(why)
                if !self.questions.has(|about| matches!(about, About::Latch(_))) =>
            {
                self.read_counts(why)
            }
            _ => Ok(()),
        }
    }

    pub fn emergency_stop(&mut self) -> Result<(), OrderError> {
        self.link.forget();
        self.hurry(Order::EmergencyStop, [])
    }

    pub fn recover(&mut self) -> Result<(), NotNow> {
        if !self.shutdown { Err(NotNow::Rest) } else { Ok(self.clear()?) }
    }

    /// Asks for the counts of all motors, and for the looks at the switches that closed.
    pub fn read_counts(&mut self, why: Ended) -> Result<(), OrderError> {
        self.motion = Motion::Reading(why);
        for motor in 0..self.setup.motors.len() {
            let oid = self.setup.oid(Object::Motor(motor));
            self.ask(About::Position(motor), Order::Position, [oid])?;
        }
        let touched = if why == Ended::Shutdown { Vec::new() } else { self.latches.touched() };
        touched.into_iter().try_for_each(|switch| self.ask_switch(switch))
    }

    pub fn told_position(&mut self, oid: u32, count: i32, news: &mut VecDeque<News>) -> Told {
        let mut motors = 0..self.setup.motors.len();
        let Some(motor) = motors.find(|n| self.setup.oid(Object::Motor(*n)) == oid) else {
            return Ok(());
        };
        if !self.questions.answered(About::Position(motor)) {
            return Ok(());
        }
        self.counts[motor] = i64::from(count);
        self.counted(news)
    }

    /// Tells the end of motion once all is known.
    pub fn counted(&mut self, news: &mut VecDeque<News>) -> Told {
        let open = |about| matches!(about, About::Position(_) | About::Switch(_));
        let Motion::Reading(why) = self.motion else { return Ok(()) };
        if self.questions.has(open) {
            return Ok(());
        }
        self.motion = Motion::Rest;
        if why == Ended::Rested && self.latches.homes.is_empty() {
            self.compare()?;
        }
        news.push_back(News::Ended { why, counts: self.counts.clone() });
        Ok(())
    }

    pub fn count_at(&self, motor: usize, clock: u64) -> Option<i64> {
        self.queue.count_at(motor, clock)
    }

    pub fn motion_due_s(&self) -> f64 {
        if self.is_ready() { self.lead.looked_s() + LOOK_S } else { f64::INFINITY }
    }

    pub fn set_output(&mut self, output: usize, share: f64, now_s: f64) -> Result<(), NotNow> {
        let ready = self.now(now_s).filter(|_| self.is_ready() && !self.shutdown);
        let Some((now, off)) = ready else { return Err(NotNow::Busy) };
        let value = self.output_value(output, share);
        self.queue.set(Change { output, clock: now + off, value });
        Ok(())
    }

    /// Value of an output as the board takes it, for a share from 0 (off) to 1.
    pub fn output_value(&self, output: usize, share: f64) -> u32 {
        let share = share.clamp(0.0, 1.0);
        if let Some(switched) = self.setup.outputs.get(output) {
            return u32::from((share > 0.0) != switched.pin.inverted);
        }
        let pulsed = self.setup.pulsed.get(output - self.setup.outputs.len());
        let share = if pulsed.is_some_and(|p| p.pin.inverted) { 1.0 - share } else { share };
        (share * f64::from(self.pwm_max())).round() as u32
    }

    pub fn pwm_max(&self) -> u32 {
        self.dictionary.constant("PWM_MAX").unwrap_or(255.0) as u32
    }

    pub fn is_ready(&self) -> bool {
        self.learning == Learning::Ready
    }

    /// A board that has made other steps than those it was told has lost them, or its host has.
    fn compare(&self) -> Told {
        let planned = self.queue.counts();
        let mut pairs = planned.iter().zip(&self.counts).enumerate();
        match pairs.find(|(_, (planned, made))| planned != made) {
            Some((motor, (planned, made))) => {
                Err(Fault::Lost { motor, planned: *planned, made: *made })
            }
            None => Ok(()),
        }
    }

    fn release(&mut self, release: Release) -> Result<(), OrderError> {
        let motor = |n| self.setup.oid(Object::Motor(n));
        match release {
            Release::Reset { motor: n, clock } => {
                self.send_motion(Order::ResetStepClock, [motor(n), clock as u32])
            }
            Release::Turn { motor: n, forward } => {
                let dir = forward != self.setup.motors.get(n).is_some_and(|m| m.dir.inverted);
                self.send_motion(Order::NextDir, [motor(n), dir.into()])
            }
            Release::Steps { motor: n, steps } => {
                let add = i32::from(steps.add) as u32;
                self.send_motion(
                    Order::QueueStep,
                    [motor(n), steps.interval, steps.count.into(), add],
                )
            }
            Release::Output(Change { output, clock, value }) => {
                let switched = self.setup.outputs.len();
                if output < switched {
                    let oid = self.setup.oid(Object::Output(output));
                    return self.send(Order::QueueDigital, [oid, clock as u32, value]);
                }
                let oid = self.setup.oid(Object::Pulsed(output - switched));
                self.send(Order::QueuePwm, [oid, clock as u32, value])
            }
        }
    }
}
