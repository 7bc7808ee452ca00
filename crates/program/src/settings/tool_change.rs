//! Tool changes by hand: the place where the operator changes the tool, and the sensor that measures it (C9, M6).

use serde::{Deserialize, Serialize};

/// Settings of tool changes. Places are those of the table base, mm; one that is not given is asked of nobody: the tool
/// stays there, or the owner's `my_variables.sbc` names it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ToolChanges {
    /// X of the place where tools are changed.
    pub place_x_mm: Option<f64>,
    /// Y of that place.
    pub place_y_mm: Option<f64>,
    /// Input of the sensor, or of the fixed plate, that measures tools.
    pub sensor_input: Option<u8>,
    /// Input of a loose plate that the operator lays below a tool to measure it, where there is no sensor.
    pub plate_input: Option<u8>,
    /// X of the sensor.
    pub sensor_x_mm: Option<f64>,
    /// Its Y.
    pub sensor_y_mm: Option<f64>,
    /// Longest way down from Safe-Z to it, mm.
    pub sensor_reach_mm: Option<f64>,
    /// Speed of measuring, mm/s.
    pub sensor_speed_mm_s: Option<f64>,
    /// A tool keeps its length in its holder: one that was measured is not measured again.
    pub keeps_lengths: bool,
}
