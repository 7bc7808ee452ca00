//! A session with a board whose words are known: what it holds, and what comes and goes.

use super::inputs::Buttons;
use super::latch::Latches;
use super::learn::Learning;
use super::motion::Motion;
use super::news::{Fault, News};
use super::questions::{About, Questions};
use super::{Ended, Options};
use crate::clock::Clock;
use crate::dictionary::{Dictionary, Message};
use crate::link::{Heard, Link, Outgoing};
use crate::orders::{Order, OrderError, Orders};
use crate::queue::{Lead, Queue};
use crate::setup::{Configured, Setup};
use std::collections::VecDeque;
use std::sync::Arc;

/// Time without an acknowledgement after which a board counts as gone, seconds.
pub const SILENCE_S: f64 = 3.0;
/// Mark of a question for the clock.
const CLOCK: u32 = 1;
/// Mark of the last command that arms latches.
pub const ARMED: u32 = 2;
/// Time that a command may need on a line, with a resend: nothing is sent that is due sooner, seconds.
const TRANSIT_S: f64 = 0.01;

/// Bits of the upper half of a clock that are believed: 100 days at 520 MHz, and exact as a float.
const HIGH: u32 = 0xf_ffff;

/// Something that ends a session.
pub type Told = Result<(), Fault>;

/// A session.
pub struct Session {
    pub setup: Setup,
    pub options: Options,
    pub link: Link,
    pub dictionary: Arc<Dictionary>,
    pub orders: Orders,
    pub configured: Configured,
    /// Ticks a second as the board tells them.
    pub frequency: f64,
    pub clock: Option<Clock>,
    /// Moment at which a question for the clock went out, where it went out once.
    clock_sent_s: Option<f64>,
    pub questions: Questions,
    pub learning: Learning,
    pub motion: Motion,
    pub latches: Latches,
    pub queue: Queue,
    pub lead: Lead,
    /// Steps that each motor has made, as the board told last.
    pub counts: Vec<i64>,
    pub shutdown: bool,
    pub buttons: Buttons,
}

