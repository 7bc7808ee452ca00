//! The factor by which runs on a machine take longer than its controller's planner says: learned slowly from finished runs,
//! kept by the port of the controller.
//!
//! ```text
//!  finished run ── taken / told ──► Learned ──► factor ──► OwnPace: time told of the next run
//! ```

use kerf_journal::facts::Fact;
use kerf_workspace::stored::Stored;
use std::collections::BTreeMap;

/// The value that keeps what was learned: of each port, factor, runs and weight.
const PACES: &str = Fact::ControllerPaces.key();

/// A run that took longer or shorter by more than this factor was held up by something else.
const OUTLIER: f64 = 1.3;

/// A run of so many seconds counts in full, a shorter one by its share.
const FULL_S: f64 = 60.0;

/// A shorter run counts nothing: the time that it takes is that of its beginning and its end.
const LEAST_S: f64 = 1.0;

/// Weight of the belief that the planner is right, in full runs.
const PRIOR: f64 = 1.0;

/// Greatest weight of all before: a machine that was changed is learned anew within some tens of runs.
const MOST: f64 = 20.0;

/// The factor is told and used in steps of this: the time of a file does not change with each run.
const STEP: f64 = 0.01;

/// Ports of which something is kept at most.
const PORTS: usize = 64;

/// A factor that was learned from runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Learned {
    factor: f64,
    runs: u32,
    weight: f64,
}

impl Default for Learned {
    fn default() -> Self {
        Self { factor: 1.0, runs: 0, weight: PRIOR }
    }
}

/// As it is kept.
type Kept = BTreeMap<String, (f64, u32, f64)>;

fn kept(stored: &Stored) -> Kept {
    stored.get(PACES).and_then(|text| serde_json::from_str(text).ok()).unwrap_or_default()
}

impl Learned {
    /// Returns what was learned at a port.
    pub fn of(port: &str, stored: &Stored) -> Self {
        let kept = kept(stored).get(port).copied();
        kept.map_or_else(Self::default, |(factor, runs, weight)| Self { factor, runs, weight })
    }

    /// Keeps what was learned at a port. Of too many ports, one of the fewest runs is forgotten.
    pub fn keep(self, port: &str, stored: &mut Stored) {
        let mut all = kept(stored);
        all.insert(port.to_owned(), (self.factor, self.runs, self.weight));
        if all.len() > PORTS {
            let others = all.iter().filter(|(other, _)| *other != port);
            let fewest =
                others.min_by_key(|(_, (_, runs, _))| *runs).map(|(other, _)| other.clone());
            if let Some(other) = fewest {
                all.remove(&other);
            }
        }
        stored.set(PACES, serde_json::to_string(&all).ok().as_deref());
    }

    /// Forgets what was learned at a port.
    pub fn forget(port: &str, stored: &mut Stored) {
        let mut all = kept(stored);
        all.remove(port);
        let text = serde_json::to_string(&all).ok().filter(|_| !all.is_empty());
        stored.set(PACES, text.as_deref());
    }

    /// Learns from a run whose motion was told to take so long, and took so long, seconds.
    #[must_use]
    pub fn run(self, told_s: f64, taken_s: f64) -> Self {
        let ratio = taken_s / told_s;
        if told_s < LEAST_S || !(1.0 / OUTLIER..=OUTLIER).contains(&ratio) {
            return self;
        }
        let counts = (told_s / FULL_S).min(1.0);
        let weight = self.weight + counts;
        let factor = self.factor + counts / weight * (ratio - self.factor);
        Self { factor, runs: self.runs.saturating_add(1), weight: weight.min(MOST) }
    }

    /// Returns the factor, in hundredths.
    pub fn factor(self) -> f64 {
        (self.factor / STEP).round() * STEP
    }

    /// Returns the number of runs that it was learned from.
    pub const fn runs(self) -> u32 {
        self.runs
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The factor behind runs of which the time told and the time taken are given.
    fn after(runs: &[(f64, f64)]) -> Learned {
        runs.iter().fold(Learned::default(), |learned, (told, taken)| learned.run(*told, *taken))
    }

    #[test]
    fn many_runs_that_take_longer_are_told_so() {
        let learned = after(&[(100.0, 103.0); 30]);
        assert_eq!((learned.factor(), learned.runs()), (1.03, 30));
        assert_eq!((after(&[]).factor(), after(&[]).runs()), (1.0, 0));
    }

    #[test]
    fn one_run_is_half_believed_and_a_short_one_little() {
        assert_eq!(after(&[(100.0, 110.0)]).factor(), 1.05);
        assert_eq!(after(&[(6.0, 6.6)]).factor(), 1.01);
        assert_eq!(after(&[(0.5, 0.6); 100]), Learned::default());
    }

    #[test]
    fn what_held_a_run_up_is_not_learned() {
        let usual = [(100.0, 103.0); 30];
        let strange = [&usual[..], &[(100.0, 140.0), (100.0, 60.0), (100.0, f64::NAN)]].concat();
        assert_eq!(after(&strange), after(&usual));
    }

    #[test]
    fn a_machine_that_was_changed_is_learned_anew() {
        let runs = [[(100.0, 80.0); 200], [(100.0, 110.0); 200]].concat();
        assert!((after(&runs[..200]).factor() - 0.8).abs() < 0.011);
        assert!((after(&runs[..300]).factor() - 1.1).abs() < 0.02);
    }

    #[test]
    fn each_port_has_its_own_and_is_forgotten_alone() {
        let mut stored = Stored::default();
        let learned = after(&[(100.0, 103.0); 30]);
        learned.keep("/dev/ttyUSB0", &mut stored);
        learned.run(100.0, 90.0).keep("shop:23", &mut stored);
        assert_eq!(Learned::of("/dev/ttyUSB0", &stored), learned);
        Learned::forget("/dev/ttyUSB0", &mut stored);
        assert_eq!(Learned::of("/dev/ttyUSB0", &stored), Learned::default());
        assert_eq!(Learned::of("shop:23", &stored).runs(), 31);
    }
}
