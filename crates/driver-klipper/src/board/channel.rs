//! The way to a board whose words are known: what is sent, what is asked, and its clock.

use super::news::Fault;
use super::options::Options;
use super::questions::{About, Questions};
use crate::clock::Clock;
use crate::dictionary::Dictionary;
use crate::link::Link;
use crate::orders::{Order, OrderError, Orders};
use crate::setup::{Object, Setup};
use std::sync::Arc;

/// Mark of a question for the clock.
pub const CLOCK: u32 = 1;
/// Mark of the last command that arms latches.
pub const ARMED: u32 = 2;
/// Time that a command may need on a line, with a resend: nothing is sent that is due sooner, seconds.
const TRANSIT_S: f64 = 0.01;

/// Something that ends a session.
pub type Told = Result<(), Fault>;

/// The way to a board.
pub struct Channel {
    pub setup: Setup,
    pub options: Options,
    pub link: Link,
    pub dictionary: Arc<Dictionary>,
    pub orders: Orders,
    /// Ticks a second as the board tells them.
    pub frequency: f64,
    pub clock: Option<Clock>,
    /// Moment at which a question for the clock went out, where it went out once.
    clock_sent_s: Option<f64>,
    pub questions: Questions,
    /// Ticks between two measurements of each voltage.
    pub rests: Vec<u64>,
}

impl Channel {
    pub fn new(
        setup: Setup,
        options: Options,
        mut link: Link,
        dictionary: Dictionary,
        orders: Orders,
    ) -> Self {
        if let Some(window) = dictionary.constant("RECEIVE_WINDOW") {
            link.limit(window as usize);
        }
        // A board on USB has none.
        if let Some(baud) = dictionary.constant("SERIAL_BAUD") {
            link.paces(baud);
        }
        Self {
            frequency: dictionary.constant("CLOCK_FREQ").unwrap_or(1.0),
            clock: None,
            clock_sent_s: None,
            questions: Questions::default(),
            rests: vec![0; setup.voltages.len()],
            setup,
            options,
            link,
            dictionary: Arc::new(dictionary),
            orders,
        }
    }

    /// Number of an object in the board.
    pub fn oid(&self, object: Object) -> u32 {
        self.setup.oid(object)
    }

    /// Ticks of a time, seconds.
    pub fn ticks(&self, time_s: f64) -> u64 {
        (time_s * self.frequency) as u64
    }

    /// Asks a question until it is answered.
    pub fn ask<const N: usize>(
        &mut self,
        about: About,
        order: Order,
        numbers: [u32; N],
    ) -> Result<(), OrderError> {
        let command = self.orders.write(order, numbers)?;
        self.questions.ask(about, command);
        Ok(())
    }

    /// Sends a command behind all others.
    pub fn send<const N: usize>(
        &mut self,
        order: Order,
        numbers: [u32; N],
    ) -> Result<(), OrderError> {
        let command = self.orders.write(order, numbers)?;
        self.push(command, None)
    }

    /// Sends a command that was written. The encoder has seen to its length.
    pub fn push(&mut self, command: Vec<u8>, mark: Option<u32>) -> Result<(), OrderError> {
        let sent = self.link.send(command, mark);
        debug_assert!(sent, "no command is longer than a frame");
        Ok(())
    }

    /// Sends a command that is of no use once motion is dropped, with the clock of its first step.
    pub fn send_motion<const N: usize>(
        &mut self,
        order: Order,
        numbers: [u32; N],
        clock: u64,
    ) -> Result<(), OrderError> {
        let command = self.orders.write(order, numbers)?;
        let sent = self.link.send_motion(command, clock);
        debug_assert!(sent, "no command is longer than a frame");
        Ok(())
    }

    /// Sends a command before those that wait.
    pub fn hurry<const N: usize>(
        &mut self,
        order: Order,
        numbers: [u32; N],
    ) -> Result<(), OrderError> {
        let command = self.orders.write(order, numbers)?;
        let sent = self.link.send_urgent(command, None);
        debug_assert!(sent, "no command is longer than a frame");
        Ok(())
    }

    /// Clock of the board now, and the farthest that it may be off, with the time that a command needs, ticks.
    pub fn now(&self, now_s: f64) -> Option<(u64, u64)> {
        let clock = self.clock.as_ref().filter(|clock| clock.is_known())?;
        let off_s = clock.off_s() + TRANSIT_S;
        Some((clock.at(now_s).max(0.0) as u64, (off_s * self.frequency) as u64))
    }

    /// A question for the clock was run.
    pub const fn clock_asked(&mut self, sent_s: f64, once: bool) {
        self.clock_sent_s = if once { Some(sent_s) } else { None };
    }

    /// The board told its clock.
    pub fn told_clock(&mut self, now_s: f64, clock: u32) {
        let Some(line) = &mut self.clock else { return };
        match self.clock_sent_s.take() {
            Some(sent_s) => line.heard(sent_s, now_s, clock),
            None => line.told(clock),
        }
    }

    /// Returns `true` once the board itself told a clock behind this one. Until then it is asked soon and again: a board
    /// that was kept waiting is behind the estimate of its clock.
    pub fn has_passed(&mut self, clock: u64) -> bool {
        let Some(line) = &mut self.clock else { return false };
        let passed = line.newest() > clock;
        if !passed {
            line.hurry();
        }
        passed
    }

    /// Asks for the clock when it is time to.
    pub fn ask_clock(&mut self, now_s: f64) -> Result<(), OrderError> {
        if self.clock.as_mut().is_some_and(|clock| clock.asks(now_s)) {
            let command = self.orders.write(Order::Clock, [])?;
            self.push(command, Some(CLOCK))?;
        }
        Ok(())
    }

    pub fn pwm_max(&self) -> u32 {
        self.dictionary.constant("PWM_MAX").unwrap_or(255.0) as u32
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
}
