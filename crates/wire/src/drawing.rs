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
        /// Its name below the part folder; `.rsg`, `.dxf` or `.svg`.
        name: String,
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
    /// Writes a part program of its tool paths into the part folder and opens it.
    Program {
        /// Name of the program below the part folder: `.sbp` or `.nc`.
        name: String,
    },
}

/// What a page shows of the drawing. Its shapes come over HTTP: `/api/drawing/shapes`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct DrawingState {
    /// The file it came from or was saved in last.
    pub name: Option<String>,
    /// Grows with every change of the shapes.
    pub revision: u32,
    /// How many shapes.
    pub shapes: u32,
    /// The shapes that operations act on: numbers from 1.
    pub selection: Vec<u32>,
    /// Whether there is something to take back.
    pub can_undo: bool,
    /// Whether there is something to make again.
    pub can_redo: bool,
    /// Whether it differs from its file.
    pub changed: bool,
    /// How many shapes are on the clipboard.
    pub clipboard: u32,
    /// The eight groups and how their shapes are cut.
    pub groups: Vec<GroupState>,
    /// What the last operation, or reading the file, had to tell.
    pub notes: Vec<String>,
}

/// How the shapes of a group are cut: what the operation `set` changes. Mm, mm a minute, degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct GroupState {
    /// Its colour.
    pub name: String,
    /// Whether its shapes are cut.
    pub on: bool,
    /// Whether the head only follows them, to get round obstacles.
    pub traversal: bool,
    /// Cut on both sides of the shape.
    pub double: bool,
    /// The tool output, 1 … 3.
    pub tool: u8,
    /// The cut output, 1 … 3.
    pub cut: u8,
    /// Highest cutting speed; nothing is the machine's.
    pub speed: Option<f64>,
    /// Depth of the cut.
    pub height: CutHeight,
    /// Depth of one pass.
    pub pass: Option<f64>,
    /// Distance of the path, right of travel.
    pub offset: f64,
    /// What the rough pass leaves.
    pub rough: f64,
    /// What is left out at the beginning.
    pub tag: f64,
    /// Radius and angle of the arc onto the path.
    pub lead_in: [f64; 2],
    /// Radius and angle of the arc off the path.
    pub lead_out: [f64; 2],
}

/// Depth of a cut: `thru`, `3d`, or mm above the surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(untagged)]
pub enum CutHeight {
    /// `thru` or `3d`.
    Word(String),
    /// Mm above the surface, negative into the material.
    Mm(f64),
}

/// The shapes of a drawing, or tool paths made of them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ShapeList {
    /// The revision of the drawing.
    pub revision: u32,
    /// In the order in which they are cut.
    pub shapes: Vec<ShapePath>,
    /// What was noticed while tool paths were made.
    pub notes: Vec<String>,
}

/// A path of lines and arcs, mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ShapePath {
    /// Number of the shape, from 1.
    pub number: u32,
    /// Its group: black, blue, green, cyan, red, magenta, brown, white.
    pub group: String,
    /// Whether its end is its start.
    pub closed: bool,
    /// Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter
    /// of the angle of an arc, positive counter-clockwise; 0 is a line.
    pub points: Vec<f64>,
    /// Height of each vertex, for a 3D shape.
    pub z: Option<Vec<f64>>,
    /// Whether the machine halts before it.
    pub pause: bool,
}
