//! Zero points that the controller keeps: those of its coordinate systems, the shift of `G92` and that by the length of
//! the tool, as `$#` and `$G` tell them.

use crate::facts::KnownFacts;
use crate::place::millimetres;
use crate::report::axes;
use kerf_machine::driver::{Axes, Zero, ZeroChange};

/// The axis that a length tells of which no axis is told.
const Z: usize = 2;

/// Zero points as they were told last, by their names.
#[derive(Clone, Debug, Default)]
pub struct Zeros {
    told: Vec<Zero>,
    /// The coordinate system that holds.
    system: String,
    /// The zero in force as a report told it last.
    in_force: Option<Axes>,
    /// They are to be asked for once more.
    stale: bool,
    /// A tool was touched off by which the lengths of others are told.
    has_reference: bool,
}

impl Zeros {
    /// Learns from `[G54:1.000,2.000,3.000]`; tells whether it was one of them.
    pub fn bracket(&mut self, name: &str, value: &str, told: &KnownFacts) -> bool {
        if name == "TLR" {
            self.has_reference = true;
            return true;
        }
        // The first of a list, at whose end the reference is told where there is one.
        self.has_reference &= name != Zero::SYSTEMS[0];
        let is_shift = [Zero::SHIFT, Zero::TOOL].contains(&name);
        let is_one = is_shift || Zero::SYSTEMS.contains(&name);
        let Some((mut at, count)) = axes(value).filter(|_| is_one) else { return is_one };
        if count == 1 {
            at.0.swap(0, Z);
        }
        let at = millimetres(at, told);
        match self.told.iter_mut().find(|zero| zero.name == name) {
            Some(zero) => zero.at = at,
            None => {
                let holds = is_shift || name == self.system;
                self.told.push(Zero { name: name.to_owned(), at, holds });
            }
        }
        true
    }

    /// Learns from the words of `$G` which coordinate system holds.
    pub fn modes(&mut self, modes: &str) {
        let mut words = modes.split_whitespace();
        let Some(system) = words.find(|word| Zero::SYSTEMS.contains(word)) else { return };
        system.clone_into(&mut self.system);
        for zero in self.told.iter_mut().filter(|zero| !zero.is_shift()) {
            zero.holds = zero.name == system;
        }
    }

    /// Learns of the zero in force: where it is another than before, or the first, somebody may have changed one.
    pub fn hear(&mut self, in_force: Axes) {
        self.stale |= self.in_force.replace(in_force) != Some(in_force);
    }

    /// Returns `true` if it has told of a tool that is the reference of the others.
    pub const fn has_reference(&self) -> bool {
        self.has_reference
    }

    /// Returns them as they were told last.
    pub fn told(&self) -> &[Zero] {
        &self.told
    }

    /// Returns the coordinate system that holds, where it is none that a reset chooses.
    pub fn chosen(&self) -> Option<&str> {
        Some(&*self.system).filter(|system| !["", Zero::SYSTEMS[0]].contains(system))
    }

    /// Returns `true` if they are to be asked for again, once.
    pub const fn are_stale(&mut self) -> bool {
        std::mem::replace(&mut self.stale, false)
    }

    /// Returns the line by which a zero point of so many axes is changed; nothing where it is not kept, or cannot be changed so.
    pub fn line(&self, name: &str, change: ZeroChange, axes: usize) -> Option<String> {
        let is_kept = self.told.iter().any(|zero| zero.name == name);
        is_kept.then(|| change.line(name, axes))?
    }
}
