//! Digitized points.

use kerf_geom::Point2;
use kerf_program::rounded;
use serde::{Deserialize, Serialize};

/// Place where the tool stands, millimetres: X and Y from the job origin, Z from home.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Stand {
    /// In the plane, from the job origin.
    pub at: Point2,
    /// From home.
    pub z_mm: f64,
}

impl Stand {
    /// A place to a millionth: what a subtraction of the job origin leaves behind is no part of a shape.
    ///
    /// ```
    /// use kerf_digitize::Stand;
    /// assert_eq!(Stand::new(333.3 - 300.0, 0.0, -5.0).at.x, 33.3);
    /// ```
    pub fn new(x_mm: f64, y_mm: f64, z_mm: f64) -> Self {
        let [x, y, z_mm] = [x_mm, y_mm, z_mm].map(|mm| rounded(mm, 6));
        Self { at: Point2::new(x, y), z_mm }
    }
}

/// Role of a point on the path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// It starts or ends a straight segment.
    #[default]
    Line,
    /// The arc from the point before to the point behind goes through it.
    Arc,
}

impl Kind {
    /// The other one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Line => Self::Arc,
            Self::Arc => Self::Line,
        }
    }
}

/// Dimension of a shape: the heights of its points count or not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Dimension {
    /// They do not: the shape is as deep as its group says, and moves along it keep Z.
    #[default]
    #[serde(rename = "2d")]
    Two,
    /// They do. There are no arcs.
    #[serde(rename = "3d")]
    Three,
}

/// A digitized point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Place where the tool stood.
    #[serde(flatten)]
    pub stand: Stand,
    /// Role on the path.
    pub kind: Kind,
}

impl Point {
    /// A point of a kind where the tool stands.
    pub const fn new(stand: Stand, kind: Kind) -> Self {
        Self { stand, kind }
    }

    /// Returns the distance of the tool from it; in 2D whatever its height.
    pub(crate) fn distance(&self, tool: &Stand, dimension: Dimension) -> f64 {
        let flat = self.stand.at.distance(tool.at);
        match dimension {
            Dimension::Two => flat,
            Dimension::Three => flat.hypot(self.stand.z_mm - tool.z_mm),
        }
    }
}
