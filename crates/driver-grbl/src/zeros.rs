//! Zero points that the controller keeps: those of its coordinate systems and the shift of `G92`, as `$#` tells them.

use crate::facts::KnownFacts;
use crate::place::millimetres;
use crate::report::axes;
use kerf_machine::driver::{Axes, Zero};

/// The coordinate systems in the order of the words `G10 L2 P…`.
const SYSTEMS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];

/// The name of the shift that holds in all of them.
const SHIFT: &str = "G92";

/// Zero points as they were told last, by their names.
#[derive(Clone, Debug, Default)]
pub struct Zeros {
    told: Vec<Zero>,
    /// The zero in force as a report told it last.
    in_force: Option<Axes>,
    /// They are to be asked for once more.
    stale: bool,
}

impl Zeros {
    /// Learns from `[G54:1.000,2.000,3.000]`; tells whether it was one of them.
    pub fn bracket(&mut self, name: &str, value: &str, told: &KnownFacts) -> bool {
        let is_one = SYSTEMS.contains(&name) || name == SHIFT;
        let Some((at, _)) = axes(value).filter(|_| is_one) else { return is_one };
        let at = millimetres(at, told);
        match self.told.iter_mut().find(|zero| zero.name == name) {
            Some(zero) => zero.at = at,
            None => self.told.push(Zero { name: name.to_owned(), at }),
        }
        true
    }

    /// Learns of the zero in force: where it is another than before, or the first, somebody may have changed one.
    pub fn hear(&mut self, in_force: Axes) {
        self.stale |= self.in_force.replace(in_force) != Some(in_force);
    }

    /// Returns them as they were told last.
    pub fn told(&self) -> &[Zero] {
        &self.told
    }

    /// Returns `true` if they are to be asked for again, once.
    pub const fn are_stale(&mut self) -> bool {
        std::mem::replace(&mut self.stale, false)
    }
}

/// Returns the line by which a zero point is kept for so many axes; nothing where there is none of this name. A shift can only
/// be taken away.
pub fn line(name: &str, at: Axes, axes: usize) -> Option<String> {
    let word = |(letter, mm): (char, &f64)| format!("{letter}{mm:.3}");
    let words = || -> String { "XYZABC".chars().zip(&at.0).take(axes).map(word).collect() };
    match SYSTEMS.iter().position(|system| *system == name) {
        Some(index) => Some(format!("G10L2P{}{}", index + 1, words())),
        None => (name == SHIFT && at == Axes::default()).then(|| "G92.1".into()),
    }
}
