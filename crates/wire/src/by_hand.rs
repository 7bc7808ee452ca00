//! Moves by hand to somewhere.

use crate::AXES;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A move by hand of a machine that does nothing else. Mm, degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", rename_all_fields = "camelCase", tag = "to", deny_unknown_fields)]
pub enum ByHand {
    /// The home switches of these axes are found.
    FindHome {
        /// Their letters, as `xy`; all that have a switch for nothing.
        axes: Option<String>,
    },
    /// To home on these axes, Z first.
    Home {
        /// Their letters, as `xy`; all for nothing.
        axes: Option<String>,
    },
    /// To the origin of the open job in X and Y; to that of the machine where none is open.
    Origin,
    /// To where the head goes when the job is done.
    Finish,
    /// To a place.
    Place {
        /// X and Y from the job origin, the others from home; or all from where the tool is. Axes without a
        /// value stay.
        #[ts(type = "AxisGoal")]
        place: [Option<f64>; AXES],
        /// From where the tool is.
        relative: bool,
        /// X and Y first, then the others; else all together.
        flat: bool,
    },
    /// The spindle warms up where the machine stands.
    WarmUp {
        /// Percent of its greatest speed and minutes, as `25:2, 50:2`; those of the settings for nothing.
        steps: Option<String>,
    },
    /// In X and Y at Z top, to a place from the job origin.
    CutMove {
        /// That place.
        #[ts(type = "[Mm, Mm]")]
        at: [f64; 2],
        /// Cuts on the way, as a job of one line.
        cut: bool,
    },
}
