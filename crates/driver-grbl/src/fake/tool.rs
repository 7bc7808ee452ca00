//! A change of tools that the fake begins by itself (`M6`), as grblHAL makes one by hand: it waits, takes jogs once it was
//! told that this was heard, and goes on by its button.

use super::read::read;
use super::{Fake, State};
use std::collections::VecDeque;

/// The error of a move while it waits for a tool.
pub(super) const WAITS_FOR_TOOL: u16 = 40;

/// The change of tools that is under way.
#[derive(Clone, Debug, Default)]
pub(super) struct Change {
    /// It was told that somebody has heard it.
    pub heard: bool,
    /// What it had received until then.
    aside: VecDeque<u8>,
    /// Its jog slows down for good.
    ends_jog: bool,
}

impl Fake {
    /// A macro, a pendant or its card has it change the tool.
    pub fn changes_tool(&mut self) {
        (self.state, self.change) = (State::Tool, Change::default());
        (self.spindle, self.coolant) = (false, 0);
    }

    /// Returns `true` while it waits for a tool.
    pub fn waits_for_tool(&self) -> bool {
        self.state == State::Tool
    }

    /// It is told that somebody has heard that it waits (0xA3): what it has is put aside.
    pub(super) fn hears_of_tool(&mut self) {
        if self.state == State::Tool && !self.change.heard {
            self.change.heard = true;
            self.change.aside = std::mem::take(&mut self.buffer);
        }
    }

    /// The tool is in.
    pub(super) fn tool_is_in(&mut self) {
        if self.change.heard && self.motion.is_empty() {
            let mut buffer = std::mem::take(&mut self.change.aside);
            buffer.append(&mut self.buffer);
            (self.buffer, self.state, self.change) = (buffer, State::Ready, Change::default());
        }
    }

    /// A jog, `G21G90G53X10F600`: makes it, or tells the error.
    pub(super) fn jogs(&mut self, line: &str) {
        let words = read(line).map_err(|number| format!("error:{number}"));
        let answer = words.map(|words| {
            let mut to = self.planned;
            for (place, told) in to.0.iter_mut().zip(words.to) {
                *place = told.unwrap_or(*place);
            }
            let speed = self.speed(to, words.feed_mm_min.unwrap_or_default() / 60.0);
            self.motion.push(self.planned, to, speed, (false, 0));
            self.planned = to;
        });
        self.tell(&answer.map_or_else(|error| error, |()| "ok".into()));
    }

    /// Its jog is to end (0x85).
    pub(super) fn cancels_jog(&mut self) {
        if self.state == State::Tool && !self.motion.is_empty() {
            (self.change.ends_jog, self.motion.held) = (true, true);
        }
    }

    /// A jog that was ended has come to a stand.
    pub(super) fn jog_ends(&mut self) {
        if self.change.ends_jog && self.motion.speed_mm_s == 0.0 {
            self.motion.clear();
            (self.change.ends_jog, self.motion.held) = (false, false);
            self.planned = self.motion.position;
        }
    }
}
