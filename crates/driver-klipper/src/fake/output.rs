//! Outputs with their queues and their watch; inputs that report by themselves.

use super::board::Board;
use super::events::Event;
use super::words::Said;
use std::collections::VecDeque;

#[derive(Clone, Debug, Default)]
pub struct Output {
    pub pin: u32,
    /// Its value counts in parts of a PWM cycle.
    pwm: bool,
    default: u32,
    max_duration: u64,
    queue: VecDeque<(u64, u32)>,
    pub value: u32,
    /// Clock and value of each change.
    pub made: Vec<(u64, u32)>,
}

#[derive(Clone, Debug, Default)]
pub struct Buttons {
    pins: Vec<u32>,
    rest_ticks: u64,
    retransmit: u64,
    looks: u64,
    last: u8,
    seen: u8,
    told: Vec<u8>,
    acknowledged: u8,
}

#[derive(Clone, Debug, Default)]
pub struct Analog {
    pin: u32,
    rest_ticks: u64,
    samples: u32,
    range: [u32; 2],
    strikes: [u32; 2],
    values: Vec<u8>,
    report: usize,
}

impl Board {
    pub fn config_output(&mut self, said: &Said, pwm: bool) {
        let value = said.clock("value");
        let output = Output {
            pin: said.clock("pin"),
            pwm,
            default: said.clock("default_value"),
            max_duration: said.n("max_duration") as u64,
            value,
            ..Output::default()
        };
        self.outputs.insert(said.n("oid") as u8, output);
    }

