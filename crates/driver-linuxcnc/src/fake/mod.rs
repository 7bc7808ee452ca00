//! A fake bridge, with a fake LinuxCNC behind it: it reads lines as the bridge does, and moves by a clock
//! that is handed to it.
//!
//! It has what matters to whoever drives it: numbered lines with check numbers, pieces that are made one at a time, a
//! program that stops where it is paused or aborted, a panel at which somebody presses something.

mod motion;
mod program;

use crate::check;
use kerf_machine::driver::{Axes, Offsets, Zero};
use motion::Motion;
use program::{Step, read};
use std::collections::VecDeque;

/// Time is followed in steps of this, seconds.
const STEP_S: f64 = 0.001;

/// Interval of its statuses, seconds.
const TELL_S: f64 = 0.02;

/// Time that opening a program takes, seconds.
const OPENING_S: f64 = 0.08;

/// Duration of homing, seconds.
const HOMING_S: f64 = 0.5;

/// What it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Doing {
    Idle,
    Run,
    Homing,
    Unlocking,
    Stopping,
    Stopped,
}

/// A fake bridge.
#[derive(Clone, Debug)]
pub struct Fake {
    clock_s: f64,
    told_s: f64,
    heard: Vec<u8>,
    out: Vec<u8>,
    greeting: u32,
    /// The number of the line that comes next; nothing before a greeting, or behind a line that was garbled.
    next: Option<u32>,
    doing: Doing,
    until_s: f64,
    piece: u32,
    lines: Vec<(u32, String)>,
    steps: VecDeque<Step>,
    done: u32,
    is_over: bool,
    contact: Option<Axes>,
    why: String,
    motion: Motion,
    shares: [u32; 3],
    /// A hold was ordered, or somebody has pressed pause at the panel.
    held: bool,
    paused: bool,
    /// Outputs that are on, a bit each.
    pub outputs: u32,
    /// Inputs that are active.
    pub inputs: u32,
    /// Speed of the spindle, on or off, revolutions a minute.
    pub rpm: f64,
    /// Its emergency stop is pressed.
    pub estop: bool,
    /// It is switched on.
    pub on: bool,
    /// It knows where it is.
    pub homed: bool,
    /// Height of the plate below its probe, machine frame, mm.
    pub plate_mm: Option<f64>,
    probing: Option<bool>,
    /// Its zero points, and those that it told last.
    pub offsets: Offsets,
    zeros: String,
    /// Lines of programs that it made, for tests.
    pub made: Vec<String>,
    /// Pieces that it began.
    pub pieces: usize,
}

impl Default for Fake {
    fn default() -> Self {
        Self {
            clock_s: 0.0,
            told_s: f64::NEG_INFINITY,
            heard: Vec::new(),
            out: Vec::new(),
            greeting: 0,
            next: None,
            doing: Doing::Idle,
            until_s: 0.0,
            piece: 0,
            lines: Vec::new(),
            steps: VecDeque::new(),
            done: 0,
            is_over: true,
            contact: None,
            why: String::new(),
            motion: Motion::default(),
            shares: [100; 3],
            held: false,
            paused: false,
            outputs: 0,
            inputs: 0,
            rpm: 0.0,
            estop: false,
            on: true,
            homed: true,
            plate_mm: None,
            probing: None,
            offsets: Offsets::default(),
            zeros: String::new(),
            made: Vec::new(),
            pieces: 0,
        }
    }
}

impl Fake {
    /// Returns the place of the machine.
    pub const fn position(&self) -> Axes {
        self.motion.position
    }

    /// Returns the number of times that it came to a stand.
    pub const fn stands(&self) -> usize {
        self.motion.stands
    }

    /// Returns the speed of the spindle while it turns.
    pub fn spindle(&self) -> Option<f64> {
        (self.outputs & 1 != 0).then_some(self.rpm)
    }

    /// Somebody presses its emergency stop.
    pub fn presses_estop(&mut self) {
        self.estop = true;
        self.switches_off("its emergency stop was pressed");
    }

    /// Somebody releases its emergency stop and switches it on.
    pub const fn panel_switches_on(&mut self) {
        (self.estop, self.on) = (false, true);
    }

    /// Somebody presses pause, or resume, at its panel.
    pub fn panel_pauses(&mut self, paused: bool) {
        self.paused = paused;
    }

    /// Somebody stops the program at its panel.
    pub fn panel_aborts(&mut self) {
        self.steps.clear();
        self.motion.clear();
        (self.outputs, self.is_over) = (0, true);
        self.doing = Doing::Idle;
    }

    /// Somebody gives it a line that changes a zero point, at its panel.
    pub fn panel(&mut self, line: &str) {
        self.offsets.keeps(line, self.motion.position);
    }

