//! A controller that is none: it reads lines and characters as the interface of grbl 1.1 is described, and
//! moves by a clock that is handed to it.
//!
//! It has what matters to whoever drives it: a receive buffer that overflows, a planner that looks ahead, a
//! row of step segments behind it, `ok` only when there was room, a hold that slows down and a reset that
//! loses the place when it comes too early.

mod motion;
mod read;

use kerf_machine::driver::Axes;
use motion::Motion;
use read::{Words, read};
use std::collections::{BTreeMap, VecDeque};

/// Bytes that its receive buffer holds.
const RX: usize = 128;

/// Time is followed in steps of this, seconds.
const STEP_S: f64 = 0.001;

/// Duration of homing, seconds.
const HOMING_S: f64 = 0.5;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Ready,
    Hold,
    Homing,
    Alarm,
}

/// A controller that is none.
#[derive(Clone, Debug)]
pub struct Fake {
    clock_s: f64,
    state: State,
    settings: BTreeMap<u16, f64>,
    motion: Motion,
    /// Received and not read.
    buffer: VecDeque<u8>,
    /// A line that waits until there is room, or until everything is made.
    waiting: Option<Words>,
    out: Vec<u8>,
    /// Place to which the lines lead.
    planned: Axes,
    feed_mm_min: f64,
    spindle: bool,
    spindle_rpm: f64,
    coolant: u8,
    homed_s: Option<f64>,
    /// Pins that are active.
    pins: String,
    /// Bytes that found no room.
    pub overflowed: usize,
    /// Lines that it read, for tests.
    pub lines: Vec<String>,
}

impl Default for Fake {
    fn default() -> Self {
        Self::new(&[])
    }
}

impl Fake {
    /// A controller that was just switched on, with some of its settings.
    pub fn new(settings: &[(u16, f64)]) -> Self {
        let usual = [
            (0, 10.0),
            (1, 25.0),
            (10, 1.0),
            (11, 0.01),
            (12, 0.002),
            (20, 0.0),
            (21, 0.0),
            (22, 0.0),
            (30, 24_000.0),
            (31, 0.0),
            (100, 250.0),
            (101, 250.0),
            (102, 250.0),
            (110, 6000.0),
            (111, 6000.0),
            (112, 3000.0),
            (120, 400.0),
            (121, 400.0),
            (122, 400.0),
            (130, 600.0),
            (131, 400.0),
            (132, 100.0),
        ];
        let mut fake = Self {
            clock_s: 0.0,
            state: State::Ready,
            settings: usual.into_iter().chain(settings.iter().copied()).collect(),
            motion: Motion::default(),
            buffer: VecDeque::new(),
            waiting: None,
            out: Vec::new(),
            planned: Axes::default(),
            feed_mm_min: 0.0,
            spindle: false,
            spindle_rpm: 0.0,
            coolant: 0,
            homed_s: None,
            pins: String::new(),
            overflowed: 0,
            lines: Vec::new(),
        };
        fake.start();
        fake
    }

    /// Returns the place of the machine.
    pub const fn position(&self) -> Axes {
        self.motion.position
    }

    /// Returns the speed of the spindle while it turns.
    pub const fn spindle(&self) -> Option<f64> {
        if self.spindle { Some(self.spindle_rpm) } else { None }
    }

    /// Returns the number of times it came to a stand on its way.
    pub const fn stands(&self) -> usize {
        self.motion.stands
    }

    /// The way it made, mm.
    pub const fn way_mm(&self) -> f64 {
        self.motion.way_mm
    }

    /// The places where it came to a stand.
    pub fn rests(&self) -> &[Axes] {
        &self.motion.rests
    }

    /// Somebody or something works its pins: the letters of a status report.
    pub fn pins(&mut self, pins: &str) {
        if self.pins != pins {
            pins.clone_into(&mut self.pins);
        }
    }

    /// A limit switch is hit: it stops at once.
    pub fn hits_limit(&mut self) {
        self.alarm(1);
    }

