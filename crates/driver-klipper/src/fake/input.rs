//! Inputs that report by themselves.

use super::words::Said;

#[derive(Clone, Debug, Default)]
pub struct Buttons {
    pub pins: Vec<u32>,
    pub rest_ticks: u64,
    retransmit: u64,
    looks: u64,
    last: u8,
    seen: u8,
    pub told: Vec<u8>,
    pub acknowledged: u8,
}

impl Buttons {
    pub fn add(&mut self, said: &Said) {
        let at = said.n("pos") as usize;
        self.pins.resize(self.pins.len().max(at + 1), 0);
        self.pins[at] = said.clock("pin");
    }

    pub fn query(&mut self, said: &Said) {
        self.rest_ticks = said.n("rest_ticks") as u64;
        self.retransmit = said.n("retransmit_count") as u64;
        self.seen = said.n("invert") as u8;
        self.last = self.seen;
    }

    pub fn acknowledge(&mut self, said: &Said) {
        let count = (said.n("count") as usize).min(self.told.len());
        self.told.drain(..count);
        self.acknowledged = self.acknowledged.wrapping_add(count as u8);
    }

    /// Looks at the levels of its pins, a bit each; true where it tells what it has seen.
    pub fn look(&mut self, levels: u8) -> bool {
        let mut tells = false;
        if levels == self.last && levels != self.seen && self.told.len() < 8 {
            self.seen = levels;
            self.told.push(levels);
            (tells, self.looks) = (true, 0);
        }
        self.last = levels;
        self.looks += 1;
        if !self.told.is_empty() && self.looks > self.retransmit {
            (tells, self.looks) = (true, 0);
        }
        tells
    }
}

#[derive(Clone, Debug, Default)]
pub struct Analog {
    pub pin: u32,
    pub rest_ticks: u64,
    pub samples: u32,
    range: [u32; 2],
    strikes: [u32; 2],
    values: Vec<u8>,
    report: usize,
}

impl Analog {
    pub fn new(said: &Said) -> Self {
        Self { pin: said.clock("pin"), ..Self::default() }
    }

    pub fn query(&mut self, said: &Said) {
        self.samples = said.clock("sample_count");
        self.rest_ticks = said.n("rest_ticks") as u64;
        self.range = [said.clock("min_value"), said.clock("max_value")];
        self.strikes = [0, said.clock("range_check_count").max(1)];
        self.report = said.n("bytes_per_report") as usize;
        self.values.clear();
    }

    /// Takes a reading; true where it was out of range too often.
    pub fn sample(&mut self, reading: u32) -> bool {
        let sum = reading * self.samples;
        self.values.extend((sum as u16).to_le_bytes());
        let out = sum < self.range[0] || sum > self.range[1];
        self.strikes[0] = if out { self.strikes[0] + 1 } else { 0 };
        self.strikes[0] >= self.strikes[1]
    }

    /// Readings that fill a report.
    pub fn report(&mut self) -> Option<Vec<u8>> {
        (self.values.len() >= self.report).then(|| std::mem::take(&mut self.values))
    }
}
