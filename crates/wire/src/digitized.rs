//! Points that are being digitized, as pages show them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Points that are being digitized, and the segments through them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Digitized {
    /// The job origin, from which they count: X and Y from home, mm.
    #[ts(type = "[Mm, Mm]")]
    pub origin: [f64; 2],
    /// The points in order.
    pub points: Vec<DigitizedPoint>,
    /// The bulge of the segment behind each point but the last, from it to the next one.
    pub bulges: Vec<f64>,
    /// Number of the current point, from 1; 0 without points.
    pub current: u32,
    /// Heights count.
    pub three_d: bool,
    /// The next point is an arc point.
    pub next_arc: bool,
    /// There are points that no shape was saved of as they are.
    pub unsaved: bool,
}

/// A digitized point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct DigitizedPoint {
    /// X and Y from the job origin, Z from home, mm.
    #[ts(type = "[Mm, Mm, Mm]")]
    pub at: [f64; 3],
    /// The arc from the point before to the point behind goes through it; else it ends a line.
    pub arc: bool,
}

/// Part of the picture that pages are to have in sight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum Look {
    /// The points that are being digitized.
    Digitized,
    /// All shapes.
    Data,
    /// The machine's bounds and all shapes.
    Machine,
    /// Twice as much as now.
    Out,
}

/// Part of the picture that pages were last told to have in sight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Looked {
    /// Grows with each time.
    pub number: u32,
    /// That part.
    pub at: Look,
}
