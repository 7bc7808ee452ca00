//! Motion of a session: armed, fed, ended, and counted.

use super::channel::{Channel, Told};
use super::latch::{Holds, Latches, Watched};
use super::news::{Ended, Fault, News, Start};
use super::questions::About;
use crate::link::FILLS_S;
use crate::orders::{Order, OrderError};
use crate::queue::{Change, Lead, Queue, Release};
use crate::setup::Object;
use std::collections::VecDeque;

/// Times that a frame may take to be filled, before the first step in it is due.
const SOON: f64 = 2.0;
/// Time between two looks at the queue, seconds.
const LOOK_S: f64 = 0.005;
/// Time behind the last step after which it has surely been made, seconds.
const SETTLED_S: f64 = 0.01;
/// Time from which on a switch is looked at that is watched while motors move, seconds: the line may need some resends.
const WATCHED_S: f64 = 0.25;

/// The state of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
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

/// Motion of the motors of a board.
pub struct Motion {
    pub state: State,
    pub latches: Latches,
    pub queue: Queue,
    pub lead: Lead,
    /// Steps that each motor has made, as the board told last.
    pub counts: Vec<i64>,
    /// More motion may follow soon: latches stay armed behind the last step.
    pub lingers: bool,
}

impl Motion {
    /// Motors that stand.
    pub fn new(channel: &Channel) -> Self {
        Self {
            state: State::Rest,
            latches: Latches::new(channel.setup.latches()),
            queue: Queue::new(Vec::new(), &[], 0),
            lead: Lead::new(channel.frequency).of_deadline(channel.options.deadline_s),
            counts: vec![0; channel.setup.motors.len()],
            lingers: true,
        }
    }

    /// Motion goes on, or is about to.
    pub const fn moves(&self) -> bool {
        matches!(self.state, State::Arming | State::Moving)
    }

    /// Motion begins at a clock that is far enough ahead.
    pub fn start_at(
        &mut self,
        channel: &mut Channel,
        holds: &Holds,
        [now, starts]: [u64; 2],
        now_s: f64,
    ) -> Result<Start, OrderError> {
        let ticks_per_s = channel.clock.as_ref().map_or(channel.frequency, |clock| clock.rate());
        self.latches.arm(channel, holds, [now, starts], now_s)?;
        self.queue.start(starts, &self.counts);
        self.state = State::Arming;
        self.lingers = true;
        Ok(Start { clock: starts, ticks_per_s })
    }

    /// The latches are armed: the way is free.
    pub fn armed(&mut self) {
        if self.state == State::Arming {
            self.state = State::Moving;
        }
    }

    /// Feeds the board with what is due, and ends motion that is over.
    pub fn move_on(&mut self, channel: &mut Channel, now_s: f64) -> Told {
        let Some((now, off)) = channel.now(now_s) else { return Ok(()) };
        self.lead.looked(now_s);
        if self.moves() && channel.link.first_step().is_some_and(|clock| clock < now + off) {
            // The host stalled while a frame was being filled.
            self.stop(channel, Ended::Late)?;
        }
        let moves = self.state != State::Arming;
        let released = self.queue.release(now, off, &self.lead, moves);
        if self.state == State::Moving {
            self.latches.push_along(channel, now, now_s)?;
        }
        // What is due soon does not wait for its frame to be filled.
        let soon = now + off + channel.ticks(SOON * FILLS_S);
        let mut clocks = released.iter().flatten().filter_map(Release::clock);
        if self.queue.is_stopping() || clocks.any(|clock| clock < soon) {
            channel.link.hurry();
        }
        match released {
            Ok(releases) => releases.into_iter().try_for_each(|it| release(channel, it))?,
            Err(_) => self.stop(channel, Ended::Late)?,
        }
        let lingers = self.lingers && !self.queue.is_stopping();
        let lingers_s = if lingers { channel.options.linger_s } else { 0.0 };
        let settled = self.queue.ends() + off + channel.ticks(SETTLED_S + lingers_s);
        let is_made = self.state == State::Moving && self.queue.is_sent() && now > settled;
        if is_made && channel.has_passed(self.queue.ends()) {
            self.state = State::Ending(Ended::Rested);
            self.latches.trigger(channel)?;
        }
        Ok(())
    }

    /// Has these switches stop all motors.
    pub fn watch(
        &mut self,
        channel: &mut Channel,
        watched: &[Watched],
        now: u64,
    ) -> Result<(), OrderError> {
        let from = now + channel.ticks(WATCHED_S);
        self.latches.watch(channel, watched, self.moves().then_some(from))
    }

