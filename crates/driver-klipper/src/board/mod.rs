//! One board, from the first byte to the last: joined, identified, configured, moved, stopped.
//!
//! ```text
//!  joining ─► identifying ─► learning ─► (configuring) ─► ready ◄────────┐
//!                                                          │ start       │ counts are read
//!                                              arming ─► moving ─► ending ─► reading
//!                 shutdown, restart, silence: told from each state, and nothing moves by itself
//! ```

mod acts;
mod channel;
mod drivers;
mod greeting;
mod inputs;
mod introduction;
mod latch;
mod learn;
mod motion;
mod news;
mod options;
mod questions;
mod session;

pub use acts::FIRST_S;
pub use introduction::{Held, Introduced, Introduction};
pub use latch::{Holds, Home, Watched};
pub use news::{Ended, Fault, Measured, News, NotNow, Start};
pub use options::Options;

use crate::clock::Clock;
use crate::link::Outgoing;
use crate::queue::{Piece, Refused};
use crate::setup::Setup;
use greeting::Greeting;
use session::Session;
use std::collections::VecDeque;

/// The state of a session.
enum Phase {
    Greeting(Greeting),
    Open(Box<Session>),
    Over,
}

/// A board and what hangs on it. Moments are seconds on the owner's clock, which never goes back.
pub struct Board {
    setup: Setup,
    options: Options,
    phase: Phase,
    news: VecDeque<News>,
}

impl Board {
    /// Begins to look for a board.
    pub fn new(setup: Setup, options: Options, now_s: f64) -> Self {
        let (phase, news) = (Phase::Greeting(Greeting::new(now_s)), VecDeque::new());
        Self { setup, options, phase, news }
    }

    /// Reads bytes that came.
    pub fn receive(&mut self, bytes: &[u8], now_s: f64) {
        let next = match &mut self.phase {
            Phase::Greeting(greeting) => greeting.receive(bytes, now_s).transpose().map(|found| {
                let (link, dictionary) = found?;
                Session::new(self.setup.clone(), self.options, link, dictionary)
                    .map(|open| Phase::Open(Box::new(open)))
            }),
            Phase::Open(open) => open.receive(bytes, now_s, &mut self.news).err().map(Err),
            Phase::Over => None,
        };
        match next {
            Some(Ok(phase)) => self.phase = phase,
            Some(Err(fault)) => self.over(fault),
            None => {}
        }
    }

    /// Returns the bytes to be written now.
    pub fn transmit(&mut self, now_s: f64) -> Outgoing {
        let written = match &mut self.phase {
            Phase::Greeting(greeting) => greeting.transmit(now_s),
            Phase::Open(open) => open.transmit(now_s, &mut self.news),
            Phase::Over => Ok(Outgoing::default()),
        };
        written.unwrap_or_else(|fault| {
            self.over(fault);
            Outgoing::default()
        })
    }

    /// Returns the moment at which [`transmit`](Self::transmit) has something to do, if nothing comes before.
    pub fn due_s(&self) -> f64 {
        match &self.phase {
            Phase::Greeting(greeting) => greeting.due_s(),
            Phase::Open(open) => open.due_s(),
            Phase::Over => f64::INFINITY,
        }
    }

    /// Takes the oldest news.
    pub fn news(&mut self) -> Option<News> {
        self.news.pop_front()
    }

    /// Motion begins, from rest: the latches are armed, and pieces may be offered. Switches of `homes` stop their
    /// motors.
    ///
    /// # Errors
    ///
    /// The board cannot be moved now.
    pub fn start(&mut self, homes: &[Home], now_s: f64) -> Result<Start, NotNow> {
        self.open()?.start(homes, now_s)
    }

    /// The same, at a clock that the owner chose, some tenths of a second ahead: with other boards.
    ///
    /// # Errors
    ///
    /// The board cannot be moved now.
    pub fn start_at(&mut self, holds: &Holds, clock: u64, now_s: f64) -> Result<Start, NotNow> {
        self.open()?.start_at(holds, clock, now_s)
    }

    /// Motion could begin.
    ///
    /// # Errors
    ///
    /// The reason for which it cannot.
    pub fn may_start(&self) -> Result<(), NotNow> {
        self.shown().ok_or(NotNow::Absent)?.may_start()
    }

    /// Pieces of motion are taken: it goes on, and is not on its way to rest.
    pub fn takes_pieces(&self) -> bool {
        self.shown().is_some_and(Session::takes_pieces)
    }

