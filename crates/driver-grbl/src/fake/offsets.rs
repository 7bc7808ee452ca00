//! Zero points that the fake keeps: G54 to G59.3, G92.

use kerf_machine::driver::Axes;

/// The coordinate systems, the first in force.
const SYSTEMS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];

/// Zero points, machine frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct Offsets {
    /// Those of the coordinate systems, G54 first, which is in force.
    pub systems: [Axes; 9],
    /// The shift of G92.
    pub shift: Axes,
}

impl Offsets {
    /// Returns the zero of the workpiece.
    pub fn zero(&self) -> Axes {
        self.systems[0].plus(self.shift)
    }

    /// Returns the lines that tell of all of them (`$#`).
    pub fn told(&self, places: impl Fn(Axes) -> String) -> Vec<String> {
        let named = SYSTEMS.iter().zip(self.systems).chain([(&"G92", self.shift)]);
        let line = |(name, at): (&&str, Axes)| format!("[{name}:{}]", places(at));
        named.map(line).chain(["[TLO:0.000]".into()]).collect()
    }

    /// Keeps a zero point that a line names, of a machine at a place; tells whether it is such a line.
    pub fn keeps(&mut self, line: &str, position: Axes) -> bool {
        if line == "G92.1" {
            self.shift = Axes::default();
        } else if let Some(words) = line.strip_prefix("G10L2P") {
            let (index, words) = words.split_at(words.find(char::is_alphabetic).unwrap_or(0));
            let index: usize = index.parse().unwrap_or(0);
            let Some(system) = index.checked_sub(1).and_then(|it| self.systems.get_mut(it)) else {
                return false;
            };
            each(words, |axis, place| system.0[axis] = place);
        } else if let Some(words) = line.strip_prefix("G92") {
            let free = position.minus(self.systems[0]);
            let shift = &mut self.shift;
            each(words, |axis, reads| shift.0[axis] = free.0[axis] - reads);
        } else {
            return false;
        }
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