    /// Drops all motion at once.
    pub fn stop(&mut self, channel: &mut Channel, why: Ended) -> Result<(), OrderError> {
        if !self.moves() {
            return Ok(());
        }
        channel.link.forget();
        match why {
            Ended::Touched => self.queue.drop_motion(),
            _ => self.queue.dropped(),
        }
        self.state = State::Ending(why);
        self.latches.trigger(channel)
    }

    /// A latch has triggered by itself, or all of them as they were told.
    pub fn stopped(&mut self, channel: &mut Channel, why: Ended) -> Result<(), OrderError> {
        match self.state {
            State::Arming | State::Moving => self.stop(channel, why),
            State::Ending(why)
                if !channel.questions.has(|about| matches!(about, About::Latch(_))) =>
            {
                self.read_counts(channel, why)
            }
            _ => Ok(()),
        }
    }

    /// The board has shut down: all that it had is dropped.
    pub fn shut_down(&mut self) {
        self.queue.shut_down();
        self.latches.disarmed();
        self.state = State::Rest;
    }

    /// Asks for the counts of all motors, and for the looks at the switches that closed.
    pub fn read_counts(&mut self, channel: &mut Channel, why: Ended) -> Result<(), OrderError> {
        self.state = State::Reading(why);
        ask_counts(channel)?;
        let touched = if why == Ended::Shutdown { Vec::new() } else { self.latches.touched() };
        touched.into_iter().try_for_each(|switch| channel.ask_switch(switch))
    }

    pub fn told_position(
        &mut self,
        channel: &mut Channel,
        (oid, count): (u32, i32),
        news: &mut VecDeque<News>,
    ) -> Told {
        let mut motors = 0..channel.setup.motors.len();
        let Some(motor) = motors.find(|n| channel.oid(Object::Motor(*n)) == oid) else {
            return Ok(());
        };
        if !channel.questions.answered(About::Position(motor)) {
            return Ok(());
        }
        // The board counts by the level of the pin, and knows nothing of a motor that turns the other way.
        let turned = channel.setup.motors.get(motor).is_some_and(|motor| motor.dir.inverted);
        self.counts[motor] = if turned { -i64::from(count) } else { i64::from(count) };
        self.counted(channel, news)
    }

    /// Tells the end of motion once all is known.
    pub fn counted(&mut self, channel: &Channel, news: &mut VecDeque<News>) -> Told {
        let open = |about| matches!(about, About::Position(_) | About::Switch(_));
        let State::Reading(why) = self.state else { return Ok(()) };
        if channel.questions.has(open) {
            return Ok(());
        }
        self.state = State::Rest;
        if why == Ended::Rested && self.latches.holds.is_empty() {
            self.compare()?;
        }
        news.push_back(News::Ended { why, counts: self.counts.clone() });
        Ok(())
    }

    /// Moment of the next look at the queue.
    pub fn due_s(&self) -> f64 {
        self.lead.looked_s() + LOOK_S
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
}

/// Asks for the counts of all motors.
pub fn ask_counts(channel: &mut Channel) -> Result<(), OrderError> {
    (0..channel.setup.motors.len()).try_for_each(|motor| {
        channel.ask(About::Position(motor), Order::Position, [channel.oid(Object::Motor(motor))])
    })
}

fn release(channel: &mut Channel, release: Release) -> Result<(), OrderError> {
    match release {
        Release::Reset { motor, clock } => {
            let oid = channel.oid(Object::Motor(motor));
            channel.send_motion(Order::ResetStepClock, [oid, clock as u32], u64::MAX)
        }
        Release::Turn { motor, forward } => {
            let oid = channel.oid(Object::Motor(motor));
            let dir = forward != channel.setup.motors.get(motor).is_some_and(|m| m.dir.inverted);
            channel.send_motion(Order::NextDir, [oid, dir.into()], u64::MAX)
        }
        Release::Steps { motor, steps } => {
            let oid = channel.oid(Object::Motor(motor));
            let add = i32::from(steps.add) as u32;
            let numbers = [oid, steps.interval, steps.count.into(), add];
            channel.send_motion(Order::QueueStep, numbers, steps.at(1))
        }
        Release::AtOnce { output, value } => {
            let oid = channel.oid(Object::Output(output));
            channel.send(Order::UpdateDigital, [oid, value])
        }
        Release::Output(Change { output, clock, value }) => {
            let switched = channel.setup.outputs.len();
            if output < switched {
                let oid = channel.oid(Object::Output(output));
                return channel.send(Order::QueueDigital, [oid, clock as u32, value]);
            }
            let oid = channel.oid(Object::Pulsed(output - switched));
            channel.send(Order::QueuePwm, [oid, clock as u32, value])
        }
    }
}
