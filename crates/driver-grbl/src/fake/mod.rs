//! A fake controller: it reads lines and characters as the interface of grbl 1.1 is described, and
//! moves by a clock that is handed to it.
//!
//! It has what matters to whoever drives it: a receive buffer that overflows, a planner that looks ahead, a
//! row of step segments behind it, `ok` only when there was room, a hold that slows down and a reset that
//! loses the place when it comes too early.

mod arc;
mod board;
mod card;
mod fluid_card;
mod goes;
mod motion;
mod read;
mod report;
mod solid;
mod state;
mod tool;
mod turned;
mod xmodem;

pub use board::Board;
pub use card::Card;
pub use solid::Solid;

use kerf_machine::driver::{Axes, Offsets};
use motion::Motion;
use read::{Way, Words, read};
use state::State;
use std::collections::{BTreeMap, VecDeque};
use tool::{
    Change, WAITS_FOR_TOOL, cancels_jog, hears_of_tool, jog_ends, jogs, tool_is_in, touches_off,
    zero_is_set,
};
use turned::turn;

/// Time is followed in steps of this, seconds.
const STEP_S: f64 = 0.001;

/// Duration of homing, seconds.
const HOMING_S: f64 = 0.5;

/// Time in which the spindle comes up again behind a door, seconds.
const RESUMING_S: f64 = 0.6;

/// A fake controller.
#[derive(Clone, Debug)]
pub struct Fake {
    board: Board,
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
    /// Zero points that it keeps.
    pub offsets: Offsets,
    /// Reports until one that tells it.
    until_offset: usize,
    /// The feed as somebody has turned it at the controller, percent.
    pub override_percent: u32,
    /// The same of rapid moves.
    pub rapid_percent: u32,
    /// The same of the spindle.
    pub spindle_percent: u32,
    /// Bytes a second of its line; nothing for a line that takes no time.
    pub rate_bytes_s: Option<f64>,
    incoming: VecDeque<u8>,
    credit_in: f64,
    credit_out: f64,
    /// Lowest place of its Z, mm.
    pub lowest_mm: f64,
    /// Height of the plate below its probe, machine frame, mm.
    pub plate_mm: Option<f64>,
    /// Things around it that its probe feels.
    pub solids: Vec<Solid>,
    /// It moves until its probe is in this state.
    probing: Option<bool>,
    /// The place at which the probe has changed.
    latched: Option<Axes>,
    relative: bool,
    inches: bool,
    /// The word of motion that holds; nothing since it was reset.
    way: Option<Way>,
    /// Chords of an arc that have found no room yet, the next one last, and the number of its line.
    chords: (Vec<Axes>, u32),
    /// The state that it claims, in place of its own.
    pub says: Option<String>,
    resumed_s: f64,
    /// The change of tools that is under way.
    change: Change,
    /// Height at which a tool was touched off last, and that of the tool by which others are measured, mm.
    touched_mm: Option<f64>,
    reference_mm: Option<f64>,
    /// It takes no setting.
    pub keeps_settings: bool,
    /// Outputs of `M64` that are on.
    pub aux: u32,
    /// Pins that are active.
    pins: String,
    /// Bytes that found no room.
    pub overflowed: usize,
    /// Lines that it read, for tests.
    pub lines: Vec<String>,
    /// Places that it came by with its spindle on, a thousandth of a second apart.
    pub cut: Vec<Axes>,
}

impl Default for Fake {
    fn default() -> Self {
        Self::new(&[])
    }
}

