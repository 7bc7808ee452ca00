//! The way from a board whose words are known to one that can be moved.

use super::news::{Fault, News};
use super::questions::About;
use super::session::{Session, Told};
use crate::compress::Limits;
use crate::dictionary::Message;
use crate::orders::Order;
use crate::queue::Queue;
use crate::setup::{Object, Pulsed, Switched};
use std::collections::VecDeque;

/// Least number of ticks between two steps of a motor that boards are asked for, whatever the setup says.
const LEAST: u32 = 3;

/// The state of learning about a board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Learning {
    /// Clock and configuration are asked for.
    Asked,
    /// The configuration went out, and is asked for.
    Configured,
    /// It is this machine's configuration; the counts are asked for.
    Counts,
    /// All is known.
    Ready,
}

impl Session {
    /// Reads the state of the configuration.
    pub fn told_config(&mut self, message: &Message<'_>) -> Told {
        let number = |field| message.number(field).unwrap_or_default();
        if number("is_shutdown") != 0 {
            // A command that is refused tells the reason.
            return Ok(self.ask(About::Position(0), Order::Position, [0])?);
        }
        let crc = self.configured.crc;
        match (number("is_config") != 0, number("crc") == crc, self.learning) {
            (true, true, _) => self.configured(number("move_count") as usize),
            (true, false, _) => Err(Fault::Foreign(number("crc"))),
            (false, _, Learning::Asked) => self.configure(),
            (false, ..) => Err(Fault::Configuration),
        }
    }

    /// Tells that the board is ready, once its clock and its counts are known.
    pub fn learn(&mut self, now_s: f64, news: &mut VecDeque<News>) -> Told {
        let counting = self.questions.has(|about| matches!(about, About::Position(_)));
        let known = self.now(now_s);
        if self.learning != Learning::Counts || counting {
            return Ok(());
        }
        let Some((clock, _)) = known else { return Ok(()) };
        self.learning = Learning::Ready;
        self.look_at_buttons(clock)?;
        let version = self.dictionary.version().to_owned();
        news.push_back(News::Ready { version, counts: self.counts.clone() });
        Ok(())
    }

    fn configure(&mut self) -> Told {
        for command in self.configured.commands.clone() {
            self.push(command, None)?;
        }
        self.send(Order::Finalize, [self.configured.crc])?;
        self.learning = Learning::Configured;
        Ok(self.ask(About::Config, Order::Config, [])?)
    }

    /// The board has this machine's configuration: it is put at rest, whatever a former session left.
    fn configured(&mut self, places: usize) -> Told {
        if self.learning == Learning::Asked {
            self.put_at_rest()?;
        }
        self.learning = Learning::Counts;
        self.queue = Queue::new(self.limits(), &self.watches(), places);
        for motor in 0..self.setup.motors.len() {
            let oid = self.setup.oid(Object::Motor(motor));
            self.ask(About::Position(motor), Order::Position, [oid])?;
        }
        Ok(())
    }

    fn put_at_rest(&mut self) -> Told {
        let latches: Vec<u32> =
            (0..self.latches.count()).map(|n| self.setup.oid(Object::Latch(n))).collect();
        // Starting a latch takes the motors from it that a former session left there.
        latches.iter().try_for_each(|oid| self.send(Order::TrsyncStart, [*oid, 0, 0, 0]))?;
        let all = self.setup.oid(Object::Latch(0));
        for motor in 0..self.setup.motors.len() {
            self.send(Order::StopOnTrigger, [self.setup.oid(Object::Motor(motor)), all])?;
        }
        latches.iter().try_for_each(|oid| self.send(Order::TrsyncTrigger, [*oid, 0]))?;
        for switch in 0..self.setup.switches.len() {
            self.stop_looking(switch)?;
        }
        Ok(())
    }

    fn limits(&self) -> Vec<Limits> {
        let ticks = |time_s: f64| (time_s * self.frequency).ceil() as u32;
        let limits = self.setup.motors.iter().map(|motor| {
            let pulse = if motor.both_edges { 0.0 } else { motor.pulse_s };
            Limits {
                error: self.options.error_s * self.frequency,
                least: ticks(motor.least_s.max(2.0 * pulse)).max(LEAST),
                turn: ticks(motor.turn_s + pulse).max(LEAST),
            }
        });
        limits.collect()
    }

    /// The watch of each output, ticks, and its value when off.
    fn watches(&self) -> Vec<(u64, u32)> {
        let ticks = |watch_s: &Option<f64>| (watch_s.unwrap_or(0.0) * self.frequency) as u64;
        let switched = |output: &Switched| (ticks(&output.watch_s), u32::from(output.pin.inverted));
        let off = |output: &Pulsed| if output.pin.inverted { self.pwm_max() } else { 0 };
        let pulsed = |output: &Pulsed| (ticks(&output.watch_s), off(output));
        let outputs = self.setup.outputs.iter().map(switched);
        outputs.chain(self.setup.pulsed.iter().map(pulsed)).collect()
    }
}
