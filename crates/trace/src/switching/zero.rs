//! Zero that the locations of a chart count from, which a program may set.

use crate::event::Partial;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Axis, Frame};

/// X, Y and Z as they are called in events.
const AXES: [(Axis, char); 3] = [(Axis::X, 'x'), (Axis::Y, 'y'), (Axis::Z, 'z')];

/// The working zero, and where the tool is.
#[derive(Debug)]
pub(super) struct Zero {
    /// Machine frame, mm.
    zero: [f64; 3],
    /// Machine frame, mm.
    at: [f64; 3],
    /// Millimetres in a unit of what is told.
    unit_mm: f64,
}

impl Zero {
    pub fn new(position: Axes, frame: &Frame) -> Self {
        Self { zero: frame.working_zero.first3(), at: position.first3(), unit_mm: 1.0 }
    }

    /// Events have this unit from now on.
    pub fn use_units(&mut self, symbol: &str) {
        let is_inch = symbol == LinearUnit::Inch.symbol();
        self.unit_mm = if is_inch { LinearUnit::Inch.mm() } else { 1.0 };
    }

    /// The tool is at a place of the machine's frame: its working location.
    pub fn goes(&mut self, position: [f64; 3]) -> [f64; 3] {
        self.at = position;
        std::array::from_fn(|axis| position[axis] - self.zero[axis])
    }

    /// Locations were set where the tool is: for each axis what it was before and is now.
    pub fn set(&mut self, told: &Partial) -> [Option<[f64; 2]>; 3] {
        AXES.map(|(axis, letter)| {
            let n = axis.index();
            let (before, now) = (self.at[n] - self.zero[n], told.get(&letter)? * self.unit_mm);
            self.zero[n] = self.at[n] - now;
            Some([before, now]).filter(|_| (now - before).abs() > 1e-9)
        })
    }
}
