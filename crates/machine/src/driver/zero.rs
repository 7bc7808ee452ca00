//! Zero points that a controller keeps, and changes of them.

use super::{AXES, Axes};

/// A zero point that a controller keeps.
#[derive(Clone, Debug, PartialEq)]
pub struct Zero {
    /// Its name, as G54; G92 is a shift of all others, TLO the length of the tool, which shifts them too.
    pub name: String,
    /// Its place, the controller's machine frame; of a shift, its way.
    pub at: Axes,
    /// It is the one that holds; a shift always does.
    pub holds: bool,
}

impl Zero {
    /// The names of the coordinate systems in the order of the words `G10 L2 P…`; a reset chooses the first.
    pub const SYSTEMS: [&str; 9] =
        ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];
    /// The name of the shift that G92 makes.
    pub const SHIFT: &str = "G92";
    /// The name of the shift by the length of the tool.
    pub const TOOL: &str = "TLO";

    /// Returns `true` if it shifts the others, and is no place.
    pub fn is_shift(&self) -> bool {
        [Self::SHIFT, Self::TOOL].contains(&&*self.name)
    }
}

/// A change of a zero point. Axes without a number stay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ZeroChange {
    /// It is so that the axes read these numbers where the machine stands, mm or degrees (`G10 L20`).
    Reads([Option<f64>; AXES]),
    /// It is at this place (`G10 L2`).
    Lies([Option<f64>; AXES]),
    /// It holds from now on (`G54`).
    Holds,
    /// The shift is taken away (`G92.1`).
    Gone,
}

impl ZeroChange {
    /// Returns the line of G-code by which a zero point of so many axes is changed; nothing where it cannot be changed so.
    pub fn line(&self, name: &str, axes: usize) -> Option<String> {
        let system = Zero::SYSTEMS.iter().position(|system| *system == name);
        match (self, system) {
            (Self::Lies(at), Some(index)) => written(2, index, at, axes),
            (Self::Reads(values), Some(index)) => written(20, index, values, axes),
            (Self::Holds, Some(_)) => Some(name.into()),
            (Self::Gone, None) => (name == Zero::SHIFT).then(|| "G92.1".into()),
            _ => None,
        }
    }
}

/// The line that writes a coordinate system, `G10L2P1X10`; nothing without a number that is one.
fn written(way: u8, index: usize, at: &[Option<f64>; AXES], axes: usize) -> Option<String> {
    let is_one = at.iter().flatten().all(|mm| mm.is_finite());
    let letters = "XYZABC".chars().zip(at).take(axes);
    let words: String =
        letters.filter_map(|(letter, mm)| Some(format!("{letter}{:.3}", (*mm)?))).collect();
    (is_one && !words.is_empty()).then(|| format!("G10L{way}P{}{words}", index + 1))
}
