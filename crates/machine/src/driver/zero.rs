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
