//! The operations on drawings as data.

use super::{Change, Clearing, Pattern, Picking, Sequencing};
use crate::{ArrayLevel, Choice, Drawing, Group, Level, Shape};
use kerf_geom::{Point2, Vec2, Vertex};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// One thing done to a drawing. Lengths are millimetres, angles degrees, counter-clockwise; shapes
/// are counted from 1 in cutting order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "op", rename_all = "kebab-case")]
pub enum Operation {
    /// Chooses the shapes that the next operations act on.
    Select {
        /// Which.
        choice: Choice,
        /// Effect on those chosen before: they are replaced, or these are added to them or taken from them.
        #[serde(default)]
        how: How,
    },
    /// Moves the selected shapes.
    Move {
        /// Displacement.
        by: Vec2,
    },
    /// Adds moved copies of the selected shapes at the end of the sequence.
    Copy {
        /// Displacement of the copies.
        by: Vec2,
    },
    /// Turns the selected shapes.
    Rotate {
        /// Angle, counter-clockwise.
        angle_deg: f64,
        /// The centre.
        about: Point2,
    },
    /// Scales the selected shapes.
    Scale {
        /// Factor of the sizes, above 0.
        factor: f64,
        /// The place that stays.
        about: Point2,
    },
    /// Mirrors the selected shapes. Closed ones keep their cutting direction.
    Mirror {
        /// A place on the mirror line.
        a: Point2,
        /// Another.
        b: Point2,
        /// Leave the direction as the mirror makes it.
        #[serde(default)]
        raw: bool,
    },
    /// Removes the selected shapes.
    Erase,
    /// Rounds corners of the selected shapes.
    Fillet {
        /// Radius of the arcs, above 0.
        radius_mm: f64,
        /// Only the corner nearest to this place; else every corner.
        #[serde(default)]
        at: Option<Point2>,
    },
    /// Cuts corners of the selected shapes off.
    Chamfer {
        /// Distance from the corner, above 0.
        length_mm: f64,
        /// Only the corner nearest to this place; else every corner.
        #[serde(default)]
        at: Option<Point2>,
    },
    /// Replaces the selected shapes by paths beside them.
    Offset {
        /// Distance to the right of travel; negative is to the left.
        distance_mm: f64,
        /// Keep the shapes too.
        #[serde(default)]
        keep: bool,
    },
    /// Joins the selected open shapes where their ends are near each other.
    Join {
        /// Greatest distance of ends that are joined; `None` is that of the last time.
        distance_mm: Option<f64>,
        /// Let the ends be one place instead of putting a line between them.
        #[serde(default)]
        merge: bool,
    },
    /// Opens a closed shape at a place, or makes two of an open one.
    Break {
        /// The shape.
        shape: usize,
        /// Place of the break.
        at: Point2,
    },
    /// Takes the part of a shape at a place out, between its meetings with the selected shapes.
    Trim {
        /// The part that goes.
        at: Point2,
    },
    /// Adds the selected shapes again in rows and columns.
    ArrayRect {
        /// Rows, upwards.
        rows: u32,
        /// Columns, to the right.
        columns: u32,
        /// Gap between neighbours.
        gap: Vec2,
    },
    /// Adds the selected shapes again round a centre, turned with the angle.
    ArrayRound {
        /// Number of places round the centre, that of the selected shapes counted.
        count: u32,
        /// The centre.
        centre: Point2,
    },
    /// Gives the segment of a shape nearest to a place another bulge.
    Bulge {
        /// The shape.
        shape: usize,
        /// On which segment.
        at: Point2,
        /// The tangent of a quarter of the new arc's angle; 0 makes a line of it.
        bulge: f64,
    },
    /// Gives the segment of a shape nearest to a place another radius.
    Radius {
        /// The shape.
        shape: usize,
        /// On which segment.
        at: Point2,
        /// The radius.
        radius_mm: f64,
    },
    /// Moves the vertex of a shape nearest to a place; arcs beside it keep their middle.
    Vertex {
        /// The shape.
        shape: usize,
        /// Which vertex.
        at: Point2,
        /// New place of the vertex.
        to: Point2,
    },
    /// Moves the vertices of the selected shapes that lie in a window; arcs keep their bulge.
    Stretch {
        /// A corner of the window.
        a: Point2,
        /// The opposite one.
        b: Point2,
        /// Displacement of the vertices.
        by: Vec2,
    },
    /// Moves the vertices of the selected shapes nearest to places; arcs keep their bulge.
    StretchAt {
        /// Places near the vertices.
        at: Vec<Point2>,
        /// The distance.
        by: Vec2,
    },
    /// Takes the vertices of a shape nearest to places out.
    DeleteVertices {
        /// The shape.
        shape: usize,
        /// Places near the vertices.
        at: Vec<Point2>,
    },
    /// Adds a circle.
    Circle {
        /// Its centre.
        centre: Point2,
        /// Its radius, above 0.
        radius_mm: f64,
    },
    /// Adds a rectangle, beginning at the first corner.
    Rectangle {
        /// First corner.
        a: Point2,
        /// The opposite corner.
        b: Point2,
    },
    /// Adds a place to drill.
    Point {
        /// Place to drill.
        at: Point2,
    },
    /// Adds lines and arcs.
    Polyarc {
        /// Places, each with the bulge of the segment that leaves it.
        vertices: Vec<Vertex>,
        /// The last segment returns to the start.
        closed: bool,
    },
    /// Adds straight lines with heights.
    SpaceLine {
        /// X, Y and height above ZSurface of each place.
        places: Vec<[f64; 3]>,
        /// The last segment returns to the start.
        closed: bool,
    },
    /// Turns the cutting direction of the selected shapes.
    Reverse,
    /// Makes outer shapes counter-clockwise and inner ones clockwise, in the whole drawing.
    Directions,
    /// Lets the cut of a shape begin at the place of it nearest to `at`.
    Start {
        /// The shape.
        shape: usize,
        /// Place near which the cut is to begin.
        at: Point2,
    },
    /// Lets the machine halt before the selected shapes, or not any more.
    Pause {
        /// The machine halts.
        on: bool,
    },
    /// Puts the selected shapes into a group.
    Group {
        /// The group.
        group: Group,
    },
    /// Adds copies of the selected shapes, in a group, on top of them.
    CopyToGroup {
        /// The group.
        group: Group,
    },
    /// Changes settings of a group.
    Set {
        /// The group.
        group: Group,
        /// Changes, in order.
        changes: Vec<Change>,
    },
    /// Adds paths that clear the areas of shapes, holes left out: rings from the wall inwards.
    Engrave(Clearing),
    /// Adds paths that clear the areas of shapes, holes left out, in a pattern.
    Pocket {
        /// Which areas, with which tool.
        #[serde(flatten)]
        clearing: Clearing,
        /// In which pattern.
        #[serde(flatten)]
        pattern: Pattern,
    },
    /// Changes the order in which shapes are cut.
    Sequence {
        /// The new order.
        order: Sequencing,
    },
    /// A step of picking a new order.
    Pick {
        /// Shapes or groups that are picked or taken back.
        picking: Picking,
    },
    /// Sets a level of the drawing's arrays.
    Array {
        /// Which level.
        level: Level,
        /// Rows, columns, gaps and order of the level.
        array: ArrayLevel,
    },
    /// Moves the drawing so that its bounds begin at the origin.
    JustifyLeft,
    /// As [`Operation::JustifyLeft`], and puts the top of the 3D shapes at ZSurface.
    JustifySurface,
    /// As [`Operation::JustifyLeft`], and puts the bottom of the 3D shapes at ZBottom.
    JustifyBottom {
        /// ZBottom above ZSurface; negative.
        bottom_mm: f64,
    },
    /// Turns the drawing by a quarter counter-clockwise and left-justifies it.
    Rotate90,
    /// Mirrors the drawing at the Y axis and left-justifies it.
    MirrorDrawing,
    /// Moves the drawing so that a place becomes the origin.
    Origin {
        /// The new origin.
        at: Point2,
    },
    /// Gives the drawing back the origin it was read with.
    CadOrigin,
    /// Puts copies of the selected shapes onto the clipboard.
    Clip,
    /// Puts the shapes of a file onto the clipboard.
    LoadClipboard {
        /// The file. Nothing here opens it: whoever sends the operation reads it before, see
        /// [`Operation::file`].
        file: String,
        /// Its shapes, once it was read.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        shapes: Option<Vec<Arc<Shape>>>,
    },
    /// Empties the clipboard.
    ClearClipboard,
    /// Adds the shapes of the clipboard.
    Paste {
        /// Place for the shapes.
        at: Point2,
        /// The origin of the shapes goes to `at`, else the lower left of their bounds does.
        #[serde(default)]
        absolute: bool,
    },
    /// Sets the comments of the drawing.
    Comment {
        /// Its lines.
        lines: Vec<String>,
    },
}

impl Operation {
    /// The file that has to be read before the operation can be carried out.
    pub fn file(&self) -> Option<&str> {
        match self {
            Self::LoadClipboard { file, shapes: None } => Some(file),
            _ => None,
        }
    }

    /// The same operation with what its file holds.
    #[must_use]
    pub fn with_file(self, read: Drawing) -> Self {
        match self {
            Self::LoadClipboard { file, .. } => {
                Self::LoadClipboard { file, shapes: Some(read.shapes) }
            }
            other => other,
        }
    }
}

/// Effect of a choice on the selection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum How {
    /// It becomes the selection.
    #[default]
    New,
    /// It is added.
    Add,
    /// It is taken away.
    Remove,
}
