//! Lengths of the axes and the soft bounds that follow from them (Profiler reference, "Axis
//! Parameters").
//!
//! Six axes are named as in part files; Profiler's `w`, which turns the tool about Z, is axis C, and
//! its `z2`, the second head, is axis A. Steps for a millimetre are `steps.per_unit`, highest speeds
//! and accelerations `dynamics`, both in [`kerf_program::Settings`].

use kerf_program::{Axes, Axis};

/// Profiler's `w`: the axis that turns the tool about Z.
pub const W: Axis = Axis::C;

/// Profiler's `z2`: the second head.
pub const Z2: Axis = Axis::A;

/// Lengths and bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisSettings {
    /// Length of travel from the home position, mm or degrees; 0 means no bounds on that axis.
    pub length: Axes,
    /// Motion that would leave the lengths is refused ("Limit Movement").
    pub limit_movement: bool,
}

impl Default for AxisSettings {
    fn default() -> Self {
        Self { length: Axes::default(), limit_movement: true }
    }
}