    /// Takes back the piece that was offered last, in the same moment: another board does not make its part of it.
    pub fn take_back(&mut self) {
        if let Phase::Open(open) = &mut self.phase {
            open.motion.queue.take_back();
        }
    }

    /// The switch of a home, counted as at the start of motion, was touched.
    pub fn has_touched(&self, home: usize) -> bool {
        self.shown().is_some_and(|open| open.motion.latches.has_touched(home))
    }

    /// Every switch that stops motors of its own was touched; nothing where no motor has one.
    pub fn is_sought(&self) -> Option<bool> {
        let latches = &self.shown()?.motion.latches;
        (!latches.holds.is_empty()).then(|| latches.is_sought())
    }

    /// A switch of another board was touched: its motors here stop.
    ///
    /// # Errors
    ///
    /// The board is not there.
    pub fn touch_away(&mut self, away: usize) -> Result<(), NotNow> {
        let Session { motion, channel, .. } = self.open()?;
        motion.latches.touch_away(channel, away).map_err(NotNow::Order)
    }

    /// From now on these switches stop all motors that no switch of their own does, and no others: at the beginning of
    /// motion, or soon where it goes on. Each stops them whenever it is as watched for, be it from the first look on.
    ///
    /// # Errors
    ///
    /// The board is not ready.
    pub fn watch(&mut self, watched: &[Watched], now_s: f64) -> Result<(), NotNow> {
        self.open()?.watch(watched, now_s)
    }

    /// Nothing moves, and motion could begin.
    pub fn is_at_rest(&self) -> bool {
        self.shown().is_some_and(Session::is_at_rest)
    }

    /// Motion goes on, or is about to.
    pub fn is_moving(&self) -> bool {
        self.shown().is_some_and(|open| open.motion.moves())
    }

    /// Motion was broken off: by the host, a switch, a deadline, a shutdown, or the end of the session.
    pub fn is_stopping(&self) -> bool {
        self.stops().is_some()
    }

    /// The reason for which motion is broken off, while it is.
    pub fn stops(&self) -> Option<Ended> {
        self.shown().map_or(Some(Ended::Deadline), Session::stops)
    }

    /// Deadlines are pushed along no more, because another board of the machine is lost, or again.
    pub fn let_expire(&mut self, expires: bool) {
        if let Phase::Open(open) = &mut self.phase {
            open.motion.latches.let_expire(expires);
        }
    }

    /// Seconds for which the board has not been heard.
    pub fn unheard_s(&self, now_s: f64) -> f64 {
        self.shown().map_or(f64::INFINITY, |open| now_s - open.channel.link.heard_s())
    }

    /// The board's clock, once it is known.
    pub fn line(&self) -> Option<&Clock> {
        self.shown()?.channel.clock.as_ref().filter(|clock| clock.is_known())
    }

    /// Takes a piece of motion behind those that it has.
    ///
    /// # Errors
    ///
    /// It does not follow, or cannot be made. Nothing of it is taken.
    pub fn offer(&mut self, piece: &Piece) -> Result<(), Refused> {
        match &mut self.phase {
            Phase::Open(open) => open.offer(piece),
            _ => Err(Refused::Stopping),
        }
    }

    /// Takes back what has not been sent, and returns the clock from which other pieces may follow: the way to slow
    /// down on the path.
    ///
    /// # Errors
    ///
    /// Nothing moves.
    pub fn withdraw(&mut self) -> Result<u64, NotNow> {
        self.open()?.withdraw()
    }

    /// Stops all motors at once, without a ramp. Their counts are told when they are known.
    ///
    /// # Errors
    ///
    /// The board is not there.
    pub fn stop(&mut self) -> Result<(), NotNow> {
        self.stop_as(Ended::Asked)
    }

    /// The same, for a reason of another board: outputs stay as they are where a switch was touched there.
    ///
    /// # Errors
    ///
    /// The board is not there.
    pub fn stop_as(&mut self, why: Ended) -> Result<(), NotNow> {
        self.open()?.stop(why).map_err(NotNow::Order)
    }

    /// Motion that is over is ended and counted, and latches are disarmed without waiting for more of it.
    pub fn let_rest(&mut self) {
        if let Phase::Open(open) = &mut self.phase {
            open.motion.lingers = false;
        }
    }

