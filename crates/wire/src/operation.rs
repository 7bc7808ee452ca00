//! The operations of a drawing as forms: made from the table that reads them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// An operation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct OperationEntry {
    /// Its first word.
    pub name: String,
    /// Description of its effect.
    pub doc: String,
    /// The ways to say it.
    pub variants: Vec<OperationVariant>,
}

/// One way to say an operation: its parts in order, after the name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct OperationVariant {
    /// As it is written.
    pub form: String,
    /// Its parts, in order.
    pub parts: Vec<OperationPart>,
}

/// A part of what is said.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct OperationPart {
    /// Text before the value: `about `, `tool=`; alone it is a word that is always said.
    pub lead: String,
    /// Value that is entered; nothing for a word alone.
    pub value: Option<OperationValue>,
    /// It may be left out.
    pub optional: bool,
    /// It may be said several times.
    pub repeats: bool,
}

/// Kind of value that is entered for a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "is")]
pub enum OperationValue {
    /// A place or a displacement `x,y`, lengths.
    Pair,
    /// A vertex: a place, and perhaps a bulge behind it.
    Vertex,
    /// A place `x,y,z`, lengths.
    Triple,
    /// A length.
    Length {
        /// Its name in the table: `RADIUS`, `D`.
        name: String,
    },
    /// A number without a unit: an angle, a factor, a count.
    Number {
        /// Its name in the table: `ANGLE`, `FACTOR`.
        name: String,
    },
    /// A radius and an angle.
    Arc,
    /// Rows by columns.
    Grid,
    /// The number of a shape.
    Shape,
    /// Numbers of shapes.
    Shapes,
    /// A group.
    Group,
    /// Several groups.
    Groups,
    /// One of some words.
    Words {
        /// The words.
        words: Vec<String>,
    },
    /// A number, or a word.
    WordsOr {
        /// The words.
        words: Vec<String>,
        /// The number is a length.
        length: bool,
    },
    /// A drawing of the part folder.
    File,
    /// Anything.
    Text,
}
