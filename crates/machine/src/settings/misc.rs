//! Settings that belong nowhere else (Profiler reference, "Miscellaneous Configuration Options").

/// Miscellaneous options of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Miscellaneous {
    /// The first Start prepares and waits, the second cuts ("Do Double Job Start").
    pub double_start: bool,
    /// The `w` axis keeps the tool along the path ("Use Tangential Axis").
    pub tangential: bool,
    /// The tangential axis turns without end: the table limits of C do not hold for it.
    pub tangential_endless: bool,
    /// Live drawing: 0 never in motion, 10 always, n up to n tenths of the highest speed.
    pub runtime_drawing: u8,
    /// STOP and Disarm at a machine that stands, and a driver who goes, leave outputs as they are.
    pub outputs_stay_on: bool,
}

impl Default for Miscellaneous {
    fn default() -> Self {
        Self {
            double_start: false,
            tangential: false,
            tangential_endless: true,
            runtime_drawing: 10,
            outputs_stay_on: false,
        }
    }
}