    fn switches_off(&mut self, why: &str) {
        if self.doing != Doing::Idle {
            self.why = why.into();
        }
        self.steps.clear();
        self.motion.clear();
        (self.on, self.outputs, self.doing) = (false, 0, Doing::Idle);
    }

    /// Bytes have come through the line.
    pub fn hear(&mut self, bytes: &[u8], now_s: f64) {
        self.follow(now_s);
        for byte in bytes {
            if *byte == b'\n' {
                let line = std::mem::take(&mut self.heard);
                self.line(&line);
            } else {
                self.heard.push(*byte);
            }
        }
    }

    /// The line has ended: what moves is stopped at once.
    pub fn loses_line(&mut self) {
        self.heard.clear();
        self.next = None;
        self.stop();
    }

    /// Returns what it sends up to a time.
    pub fn speak(&mut self, now_s: f64) -> Vec<u8> {
        self.follow(now_s);
        std::mem::take(&mut self.out)
    }

    fn line(&mut self, line: &[u8]) {
        let read = check::text(line).and_then(|text| {
            let (number, words) = text.split_once(' ')?;
            Some((number.parse::<u32>().ok()?, words.to_owned()))
        });
        if let Some(greeting) = read.as_ref().and_then(|(_, words)| words.strip_prefix("hi ")) {
            (self.next, self.greeting) = (Some(1), greeting.parse().unwrap_or(0));
            (self.piece, self.done, self.is_over) = (0, 0, true);
            self.why.clear();
            self.zeros.clear();
            if self.doing == Doing::Stopped {
                self.doing = Doing::Idle;
            }
            return self.facts();
        }
        let Some(next) = self.next else { return };
        match read {
            Some((number, words)) if number == next => {
                self.next = Some(next + 1);
                self.obey(&words);
            }
            _ => {
                self.next = None;
                self.why = "a line was garbled on its way".into();
                self.stop();
            }
        }
    }

    fn facts(&mut self) {
        self.say(
            "facts version=2 name=LinuxCNC%20of%20tests axes=3 speed=100,100,50 accel=400,400,400 \
             travel=-500,500,-500,500,-200,200 outputs=255 inputs=3 rpm=24000 unfit=no",
        );
    }

    fn obey(&mut self, words: &str) {
        let (command, rest) = words.split_once(' ').unwrap_or((words, ""));
        let number = rest.parse().unwrap_or(0);
        match command {
            "g" => {
                let (ticket, code) = rest.split_once(' ').unwrap_or(("0", ""));
                self.lines.push((ticket.parse().unwrap_or(0), code.to_owned()));
            }
            "piece" => {
                self.lines.clear();
                self.piece = number;
            }
            "run" | "home" | "unlock" => self.begin(command),
            "hold" => self.held = true,
            "resume" => (self.held, self.paused) = (false, false),
            "stop" => self.stop(),
            "feed" => self.shares[0] = number,
            "rapid" => self.shares[1] = number,
            "turn" => self.shares[2] = number,
            "zero" => {
                self.panel(rest);
                self.zeros.clear();
            }
            _ => {}
        }
    }

    fn begin(&mut self, command: &str) {
        (self.is_over, self.done, self.contact) = (false, 0, None);
        self.why.clear();
        match command {
            "unlock" => {
                self.doing = Doing::Unlocking;
                (self.estop, self.on) = (false, true);
                self.until_s = self.clock_s + OPENING_S;
            }
            _ if !self.on => {
                self.why =
                    "it is switched off: switch it on at its panel, or unlock it first (--unlock)"
                        .into()
            }
            "home" => (self.doing, self.until_s) = (Doing::Homing, self.clock_s + HOMING_S),
            _ => {
                (self.doing, self.until_s) = (Doing::Run, self.clock_s + OPENING_S);
                self.pieces += 1;
                self.made.extend(self.lines.iter().map(|(_, code)| code.clone()));
                match read(&self.lines, self.motion.position) {
                    Ok(steps) => self.steps = steps,
                    Err(why) => self.why = why,
                }
            }
        }
    }

    fn stop(&mut self) {
        self.steps.clear();
        (self.doing, self.held, self.paused) = (Doing::Stopping, false, false);
    }

    fn follow(&mut self, now_s: f64) {
        while self.clock_s + STEP_S <= now_s {
            self.clock_s += STEP_S;
            self.tick();
            if self.clock_s - self.told_s >= TELL_S - STEP_S / 2.0 {
                self.told_s = self.clock_s;
                self.tell();
            }
        }
    }

