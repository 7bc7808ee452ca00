//! The board: its clock, its objects, its states, and what it does with commands.

use super::chip::{Chip, bits_of, bytes_of};
use super::events::{Event, Events};
use super::input::{Analog, Buttons};
use super::output::{Awaits, Output};
use super::reader::{Piece, Reader};
use super::stepper::Stepper;
use super::switch::{Endstop, Trsync};
use super::words::{Said, Words};
use std::collections::BTreeMap;

/// A change of a pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    pub clock: u64,
    pub pin: u32,
    pub level: bool,
}

#[derive(Clone, Debug, Default)]
pub struct Board {
    pub words: Words,
    pub frequency: f64,
    /// Share by which its clock is faster than told.
    pub drift: f64,
    start: u64,
    /// Its clock, since power-up and the number that it began with.
    pub now: u64,
    reader: Reader,
    out: Vec<u8>,
    pub events: Events,
    pub steppers: BTreeMap<u8, Stepper>,
    pub trsyncs: BTreeMap<u8, Trsync>,
    /// Deadlines that passed: nobody was heard, and motors stood at once.
    pub expired: u32,
    pub endstops: BTreeMap<u8, Endstop>,
    pub outputs: BTreeMap<u8, Output>,
    pub buttons: BTreeMap<u8, Buttons>,
    pub analogs: BTreeMap<u8, Analog>,
    pub voltages: BTreeMap<u32, u32>,
    /// Answers of drivers on a wire, by object: what is asked, what comes.
    pub answers: Vec<(Vec<u8>, Vec<u8>)>,
    pending_answers: BTreeMap<u8, Vec<u8>>,
    /// Pins of wires and chip selects, by object.
    pub wires: BTreeMap<u8, u32>,
    /// Motor drivers behind them.
    pub chips: Vec<Chip>,
    /// Places of the common queue, and those taken.
    pub move_count: usize,
    pub places: usize,
    pub most_places: usize,
    oids: Option<i64>,
    pub config: Option<u32>,
    shutdown: Option<String>,
    /// Level of pins that something outside drives, each from a clock on.
    pub driven: BTreeMap<u32, Vec<(u64, bool)>>,
    levels: BTreeMap<u32, bool>,
    pub edges: Vec<Edge>,
    /// Edges are written down.
    pub records: bool,
    /// A switch that closes at a count of a stepper: pin, stepper, count.
    pub stops_at: Vec<(u32, u8, i64)>,
    /// Steps that are neither made nor counted: stepper, and how many it has made before.
    pub loses: Vec<(u8, usize)>,
    /// The answer of this name is never given.
    pub mute: Option<&'static str>,
    /// Bytes that came with a command that shuts down are lost, as with the build for Linux.
    pub loses_at_shutdown: bool,
    /// Commands that ran, by name.
    pub ran: BTreeMap<String, u64>,
}

impl Board {
    pub fn new(words: Words, frequency: f64, start: u64) -> Self {
        let mut board = Self { words, frequency, start, now: start, ..Self::default() };
        board.records = true;
        board.move_count = 0;
        board.events.set(start + (5.0 * frequency) as u64, Event::Stats);
        board
    }

    /// A board whose words are in an order of their own.
    pub fn of_seed(seed: u64) -> Self {
        let start = (1 << 32) - 12_000_000 * (1 + seed % 3);
        Self::new(Words::shuffled(seed, 12e6), 12e6, start)
    }

    pub fn clock_at(&self, t_s: f64) -> u64 {
        self.start.wrapping_add((t_s * self.frequency * (1.0 + self.drift)).round() as u64)
    }

    /// Its crystal runs otherwise from now on.
    pub fn warm(&mut self, t_s: f64, drift: f64) {
        let clock = self.clock_at(t_s);
        self.drift = drift;
        self.start = clock.wrapping_sub((t_s * self.frequency * (1.0 + drift)).round() as u64);
    }

    /// Its clock stands still for a time, seconds, as that of a board whose processor does something else.
    pub fn stand_still(&mut self, time_s: f64) {
        self.start = self.start.wrapping_sub((time_s * self.frequency) as u64);
    }

