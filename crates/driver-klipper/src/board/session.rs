//! A session with a board whose words are known: what it holds, and what comes and goes.

use super::channel::{ARMED, CLOCK, Channel, Told};
use super::drivers::Drivers;
use super::inputs::Buttons;
use super::learn::{self, Learning};
use super::motion::{Motion, ask_counts};
use super::news::{Fault, News};
use super::options::Options;
use super::questions::About;
use crate::clock::Clock;
use crate::dictionary::{Dictionary, Message};
use crate::link::{Heard, Link, Outgoing};
use crate::orders::{Order, Orders};
use crate::setup::{Configured, Setup};
use std::collections::VecDeque;
use std::sync::Arc;

/// Time without an acknowledgement after which a board counts as gone, seconds.
pub const SILENCE_S: f64 = 3.0;

/// Answers from before the configuration that are borne.
const STALE: u32 = 8;

/// Bits of the upper half of a clock that are believed: 100 days at 520 MHz, and exact as a float.
const HIGH: u32 = 0xf_ffff;

/// A session.
pub struct Session {
    pub channel: Channel,
    pub motion: Motion,
    pub shutdown: bool,
    configured: Configured,
    learning: Learning,
    /// The reason of a shutdown from before the session that is being cleared, and how many answers from before have come.
    clearing: Option<(String, u32)>,
    buttons: Buttons,
    pub drivers: Drivers,
}

impl Session {
    pub fn new(
        setup: Setup,
        options: Options,
        link: Link,
        dictionary: Dictionary,
    ) -> Result<Self, Fault> {
        let orders = Orders::new(&dictionary);
        let configured = setup.commands(&dictionary, &orders)?;
        let mut channel = Channel::new(setup, options, link, dictionary, orders);
        channel.ask(About::Uptime, Order::Uptime, [])?;
        Ok(Self {
            motion: Motion::new(&channel),
            channel,
            shutdown: false,
            configured,
            learning: Learning::Asked,
            clearing: None,
            buttons: Buttons::default(),
            drivers: Drivers::default(),
        })
    }

    pub fn receive(&mut self, bytes: &[u8], now_s: f64, news: &mut VecDeque<News>) -> Told {
        for heard in self.channel.link.receive(bytes, now_s) {
            match heard {
                Heard::Delivered { mark: CLOCK, sent_s, once } => {
                    self.channel.clock_asked(sent_s, once);
                }
                Heard::Delivered { mark: ARMED, .. } => self.motion.armed(),
                Heard::Delivered { .. } => {}
                Heard::Message(bytes) => self.message(&bytes, now_s, news)?,
                Heard::OutOfTurn(bytes) => self.begins_anew(&bytes)?,
            }
        }
        Ok(())
    }

    pub fn transmit(&mut self, now_s: f64, news: &mut VecDeque<News>) -> Result<Outgoing, Fault> {
        if self.channel.link.silent_s(now_s) > SILENCE_S {
            return Err(Fault::Silent);
        }
        self.channel.ask_clock(now_s)?;
        self.learn(now_s, news)?;
        if self.is_ready() && !self.shutdown {
            self.motion.move_on(&mut self.channel, now_s)?;
        }
        let asked = self.channel.questions.due(now_s);
        let asked = asked.map_err(|about| Fault::Unanswered(about.name()))?;
        asked.into_iter().try_for_each(|command| self.channel.push(command, None))?;
        Ok(self.channel.link.transmit(now_s))
    }

    pub fn due_s(&self) -> f64 {
        let Channel { link, clock, questions, .. } = &self.channel;
        let clock_s = clock.as_ref().map_or(f64::INFINITY, Clock::due_s);
        let motion_s = if self.is_ready() { self.motion.due_s() } else { f64::INFINITY };
        let asked_s = questions.due_s().min(self.drivers.due_s());
        link.due_s().min(clock_s).min(asked_s).min(motion_s)
    }

    pub fn is_ready(&self) -> bool {
        self.learning == Learning::Ready
    }

    fn message(&mut self, bytes: &[u8], now_s: f64, news: &mut VecDeque<News>) -> Told {
        let dictionary = Arc::clone(&self.channel.dictionary);
        // One that is unknown was meant for others, or for people.
        let Some(message) = dictionary.message(bytes) else { return Ok(()) };
        self.hear(&message, now_s, news)?;
        match reason(&dictionary, &message) {
            Some(reason) => self.shut_down(reason, news),
            None => Ok(()),
        }
    }

    /// Looks at a message that fits no number: a board that begins anew counts from 0.
    fn begins_anew(&self, bytes: &[u8]) -> Told {
        let message = self.channel.dictionary.message(bytes);
        if message.is_some_and(|it| it.name() == "starting") {
            return Err(Fault::Restarted);
        }
        Ok(())
    }

