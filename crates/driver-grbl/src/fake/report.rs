//! Status reports of the fake.

use super::{Fake, HOMING_S, State, Way};
use kerf_machine::driver::Axes;

/// Reports between two that tell the offset of the workpiece.
const OFFSET_EVERY: usize = 10;

impl Fake {
    /// Answers `?`.
    pub(super) fn report(&mut self) {
        let mask = self.setting(10) as u32;
        let place = self.motion.position;
        let (name, place) = if mask & 1 == 1 {
            ("MPos", place)
        } else {
            ("WPos", place.minus(self.offsets.zero()))
        };
        let mut line = format!("<{}|{name}:{}", self.doing(), self.places(place));
        if mask & 2 == 2 {
            let room = self.board.rx.saturating_sub(self.buffer.len());
            line += &format!("|Bf:{},{room}", self.motion.free());
        }
        if let Some(field) = self.board.card.as_ref().and_then(|card| card.field()) {
            line += &field;
        }
        if self.board.numbers && self.motion.line() > 0 && (!self.board.hal || mask & 4 == 4) {
            line += &format!("|Ln:{}", self.motion.line());
        }
        let feed = self.motion.speed_mm_s * 60.0 / self.unit_mm();
        line += &format!("|FS:{feed:.0},{:.0}", self.spindle_rpm);
        let probe = if self.touches() && !self.pins.contains('P') { "P" } else { "" };
        if !self.pins.is_empty() || !probe.is_empty() {
            line += &format!("|Pn:{}{probe}", self.pins);
        }
        self.until_offset = self.until_offset.saturating_sub(1);
        let tells_offset = !self.board.hal || mask & 16 == 16;
        if self.until_offset == 0 && tells_offset {
            self.until_offset = OFFSET_EVERY;
            line += &format!("|WCO:{}", self.places(self.offsets.zero()));
        } else if self.until_offset == OFFSET_EVERY - 1 {
            line += &format!(
                "|Ov:{},{},{}",
                self.override_percent, self.rapid_percent, self.spindle_percent
            );
        }
        self.tell(&(line + ">"));
    }

    /// The modes that hold, as `$G` tells them.
    pub(super) fn modes(&self) -> String {
        let motion = match self.way {
            None | Some(Way::Rapid) => "G0",
            Some(Way::Cut) => "G1",
            Some(Way::Arc { counter: false }) => "G2",
            Some(Way::Arc { counter: true }) => "G3",
            Some(Way::Probe) => "G38.3",
        };
        let way = if self.relative { "G91" } else { "G90" };
        let spindle = if self.spindle { "M3" } else { "M5" };
        let coolant = ["M9", "M8", "M7", "M7 M8"][usize::from(self.coolant & 3)];
        let (feed, rpm) = (self.feed_mm_min, self.spindle_rpm);
        let system = self.offsets.system();
        format!(
            "[GC:{motion} {system} G17 G21 {way} G94 {spindle} {coolant} T0 F{feed:.0} S{rpm:.0}]"
        )
    }

    fn doing(&self) -> String {
        if let Some(said) = &self.says {
            return said.clone();
        }
        let moves = self.motion.speed_mm_s > 0.0;
        match self.state {
            State::Hold if moves => "Hold:1",
            State::Hold => "Hold:0",
            State::Door if moves => "Door:2",
            State::Door if self.pins.contains('D') => "Door:1",
            State::Door => "Door:0",
            State::Resuming if self.board.hal => "Door:4",
            State::Resuming => "Door:3",
            State::Alarm => "Alarm",
            State::Sleep => "Sleep",
            State::Check => "Check",
            State::Homing => "Home",
            State::Tool if self.motion.is_empty() || self.change.touches => "Tool",
            State::Tool => "Jog",
            State::Ready if self.motion.is_empty() => "Idle",
            State::Ready => "Run",
        }
        .into()
    }

    /// Places in the unit of `$13`.
    pub(super) fn places(&self, place: Axes) -> String {
        let (unit_mm, digits) = (self.unit_mm(), if self.setting(13) == 1.0 { 4 } else { 3 });
        let each = place.0[..3].iter().map(|v| format!("{:.digits$}", v / unit_mm));
        each.collect::<Vec<_>>().join(",")
    }

    fn unit_mm(&self) -> f64 {
        if self.setting(13) == 1.0 { 25.4 } else { 1.0 }
    }

    /// It counts where it stands in steps: other steps of a millimetre (`$100` to `$102`) make it another place.
    pub(super) fn counts_by(&mut self, number: u16, value: f64) {
        if (100..103).contains(&number) && value > 0.0 {
            self.motion.position.0[usize::from(number - 100)] *= self.setting(number) / value;
            self.planned = self.motion.position;
        }
    }

    pub(super) fn setting(&self, number: u16) -> f64 {
        self.settings.get(&number).copied().unwrap_or(0.0)
    }

    /// Goes home with all axes: to the end that `$23` names, at zero or at its travel.
    pub(super) fn homed(&self) -> Axes {
        let mut place = Axes::default();
        for axis in 0..3_u16 {
            let low = self.setting(23) as u32 & (1 << axis) != 0;
            place.0[usize::from(axis)] = match (self.forces_zero(), low) {
                (true, _) => 0.0,
                (false, true) => 1.0 - self.setting(130 + axis),
                (false, false) => -1.0,
            };
        }
        place
    }

    /// Home is at zero, at whatever end of the travel it is.
    pub(super) fn forces_zero(&self) -> bool {
        let letters = self.board.tells.iter().find_map(|line| line.strip_prefix("[OPT:"));
        let letters = letters.and_then(|line| line.split(',').next()).unwrap_or("");
        if self.board.hal { self.setting(22) as u32 & 8 != 0 } else { letters.contains('Z') }
    }

    pub(super) fn is_outside(&self, to: Axes) -> bool {
        (0..3_u16).any(|axis| {
            let travel = self.setting(130 + axis);
            let up = self.forces_zero() && self.setting(23) as u32 & (1 << axis) != 0;
            let (low, high) = if up { (0.0, travel) } else { (-travel, 0.0) };
            !(low..=high).contains(&to.0[usize::from(axis)])
        })
    }

    pub(super) const fn begins_homing(&mut self) {
        self.state = State::Homing;
        self.homed_s = Some(self.clock_s + HOMING_S);
    }
}
