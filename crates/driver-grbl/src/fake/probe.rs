//! The probe of the fake.

use super::Fake;

impl Fake {
    /// Returns `true` if its probe has contact.
    pub(super) fn touches(&self) -> bool {
        let touches = self.plate_mm.is_some_and(|plate_mm| self.motion.position.0[2] <= plate_mm);
        touches || self.pins.contains('P')
    }

    /// While it probes: latches the place of a change, slows down, and tells of it.
    pub(super) fn probe(&mut self) {
        let Some(state) = self.probing else { return };
        if self.latched.is_none() && self.touches() == state {
            let mut place = self.motion.position;
            place.0[2] = self.plate_mm.unwrap_or(place.0[2]);
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
            self.latched = None;
            self.tell(&format!("[PRB:{}:{changed}]", self.places(place)));
            self.tell("ok");
        }
    }
}
