//! The drawing that is open.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A change of the drawing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "op")]
pub enum Op {
    /// An empty drawing.
    New,
    /// Opens a drawing of the part folder.
    Open {
        /// Its name below the part folder.
        name: String,
    },
    /// Writes it into the part folder.
    Save {
        /// Its name below the part folder: `.rsg`, `.dxf` or `.svg`; `.rsm` for tool paths that were opened.
        name: String,
        /// The hash of the file that may be replaced; `*` for any. The file that was opened or saved last
        /// needs none while it is as it was.
        #[serde(default)]
        replaces: Option<String>,
    },
    /// Operations, as `kerf draw --do` reads them: `select all; move 10,5`. All of them or none.
    Do {
        /// The clauses.
        clauses: String,
    },
    /// Takes the last change back.
    Undo,
    /// Makes it again.
    Redo,
    /// Sets the place to which the head goes when the job of the drawing is done.
    Finish {
        /// Mm from the origin.
        #[ts(type = "[Mm, Mm]")]
        at: [f64; 2],
    },
    /// Writes a part program of its tool paths into the part folder and opens it.
    Program {
        /// Name of the program below the part folder: `.sbp` or `.nc`.
        name: String,
        /// The hash of the file that may be replaced; `*` for any.
        #[serde(default)]
        replaces: Option<String>,
    },
}

/// The drawing as a page shows it. Its shapes come over HTTP: `/api/drawing/shapes`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct DrawingState {
    /// The file it came from or was saved in last.
    pub name: Option<String>,
    /// Grows with every change of the shapes.
    pub revision: u32,
    /// Its revision when it was opened or begun.
    pub begun: u32,
    /// Number of shapes.
    pub shapes: u32,
    /// The shapes that operations act on: numbers from 1.
    pub selection: Vec<u32>,
    /// The shapes that were picked to be sequenced, in that order: numbers from 1.
    pub picked: Vec<u32>,
    /// There is something to take back.
    pub can_undo: bool,
    /// There is something to make again.
    pub can_redo: bool,
    /// It differs from its file.
    pub changed: bool,
    /// Number of shapes on the clipboard.
    pub clipboard: u32,
    /// The eight groups and how their shapes are cut.
    pub groups: Vec<GroupState>,
    /// The basic block of data: bounds of the drawing before it is arrayed. Nothing without shapes.
    pub block: Option<Block>,
    /// Place to which the head goes when its job is done, from the origin.
    #[ts(type = "[Mm, Mm]")]
    pub finish: [f64; 2],
    /// Distance at which ends are joined when nothing else is said: that of the last time.
    #[ts(type = "Mm")]
    pub join: f64,
    /// The comments that are kept with it.
    pub comments: Vec<String>,
    /// Its two levels of repetition: blocks in a job, then jobs on the table.
    pub arrays: Vec<ArrayState>,
    /// Notes of the last operation, or of reading the file.
    pub notes: Vec<String>,
}

/// A level of arrays. Mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ArrayState {
    /// `block` or `job`.
    pub level: String,
    /// Rows, counted upwards, and columns, to the right.
    pub grid: [u32; 2],
    /// Gaps between neighbouring columns and rows.
    #[ts(type = "[Mm, Mm]")]
    pub gap: [f64; 2],
    /// Distances from one to the next, in X and Y.
    #[ts(type = "[Mm, Mm]")]
    pub pitch: [f64; 2],
    /// The corner at which it begins: bl, br, tr, tl.
    pub start: String,
    /// The order of the places: row, column, row-snake, column-snake.
    pub order: String,
}

/// The smallest box round the shapes of a drawing, arcs counted exactly.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Block {
    /// Least X and Y.
    #[ts(type = "[Mm, Mm]")]
    pub min: [f64; 2],
    /// Greatest X and Y.
    #[ts(type = "[Mm, Mm]")]
    pub max: [f64; 2],
    /// Least and greatest height of its 3D shapes; nothing without any. Flat shapes have no height.
    #[ts(type = "[Mm, Mm] | null")]
    pub z: Option<[f64; 2]>,
}

/// Cut of the shapes of a group, as the operation `set` changes it. Lengths in mm, angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct GroupState {
    /// Its colour.
    pub name: String,
    /// Its shapes are cut.
    pub on: bool,
    /// The head only follows them, to get round obstacles.
    pub traversal: bool,
    /// Cut on both sides of the shape.
    pub double: bool,
    /// The tool output, 1 … 3.
    pub tool: u8,
    /// The cut output, 1 … 3.
    pub cut: u8,
    /// Highest cutting speed; nothing is the machine's.
    #[ts(type = "MmPerMin | null")]
    pub speed_mm_min: Option<f64>,
    /// Depth of the cut.
    pub height: CutHeight,
    /// Depth of one pass.
    #[ts(type = "Mm | null")]
    pub pass: Option<f64>,
    /// Z of each pass from the machine's home. None when each point of a shape has its own height, which
    /// counts from the surface.
    #[ts(type = "Array<Mm>")]
    pub levels: Vec<f64>,
    /// Distance of the path, right of travel.
    #[ts(type = "Mm")]
    pub offset: f64,
    /// Material that the rough pass leaves.
    #[ts(type = "Mm")]
    pub rough: f64,
    /// Length that is left out at the beginning.
    #[ts(type = "Mm")]
    pub tag: f64,
    /// Radius and angle of the arc onto the path.
    #[ts(type = "[Mm, Degrees]")]
    pub lead_in: [f64; 2],
    /// Radius and angle of the arc off the path.
    #[ts(type = "[Mm, Degrees]")]
    pub lead_out: [f64; 2],
}

/// Depth of a cut: `thru`, `3d`, or mm above the surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(untagged)]
pub enum CutHeight {
    /// `thru` or `3d`.
    Word(String),
    /// Mm above the surface, negative into the material.
    Mm(#[ts(type = "Mm")] f64),
}

/// The shapes of a drawing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ShapeList {
    /// The revision of the drawing.
    pub revision: u32,
    /// In the order in which they are cut.
    pub shapes: Vec<ShapePath>,
}

/// Tool paths that a drawing becomes when it is machined.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ToolPaths {
    /// The revision of the drawing.
    pub revision: u32,
    /// The paths, in the order in which they are cut, arrays laid out.
    pub paths: Vec<CutShape>,
    /// Shapes whose short lines become curves, as those are machined.
    pub smoothed: Vec<ShapePath>,
    /// Vertices that are left out because they lie too near to the one before: X and Y by turns.
    pub filtered: Vec<f64>,
    /// Notes from their making, or the reason why there are none.
    pub notes: Vec<String>,
}

/// One path of the tool.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct CutShape {
    /// The path; its number is that of the shape it comes from.
    #[serde(flatten)]
    pub path: ShapePath,
    /// Which cut of that shape it is.
    pub pass: CutPass,
}

/// Which cut of a shape a path is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum CutPass {
    /// The first one, which leaves some material.
    Rough,
    /// The one that gives the part its size.
    #[default]
    Final,
    /// No cut: the head only follows it.
    Traversal,
}

/// A path of lines and arcs, mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ShapePath {
    /// Number of the shape, from 1.
    pub number: u32,
    /// Its group: black, blue, green, cyan, red, magenta, brown, white.
    pub group: String,
    /// Its end is its start.
    pub closed: bool,
    /// Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter
    /// of the angle of an arc, positive counter-clockwise; 0 is a line.
    pub points: Vec<f64>,
    /// Height of each vertex, for a 3D shape.
    pub z: Option<Vec<f64>>,
    /// The machine halts before it.
    pub pause: bool,
}