    fn start(&mut self) {
        let homes = self.settings.get(&22) == Some(&1.0) && self.homed_s.is_none();
        self.state = if homes || self.state == State::Alarm { State::Alarm } else { State::Ready };
        self.tell("");
        self.tell("Grbl 1.1h ['$' for help]");
        if self.state == State::Alarm {
            self.tell("[MSG:'$H'|'$X' to unlock]");
        }
    }

    fn tell(&mut self, line: &str) {
        self.out.extend_from_slice(line.as_bytes());
        self.out.extend_from_slice(b"\r\n");
    }

    /// Bytes come, at a time.
    pub fn hear(&mut self, bytes: &[u8], now_s: f64) {
        self.follow(now_s);
        for byte in bytes {
            match byte {
                b'?' if self.state != State::Homing => self.report(),
                b'?' => {}
                b'!' if self.state == State::Ready => {
                    self.state = State::Hold;
                    self.motion.held = true;
                }
                b'~' if self.state == State::Hold => {
                    self.state = State::Ready;
                    self.motion.held = false;
                }
                b'!' | b'~' => {}
                0x18 => self.reset(),
                _ if self.buffer.len() < RX => self.buffer.push_back(*byte),
                _ => self.overflowed += 1,
            }
        }
        self.read_on();
    }

    /// Returns what it sends up to a time.
    pub fn speak(&mut self, now_s: f64) -> Vec<u8> {
        self.follow(now_s);
        std::mem::take(&mut self.out)
    }

    fn follow(&mut self, now_s: f64) {
        while self.clock_s + STEP_S <= now_s {
            self.clock_s += STEP_S;
            self.motion.step(STEP_S);
            if self.homed_s.is_some_and(|at_s| self.state == State::Homing && self.clock_s >= at_s)
            {
                self.home();
            }
            self.read_on();
        }
    }

    fn home(&mut self) {
        self.state = State::Ready;
        self.planned = Axes::xyz(-1.0, -1.0, -1.0);
        self.motion.put(self.planned);
        self.tell("ok");
    }

    fn alarm(&mut self, number: u16) {
        self.state = State::Alarm;
        self.halt();
        self.tell(&format!("ALARM:{number}"));
        self.tell("[MSG:Reset to continue]");
    }

    fn halt(&mut self) {
        self.motion.clear();
        self.planned = self.motion.position;
        self.buffer.clear();
        self.waiting = None;
        (self.spindle, self.coolant) = (false, 0);
    }

    fn reset(&mut self) {
        let too_early = self.motion.speed_mm_s > 0.0 || self.state == State::Homing;
        self.halt();
        self.motion.held = false;
        if too_early {
            self.tell("ALARM:3");
            self.state = State::Alarm;
        } else if self.state == State::Hold {
            self.state = State::Ready;
        }
        self.start();
    }

    fn report(&mut self) {
        let doing = match self.state {
            State::Hold if self.motion.speed_mm_s > 0.0 => "Hold:1",
            State::Hold => "Hold:0",
            State::Alarm => "Alarm",
            State::Homing => "Home",
            State::Ready if self.motion.is_empty() => "Idle",
            State::Ready => "Run",
        };
        let [x, y, z, ..] = self.motion.position.0;
        let mut line = format!("<{doing}|MPos:{x:.3},{y:.3},{z:.3}");
        if self.settings.get(&10).is_some_and(|mask| *mask as u32 & 2 == 2) {
            line += &format!("|Bf:{},{}", self.motion.free(), RX - self.buffer.len());
        }
        line += &format!("|FS:{:.0},{:.0}", self.motion.speed_mm_s * 60.0, self.spindle_rpm);
        if !self.pins.is_empty() {
            line += &format!("|Pn:{}", self.pins);
        }
        self.tell(&(line + ">"));
    }

