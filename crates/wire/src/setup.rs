//! Settings of the machine, as far as drawings are worked on with it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Settings of the machine's configuration that pages show or follow, and which axes were homed. Mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Setup {
    /// The special positions of Z, from its home.
    pub heights: ZHeights,
    /// Reaches of X and Y from their home; 0 is without bounds.
    #[ts(type = "[Mm, Mm]")]
    pub reach: [f64; 2],
    /// Changing settings asks for a password.
    pub protected: bool,
    /// Outputs stay on when a machine that stands is stopped, disarmed or left.
    pub outputs_stay_on: bool,
    /// A click selects what lies so near, pixels.
    pub pick_radius: f64,
    /// So much larger than what is drawn is the window that shows all of it, percent.
    pub window_expansion: f64,
    /// Letters of the axes that were homed.
    pub homed: String,
    /// Letters of the axes that have a home switch and were not homed: places on them are counted from where the
    /// machine was switched on.
    pub not_homed: String,
}

/// Heights at which a job is cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ZHeights {
    /// Height at which the tool travels.
    #[ts(type = "Mm")]
    pub top: f64,
    /// The surface of the material.
    #[ts(type = "Mm")]
    pub surface: f64,
    /// The lowest the tool may go; where THRU cuts.
    #[ts(type = "Mm")]
    pub bottom: f64,
}
