//! The extent of the drawable part of a scene.

use super::tracks::{arc, length};
use crate::scene::{Scene, Segment};
use kerf_geom::Bounds3;
use kerf_program::MoveKind;

/// The reach of a scene's segments.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// Of cutting moves.
    pub cut: Bounds3,
    /// Of everything drawn.
    pub drawn: Bounds3,
    /// Length of cutting in X and Y, mm.
    pub cut_mm: f64,
    /// Segments that cannot be drawn.
    pub left_out: usize,
}

impl Extent {
    /// Goes through the scene once.
    pub fn of(scene: &Scene) -> Self {
        let mut extent = Self::default();
        for segment in &scene.segments {
            extent.add(segment, scene.show_jogs);
        }
        extent
    }

    fn add(&mut self, segment: &Segment, show_jogs: bool) {
        if !segment.is_drawable() {
            self.left_out += 1;
            return;
        }
        let cut = segment.kind == MoveKind::Cut;
        if !cut && !show_jogs {
            return;
        }
        let mut own = Bounds3::default();
        reach(segment, &mut own);
        self.drawn.merge(&own);
        if cut {
            self.cut_mm += length(segment);
            self.cut.merge(&own);
        }
    }
}

/// Adds the reach of a segment.
pub fn reach(segment: &Segment, bounds: &mut Bounds3) {
    bounds.add(segment.from);
    bounds.add(segment.to);
    if let Some(arc) = arc(segment) {
        arc.extremes(|p| bounds.add([p.x, p.y, segment.from[2]]));
    }
}
