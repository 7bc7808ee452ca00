//! The tool path in binary pieces.
//!
//! `GET /api/preview/KEY` gives a [`PreviewInfo`]. Each of its [`Detail`]s is the whole path, coarser
//! than the one before; `GET /api/preview/KEY/LEVEL/PIECE` gives a piece of it, little-endian:
//!
//! ```text
//!  u32 segments (n)   u32 reserved: 0
//!  f32 × 3 × (n + 1)  vertices, mm from the origin of the preview, in the machine's frame
//!  f32 × n            when each segment is over, seconds of planned time
//!  u32 × n            line of the part file that makes it
//!  u32 × n            which move it belongs to: what `Motion.made` counts
//!  u8  × n            kind: 0 jog, 1 cut, 2 nothing is made (the path goes on elsewhere)
//! ```
//!
//! The first vertex of a piece is the last of the one before.
//!
//! `GET /api/preview/KEY/timing` gives a [`Timing`].
//!
//! What is typed is drawn as it is made: `GET /api/typed/KEY/FROM` gives its segments from there on in the same form,
//! with vertices from the machine's zero.

use crate::Finding;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A jog.
pub const JOG: u8 = 0;
/// A cut.
pub const CUT: u8 = 1;
/// No move: the path goes on elsewhere.
pub const GAP: u8 = 2;
/// Most segments in a piece.
pub const PIECE: usize = 1 << 16;

/// The path of what was typed, so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct TypedPath {
    /// Changes when it begins anew.
    pub key: u32,
    /// Number of its segments, which can be asked for as `/api/typed/KEY/FROM`.
    pub segments: u32,
}

/// Facts that a page knows before it asks for pieces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct PreviewInfo {
    /// Origin of the vertices: mm, machine frame.
    #[ts(type = "[Mm, Mm, Mm]")]
    pub origin: [f64; 3],
    /// Place that the working zero had: mm, machine frame.
    #[ts(type = "[Mm, Mm, Mm]")]
    pub zero: [f64; 3],
    /// Corner of the table with the least X and Y: mm, machine frame.
    #[ts(type = "[Mm, Mm]")]
    pub table: [f64; 2],
    /// Size of the table, mm.
    #[ts(type = "[Mm, Mm]")]
    pub table_size: [f64; 2],
    /// Distance of the lines of the grid, mm.
    #[ts(type = "Mm")]
    pub grid: f64,
    /// Bounds of the cuts: least and greatest corner, mm, machine frame.
    #[ts(type = "[[Mm, Mm, Mm], [Mm, Mm, Mm]] | null")]
    pub bounds: Option<[[f64; 3]; 2]>,
    /// Diameter of the cutter, mm.
    #[ts(type = "Mm")]
    pub cutter: f64,
    /// Planned time, seconds.
    #[ts(type = "Seconds")]
    pub seconds: f64,
    /// Length of the cuts, mm.
    #[ts(type = "Mm")]
    pub cut: f64,
    /// Length of the jogs, mm.
    #[ts(type = "Mm")]
    pub jog: f64,
    /// Moves.
    pub moves: u32,
    /// An axis turns the work about X: the key with `~rotary` behind it gives the path where it lies on the work.
    pub rotary: bool,
    /// From all of it to the coarsest.
    pub details: Vec<Detail>,
    /// The tool paths that the program names.
    pub toolpaths: Vec<ToolPathInfo>,
}

/// The path at a level of detail.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Detail {
    /// Greatest distance from the true path, mm.
    #[ts(type = "Mm")]
    pub tolerance: f64,
    /// Segments.
    pub segments: u32,
    /// Pieces they come in.
    pub pieces: u32,
}

/// A tool path that the program names.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ToolPathInfo {
    /// Its name.
    pub name: String,
    /// The tool.
    pub tool: String,
    /// Planned time, seconds.
    #[ts(type = "Seconds")]
    pub seconds: f64,
    /// Its first move.
    pub first_move: u32,
}

/// Most points of a line of a timing chart, and most edges of all of them.
pub const TIMING_POINTS: usize = 20_000;

/// Inputs and outputs of a run on the simulated machine, beside its motion.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Timing {
    /// Its end, seconds of machine time.
    #[ts(type = "Seconds")]
    pub seconds: f64,
    /// It holds all of a run that came to its end.
    pub whole: bool,
    /// It ends before the run because that has more edges than a chart holds.
    pub full: bool,
    /// Word for the end of the run: `ok`, `ended`, `failed`, `stopped`, `limit`.
    pub status: String,
    /// Reason why the run ended before its end.
    pub finding: Option<Finding>,
    /// Its lines, from above.
    pub lines: Vec<TimingLine>,
}

/// A line of a timing chart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct TimingLine {
    /// Kind of line.
    pub kind: TimingKind,
    /// Its name.
    pub name: String,
    /// Length of a grain, seconds. If it is not 0 the line has more points than a chart holds: of each grain,
    /// counted from 0, only the first, the least, the greatest and the last are here.
    pub grain: f64,
    /// Moments, seconds, and the value there. An axis goes evenly between them; a value or a bit is 0 before
    /// the first and keeps what it is to the next.
    pub points: Vec<[f64; 2]>,
}

/// Kind of a line of a timing chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum TimingKind {
    /// Place of an axis, mm: from the working zero for a program, from the machine's for a job.
    Axis,
    /// A value: intensity, pulses a second.
    Value,
    /// An output.
    Output,
    /// An input.
    Input,
}
