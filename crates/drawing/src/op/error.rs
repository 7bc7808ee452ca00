//! Reasons why an operation was not carried out, and what was noticed when it was.

use crate::{CommentError, GapError, SettingsError};
use kerf_geom::Point2;
use kerf_program::rounded;
use thiserror::Error;

/// Messages of an operation that succeeded.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Warnings that the user should look at, a sentence each.
    pub warnings: Vec<String>,
    /// Notes that the user may like to know, a sentence each.
    pub notes: Vec<String>,
}

/// A place as it stands behind the number of a shape: ` at 10,5.25`; nothing for none.
pub fn spot(at: Option<Point2>) -> String {
    at.map_or_else(String::new, |at| format!(" at {},{}", rounded(at.x, 3), rounded(at.y, 3)))
}

/// Reason why an operation was not carried out. The drawing is as it was.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum OpError {
    /// There is nothing to act on.
    #[error("no shapes selected: choose some with `select` first")]
    NothingSelected,
    /// A number without a shape.
    #[error("there is no shape {number}: the drawing has {count}")]
    NoShape {
        /// The number.
        number: usize,
        /// Shapes in the drawing.
        count: usize,
    },
    /// An argument out of bounds.
    #[error("{what} is {value}: it must be {bound}")]
    Bound {
        /// The argument.
        what: &'static str,
        /// Its value.
        value: f64,
        /// The bound, in words.
        bound: &'static str,
    },
    /// Nothing of what the operation changes is there.
    #[error("{0} {1}: nothing would change")]
    NothingThere(&'static str, &'static str),
    /// A shape that is named again.
    #[error("shape {0} is named twice")]
    NamedTwice(usize),
    /// A shape that is taken back but was not picked.
    #[error("shape {0} is not picked")]
    NotPicked(usize),
    /// Two places that must differ are one.
    #[error("{0} are the same place")]
    SamePlace(&'static str),
    /// A shape cannot be what the operation needs.
    #[error("shape {shape}{}: {why}", spot(*.at))]
    Shape {
        /// Its number.
        shape: usize,
        /// Place where it begins; whoever carries the operation out fills it in.
        at: Option<Point2>,
        /// Description of the problem and of what helps.
        why: String,
    },
    /// No order is being picked.
    #[error("nothing was picked: choose shapes or groups with `pick` first")]
    NothingPicked,
    /// A file that nobody has read.
    #[error("{0} was not read: files cannot be loaded from here")]
    NotRead(String),
    /// The clipboard is empty.
    #[error(
        "clipboard empty: copy shapes to it with `clip`, or a file with `load-clipboard`, first"
    )]
    ClipboardEmpty,
    /// A setting of a group.
    #[error("group {group}: {source}")]
    Setting {
        /// The group.
        group: crate::Group,
        /// Mistake in the setting.
        source: SettingsError,
    },
    /// A tool or an overlap that clears nothing.
    #[error(transparent)]
    Clearing(kerf_pocket::PocketError),
    /// No group is free for new paths.
    #[error("all eight groups have shapes: say with group= which one the paths belong to")]
    NoFreeGroup,
    /// A group that would not cut paths as they are.
    #[error(
        "group {group} has shapes and an offset, rough pass, double line, tag or lead: paths that clear \
         an area need a group without; choose another one with group="
    )]
    NotAsDrawn {
        /// The group.
        group: crate::Group,
    },
    /// A group that would clear an area through the sheet though nobody said so.
    #[error(
        "group {group} has shapes that are cut through the sheet: say depth=thru where the area is to fall out, or \
         choose another group with group= and say how deep with depth=2"
    )]
    DepthNotSaid {
        /// The group.
        group: crate::Group,
    },
    /// A depth that is not that of the group's other shapes.
    #[error(
        "group {group} has shapes of another height: choose another group with group=, or change the height of all \
         its shapes first"
    )]
    OtherDepth {
        /// The group.
        group: crate::Group,
    },
    /// No group can keep the outlines of what is cleared from being cut.
    #[error(
        "all eight groups have shapes and are on: none is left for the outlines, which are not to be cut; say \
         cut-outlines to cut them too, or switch a group off"
    )]
    NoGroupOff,
    /// An array whose copies lie on each other.
    #[error(transparent)]
    Gap(#[from] GapError),
    /// A comment.
    #[error(transparent)]
    Comment(#[from] CommentError),
    /// Nothing to undo or redo.
    #[error("nothing to {0}")]
    NoHistory(&'static str),
}