    fn hear(&mut self, message: &Message<'_>, now_s: f64, news: &mut VecDeque<News>) -> Told {
        let number = |field| message.number(field).unwrap_or_default();
        let channel = &mut self.channel;
        match message.name() {
            "starting" => return Err(Fault::Restarted),
            "uptime" if channel.questions.answered(About::Uptime) => {
                let high = u64::from(number("high") & HIGH);
                let uptime = high << 32 | u64::from(number("clock"));
                channel.clock = Some(Clock::new(channel.frequency, uptime, now_s));
                channel.ask(About::Config, Order::Config, [])?;
            }
            "clock" => channel.told_clock(now_s, number("clock")),
            "config" if channel.questions.answered(About::Config) => self.told_config(message)?,
            "stepper_position" => {
                self.motion.told_position(channel, (number("oid"), number("pos") as i32), news)?;
            }
            "trsync_state" => {
                if let Some(why) = self.motion.latches.told(channel, message) {
                    self.motion.stopped(channel, why)?;
                }
            }
            "endstop_state" => {
                channel.told_switch(&self.motion, message, news);
                self.motion.counted(channel, news)?;
            }
            "buttons_state" => self.buttons.told(channel, message, news)?,
            "analog_in_state" => channel.told_voltage(message, news),
            "tmcuart_response" => {
                if let Some((driver, register, value)) = channel.told_register(message)
                    && !self.drivers.told_wire(channel, (driver, register), value)?
                {
                    news.push_back(News::Register { driver, register, value });
                }
            }
            "spi_transfer_response" => {
                if let Some((select, value)) = channel.told_transfer(message) {
                    self.drivers.told_select(channel, select, value)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Clears a shutdown from before the session, once and where that is wanted. A board that is told so twice shuts down.
    fn clear_at_first(&mut self, reason: String) -> Told {
        if self.clearing.is_some() {
            // The refusal of a command from before.
            return self.is_stale();
        }
        let channel = &mut self.channel;
        if !std::mem::take(&mut channel.options.clears) {
            return Err(Fault::ShutDown(reason));
        }
        self.clearing = Some((reason, 0));
        channel.questions.clear();
        channel.send(Order::ClearShutdown, [])?;
        if channel.clock.is_none() {
            channel.ask(About::Uptime, Order::Uptime, [])?;
        }
        Ok(channel.ask(About::Config, Order::Config, [])?)
    }

    /// An answer from before the shutdown was cleared, which is borne: on a bad line a question is asked twice.
    fn is_stale(&mut self) -> Told {
        match &mut self.clearing {
            Some((_, stale)) if *stale < STALE => *stale += 1,
            Some((reason, _)) => return Err(Fault::ShutDown(std::mem::take(reason))),
            None => {}
        }
        Ok(())
    }

    /// Reads the state of the configuration.
    fn told_config(&mut self, message: &Message<'_>) -> Told {
        let number = |field| message.number(field).unwrap_or_default();
        if number("is_shutdown") != 0 {
            if self.clearing.is_some() {
                self.is_stale()?;
                return Ok(self.channel.ask(About::Config, Order::Config, [])?);
            }
            // A command that is refused tells the reason.
            return Ok(self.channel.ask(About::Position(0), Order::Position, [0])?);
        }
        self.clearing = None;
        let crc = self.configured.crc;
        match (number("is_config") != 0, number("crc") == crc, self.learning) {
            (true, true, _) => self.configured(number("move_count") as usize),
            (true, false, _) => Err(Fault::Foreign(number("crc"))),
            (false, _, Learning::Asked) => {
                learn::configure(&mut self.channel, &self.configured)?;
                self.learning = Learning::Configured(0);
                Ok(self.channel.ask(About::Config, Order::Config, [])?)
            }
            // The answer to a question from before, which was asked twice on a bad line.
            (false, _, Learning::Configured(stale)) if stale < STALE => {
                self.learning = Learning::Configured(stale + 1);
                Ok(self.channel.ask(About::Config, Order::Config, [])?)
            }
            (false, ..) => Err(Fault::Configuration),
        }
    }

    /// The board has this machine's configuration: it is put at rest, whatever a former session left.
    fn configured(&mut self, places: usize) -> Told {
        self.motion.queue = learn::queue(&self.channel, places);
        if self.learning == Learning::Asked {
            learn::put_at_rest(&mut self.channel)?;
            self.motion.queue.put_off();
        }
        self.learning = Learning::Counts;
        Ok(ask_counts(&mut self.channel)?)
    }

    /// Tells that the board is ready, once its clock and its counts are known.
    fn learn(&mut self, now_s: f64, news: &mut VecDeque<News>) -> Told {
        let channel = &mut self.channel;
        if channel.clock.as_ref().is_some_and(Clock::is_vain) {
            return Err(Fault::Unanswered("get_clock"));
        }
        let counting = channel.questions.has(|about| matches!(about, About::Position(_)));
        self.drivers.go_on(channel, now_s)?;
        news.extend(self.drivers.troubles().into_iter().map(News::Driver));
        if self.learning == Learning::Counts && !counting {
            self.drivers.tune(&channel.setup.tuned)?;
            self.learning = Learning::Drivers;
        }
        if self.learning != Learning::Drivers || !self.drivers.is_done() {
            return Ok(());
        }
        let Some((clock, _)) = channel.now(now_s) else { return Ok(()) };
        self.learning = Learning::Ready;
        self.buttons.look(channel, clock)?;
        let version = channel.dictionary.version().to_owned();
        news.push_back(News::Ready { version, counts: self.motion.counts.clone() });
        Ok(())
    }

    /// The board has shut down: all that it had is dropped.
    fn shut_down(&mut self, reason: String, news: &mut VecDeque<News>) -> Told {
        if self.learning != Learning::Ready {
            return self.clear_at_first(reason);
        }
        if std::mem::replace(&mut self.shutdown, true) {
            return Ok(());
        }
        self.channel.link.forget();
        self.channel.questions.clear();
        self.drivers.forget();
        self.motion.shut_down();
        news.push_back(News::Shutdown(reason));
        Ok(())
    }
}

/// The reason of a shutdown in words, where a message tells one.
fn reason(dictionary: &Dictionary, message: &Message<'_>) -> Option<String> {
    let told = ["shutdown", "is_shutdown"].contains(&message.name());
    let number = message.number("static_string_id").filter(|_| told)?;
    let word = dictionary.word("static_string_id", number);
    Some(word.map_or_else(|| format!("reason {number}"), str::to_owned))
}
