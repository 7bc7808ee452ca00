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

/// It is told that somebody has heard that it waits (0xA3): what it has is put aside.
pub(super) fn hears_of_tool(fake: &mut Fake) {
    if fake.state == State::Tool && !fake.change.heard {
        fake.change.heard = true;
        fake.change.aside = std::mem::take(&mut fake.buffer);
    }
}

/// The tool is in.
pub(super) fn tool_is_in(fake: &mut Fake) {
    if fake.change.heard && fake.motion.is_empty() {
        let mut buffer = std::mem::take(&mut fake.change.aside);
        buffer.append(&mut fake.buffer);
        (fake.buffer, fake.state, fake.change) = (buffer, State::Ready, Change::default());
    }
}

/// A jog, `G21G90G53X10F600`: makes it, or tells the error.
pub(super) fn jogs(fake: &mut Fake, line: &str) {
    let words = read(line).map_err(|number| format!("error:{number}"));
    let answer = words.map(|words| {
        let mut to = fake.planned;
        for (place, told) in to.0.iter_mut().zip(words.to) {
            *place = told.unwrap_or(*place);
        }
        let speed = fake.speed(to, words.feed_mm_min.unwrap_or_default() / 60.0);
        fake.motion.push(fake.planned, to, speed, (false, 0));
        fake.planned = to;
    });
    fake.tell(&answer.map_or_else(|error| error, |()| "ok".into()));
}

/// Its jog is to end (0x85).
pub(super) fn cancels_jog(fake: &mut Fake) {
    if fake.state == State::Tool && !fake.motion.is_empty() {
        (fake.change.ends_jog, fake.motion.held) = (true, true);
    }
}

/// A jog that was ended has come to a stand.
pub(super) fn jog_ends(fake: &mut Fake) {
    if fake.change.ends_jog && fake.motion.speed_mm_s == 0.0 {
        fake.motion.clear();
        (fake.change.ends_jog, fake.motion.held) = (false, false);
        fake.planned = fake.motion.position;
    }
}
