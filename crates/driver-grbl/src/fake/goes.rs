//! The moves of the fake: from the words of a line into its planner, and those that end at a contact of its probe.

use super::read::{Way, Words};
use super::tool::is_touched;
use super::{Fake, arc};
use kerf_machine::driver::Axes;

impl Fake {
    /// Makes the move of a line, as far as it is one; returns the number of the error where it is refused.
    pub(super) fn go(&mut self, words: &Words) -> Option<u16> {
        self.motion.accel_mm_s2 = [120, 121, 122].map(|number| self.setting(number));
        self.motion.junction_mm = self.setting(11);
        self.relative = words.relative.unwrap_or(self.relative);
        self.way = words.way.or(self.way);
        let moves = words.to.iter().any(Option::is_some) && words.probes.is_none();
        if !moves && words.probes.is_none() {
            return None;
        }
        if words.machine && !matches!(self.way, Some(Way::Rapid | Way::Cut)) {
            return Some(30);
        }
        let rapid = matches!(self.way, None | Some(Way::Rapid));
        if self.feed_mm_min <= 0.0 && !rapid {
            return Some(22);
        }
        let mut to = self.planned;
        for (axis, place) in words.to.iter().enumerate() {
            // Places of the machine frame (G53) are no ways.
            let from = if self.relative && !words.machine { to.0[axis] } else { 0.0 };
            to.0[axis] = place.map_or(to.0[axis], |place| from + place);
        }
        if self.setting(20) == 1.0 && self.is_outside(to) {
            self.alarm(2);
            return Some(15);
        }
        if let Some(Way::Arc { counter }) = self.way {
            let chords = arc::chords(self.planned, to, words.centre, counter, self.setting(12));
            return match chords {
                Err(number) => Some(number),
                Ok(chords) => {
                    self.chords = (chords, words.number);
                    None
                }
            };
        }
        let feed_mm_s = if rapid { f64::INFINITY } else { self.feed_mm_min / 60.0 };
        self.motion.push(self.planned, to, self.speed(to, feed_mm_s), (rapid, words.number));
        self.planned = to;
        None
    }

    /// Chords of an arc join the planner as far as there is room; it is answered when all have.
    pub(super) fn goes_round(&mut self) -> bool {
        while self.motion.free() > 0
            && let Some(to) = self.chords.0.pop()
        {
            let speed_mm_s = self.speed(to, self.feed_mm_min / 60.0);
            self.motion.push(self.planned, to, speed_mm_s, (false, self.chords.1));
            self.planned = to;
        }
        let is_round = self.chords.0.is_empty();
        if is_round {
            self.tell("ok");
        }
        is_round
    }

    /// The feed, as far as every axis can follow.
    pub(super) fn speed(&self, to: Axes, feed_mm_s: f64) -> f64 {
        let way = kerf_machine::driver::way_mm(self.planned, to);
        (0..3_u16).fold(feed_mm_s, |speed, axis| {
            let share = (to.0[usize::from(axis)] - self.planned.0[usize::from(axis)]).abs() / way;
            let most = self.settings.get(&(110 + axis)).copied().unwrap_or(f64::INFINITY) / 60.0;
            if share > 0.0 { speed.min(most / share) } else { speed }
        })
    }

    /// Returns `true` if its probe has contact.
    pub(super) fn touches(&self) -> bool {
        let touches = self.plate_mm.is_some_and(|plate_mm| self.motion.position.0[2] <= plate_mm);
        let [x, y, z, ..] = self.motion.position.0;
        let meets = self.solids.iter().any(|solid| solid.touches([x, y, z]));
        touches || meets || self.pins.contains('P')
    }

    /// While it probes: latches the place of a change, slows down, and tells of it.
    pub(super) fn probe(&mut self) {
        let Some(state) = self.probing else { return };
        if self.latched.is_none() && self.touches() == state {
            let mut place = self.motion.position;
            if let Some(plate_mm) = self.plate_mm.filter(|plate_mm| place.0[2] <= *plate_mm) {
                place.0[2] = plate_mm;
            }
            self.latched = Some(place);
            self.motion.held = true;
        }
        let over =
            self.motion.is_empty() || self.latched.is_some() && self.motion.speed_mm_s == 0.0;
        if over {
            self.motion.clear();
            (self.motion.held, self.probing) = (false, None);
            self.planned = self.motion.position;
            let (place, changed) =
                (self.latched.unwrap_or_default(), u8::from(self.latched.is_some()));
            let latched = self.latched.take();
            self.tell(&format!("[PRB:{}:{changed}]", self.places(place)));
            match self.change.touches {
                true => is_touched(self, latched),
                false => self.tell("ok"),
            }
        }
    }
}