    pub fn time_at(&self, clock: u64) -> f64 {
        (clock.wrapping_sub(self.start) as i64) as f64 / (self.frequency * (1.0 + self.drift))
    }

    /// The next frame has that number.
    pub fn expect(&mut self, number: u8) {
        self.reader.expected = number;
    }

    /// Bytes that came at the moment which the board has reached.
    pub fn feed(&mut self, bytes: &[u8]) {
        self.reader.feed(bytes);
        while let Some(piece) = self.reader.piece() {
            match piece {
                Piece::Nak => self.say_content(&[]),
                Piece::Run(content) => {
                    if self.run_frame(&content) {
                        self.say_content(&[]);
                    } else if self.loses_at_shutdown {
                        self.reader.lose();
                    }
                }
            }
        }
    }

    /// Goes on to a moment.
    pub fn run_to(&mut self, clock: u64) {
        while let Some((at, event)) = self.events.next(clock) {
            self.now = self.now.max(at);
            self.happen(event);
        }
        self.now = self.now.max(clock);
    }

    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.out)
    }

    pub fn is_shutdown(&self) -> bool {
        self.shutdown.is_some()
    }

    pub fn reason(&self) -> Option<&str> {
        self.shutdown.as_deref()
    }

    /// Power off and on.
    pub fn reset(&mut self) {
        let mut fresh = Self::new(self.words.clone(), self.frequency, self.start);
        fresh.now = self.now;
        fresh.drift = self.drift;
        fresh.records = self.records;
        fresh.chips = std::mem::take(&mut self.chips);
        fresh.edges = std::mem::take(&mut self.edges);
        *self = fresh;
        self.say("starting", &[]);
    }

    fn happen(&mut self, event: Event) {
        match event {
            Event::Step(oid) => self.step(oid),
            Event::Unstep(oid) => self.unstep(oid),
            Event::Report(oid) => self.report(oid),
            Event::Expire(oid) => self.expire(oid),
            Event::Look(oid) => self.look(oid),
            Event::Output(oid) => self.output(oid),
            Event::Watch(oid) => self.shut(self.outputs[&oid].missed()),
            Event::Buttons(oid) => self.look_at_buttons(oid),
            Event::Analog(oid) => self.sample(oid),
            Event::Answer(oid) => {
                let answer = self.pending_answers.remove(&oid).unwrap_or_default();
                self.say_bytes("tmcuart_response", &[("oid", oid.into())], &answer);
            }
            Event::Stats => {
                self.say("stats", &[("count", 50), ("sum", 100), ("sumsq", 50)]);
                self.events.set(self.now + (5.0 * self.frequency) as u64, Event::Stats);
            }
        }
    }

    /// A clock of 32 bits as one of 64.
    pub fn at(&self, clock: u32) -> u64 {
        self.now.wrapping_add_signed(i64::from(clock.wrapping_sub(self.now as u32) as i32))
    }

    pub fn set_timer(&mut self, clock: u32, event: Event) {
        let at = self.at(clock);
        if at < self.now {
            return self.shut("Timer too close");
        }
        self.events.set(at, event);
    }

    pub fn edge(&mut self, pin: u32, level: bool) {
        let before = self.levels.insert(pin, level);
        if self.records && before.unwrap_or(false) != level {
            self.edges.push(Edge { clock: self.now, pin, level });
        }
    }

    pub fn level(&self, pin: u32) -> bool {
        if let Some((_, oid, count)) = self.stops_at.iter().find(|(p, _, _)| *p == pin) {
            let position = self.steppers[oid].position;
            return if *count >= 0 { position >= *count } else { position <= *count };
        }
        let changes = self.driven.get(&pin).map_or(&[][..], Vec::as_slice);
        changes.iter().rev().find(|(clock, _)| *clock <= self.now).is_some_and(|(_, level)| *level)
    }

    pub fn say(&mut self, name: &str, numbers: &[(&str, i64)]) {
        if self.mute == Some(name) {
            return;
        }
        let content = self.words.response(name, numbers, None);
        self.say_content(&content);
    }

    pub fn say_bytes(&mut self, name: &str, numbers: &[(&str, i64)], data: &[u8]) {
        let content = self.words.response(name, numbers, Some(data));
        self.say_content(&content);
    }

    pub fn say_content(&mut self, content: &[u8]) {
        let frame = self.reader.frame(content);
        self.out.extend(frame);
    }

    pub fn shut(&mut self, reason: &str) {
        if self.shutdown.is_none() {
            self.shutdown = Some(reason.to_owned());
            let running: Vec<u8> = self.steppers.keys().copied().collect();
            self.outputs_off();
            running.into_iter().for_each(|oid| self.stop_stepper(oid));
            self.trsyncs.values_mut().for_each(|trsync| trsync.armed = false);
            self.events.clear();
            self.places = 0;
        }
        let first = self.shutdown.clone().unwrap();
        let number = self.words.reason(&first);
        self.say(
            "shutdown",
            &[("clock", i64::from(self.now as u32)), ("static_string_id", number)],
        );
    }

    /// Runs the commands of a frame. False where one shut the board down.
    fn run_frame(&mut self, mut content: &[u8]) -> bool {
        while !content.is_empty() {
            let said = match self.words.command(&mut content) {
                Ok(said) => said,
                Err(reason) => {
                    self.shut(reason);
                    return false;
                }
            };
            let before = self.shutdown.clone();
            *self.ran.entry(said.name.clone()).or_default() += 1;
            self.run(&said);
            if self.shutdown.is_some() && (before.is_none() || said.name == "emergency_stop") {
                return false;
            }
        }
        true
    }

    fn run(&mut self, said: &Said) {
        match said.name.as_str() {
            "identify" => return self.identify(said),
            "get_clock" => return self.say("clock", &[("clock", i64::from(self.now as u32))]),
            "get_uptime" => {
                let fields =
                    [("high", (self.now >> 32) as i64), ("clock", i64::from(self.now as u32))];
                return self.say("uptime", &fields);
            }
            "get_config" => return self.say_config(),
            "emergency_stop" => return self.shut("Command request"),
            "clear_shutdown" => {
                if self.shutdown.take().is_none() {
                    self.shut("Shutdown cleared when not shutdown");
                }
                return;
            }
            "debug_nop" => return,
            _ => {}
        }
        if let Some(reason) = &self.shutdown {
            let number = self.words.reason(reason);
            return self.say("is_shutdown", &[("static_string_id", number)]);
        }
        if said.name.starts_with("config_") && !self.may_configure(said) {
            return self.shut("Can't assign oid");
        }
        self.run_object(said);
    }

    fn may_configure(&mut self, said: &Said) -> bool {
        let oid = said.n("oid");
        let o = oid as u8;
        let taken = self.steppers.contains_key(&o)
            || self.trsyncs.contains_key(&o)
            || self.endstops.contains_key(&o)
            || self.outputs.contains_key(&o)
            || self.analogs.contains_key(&o);
        self.config.is_none() && !taken && self.oids.is_some_and(|count| oid < count)
    }

    fn run_object(&mut self, said: &Said) {
        match said.name.as_str() {
            "allocate_oids" if self.oids.is_some() => self.shut("oids already allocated"),
            "allocate_oids" => self.oids = Some(said.n("count")),
            "finalize_config" if self.config.is_some() => self.shut("Already finalized"),
            "finalize_config" => {
                self.config = Some(said.clock("crc"));
                self.move_count = if self.move_count == 0 { 819 } else { self.move_count };
            }
            "config_stepper" => self.config_stepper(said),
            "config_trsync" => _ = self.trsyncs.insert(said.n("oid") as u8, Trsync::default()),
            "config_endstop" => self.config_endstop(said),
            "config_digital_out" => self.add_output(said, false),
            "config_pwm_out" => self.add_output(said, true),
            "config_analog_in" => {
                self.analogs.insert(said.n("oid") as u8, Analog::new(said));
            }
            "config_buttons" | "set_digital_out_pwm_cycle" | "spi_set_sw_bus" => {}
            "config_tmcuart" => _ = self.wires.insert(said.n("oid") as u8, said.clock("rx_pin")),
            "config_spi" => _ = self.wires.insert(said.n("oid") as u8, said.clock("pin")),
            "buttons_add" => self.buttons.entry(said.n("oid") as u8).or_default().add(said),
            "buttons_query" => self.query_buttons(said),
            "buttons_ack" => {
                let buttons = self.buttons.get_mut(&(said.n("oid") as u8));
                buttons.into_iter().for_each(|it| it.acknowledge(said));
            }
            "query_analog_in" => self.query_analog(said),
            "set_next_step_dir" => self.set_next_dir(said),
            "reset_step_clock" => self.reset_step_clock(said),
            "queue_step" => self.queue_step(said),
            "stepper_get_position" => self.say_position(said),
            "stepper_stop_on_trigger" => self.stop_on_trigger(said),
            "trsync_start" => self.trsync_start(said),
            "trsync_set_timeout" => self.trsync_set_timeout(said),
            "trsync_trigger" => self.trsync_trigger(said),
            "endstop_home" => self.endstop_home(said),
            "endstop_query_state" => self.say_endstop(said.n("oid") as u8),
            "queue_digital_out" => self.queue_output(said, "on_ticks"),
            "queue_pwm_out" => self.queue_output(said, "value"),
            "update_digital_out" => self.update_output(said),
            "set_digital_out" => self.edge(said.clock("pin"), said.n("value") != 0),
            "tmcuart_send" => self.ask_driver(said),
            "spi_transfer" => self.transfer(said),
            _ => self.shut("Invalid command"),
        }
    }

    /// Bits for a wire. What comes while one is under way is dropped.
    fn ask_driver(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        if self.pending_answers.contains_key(&oid) {
            return;
        }
        let written = &said.bytes["write"];
        let known = self.answers.iter().find(|(asked, _)| asked == written).map(|(_, a)| a.clone());
        let pin = self.wires.get(&oid).copied().unwrap_or_default();
        let bytes = bytes_of(written);
        let heard: Vec<_> = self
            .chips
            .iter_mut()
            .filter(|it| it.pin == pin)
            .filter_map(|it| it.hear(&bytes))
            .collect();
        let told = heard.first().map(|bytes| bits_of(bytes)).filter(|_| said.n("read") > 0);
        self.pending_answers.insert(oid, known.or(told).unwrap_or_default());
        self.events.set(self.now + (self.frequency * 0.004) as u64, Event::Answer(oid));
    }

    fn transfer(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        let bytes = &said.bytes["data"];
        let pin = self.wires.get(&oid).copied().unwrap_or_default();
        let chip = self.chips.iter_mut().find(|it| it.pin == pin);
        let answer = chip.map_or_else(|| vec![0xff; bytes.len()], |it| it.swap(bytes));
        self.say_bytes("spi_transfer_response", &[("oid", oid.into())], &answer);
    }

    fn identify(&mut self, said: &Said) {
        let [offset, count] = ["offset", "count"].map(|field| said.n(field) as usize);
        if count > 52 {
            return;
        }
        let packed = &self.words.packed;
        let from = offset.min(packed.len());
        let piece = packed[from..(from + count).min(packed.len())].to_vec();
        self.say_bytes("identify_response", &[("offset", offset as i64)], &piece);
    }

    fn say_config(&mut self) {
        let fields = [
            ("is_config", self.config.is_some().into()),
            ("crc", self.config.unwrap_or(0).into()),
            ("is_shutdown", self.shutdown.is_some().into()),
            ("move_count", if self.config.is_some() { self.move_count as i64 } else { 0 }),
        ];
        self.say("config", &fields);
    }

    fn say_position(&mut self, said: &Said) {
        let oid = said.n("oid");
        match self.steppers.get(&(oid as u8)).map(|stepper| stepper.position) {
            Some(position) => self.say("stepper_position", &[("oid", oid), ("pos", position)]),
            None => self.shut("Invalid oid type"),
        }
    }

    fn add_output(&mut self, said: &Said, pwm: bool) {
        self.outputs.insert(said.n("oid") as u8, Output::new(said, pwm));
    }

    fn queue_output(&mut self, said: &Said, field: &str) {
        let oid = said.n("oid") as u8;
        let clock = self.at(said.clock("clock"));
        let Some(output) = self.outputs.get_mut(&oid) else { return self.shut("Invalid oid type") };
        let first = !output.is_queued();
        output.push(clock, said.clock(field));
        self.places += 1;
        self.most_places = self.most_places.max(self.places);
        if self.places > self.move_count {
            return self.shut("Move queue overflow");
        }
        if first {
            self.events.drop(Event::Watch(oid));
            self.set_timer(said.clock("clock"), Event::Output(oid));
        }
    }

    fn update_output(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        let Some(output) = self.outputs.get(&oid) else { return self.shut("Invalid oid type") };
        if output.is_queued() {
            return self.shut("update_digital_out not valid with active queue");
        }
        self.events.drop(Event::Watch(oid));
        self.put(oid, said.clock("value"));
    }

    fn output(&mut self, oid: u8) {
        if let Some(value) = self.outputs.get_mut(&oid).unwrap().pop() {
            self.places -= 1;
            self.put(oid, value);
        }
    }

    fn put(&mut self, oid: u8, value: u32) {
        let output = self.outputs.get_mut(&oid).unwrap();
        let (pin, awaits) = (output.pin, output.put(value, self.now));
        self.edge(pin, value != 0);
        match awaits {
            Err(reason) => self.shut(reason),
            Ok(Awaits::Change(clock)) => self.events.set(clock, Event::Output(oid)),
            Ok(Awaits::Watch(clock)) => self.events.set(clock, Event::Watch(oid)),
            Ok(Awaits::Nothing) => {}
        }
    }

    fn outputs_off(&mut self) {
        let now = self.now;
        let off = |output: &mut Output| output.off(now).map(|level| (output.pin, level));
        let off: Vec<_> = self.outputs.values_mut().filter_map(off).collect();
        off.into_iter().for_each(|(pin, level)| self.edge(pin, level));
    }

    fn query_buttons(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        let buttons = self.buttons.entry(oid).or_default();
        buttons.query(said);
        if buttons.rest_ticks > 0 {
            self.set_timer(said.clock("clock"), Event::Buttons(oid));
        }
    }

    fn look_at_buttons(&mut self, oid: u8) {
        let pins = self.buttons[&oid].pins.clone();
        let levels = pins.iter().enumerate().map(|(n, pin)| u8::from(self.level(*pin)) << n).sum();
        let buttons = self.buttons.get_mut(&oid).unwrap();
        let tells = buttons.look(levels);
        let (count, told) = (buttons.acknowledged, buttons.told.clone());
        self.events.set(self.now + buttons.rest_ticks, Event::Buttons(oid));
        if tells {
            let fields = [("oid", i64::from(oid)), ("ack_count", i64::from(count))];
            self.say_bytes("buttons_state", &fields, &told);
        }
    }

    fn query_analog(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        self.events.drop(Event::Analog(oid));
        let analog = self.analogs.entry(oid).or_default();
        analog.query(said);
        if analog.samples > 0 {
            self.set_timer(said.clock("clock"), Event::Analog(oid));
        }
    }

    fn sample(&mut self, oid: u8) {
        let analog = self.analogs.get_mut(&oid).unwrap();
        let struck = analog.sample(self.voltages.get(&analog.pin).copied().unwrap_or(2048));
        let next = self.now + analog.rest_ticks;
        let report = analog.report();
        self.events.set(next, Event::Analog(oid));
        if let Some(values) = report {
            let fields = [("oid", i64::from(oid)), ("next_clock", i64::from(next as u32))];
            self.say_bytes("analog_in_state", &fields, &values);
        }
        if struck && !self.is_shutdown() {
            self.shut("ADC out of range");
        }
    }
}