    fn tick(&mut self) {
        let stops = self.doing == Doing::Stopping;
        let share = f64::from(self.shares[0]) / 100.0;
        self.motion.step(STEP_S, share, stops || self.held || self.paused);
        match self.doing {
            Doing::Run if self.clock_s >= self.until_s && self.why.is_empty() => self.runs(),
            Doing::Homing if self.clock_s >= self.until_s => {
                self.homed = true;
                self.motion.put(Axes::default());
                self.ends();
            }
            Doing::Unlocking if self.clock_s >= self.until_s => self.ends(),
            Doing::Stopping if self.motion.speed_mm_s == 0.0 => {
                self.motion.clear();
                (self.outputs, self.doing, self.probing) = (0, Doing::Stopped, None);
            }
            _ => {}
        }
    }

    /// Hands moves to its planner; what is none waits until it stands.
    fn runs(&mut self) {
        self.touches();
        if let Some(ticket) = self.motion.passed() {
            self.done = ticket;
        }
        while let Some(step) = self.steps.front() {
            let stands = self.motion.is_empty();
            match step {
                Step::Go { to, speed_mm_s, ticket } => self.motion.push(*to, *speed_mm_s, *ticket),
                Step::Probe { .. } | Step::Set { .. } | Step::Turn { .. } if !stands => return,
                Step::Probe { to, speed_mm_s, ticket, active } => {
                    self.probing = Some(*active);
                    self.motion.push(*to, *speed_mm_s, *ticket);
                }
                Step::Set { line, on } => {
                    let bit = 1 << (line - 1);
                    self.outputs = if *on { self.outputs | bit } else { self.outputs & !bit };
                }
                Step::Turn { rpm } => self.rpm = *rpm,
            }
            self.steps.pop_front();
        }
        if self.motion.is_empty() && !self.held && !self.paused {
            self.ends();
        }
    }

    fn touches(&mut self) {
        let Some(plate_mm) = self.plate_mm else { return };
        let place = self.motion.position;
        let touches = place.0[2] <= plate_mm;
        self.inputs = self.inputs & !1 | u32::from(touches);
        if self.probing == Some(touches) {
            (self.contact, self.probing) = (Some(place), None);
            self.motion.clear();
        }
    }

    fn ends(&mut self) {
        (self.doing, self.is_over, self.probing) = (Doing::Idle, true, None);
        self.done = self.lines.last().map_or(self.done, |(ticket, _)| *ticket);
    }

    fn shows(&self) -> &'static str {
        match self.doing {
            Doing::Stopping => "stopping",
            Doing::Stopped => "stopped",
            _ if self.estop => "estop",
            _ if !self.on => "off",
            Doing::Run if (self.held || self.paused) && self.motion.speed_mm_s > 0.0 => "slowing",
            Doing::Run | Doing::Idle if self.held => "held",
            Doing::Run if self.paused => "panel",
            Doing::Run => "run",
            Doing::Homing => "homing",
            Doing::Unlocking => "unlocking",
            Doing::Idle => "idle",
        }
    }

    fn tell(&mut self) {
        if self.greeting == 0 {
            return;
        }
        let [feed, rapid, turn] = self.shares;
        let mut text = format!(
            "s hi={} next={} piece={} done={} over={} doing={} homed={} moves={} at={} out={} in={} feed={feed} \
             rapid={rapid} turn={turn}",
            self.greeting,
            self.next.unwrap_or(0),
            self.piece,
            self.done,
            u8::from(self.is_over),
            self.shows(),
            u8::from(self.homed),
            u8::from(self.motion.speed_mm_s > 0.0),
            told(self.motion.position),
            self.outputs,
            self.inputs,
        );
        if let Some(contact) = self.contact {
            text += &format!(" contact={}", told(contact));
        }
        if !self.why.is_empty() {
            text += &format!(" why={}", self.why.replace(' ', "%20"));
        }
        self.tell_zeros();
        self.say(&text);
    }

    fn tell_zeros(&mut self) {
        let offsets = self.offsets;
        let shifts =
            [(Zero::SHIFT, offsets.shift), (Zero::TOOL, Axes::xyz(0.0, 0.0, offsets.tool_mm))];
        let each = Zero::SYSTEMS.into_iter().zip(offsets.systems).chain(shifts);
        let words: String = each.map(|(name, at)| format!(" {name}={}", told(at))).collect();
        let zeros = format!("holds={}{words} turned=", offsets.system());
        if zeros != self.zeros {
            self.say(&format!("z hi={} next={} {zeros}", self.greeting, self.next.unwrap_or(0)));
            self.zeros = zeros;
        }
    }

    fn say(&mut self, text: &str) {
        self.out.extend_from_slice(check::line(text).as_bytes());
    }
}

/// A place as the bridge tells it.
fn told(place: Axes) -> String {
    let [x, y, z, ..] = place.0;
    format!("{x:.5},{y:.5},{z:.5}")
}