impl Session {
    pub fn new(
        setup: Setup,
        options: Options,
        mut link: Link,
        dictionary: Dictionary,
    ) -> Result<Self, Fault> {
        let orders = Orders::new(&dictionary);
        let configured = setup.commands(&dictionary, &orders)?;
        let frequency = dictionary.constant("CLOCK_FREQ").unwrap_or(1.0);
        if let Some(window) = dictionary.constant("RECEIVE_WINDOW") {
            link.limit(window as usize);
        }
        let mut session = Self {
            latches: Latches::new(setup.switches.len() + 1),
            counts: vec![0; setup.motors.len()],
            queue: Queue::new(Vec::new(), &[], 0),
            lead: Lead::new(frequency),
            buttons: Buttons::default(),
            clock: None,
            clock_sent_s: None,
            questions: Questions::default(),
            learning: Learning::Asked,
            motion: Motion::Rest,
            shutdown: false,
            setup,
            options,
            link,
            dictionary: Arc::new(dictionary),
            orders,
            configured,
            frequency,
        };
        session.ask(About::Uptime, Order::Uptime, [])?;
        Ok(session)
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

    /// Sends a command that is of no use once motion is dropped.
    pub fn send_motion<const N: usize>(
        &mut self,
        order: Order,
        numbers: [u32; N],
    ) -> Result<(), OrderError> {
        let command = self.orders.write(order, numbers)?;
        let sent = self.link.send_motion(command);
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

    pub fn receive(&mut self, bytes: &[u8], now_s: f64, news: &mut VecDeque<News>) -> Told {
        for heard in self.link.receive(bytes, now_s) {
            match heard {
                Heard::Delivered { mark: CLOCK, sent_s, once } => {
                    self.clock_sent_s = once.then_some(sent_s);
                }
                Heard::Delivered { mark: ARMED, .. } => self.armed(),
                Heard::Delivered { .. } => {}
                Heard::Message(bytes) => self.message(&bytes, now_s, news)?,
            }
        }
        Ok(())
    }

    pub fn transmit(&mut self, now_s: f64, news: &mut VecDeque<News>) -> Result<Outgoing, Fault> {
        if self.link.silent_s(now_s) > SILENCE_S {
            return Err(Fault::Silent);
        }
        if self.clock.as_mut().is_some_and(|clock| clock.asks(now_s)) {
            let command = self.orders.write(Order::Clock, [])?;
            self.push(command, Some(CLOCK))?;
        }
        self.learn(now_s, news)?;
        self.move_on(now_s)?;
        match self.questions.due(now_s) {
            Ok(commands) => {
                commands.into_iter().try_for_each(|command| self.push(command, None))?
            }
            Err(about) => return Err(Fault::Unanswered(about.name())),
        }
        Ok(self.link.transmit(now_s))
    }

    pub fn due_s(&self) -> f64 {
        let clock_s = self.clock.as_ref().map_or(f64::INFINITY, Clock::due_s);
        self.link.due_s().min(clock_s).min(self.questions.due_s()).min(self.motion_due_s())
    }

    /// Longest stall of the host that was seen, and the lead, seconds.
    pub fn lead_s(&self) -> [f64; 2] {
        [self.lead.stall_s(), self.lead.full_s()]
    }

    fn message(&mut self, bytes: &[u8], now_s: f64, news: &mut VecDeque<News>) -> Told {
        let dictionary = Arc::clone(&self.dictionary);
        // One that is unknown was meant for others, or for people.
        let Some(message) = dictionary.message(bytes) else { return Ok(()) };
        self.hear(&message, now_s, news)?;
        match reason(&dictionary, &message) {
            Some(reason) => self.shut_down(reason, news),
            None => Ok(()),
        }
    }

    fn hear(&mut self, message: &Message<'_>, now_s: f64, news: &mut VecDeque<News>) -> Told {
        let number = |field| message.number(field).unwrap_or_default();
        match message.name() {
            "starting" => return Err(Fault::Restarted),
            "uptime" if self.questions.answered(About::Uptime) => {
                let high = u64::from(number("high") & HIGH);
                let uptime = high << 32 | u64::from(number("clock"));
                self.clock = Some(Clock::new(self.frequency, uptime, now_s));
                self.ask(About::Config, Order::Config, [])?;
            }
            "clock" => {
                if let (Some(sent_s), Some(clock)) = (self.clock_sent_s.take(), &mut self.clock) {
                    clock.heard(sent_s, now_s, number("clock"));
                }
            }
            "config" if self.questions.answered(About::Config) => self.told_config(message)?,
            "stepper_position" => self.told_position(number("oid"), number("pos") as i32, news)?,
            "trsync_state" => self.told_latch(message)?,
            "endstop_state" => {
                self.told_switch(message, news);
                self.counted(news)?;
            }
            "buttons_state" => self.told_buttons(message, news)?,
            "analog_in_state" => self.told_voltage(message, news),
            "tmcuart_response" => self.told_register(message, news),
            _ => {}
        }
        Ok(())
    }

    /// The board has shut down: all that it had is dropped.
    fn shut_down(&mut self, reason: String, news: &mut VecDeque<News>) -> Told {
        if self.learning != Learning::Ready {
            return Err(Fault::ShutDown(reason));
        }
        if std::mem::replace(&mut self.shutdown, true) {
            return Ok(());
        }
        self.link.forget();
        self.questions.clear();
        self.queue.shut_down();
        self.latches.disarmed();
        self.motion = Motion::Rest;
        news.push_back(News::Shutdown(reason));
        Ok(())
    }

    /// Clears a shutdown, and reads the counts.
    pub fn clear(&mut self) -> Result<(), OrderError> {
        self.send(Order::ClearShutdown, [])?;
        self.shutdown = false;
        self.read_counts(Ended::Shutdown)
    }
}

/// The reason of a shutdown in words, where a message tells one.
fn reason(dictionary: &Dictionary, message: &Message<'_>) -> Option<String> {
    let told = ["shutdown", "is_shutdown"].contains(&message.name());
    let number = message.number("static_string_id").filter(|_| told)?;
    let word = dictionary.word("static_string_id", number);
    Some(word.map_or_else(|| format!("reason {number}"), str::to_owned))
}