    /// Reads lines as long as there is room for what they ask for.
    fn read_on(&mut self) {
        loop {
            if let Some(words) = self.waiting.take() {
                if !self.has_room(&words) {
                    self.waiting = Some(words);
                    return;
                }
                self.make(&words);
            }
            if self.state == State::Homing {
                return;
            }
            let Some(end) = self.buffer.iter().position(|byte| *byte == b'\n') else { return };
            let bytes: Vec<u8> = self.buffer.drain(..=end).collect();
            self.line(String::from_utf8_lossy(&bytes).trim());
        }
    }

    fn line(&mut self, line: &str) {
        self.lines.push(line.to_owned());
        if let Some(command) = line.strip_prefix('$') {
            return self.dollar(command);
        }
        match read(line) {
            _ if self.state == State::Alarm && !line.is_empty() => self.tell("error:9"),
            Ok(words) => self.waiting = Some(words),
            Err(number) => self.tell(&format!("error:{number}")),
        }
    }

    fn dollar(&mut self, command: &str) {
        match command {
            "$" => {
                for (number, value) in self.settings.clone() {
                    self.tell(&format!("${number}={value:.3}"));
                }
                self.tell("ok");
            }
            "I" => {
                self.tell("[VER:1.1h.20190825:]");
                self.tell("[OPT:V,15,128]");
                self.tell("ok");
            }
            "H" if self.settings.get(&22) != Some(&1.0) => self.tell("error:5"),
            "H" => {
                self.state = State::Homing;
                self.homed_s = Some(self.clock_s + HOMING_S);
            }
            "X" => {
                self.state = State::Ready;
                self.tell("ok");
            }
            other => {
                let setting = other.split_once('=');
                let read: Option<(u16, f64)> =
                    setting.and_then(|(n, v)| Some((n.parse().ok()?, v.parse().ok()?)));
                self.settings.extend(read);
                self.tell(if read.is_some() { "ok" } else { "error:3" });
            }
        }
    }

    fn has_room(&self, words: &Words) -> bool {
        if words.waits { self.motion.is_empty() } else { self.motion.free() > 0 }
    }

    fn make(&mut self, words: &Words) {
        self.feed_mm_min = words.feed_mm_min.unwrap_or(self.feed_mm_min);
        self.spindle_rpm = words.spindle_rpm.unwrap_or(self.spindle_rpm);
        self.spindle = words.spindle.unwrap_or(self.spindle);
        match words.coolant {
            Some(0) => self.coolant = 0,
            Some(bit) => self.coolant |= bit,
            None => {}
        }
        if let Some(error) = self.go(words) {
            return self.tell(&format!("error:{error}"));
        }
        self.tell("ok");
    }

    fn go(&mut self, words: &Words) -> Option<u16> {
        if !words.moves {
            return None;
        }
        if self.feed_mm_min <= 0.0 {
            return Some(22);
        }
        let mut to = self.planned;
        for (axis, place) in words.to.iter().enumerate() {
            to.0[axis] = place.unwrap_or(to.0[axis]);
        }
        if self.settings.get(&20) == Some(&1.0) && self.is_outside(to) {
            self.alarm(2);
            return Some(15);
        }
        self.motion.push(self.planned, to, self.speed(to));
        self.planned = to;
        None
    }

    fn is_outside(&self, to: Axes) -> bool {
        let travel = |axis: u16| self.settings.get(&(130 + axis)).copied().unwrap_or(0.0);
        (0..3).any(|axis| to.0[axis as usize] > 0.0 || to.0[axis as usize] < -travel(axis))
    }

    /// The feed, as far as every axis can follow.
    fn speed(&self, to: Axes) -> f64 {
        let way = kerf_machine::driver::way_mm(self.planned, to);
        (0..3_u16).fold(self.feed_mm_min / 60.0, |speed, axis| {
            let share = (to.0[usize::from(axis)] - self.planned.0[usize::from(axis)]).abs() / way;
            let most = self.settings.get(&(110 + axis)).copied().unwrap_or(f64::INFINITY) / 60.0;
            if share > 0.0 { speed.min(most / share) } else { speed }
        })
    }
}
