//! Zero points as controllers that are none keep them: G54 to G59.3, G92.

use super::{Axes, Zero};

/// Zero points, machine frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct Offsets {
    /// Those of the coordinate systems, G54 first.
    pub systems: [Axes; 9],
    /// The one that holds.
    pub chosen: usize,
    /// Length of the tool, Z.
    pub tool_mm: f64,
    /// The shift of G92.
    pub shift: Axes,
}

impl Offsets {
    /// Returns the zero of the workpiece.
    pub fn zero(&self) -> Axes {
        self.systems[self.chosen].plus(self.shift).plus(Axes::xyz(0.0, 0.0, self.tool_mm))
    }

    /// The name of the coordinate system that holds.
    pub const fn system(&self) -> &'static str {
        Zero::SYSTEMS[self.chosen]
    }

    /// Returns the lines that tell of all of them (`$#`).
    pub fn told(&self, places: impl Fn(Axes) -> String) -> Vec<String> {
        let named = Zero::SYSTEMS.iter().zip(self.systems).chain([(&"G92", self.shift)]);
        let line = |(name, at): (&&str, Axes)| format!("[{name}:{}]", places(at));
        named.map(line).chain([format!("[TLO:{:.3}]", self.tool_mm)]).collect()
    }

    /// Keeps a zero point that a line names, of a machine at a place; tells whether it is such a line.
    pub fn keeps(&mut self, line: &str, position: Axes) -> bool {
        if line == "G92.1" {
            self.shift = Axes::default();
        } else if let Some(chosen) = Zero::SYSTEMS.iter().position(|system| *system == line) {
            self.chosen = chosen;
        } else if let Some(words) = line.strip_prefix("G10L20P") {
            let free = position.minus(self.zero()).plus(self.systems[self.chosen]);
            return self.writes(words, |reads, axis| free.0[axis] - reads);
        } else if let Some(words) = line.strip_prefix("G10L2P") {
            return self.writes(words, |place, _| place);
        } else if let Some(words) = line.strip_prefix("G92") {
            let free = position.minus(self.systems[self.chosen]);
            let shift = &mut self.shift;
            each(words, |axis, reads| shift.0[axis] = free.0[axis] - reads);
        } else {
            return false;
        }
        true
    }

    /// Writes a coordinate system, `1X5Y-2`: each axis gets what becomes of its number.
    fn writes(&mut self, words: &str, becomes: impl Fn(f64, usize) -> f64) -> bool {
        let (index, words) = words.split_at(words.find(char::is_alphabetic).unwrap_or(0));
        let index: usize = index.parse().unwrap_or(0);
        let Some(system) = index.checked_sub(1).and_then(|it| self.systems.get_mut(it)) else {
            return false;
        };
        each(words, |axis, value| system.0[axis] = becomes(value, axis));
        true
    }
}

/// The words of axes, `X1.5Y-2`.
fn each(words: &str, mut does: impl FnMut(usize, f64)) {
    for (axis, letter) in "XYZ".chars().enumerate() {
        let value = words.split_once(letter).map(|(_, rest)| rest);
        let value = value.and_then(|rest| rest.split(char::is_alphabetic).next()?.parse().ok());
        value.into_iter().for_each(|value| does(axis, value));
    }
}