    pub fn queue_output(&mut self, said: &Said, field: &str) {
        let oid = said.n("oid") as u8;
        let clock = self.at(said.clock("clock"));
        let Some(output) = self.outputs.get_mut(&oid) else { return self.shut("Invalid oid type") };
        let first = output.queue.is_empty();
        output.queue.push_back((clock, said.clock(field)));
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

    pub fn update_output(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        let Some(output) = self.outputs.get_mut(&oid) else { return self.shut("Invalid oid type") };
        if !output.queue.is_empty() {
            return self.shut("update_digital_out not valid with active queue");
        }
        self.events.drop(Event::Watch(oid));
        self.put(oid, said.clock("value"));
    }

    pub fn output(&mut self, oid: u8) {
        let output = self.outputs.get_mut(&oid).unwrap();
        let Some((_, value)) = output.queue.pop_front() else { return };
        self.places -= 1;
        self.put(oid, value);
    }

    fn put(&mut self, oid: u8, value: u32) {
        let now = self.now;
        let output = self.outputs.get_mut(&oid).unwrap();
        output.value = value;
        output.made.push((now, value));
        let off_default = value != output.default;
        let watch = (output.max_duration > 0 && off_default).then(|| now + output.max_duration);
        let next = output.queue.front().map(|(clock, _)| *clock);
        let (pin, pwm) = (output.pin, output.pwm);
        self.edge(pin, value != 0);
        match (next, watch) {
            (Some(next), Some(watch)) if next > watch => self.shut(if pwm {
                "Scheduled pwm event will exceed max_duration"
            } else {
                "Scheduled digital out event will exceed max_duration"
            }),
            (Some(next), _) => self.events.set(next, Event::Output(oid)),
            (None, Some(watch)) => self.events.set(watch, Event::Watch(oid)),
            (None, None) => {}
        }
    }

    pub fn watch(&mut self, oid: u8) {
        self.shut(if self.outputs[&oid].pwm {
            "Missed scheduling of next hard pwm event"
        } else {
            "Missed scheduling of next digital out event"
        });
    }

    /// Every output goes to its default, at a shutdown.
    pub fn outputs_off(&mut self) {
        let now = self.now;
        let mut off = Vec::new();
        for output in self.outputs.values_mut() {
            output.queue.clear();
            if output.value != output.default {
                output.value = output.default;
                output.made.push((now, output.default));
                off.push((output.pin, output.default != 0));
            }
        }
        off.into_iter().for_each(|(pin, level)| self.edge(pin, level));
    }

    pub fn add_button(&mut self, said: &Said) {
        let buttons = self.buttons.entry(said.n("oid") as u8).or_default();
        let at = said.n("pos") as usize;
        buttons.pins.resize(buttons.pins.len().max(at + 1), 0);
        buttons.pins[at] = said.clock("pin");
    }

    pub fn query_buttons(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        let buttons = self.buttons.entry(oid).or_default();
        buttons.rest_ticks = said.n("rest_ticks") as u64;
        buttons.retransmit = said.n("retransmit_count") as u64;
        buttons.seen = said.n("invert") as u8;
        buttons.last = buttons.seen;
        if buttons.rest_ticks > 0 {
            self.set_timer(said.clock("clock"), Event::Buttons(oid));
        }
    }

    pub fn ack_buttons(&mut self, said: &Said) {
        let count = said.n("count") as usize;
        let Some(buttons) = self.buttons.get_mut(&(said.n("oid") as u8)) else { return };
        let count = count.min(buttons.told.len());
        buttons.told.drain(..count);
        buttons.acknowledged = buttons.acknowledged.wrapping_add(count as u8);
    }

    pub fn look_at_buttons(&mut self, oid: u8) {
        let pins = self.buttons[&oid].pins.clone();
        let levels = pins.iter().enumerate().map(|(n, pin)| u8::from(self.level(*pin)) << n).sum();
        let now = self.now;
        let buttons = self.buttons.get_mut(&oid).unwrap();
        let mut tell = false;
        if levels == buttons.last && levels != buttons.seen && buttons.told.len() < 8 {
            buttons.seen = levels;
            buttons.told.push(levels);
            (tell, buttons.looks) = (true, 0);
        }
        buttons.last = levels;
        buttons.looks += 1;
        if !buttons.told.is_empty() && buttons.looks > buttons.retransmit {
            (tell, buttons.looks) = (true, 0);
        }
        let next = now + buttons.rest_ticks;
        let (count, told) = (buttons.acknowledged, buttons.told.clone());
        self.events.set(next, Event::Buttons(oid));
        if tell {
            let fields = [("oid", i64::from(oid)), ("ack_count", i64::from(count))];
            self.say_bytes("buttons_state", &fields, &told);
        }
    }

    pub fn query_analog(&mut self, said: &Said) {
        let oid = said.n("oid") as u8;
        self.events.drop(Event::Analog(oid));
        let analog = self.analogs.entry(oid).or_default();
        analog.samples = said.clock("sample_count");
        analog.rest_ticks = said.n("rest_ticks") as u64;
        analog.range = [said.clock("min_value"), said.clock("max_value")];
        analog.strikes = [0, said.clock("range_check_count").max(1)];
        analog.report = said.n("bytes_per_report") as usize;
        analog.values.clear();
        if analog.samples > 0 {
            self.set_timer(said.clock("clock"), Event::Analog(oid));
        }
    }

    pub fn config_analog(&mut self, said: &Said) {
        let analog = Analog { pin: said.clock("pin"), ..Analog::default() };
        self.analogs.insert(said.n("oid") as u8, analog);
    }

    pub fn sample(&mut self, oid: u8) {
        let now = self.now;
        let pin = self.analogs[&oid].pin;
        let reading = self.voltages.get(&pin).copied().unwrap_or(2048);
        let analog = self.analogs.get_mut(&oid).unwrap();
        let sum = reading * analog.samples;
        analog.values.extend((sum as u16).to_le_bytes());
        let out = sum < analog.range[0] || sum > analog.range[1];
        analog.strikes[0] = if out { analog.strikes[0] + 1 } else { 0 };
        let struck = analog.strikes[0] >= analog.strikes[1];
        let next = now + analog.rest_ticks;
        let full = analog.values.len() >= analog.report;
        let values = if full { std::mem::take(&mut analog.values) } else { Vec::new() };
        self.events.set(next, Event::Analog(oid));
        if full {
            let fields = [("oid", i64::from(oid)), ("next_clock", i64::from(next as u32))];
            self.say_bytes("analog_in_state", &fields, &values);
        }
        if struck && !self.is_shutdown() {
            self.shut("ADC out of range");
        }
    }
}
