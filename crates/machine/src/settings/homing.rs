//! Finding home (Profiler reference, "Finding the Home Position on an Axis").

use super::words;
use kerf_program::{AXES, Axis, AxisSet};

words! {
    /// Action when a run begins and an axis with a home switch was not homed.
    BeforeRuns {
        /// It begins, with a note.
        Tell = "tell",
        /// The operator is asked whether to home first.
        Ask = "ask",
        /// It does not begin.
        Refuse = "refuse",
    }
}

words! {
    /// The end of an axis at which its switch sits.
    HomeEnd {
        /// Left, front, bottom, clockwise: the search goes in the negative direction.
        Low = "low",
        /// Right, back, top, anticlockwise: the search goes in the positive direction.
        High = "high",
    }
}

/// Homing of one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HomeSwitch {
    /// The axis has a switch.
    pub fitted: bool,
    /// End of the axis at which it sits.
    pub end: HomeEnd,
    /// Speed of the search, mm/s or degrees/s.
    pub fast: f64,
    /// Speed of finding the edge; 0 takes the edge of step 2.
    pub slow: f64,
    /// Distance of home from the edge, mm or degrees, into the work area.
    pub off: f64,
}

/// Homing of the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homing {
    /// The switch of each axis: X, Y, Z, A (`z2`), B, C (`w`).
    pub switches: [HomeSwitch; AXES],
    /// The two motors of X are homed one by one after they were homed together.
    pub separate_x: bool,
    /// The same for Y.
    pub separate_y: bool,
    /// The second head moves by this further, mm, after it is off its switch.
    pub z2_adjustment_mm: f64,
    /// Action when a run begins before the axes were homed.
    pub before_runs: BeforeRuns,
    /// Axes homed when the program starts.
    pub at_program_start: AxisSet,
    /// Axes homed when a job starts.
    pub at_job_start: AxisSet,
}

impl Homing {
    /// The switch of an axis.
    pub const fn of(&self, axis: Axis) -> &HomeSwitch {
        &self.switches[axis.index()]
    }
}

const fn switch(end: HomeEnd) -> HomeSwitch {
    HomeSwitch { fitted: false, end, fast: 50.0, slow: 2.0, off: 3.0 }
}

impl Default for Homing {
    fn default() -> Self {
        let (low, z) =
            (switch(HomeEnd::Low), HomeSwitch { fast: 20.0, slow: 1.0, ..switch(HomeEnd::High) });
        let turn = HomeSwitch { off: 2.0, ..switch(HomeEnd::High) };
        Self {
            switches: [low, low, z, z, turn, turn],
            separate_x: false,
            separate_y: false,
            z2_adjustment_mm: 0.0,
            before_runs: BeforeRuns::Tell,
            at_program_start: AxisSet::EMPTY,
            at_job_start: AxisSet::EMPTY,
        }
    }
}
