//! The facts that a controller tells of itself: its version line (`$I`) and its settings (`$$`).

use kerf_machine::driver::{AXES, Facts};
use std::collections::BTreeMap;

/// Bytes that the receive buffer of grbl holds, where it does not say.
const RX: usize = 128;

/// Moves that the planner of grbl holds, where it does not say.
const PLANNER: usize = 15;

/// The bit of `$10` that has the place told in the machine frame, and the one that has the buffers told.
const TELLS: u32 = 3;

/// Facts that are known so far.
#[derive(Clone, Debug)]
pub struct Told {
    version: String,
    /// It is grblHAL, which has more outputs.
    hal: bool,
    settings: BTreeMap<u16, f64>,
    /// Bytes that its receive buffer holds.
    pub rx: usize,
    /// Moves that its planner holds.
    pub planner: usize,
}

impl Default for Told {
    fn default() -> Self {
        let (version, settings) = (String::new(), BTreeMap::new());
        Self { version, hal: false, settings, rx: RX, planner: PLANNER }
    }
}

impl Told {
    /// Learns from a line in brackets.
    pub fn bracket(&mut self, line: &str) {
        let Some((name, value)) = line.trim_matches(['[', ']']).split_once(':') else { return };
        match name {
            "VER" => value.trim_end_matches(':').clone_into(&mut self.version),
            "FIRMWARE" => self.hal = value == "grblHAL",
            "OPT" => {
                let mut sizes = value.split(',').skip(1).map(str::parse);
                if let Some(Ok(planner)) = sizes.next() {
                    self.planner = planner;
                }
                if let Some(Ok(rx)) = sizes.next() {
                    self.rx = rx;
                }
            }
            _ => {}
        }
    }

    /// Learns from a line `$110=500.000`; tells whether it is one.
    pub fn setting(&mut self, line: &str) -> bool {
        let read = || {
            let (number, value) = line.strip_prefix('$')?.split_once('=')?;
            let value = value.split_whitespace().next()?;
            Some((number.parse().ok()?, value.parse().ok()?))
        };
        let read: Option<(u16, f64)> = read();
        self.settings.extend(read);
        read.is_some()
    }

    fn of(&self, number: u16) -> Option<f64> {
        self.settings.get(&number).copied()
    }

    fn is_on(&self, number: u16) -> bool {
        self.of(number).is_some_and(|value| value as u32 & 1 == 1)
    }

    /// The line that makes it tell its place and its buffers, where it does not.
    pub fn mend(&self) -> Option<String> {
        let mask = self.of(10).unwrap_or(0.0) as u32;
        (mask & TELLS != TELLS).then(|| format!("$10={}", mask | TELLS))
    }

    /// Steps of an axis, a millimetre or degree.
    pub fn steps(&self, axis: usize) -> f64 {
        self.of(100 + axis as u16).unwrap_or(0.0)
    }

    /// The outputs there are.
    fn outputs(&self) -> u32 {
        // Spindle, flood and mist; grblHAL has four more on most boards.
        if self.hal { 0b111_1111 } else { 0b111 }
    }

    /// All of it, for whoever plans.
    pub fn facts(&self, axes: usize) -> Facts {
        let each = |of: &dyn Fn(usize) -> Option<f64>| {
            std::array::from_fn::<_, AXES, _>(|axis| of(axis).filter(|_| axis < axes))
        };
        let speed_mm_s = each(&|axis| Some(self.of(110 + axis as u16)? / 60.0));
        let ends = each(&|axis| self.of(130 + axis as u16).filter(|_| self.is_on(20)));
        let name = if self.hal { "grblHAL" } else { "grbl" };
        Facts {
            name: format!("{name} {}", self.version).trim_end().to_owned(),
            axes,
            speed_mm_s,
            // Without the option HOMING_FORCE_SET_ORIGIN, home is at 0 and everything else below.
            travel_mm: ends.map(|end| Some((-end?, 0.0))),
            homes: self.is_on(22),
            arc_tolerance_mm: self.of(12).unwrap_or(0.002),
            outputs: self.outputs(),
            spindle_rpm: self.of(30).unwrap_or(1000.0),
            overrides: true,
        }
    }
}

/// Tells how a locked controller takes orders again, in words.
pub const fn locked(homes: bool) -> &'static str {
    if homes {
        "home it first (--home)"
    } else {
        "look why, set its location, and unlock it (--unlock)"
    }
}
