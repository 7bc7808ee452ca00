//! The tools of the machine by their numbers, and changes of them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A tool that is known by its number.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct NumberedTool {
    /// Its number, from 1.
    pub number: u32,
    /// Its name; empty where it has none.
    pub name: String,
    /// Diameter of its cutter; 0 where it is not known.
    #[ts(type = "Mm")]
    pub diameter: f64,
    /// Its length: of one that was measured, the height of the table base at which it touched the sensor.
    #[ts(type = "Mm")]
    pub length: f64,
    /// Its length was measured at the sensor of the machine: Z zero goes with it.
    pub measured: bool,
}

/// All tools that are known.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ToolTable {
    /// The tools, in order of their numbers.
    pub tools: Vec<NumberedTool>,
    /// Number of the one in the spindle; 0 for none that is known.
    pub in_spindle: u32,
    /// The machine has a sensor that measures tools.
    pub has_sensor: bool,
    /// The machine finds home: a length that was measured holds for good.
    pub finds_home: bool,
}

/// A change of a tool.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "to", deny_unknown_fields)]
pub enum ToolChange {
    /// It is so from now on.
    Is {
        /// Its name; empty for none.
        name: String,
        /// Diameter of its cutter; 0 where it is not known.
        #[ts(type = "Mm")]
        diameter: f64,
        /// Its length.
        #[ts(type = "Mm")]
        length: f64,
    },
    /// It is forgotten.
    Gone,
    /// It is the one in the spindle.
    In,
}