/// Settings of a controller that nobody has changed.
const USUAL: [(u16, f64); 25] = [
    (0, 10.0),
    (1, 25.0),
    (10, 1.0),
    (11, 0.01),
    (12, 0.002),
    (13, 0.0),
    (20, 0.0),
    (21, 0.0),
    (22, 0.0),
    (23, 0.0),
    (30, 24_000.0),
    (31, 0.0),
    (32, 0.0),
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

impl Fake {
    /// grbl that was just switched on, with some of its settings.
    pub fn new(settings: &[(u16, f64)]) -> Self {
        Self::of(Board::grbl(), settings)
    }

    /// A controller that was just switched on, with some of its settings.
    pub fn of(board: Board, settings: &[(u16, f64)]) -> Self {
        let mut fake = Self {
            clock_s: 0.0,
            state: State::Ready,
            settings: USUAL.into_iter().chain(settings.iter().copied()).collect(),
            motion: Motion::new(board.planner),
            board,
            buffer: VecDeque::new(),
            waiting: None,
            out: Vec::new(),
            planned: Axes::default(),
            feed_mm_min: 0.0,
            spindle: false,
            spindle_rpm: 0.0,
            coolant: 0,
            homed_s: None,
            offsets: Offsets::default(),
            until_offset: 8,
            override_percent: 100,
            rapid_percent: 100,
            spindle_percent: 100,
            rate_bytes_s: None,
            incoming: VecDeque::new(),
            credit_in: 0.0,
            credit_out: 0.0,
            lowest_mm: 0.0,
            plate_mm: None,
            solids: Vec::new(),
            probing: None,
            latched: None,
            relative: false,
            inches: false,
            way: None,
            chords: (Vec::new(), 0),
            says: None,
            resumed_s: 0.0,
            change: Change::default(),
            touched_mm: None,
            reference_mm: None,
            keeps_settings: false,
            aux: 0,
            pins: String::new(),
            overflowed: 0,
            lines: Vec::new(),
            cut: Vec::new(),
        };
        fake.start();
        fake
    }

    /// Returns the place of the machine.
    pub const fn position(&self) -> Axes {
        self.motion.position
    }

    /// Returns the speed of the spindle while it turns.
    pub fn spindle(&self) -> Option<f64> {
        if self.spindle && !matches!(self.state, State::Door | State::Resuming) {
            Some(self.spindle_rpm * f64::from(self.spindle_percent) / 100.0)
        } else {
            None
        }
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

    /// Somebody or something works its pins: the letters of a status report. An open door holds it and switches its
    /// spindle off.
    pub fn pins(&mut self, pins: &str) {
        if self.pins != pins {
            pins.clone_into(&mut self.pins);
        }
        if pins.contains('D') && matches!(self.state, State::Ready | State::Hold | State::Resuming)
        {
            self.state = State::Door;
            self.motion.held = true;
        }
    }

    /// Somebody presses its button to go on.
    pub fn cycle_start(&mut self) {
        match self.state {
            State::Tool => tool_is_in(self),
            State::Hold => {
                self.state = State::Ready;
                self.motion.held = false;
            }
            State::Door if !self.pins.contains('D') => {
                self.state = State::Resuming;
                self.resumed_s = self.clock_s + RESUMING_S;
            }
            _ => {}
        }
    }

    /// A macro, a pendant or its card has it change the tool.
    pub fn changes_tool(&mut self) {
        (self.state, self.change) = (State::Tool, Change::default());
        (self.spindle, self.coolant) = (false, 0);
    }

    /// Returns `true` while it waits for a tool.
    pub fn waits_for_tool(&self) -> bool {
        self.state == State::Tool
    }

    /// Somebody has put it to sleep.
    pub fn sleeps(&mut self) {
        self.halt();
        self.state = State::Sleep;
    }

    /// Somebody has set it to check lines in place of making them (`$C`).
    pub const fn checks(&mut self) {
        self.state = State::Check;
    }

    /// A value of its settings.
    pub fn is_set_to(&self, number: u16) -> f64 {
        self.setting(number)
    }

    /// A limit switch is hit: it stops at once.
    pub fn hits_limit(&mut self) {
        self.alarm(1);
    }

    fn start(&mut self) {
        let homes = self.setting(22) as u32 & 1 == 1 && self.homed_s.is_none();
        self.state = if homes || self.state == State::Alarm { State::Alarm } else { State::Ready };
        self.tell("");
        self.tell(self.board.greeting);
        if self.state == State::Alarm {
            self.tell("[MSG:'$H'|'$X' to unlock]");
        }
    }

    /// Tells a line. What answers a line of a file on its card is not told, but for an error, which ends the file.
    fn tell(&mut self, line: &str) {
        let own = self.board.card.as_mut().filter(|card| card.runs());
        if let Some(card) = own {
            let at = card.line().0;
            match line.strip_prefix("error:") {
                _ if line == "ok" => return,
                Some(number) if card.fluid => {
                    let told = card.fluid_refusal(number);
                    return self.out.extend(told.bytes());
                }
                Some(_) => {
                    card.ends();
                    self.tell(&format!("{line} in SD file at line {at}"));
                }
                None => {}
            }
        }
        self.out.extend_from_slice(line.as_bytes());
        self.out.extend_from_slice(b"\r\n");
    }

    /// Bytes come, at a time.
    pub fn hear(&mut self, bytes: &[u8], now_s: f64) {
        self.follow(now_s);
        if self.rate_bytes_s.is_some() {
            return self.incoming.extend(bytes);
        }
        self.take(bytes);
    }

    /// Bytes have come through the line.
    fn take(&mut self, bytes: &[u8]) {
        for byte in bytes {
            match byte {
                _ if self.hears_card(*byte) => {}
                b'?' if self.state != State::Homing => self.report(),
                b'?' => {}
                b'!' if self.state == State::Ready || self.change.touches => {
                    self.state = State::Hold;
                    self.motion.held = true;
                }
                b'~' => self.cycle_start(),
                b'!' => {}
                0x18 => self.reset(),
                0xa3 => hears_of_tool(self),
                0x85 => cancels_jog(self),
                0x90..=0x9d => turn(self, *byte),
                0x80.. => {}
                _ if self.buffer.len() < self.board.rx => self.buffer.push_back(*byte),
                _ => self.overflowed += 1,
            }
        }
        self.read_on();
    }

    /// Returns its card; one that has none gets one that it does not tell.
    pub fn card(&mut self) -> &mut Card {
        self.board.card.get_or_insert_with(Card::default)
    }

    /// Returns `true` if something holds of its card.
    pub fn has_card_with(&self, holds: impl Fn(&Card) -> bool) -> bool {
        self.board.card.as_ref().is_some_and(holds)
    }

    /// Somebody begins a file of its card at its own panel; tells whether it is there.
    pub fn runs_from_card(&mut self, name: &str) -> bool {
        self.board.card.as_mut().is_some_and(|card| card.begins(name))
    }

    fn works_card(&mut self, command: &str) -> bool {
        let stands = self.state == State::Ready && self.motion.is_empty();
        let told = self.board.card.as_mut().and_then(|card| card.command(command, stands));
        told.iter().flatten().for_each(|line| self.tell(line));
        let named = command.strip_prefix("F=").or_else(|| command.strip_prefix("SD/Run="));
        if let (true, Some(name)) = (stands, named) {
            self.runs_from_card(name.trim_start_matches('/'));
        }
        told.is_some()
    }

    fn hears_card(&mut self, byte: u8) -> bool {
        let now_s = self.clock_s;
        let told = self.board.card.as_mut().and_then(|card| card.hears(byte, now_s));
        self.out.extend(told.iter().flatten());
        told.is_some()
    }

    /// Returns what it sends up to a time.
    pub fn speak(&mut self, now_s: f64) -> Vec<u8> {
        self.follow(now_s);
        if self.rate_bytes_s.is_none() {
            return std::mem::take(&mut self.out);
        }
        let count = (self.credit_out as usize).min(self.out.len());
        self.credit_out -= count as f64;
        self.out.drain(..count).collect()
    }

    fn follow(&mut self, now_s: f64) {
        while self.clock_s + STEP_S <= now_s {
            self.clock_s += STEP_S;
            self.motion.step(STEP_S);
            self.carry();
            jog_ends(self);
            if self.spindle().is_some() && self.motion.speed_mm_s > 0.0 {
                self.cut.push(self.motion.position);
            }
            self.lowest_mm = self.lowest_mm.min(self.motion.position.0[2]);
            self.probe();
            if self.homed_s.is_some_and(|at_s| self.state == State::Homing && self.clock_s >= at_s)
            {
                self.home();
            }
            if self.state == State::Resuming && self.clock_s >= self.resumed_s {
                self.state = State::Ready;
                self.motion.held = false;
            }
            let now_s = self.clock_s;
            self.out.extend(self.board.card.iter_mut().flat_map(|card| card.waits(now_s)));
            self.read_on();
        }
    }

    /// The line carries as many bytes as its rate allows, each way.
    fn carry(&mut self) {
        let Some(rate) = self.rate_bytes_s else { return };
        let idle = self.out.is_empty();
        self.credit_out = if idle { 0.0 } else { self.credit_out } + rate * STEP_S;
        self.credit_in = (self.credit_in + rate * STEP_S).min(self.incoming.len() as f64 + 1.0);
        let count = (self.credit_in as usize).min(self.incoming.len());
        self.credit_in -= count as f64;
        let bytes: Vec<u8> = self.incoming.drain(..count).collect();
        self.take(&bytes);
    }

    /// Returns how many moves its planner has, and how many it can have.
    pub fn planner(&self) -> (usize, usize) {
        (self.board.planner - self.motion.free(), self.board.planner)
    }

    /// Somebody presses its reset, or its power fails: it begins anew, and counts from where it stands as zero.
    pub fn begins_anew(&mut self) {
        self.halt();
        self.board.card.iter_mut().for_each(Card::ends);
        self.feed_mm_min = 0.0;
        self.motion.put(Axes::default());
        (self.planned, self.motion.held, self.state) = (Axes::default(), false, State::Ready);
        self.incoming.clear();
        self.out.clear();
        self.start();
    }

    fn home(&mut self) {
        self.state = State::Ready;
        self.planned = self.homed();
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
        (self.waiting, self.probing, self.latched) = (None, None, None);
        self.chords.0.clear();
        (self.relative, self.inches, self.way) = (false, false, None);
        (self.spindle, self.coolant) = (false, 0);
    }

    fn reset(&mut self) {
        [0x90, 0x95, 0x99].into_iter().for_each(|back| turn(self, back));
        self.offsets.chosen = 0;
        self.board.card.iter_mut().for_each(Card::ends);
        self.feed_mm_min = 0.0;
        let too_early = self.motion.speed_mm_s > 0.0 || self.state == State::Homing;
        self.halt();
        (self.motion.held, self.change) = (false, Change::default());
        if too_early {
            self.tell("ALARM:3");
            self.state = State::Alarm;
        } else if self.pins.contains('D') {
            self.state = State::Door;
        } else if self.state != State::Alarm {
            self.state = State::Ready;
        }
        self.start();
    }

    /// Reads lines as long as there is room for what they ask for.
    fn read_on(&mut self) {
        loop {
            // A hold suspends what is not in the planner yet.
            let unheard = self.state == State::Tool && !self.change.heard;
            let suspended = self.probing.is_some()
                || unheard
                || matches!(
                    self.state,
                    State::Homing | State::Hold | State::Door | State::Resuming
                );
            if suspended {
                return;
            }
            if !self.chords.0.is_empty() && !self.goes_round() {
                return;
            }
            if let Some(words) = self.waiting.take() {
                if !self.has_room(&words) {
                    self.waiting = Some(words);
                    return;
                }
                self.make(&words);
            }
            if self.board.card.as_ref().is_some_and(Card::runs) {
                let is_fluid = self.board.card.as_ref().is_some_and(|card| card.fluid);
                if !is_fluid {
                    // What comes on its line is dropped; FluidNC reads it behind the file.
                    self.buffer.clear();
                }
                match self.board.card.as_mut().and_then(Card::next_line) {
                    Some(line) => self.line(&line),
                    None if is_fluid => self.board.card.iter_mut().for_each(Card::ends),
                    None if self.motion.is_empty() => {
                        self.board.card.iter_mut().for_each(Card::ends);
                        self.tell("[MSG:Pgm End]");
                    }
                    None => return,
                }
                continue;
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
            _ if self.state == State::Sleep => {}
            _ if self.state == State::Alarm && !line.is_empty() => self.tell("error:9"),
            _ if self.offsets.keeps(line, self.motion.position) => {
                // Its next report tells of it.
                self.until_offset = 1;
                zero_is_set(self);
                self.tell("ok");
            }
            Ok(mut words) => {
                self.inches = words.inches.unwrap_or(self.inches);
                if self.inches {
                    words.in_inches();
                }
                self.waiting = Some(words);
            }
            Err(number) => self.tell(&format!("error:{number}")),
        }
    }

    fn dollar(&mut self, command: &str) {
        match command {
            _ if self.works_card(command) => {}
            _ if command.starts_with("J=") => jogs(self, command.trim_start_matches("J=")),
            "I" | "$" if !self.motion.is_empty() => self.tell("error:8"),
            "G" => {
                self.tell(&self.modes());
                self.tell("ok");
            }
            "#" => {
                let lines = self.offsets.told(|at| self.places(at));
                lines.iter().for_each(|line| self.tell(line));
                if let Some(mm) = self.reference_mm {
                    self.tell(&format!("[TLR:{mm:.3}]"));
                }
                self.tell("ok");
            }
            "TPW" => touches_off(self),
            "TLR" if self.board.hal => {
                self.reference_mm = self.touched_mm;
                self.tell("ok");
            }
            "$" => {
                for (number, value) in self.settings.clone() {
                    self.tell(&format!("${number}={value:.3}"));
                }
                self.tell("ok");
            }
            "I" => {
                self.board.tells.clone().iter().for_each(|line| self.tell(line));
                self.tell("ok");
            }
            "EA" | "EE" | "EG" | "ES" if self.board.hal => {
                board::listed(command).iter().for_each(|line| self.tell(line));
                self.tell("ok");
            }
            _ if command.starts_with("SED=") && self.board.hal => {
                self.tell(&board::described(command.trim_start_matches("SED=")));
                self.tell("ok");
            }
            "H" if self.setting(22) as u32 & 1 == 0 => self.tell("error:5"),
            "H" => self.begins_homing(),
            _ if self.state == State::Sleep => {}
            _ if command.contains('=') && self.keeps_settings => self.tell("error:8"),
            _ if command.contains('=') && !self.motion.is_empty() => self.tell("error:8"),
            "X" => {
                self.state = State::Ready;
                self.tell("ok");
            }
            other => {
                let setting = other.split_once('=');
                let read: Option<(u16, f64)> =
                    setting.and_then(|(n, v)| Some((n.parse().ok()?, v.parse().ok()?)));
                read.into_iter().for_each(|(number, value)| self.counts_by(number, value));
                self.settings.extend(read);
                self.tell(if read.is_some() { "ok" } else { "error:3" });
            }
        }
    }

    fn has_room(&self, words: &Words) -> bool {
        if words.waits { self.motion.is_empty() } else { self.motion.free() > 0 }
    }

    fn make(&mut self, words: &Words) {
        if self.state == State::Tool && words.to.iter().any(Option::is_some) {
            return self.tell(&format!("error:{WAITS_FOR_TOOL}"));
        }
        if self.state == State::Check {
            return self.tell("ok");
        }
        if let Some((output, on)) = words.aux {
            if output >= self.board.aux {
                return self.tell(if self.board.hal { "error:20" } else { "error:39" });
            }
            self.aux = if on { self.aux | 1 << output } else { self.aux & !(1 << output) };
        }
        self.feed_mm_min = words.feed_mm_min.unwrap_or(self.feed_mm_min);
        self.spindle_rpm = words.spindle_rpm.unwrap_or(self.spindle_rpm);
        self.spindle = words.spindle.unwrap_or(self.spindle);
        match words.coolant {
            Some(0) => self.coolant = 0,
            Some(bit) => self.coolant |= bit,
            None => {}
        }
        if words.probes.is_some_and(|state| state == self.touches()) {
            return self.alarm(4);
        }
        if let Some(error) = self.go(words) {
            return self.tell(&format!("error:{error}"));
        }
        if words.changes_tool {
            self.changes_tool();
        }
        // A move that probes is answered when it is over.
        self.probing = words.probes;
        if self.probing.is_none() && self.chords.0.is_empty() {
            self.tell("ok");
        }
    }
}