    /// Shuts the board down: motors stand, outputs go off.
    ///
    /// # Errors
    ///
    /// The board is not there.
    pub fn emergency_stop(&mut self) -> Result<(), NotNow> {
        self.open()?.emergency_stop().map_err(NotNow::Order)
    }

    /// Goes on after a shutdown. Counts are read; they are those of pulses, and a motor that was stopped at speed may
    /// have slipped.
    ///
    /// # Errors
    ///
    /// The board is not there, or not shut down.
    pub fn recover(&mut self) -> Result<(), NotNow> {
        self.open()?.recover()
    }

    /// Sets an output, counted as in the setup: those that go on and off, then those with a share of time; from 0 (off)
    /// to 1.
    ///
    /// # Errors
    ///
    /// The board is not ready.
    pub fn set_output(&mut self, output: usize, share: f64, now_s: f64) -> Result<(), NotNow> {
        self.open()?.set_output(output, share, now_s)
    }

    /// Value of an output as the board takes it, for a share from 0 (off) to 1; nothing before the board is known.
    pub fn output_value(&self, output: usize, share: f64) -> Option<u32> {
        self.shown().map(|open| open.channel.output_value(output, share))
    }

    /// Asks for the state of a switch.
    ///
    /// # Errors
    ///
    /// The board is not there.
    pub fn ask_switch(&mut self, switch: usize) -> Result<(), NotNow> {
        self.open()?.way().ask_switch(switch).map_err(NotNow::Order)
    }

    /// Asks for a register of a motor driver.
    ///
    /// # Errors
    ///
    /// The board is not there, or has no such wire.
    pub fn ask_register(&mut self, driver: usize, address: u8, register: u8) -> Result<(), NotNow> {
        self.open()?.way().ask_register(driver, address, register).map_err(NotNow::Order)
    }

    /// Writes a register of a motor driver. Nothing tells that it came: ask for it.
    ///
    /// # Errors
    ///
    /// The board is not there, or has no such wire.
    pub fn write_register(
        &mut self,
        driver: usize,
        address: u8,
        register: u8,
        value: u32,
    ) -> Result<(), NotNow> {
        self.open()?.way().write_register(driver, address, register, value).map_err(NotNow::Order)
    }

    /// Looks at the condition of all motor drivers. What is wrong is told as news.
    ///
    /// # Errors
    ///
    /// The board is not ready.
    pub fn check_drivers(&mut self) -> Result<(), NotNow> {
        self.open()?.check_drivers()
    }

    /// Measures a voltage again and again, every so many seconds, or no more.
    ///
    /// # Errors
    ///
    /// The board is not ready.
    pub fn measure(
        &mut self,
        voltage: usize,
        every_s: Option<f64>,
        now_s: f64,
    ) -> Result<(), NotNow> {
        self.open()?.way().measure(voltage, every_s, now_s)
    }

    /// Clock of the board at a moment, and the farthest that it may be off, ticks; nothing before it is known.
    pub fn clock(&self, now_s: f64) -> Option<(u64, u64)> {
        self.shown()?.channel.now(now_s)
    }

    /// Count of a motor at a clock that is not long past, if it made all that it was told.
    pub fn count_at(&self, motor: usize, clock: u64) -> Option<i64> {
        self.shown()?.motion.queue.count_at(motor, clock)
    }

    /// Shortest time by which a step was sent before it was due, seconds; nothing before one was.
    pub fn latest_s(&self) -> Option<f64> {
        let open = self.shown()?;
        Some(open.motion.queue.latest()? as f64 / open.channel.frequency)
    }

    /// Smoothed round trip of the line and its deviation, seconds.
    pub fn trip_s(&self) -> Option<[f64; 2]> {
        self.shown()?.channel.link.trip_s()
    }

    /// Longest stall of the host that was seen, and the lead that follows from it, seconds.
    pub fn lead_s(&self) -> Option<[f64; 2]> {
        self.shown().map(|open| open.lead_s())
    }

    fn open(&mut self) -> Result<&mut Session, NotNow> {
        match &mut self.phase {
            Phase::Open(open) => Ok(open),
            _ => Err(NotNow::Absent),
        }
    }

    fn shown(&self) -> Option<&Session> {
        match &self.phase {
            Phase::Open(open) => Some(open),
            _ => None,
        }
    }

    fn over(&mut self, fault: Fault) {
        self.phase = Phase::Over;
        self.news.push_back(News::Fault(fault));
    }
}
