//! A change of tools that the fake begins by itself (`M6`), as grblHAL makes one by hand: it waits, takes jogs once it was
//! told that this was heard, and goes on by its button. By `$341` the tool has to be touched off first (`$TPW`).

use super::read::read;
use super::{Fake, State};
use kerf_machine::driver::Axes;
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
    /// It touches the tool off.
    pub touches: bool,
    /// The tool is touched off, or its zero point was set.
    is_touched: bool,
}

/// Feed at which a tool is touched off, mm/s.
const TOUCH_MM_S: f64 = 10.0;

/// Way down on which it looks for the plate, mm, where no setting says it.
const TOUCH_MM: f64 = 30.0;

/// Way up from the plate, mm.
const LIFT_MM: f64 = 4.0;

/// The error of a line that makes no sense now.
const NO_SENSE: u16 = 3;

/// The error of a tool that was not touched off.
const NOT_TOUCHED: u16 = 38;

/// It is told that somebody has heard that it waits (0xA3): what it has is put aside.
pub(super) fn hears_of_tool(fake: &mut Fake) {
    if fake.state == State::Tool && !fake.change.heard {
        fake.change.heard = true;
        fake.change.aside = std::mem::take(&mut fake.buffer);
    }
}

/// The tool is in.
pub(super) fn tool_is_in(fake: &mut Fake) {
    if !fake.change.heard || !fake.motion.is_empty() {
        return;
    }
    if is_touched_off(fake) && !fake.change.is_touched {
        return fake.tell("[MSG:Warning: touch the tool off with $TPW before that]");
    }
    let mut buffer = std::mem::take(&mut fake.change.aside);
    buffer.append(&mut fake.buffer);
    (fake.buffer, fake.state, fake.change) = (buffer, State::Ready, Change::default());
}

/// Its setting has tools touched off.
fn is_touched_off(fake: &Fake) -> bool {
    fake.board.hal && [1.0, 2.0].contains(&fake.setting(341))
}

/// A zero point was set, which may have been that of the tool.
pub(super) const fn zero_is_set(fake: &mut Fake) {
    fake.change.is_touched = true;
}

/// It is to touch the tool off (`$TPW`): goes down until its probe touches something.
pub(super) fn touches_off(fake: &mut Fake) {
    if !is_touched_off(fake) || fake.state != State::Tool || !fake.change.heard {
        return fake.tell(&format!("error:{NO_SENSE}"));
    }
    let far_mm = Some(fake.setting(342)).filter(|mm| *mm > 0.0).unwrap_or(TOUCH_MM);
    let to = fake.planned.plus(Axes::xyz(0.0, 0.0, -far_mm));
    fake.motion.push(fake.planned, to, TOUCH_MM_S, (false, 0));
    (fake.planned, fake.probing, fake.change.touches) = (to, Some(true), true);
}

/// Its probe has ended that: the tool is longer than the one that is the reference by so much, and lifts off the plate.
pub(super) fn is_touched(fake: &mut Fake, at: Option<Axes>) {
    let Some(at) = at else {
        fake.change.touches = false;
        return fake.tell(&format!("error:{NOT_TOUCHED}"));
    };
    (fake.change.is_touched, fake.touched_mm) = (true, Some(at.0[2]));
    if let Some(reference_mm) = fake.reference_mm {
        fake.offsets.tool_mm = at.0[2] - reference_mm;
        fake.until_offset = 1;
    }
    let lifted = fake.planned.plus(Axes::xyz(0.0, 0.0, LIFT_MM));
    fake.motion.push(fake.planned, lifted, TOUCH_MM_S, (false, 0));
    fake.planned = lifted;
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

/// A jog that was ended has come to a stand, or a tool that was touched off is off the plate.
pub(super) fn jog_ends(fake: &mut Fake) {
    if fake.change.touches && fake.probing.is_none() && fake.motion.is_empty() {
        fake.change.touches = false;
        fake.tell("ok");
    }
    if fake.change.ends_jog && fake.motion.speed_mm_s == 0.0 {
        fake.motion.clear();
        (fake.change.ends_jog, fake.motion.held) = (false, false);
        fake.planned = fake.motion.position;
    }
}
