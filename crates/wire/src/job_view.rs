//! Jobs as a page shows them: the tool paths of a drawing, and how they are cut.

use crate::ShapePath;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Sort of the open file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum FileKind {
    /// A part program.
    #[default]
    Program,
    /// A job: the tool path of a drawing. The machine cuts it.
    Job,
    /// A drawing, which has no tool path yet: nothing can be cut.
    Drawing,
}

/// Choices of the person who starts a job. Its file stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
#[ts(optional_fields = false)]
pub struct JobChoice {
    /// The path with which it begins, counted from 1 in cutting order; that of the file for nothing.
    pub start: Option<u32>,
    /// Distance beside itself at which every path is cut, mm, to the right of travel.
    #[ts(type = "Mm")]
    pub offset: f64,
    /// Place of its origin on the table, X and Y from home, mm; that of the file for nothing.
    #[ts(type = "[Mm, Mm] | null")]
    pub origin: Option<[f64; 2]>,
    /// Place to which the head goes at the end, X and Y from the origin, mm; that of the file for nothing.
    #[ts(type = "[Mm, Mm] | null")]
    pub finish: Option<[f64; 2]>,
    /// Height that the paths with heights of their own are raised above those of the file, mm.
    #[ts(type = "Mm")]
    pub lift: f64,
}

/// A job, to be looked at and started.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct JobView {
    /// The hash by which it is run.
    pub hash: String,
    /// Its paths in cutting order, arrays laid out, mm from the origin.
    pub paths: Vec<JobPath>,
    /// Place of the origin on the table, X and Y from home, mm.
    #[ts(type = "[Mm, Mm]")]
    pub origin: [f64; 2],
    /// Place to which the head goes at the end, X and Y from the origin, mm.
    #[ts(type = "[Mm, Mm]")]
    pub finish: [f64; 2],
    /// The path with which it begins, from 1.
    pub start: u32,
    /// Number of times that it is cut.
    pub repeats: u32,
    /// Cutting speed.
    #[ts(type = "MmPerS")]
    pub cut_mm_s: f64,
    /// Plunging speed.
    #[ts(type = "MmPerS")]
    pub plunge_mm_s: f64,
    /// Z of travel, of the surface of the material and of the lowest place of the tool: from home, mm.
    #[ts(type = "[Mm, Mm, Mm]")]
    pub heights: [f64; 3],
    /// The tool rises when the job is paused.
    pub raise: bool,
    /// Reaches of X and Y, from home, mm.
    #[ts(type = "[[Mm, Mm], [Mm, Mm]]")]
    pub table: [[f64; 2]; 2],
    /// The origin becomes the present position at each start.
    pub origin_at_start: bool,
}

/// One path of a job.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct JobPath {
    /// The path; its number is its place in cutting order, from 1.
    #[serde(flatten)]
    pub path: ShapePath,
    /// It is followed and not cut.
    pub traversal: bool,
    /// The tool that cuts it.
    pub tool: u8,
}
