//! One shape of a drawing: a path, perhaps with heights, in a group.

use crate::Group;
use kerf_geom::{Point2, Polyarc, PolyarcPlace, Transform2};
use serde::{Deserialize, Serialize};

/// A shape: what is cut in one go.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Its lines and arcs, millimetres, in the direction of the cut. A single vertex is a point:
    /// a place to drill.
    pub path: Polyarc,
    /// Height of each vertex above ZSurface, millimetres, for a 3D shape.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z_mm: Option<Vec<f64>>,
    /// Its group.
    #[serde(default)]
    pub group: Group,
    /// The machine halts before it by itself.
    #[serde(default)]
    pub pause: bool,
    /// The first vertex is there only because the cut begins at it (readings, Start point).
    #[serde(default)]
    pub start_inserted: bool,
}

/// Kind of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A single place.
    Point,
    /// Lines and arcs.
    Polyarc,
}

impl Shape {
    /// A flat shape of the black group.
    pub fn flat(path: Polyarc) -> Self {
        Self { path, z_mm: None, group: Group::default(), pause: false, start_inserted: false }
    }

    /// A place to drill.
    pub fn point(at: Point2) -> Self {
        Self::flat(Polyarc::lines([at], false))
    }

    /// A 3D shape: a path with the height of each vertex. Heights beyond the last vertex are
    /// dropped, missing ones repeat the last.
    pub fn with_heights(path: Polyarc, mut z_mm: Vec<f64>) -> Self {
        let last = z_mm.last().copied().unwrap_or_default();
        z_mm.resize(path.vertices.len(), last);
        Self { z_mm: Some(z_mm), ..Self::flat(path) }
    }

    /// The same shape in another group.
    pub fn in_group(self, group: Group) -> Self {
        Self { group, ..self }
    }

    /// Returns the kind of the shape.
    pub fn kind(&self) -> Kind {
        if self.path.vertices.len() == 1 { Kind::Point } else { Kind::Polyarc }
    }

    /// Tells whether its end is its start.
    pub fn is_closed(&self) -> bool {
        self.path.closed
    }

    /// Returns the place where its cut begins; the origin for a path without vertices.
    pub fn start(&self) -> Point2 {
        self.path.start().unwrap_or_default()
    }

    /// Height of a vertex above ZSurface, millimetres; 0 for a flat shape.
    pub fn height_mm(&self, vertex: usize) -> f64 {
        self.z_mm.as_ref().and_then(|z| z.get(vertex)).copied().unwrap_or_default()
    }

    /// Height at a place of its path, in proportion to the length between two vertices.
    pub fn height_at(&self, place: &PolyarcPlace) -> f64 {
        let next = (place.segment + 1) % self.path.vertices.len().max(1);
        let (from, to) = (self.height_mm(place.segment), self.height_mm(next));
        from + (to - from) * place.share
    }

    /// Moved, turned, scaled or mirrored in the plane. Heights stay.
    ///
    /// The map must keep circles circular ([`Transform2::keeps_circles`]); otherwise arcs come out wrong.
    pub fn mapped(&self, map: &Transform2) -> Self {
        Self { path: self.path.similar(map), ..self.clone() }
    }

    /// The same shape cut the other way round; a closed shape keeps its start.
    pub fn reversed(&self) -> Self {
        let z_mm = self.z_mm.as_ref().map(|z| reversed_heights(z, self.path.closed));
        Self { path: self.path.reversed(), z_mm, ..self.clone() }
    }
}

/// Heights in the order in which `Polyarc::reversed` leaves the vertices.
fn reversed_heights(z_mm: &[f64], closed: bool) -> Vec<f64> {
    let mut turned: Vec<f64> = z_mm.iter().rev().copied().collect();
    if closed {
        turned.rotate_right(1);
    }
    turned
}
