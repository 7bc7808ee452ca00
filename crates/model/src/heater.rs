//! A heater held at a temperature (command reference, VH): heat at the PWM that the low cycle time
//! leaves, or none. How fast it warms and cools is a guess; control does not depend on it.

use kerf_program::settings::{IoModes, TorchHeight};

/// Temperature without heat, degrees.
const AMBIENT: f64 = 20.0;
/// Rise above it that full heat brings in the end, degrees.
const FULL: f64 = 600.0;
/// In such a time it comes to within 37 % of where it tends, seconds.
const TIME_S: f64 = 60.0;
/// Heat goes on so far below the set temperature and off so far above, degrees.
const BAND: f64 = 1.0;
/// So little above its surroundings it counts as cold, degrees.
const COLD: f64 = 0.01;
/// Most changes of heat that are simulated in one wait.
const MOST_CHANGES: usize = 100_000;

/// The heater and its temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Heater {
    degrees: f64,
    at_s: f64,
    heats: bool,
}

impl Default for Heater {
    fn default() -> Self {
        Self { degrees: AMBIENT, at_s: 0.0, heats: false }
    }
}

/// Returns `true` if VN and VH let it be controlled: analog inputs are 3 to 5 of VN's third value.
pub(crate) const fn active(height: &TorchHeight, modes: &IoModes) -> bool {
    height.on && modes.analog >= 3 && height.temperature > 0.0
}

/// PWM while it heats, percent: the low cycle time is the share of time, in tenths, at low.
fn percent(height: &TorchHeight) -> f64 {
    (100.0 - 10.0 * height.low_cycle).clamp(0.0, 100.0)
}

impl Heater {
    /// Its temperature, degrees.
    pub(crate) const fn degrees(&self) -> f64 {
        self.degrees
    }

    /// Tells whether it heats.
    pub(crate) const fn heats(&self) -> bool {
        self.heats
    }

    /// The clock was set back by so much.
    pub(crate) fn set_back(&mut self, by_s: f64) {
        self.at_s -= by_s;
    }

    /// Cools until a time.
    pub(crate) fn cool(&mut self, to_s: f64) {
        self.heats = false;
        if self.degrees > AMBIENT {
            self.tend(to_s, AMBIENT);
        }
        if self.degrees < AMBIENT + COLD {
            (self.degrees, self.at_s) = (AMBIENT, self.at_s.max(to_s));
        }
    }

    /// Is controlled until a time; tells when the PWM changes, and to what percent.
    pub(crate) fn hold(&mut self, to_s: f64, height: &TorchHeight, mut tell: impl FnMut(f64, f64)) {
        for _ in 0..MOST_CHANGES {
            let goal = self.goal(height);
            let edge = height.temperature + if self.heats { BAND } else { -BAND };
            let reached = (self.degrees - edge) * if self.heats { 1.0 } else { -1.0 } >= 0.0;
            let share = (self.degrees - goal) / (edge - goal);
            let wait_s = if reached { 0.0 } else { TIME_S * share.max(0.0).ln() };
            if !(wait_s >= 0.0 && self.at_s + wait_s <= to_s) {
                break;
            }
            if !reached {
                (self.degrees, self.at_s) = (edge, self.at_s + wait_s);
            }
            self.heats = !self.heats;
            tell(self.at_s, if self.heats { percent(height) } else { 0.0 });
        }
        self.tend(to_s, self.goal(height));
    }

    fn goal(&self, height: &TorchHeight) -> f64 {
        AMBIENT + if self.heats { FULL * percent(height) / 100.0 } else { 0.0 }
    }

    fn tend(&mut self, to_s: f64, goal: f64) {
        let passed_s = (to_s - self.at_s).max(0.0);
        self.degrees = goal + (self.degrees - goal) * (-passed_s / TIME_S).exp();
        self.at_s = self.at_s.max(to_s);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::Settings;

    #[test]
    fn it_warms_is_held_and_cools() {
        let mut height = Settings::default().height;
        (height.low_cycle, height.temperature) = (5.0, 200.0);
        let mut heater = Heater::default();
        let mut changes = Vec::new();
        heater.hold(50.0, &height, |t_s, percent| changes.push((t_s, percent)));
        assert_eq!(changes, [(0.0, 50.0)]);
        for minute in 2..30 {
            let to_s = 60.0 * f64::from(minute);
            heater.hold(to_s, &height, |t_s, percent| changes.push((t_s, percent)));
            assert!((heater.degrees() - 200.0).abs() <= BAND + 1e-9, "{}", heater.degrees());
        }
        assert!(changes.windows(2).all(|c| c[0].0 < c[1].0 && c[0].1 != c[1].1));
        heater.cool(1e5);
        assert!((heater.degrees() - AMBIENT).abs() < 1e-9);
    }

    #[test]
    fn a_heater_too_weak_or_a_wait_without_end_is_no_trouble() {
        let mut height = Settings::default().height;
        (height.low_cycle, height.temperature) = (10.0, 200.0);
        let mut heater = Heater::default();
        heater.hold(1e300, &height, |_, _| {});
        assert_eq!(heater.degrees(), AMBIENT);
        height.low_cycle = 1.0;
        heater.hold(f64::INFINITY, &height, |_, _| {});
        assert!(heater.degrees().is_finite());
    }
}
