//! An output with its queue and its watch.

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

/// The event that a changed output awaits, with its clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Awaits {
    Change(u64),
    Watch(u64),
    Nothing,
}

impl Output {
    pub fn new(said: &Said, pwm: bool) -> Self {
        Self {
            pin: said.clock("pin"),
            pwm,
            default: said.clock("default_value"),
            max_duration: said.n("max_duration") as u64,
            value: said.clock("value"),
            ..Self::default()
        }
    }

    pub fn is_queued(&self) -> bool {
        !self.queue.is_empty()
    }

    pub fn push(&mut self, clock: u64, value: u32) {
        self.queue.push_back((clock, value));
    }

    pub fn pop(&mut self) -> Option<u32> {
        self.queue.pop_front().map(|(_, value)| value)
    }

    /// Changes to a value; a reason to shut down where the change that follows comes too late.
    pub fn put(&mut self, value: u32, now: u64) -> Result<Awaits, &'static str> {
        self.value = value;
        self.made.push((now, value));
        let off_default = value != self.default;
        let watch = (self.max_duration > 0 && off_default).then(|| now + self.max_duration);
        let next = self.queue.front().map(|(clock, _)| *clock);
        match (next, watch) {
            (Some(next), Some(watch)) if next > watch => Err(match self.pwm {
                true => "Scheduled pwm event will exceed max_duration",
                false => "Scheduled digital out event will exceed max_duration",
            }),
            (Some(next), _) => Ok(Awaits::Change(next)),
            (None, Some(watch)) => Ok(Awaits::Watch(watch)),
            (None, None) => Ok(Awaits::Nothing),
        }
    }

    /// The reason to shut down when its watch has run out.
    pub fn missed(&self) -> &'static str {
        match self.pwm {
            true => "Missed scheduling of next hard pwm event",
            false => "Missed scheduling of next digital out event",
        }
    }

    /// Goes to its default, at a shutdown; tells the level of its pin where that changes.
    pub fn off(&mut self, now: u64) -> Option<bool> {
        self.queue.clear();
        (self.value != self.default).then(|| {
            self.value = self.default;
            self.made.push((now, self.default));
            self.default != 0
        })
    }
}
