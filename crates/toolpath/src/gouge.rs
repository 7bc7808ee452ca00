//! Finds leads that cut into a part.

use crate::warning::Warning;
use kerf_drawing::{Drawing, Group, Kind, Shape, crosses};
use kerf_geom::{Bounds2, BoxTree, Point2, Polyarc, Segment};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A lead may come nearer to a contour than its offset by so much, millimetres: far above what is lost
/// by rounding, far below what a cutter shows.
const ALLOWED_MM: f64 = 1e-4;

/// A tool on its way down may come so near, millimetres: areas are cleared by a ten-thousandth more than asked,
/// so that nothing of them stays.
const ALLOWED_DOWN_MM: f64 = 5e-4;

/// The tool as a contour sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tool {
    /// Half its width, millimetres; 0 where nobody knows it.
    pub radius_mm: f64,
}

/// All contours of a drawing, to be asked what is near.
pub(crate) struct Contours {
    shapes: Vec<Arc<Shape>>,
    /// The closed shapes, neighbours in the plane beside each other.
    outlines: Vec<usize>,
    /// Their segments, each with the place of its outline. The boxes of whole outlines say little: those of
    /// frames within each other all meet.
    segments: Vec<(usize, Segment)>,
    /// The boxes of the segments.
    tree: BoxTree,
}

impl Contours {
    /// The closed shapes of a drawing.
    pub fn of(drawing: &Drawing) -> Self {
        let closed = |n: &usize| {
            let shape = &drawing.shapes[*n];
            shape.is_closed() && shape.kind() == Kind::Polyarc
        };
        let shapes: Vec<usize> = (0..drawing.shapes.len()).filter(closed).collect();
        let boxes: Vec<Bounds2> = shapes.iter().map(|n| drawing.shapes[*n].path.bounds()).collect();
        let order = BoxTree::order(&boxes).into_iter();
        let outlines: Vec<usize> = order.map(|place| shapes[place]).collect();
        let of = |(place, shape): (usize, &usize)| {
            drawing.shapes[*shape].path.segments().map(move |segment| (place, segment))
        };
        let segments: Vec<(usize, Segment)> = outlines.iter().enumerate().flat_map(of).collect();
        let boxes: Vec<Bounds2> = segments.iter().map(|(_, segment)| segment.bounds()).collect();
        let order = BoxTree::order(&boxes);
        let segments = order.iter().map(|n| segments[*n]).collect();
        let tree = BoxTree::new(order.iter().map(|n| boxes[*n]));
        Self { shapes: drawing.shapes.clone(), outlines, segments, tree }
    }

    /// Calls `visit` with every wanted shape of which a segment near an area is `hit`, until it returns false.
    fn near(
        &self,
        area: &Bounds2,
        wanted: impl Fn(usize) -> bool,
        hit: impl Fn(&Segment) -> bool,
        visit: impl FnMut(usize) -> bool,
    ) {
        let mut found = BTreeSet::new();
        self.tree.meeting(area, |n| {
            let (outline, segment) = &self.segments[n];
            if wanted(self.outlines[*outline]) && !found.contains(outline) && hit(segment) {
                found.insert(*outline);
            }
        });
        // One that stops early is given the first in the order of the plane.
        _ = found.into_iter().map(|outline| self.outlines[outline]).all(visit);
    }

    /// The first shape whose contour a tool of that radius would cut into on a lead.
    fn cut_into(&self, lead: &Polyarc, radius: f64) -> Option<usize> {
        let mut first: Option<usize> = None;
        for segment in lead.segments() {
            self.nearer(&segment, radius, |shape| {
                first = Some(first.map_or(shape, |least| least.min(shape)));
            });
        }
        first
    }

    /// Calls `visit` with every shape whose contour lies nearer to a segment than a tool of that radius
    /// allows.
    pub fn nearer(&self, segment: &Segment, radius: f64, mut visit: impl FnMut(usize)) {
        self.nearer_of(segment, radius, |_| true, &mut visit);
    }

    /// The same for those shapes that `wanted` lets pass.
    pub fn nearer_of(
        &self,
        segment: &Segment,
        radius: f64,
        wanted: impl Fn(usize) -> bool,
        mut visit: impl FnMut(usize),
    ) {
        let reach = radius - ALLOWED_MM;
        let hit = |contour: &Segment| segment.distance_to(contour) < reach;
        self.near(&segment.bounds().grown(reach), wanted, hit, |shape| {
            visit(shape);
            true
        });
    }

    /// Calls `visit` with the shapes whose contours a tool of that radius cuts into on a path; of a tool without
    /// one with those that a closed path crosses.
    pub fn touched(&self, path: &Polyarc, radius: f64, mut visit: impl FnMut(usize)) {
        if radius > 0.0 {
            path.segments().for_each(|segment| self.nearer(&segment, radius, &mut visit));
        } else if path.closed {
            self.crossed_by(path, |_| true).into_iter().for_each(visit);
        }
    }

    /// The first shape whose contour a closed path crosses, of those that `wanted` lets pass.
    fn crossed_by(&self, path: &Polyarc, wanted: impl Fn(usize) -> bool) -> Option<usize> {
        let mut near = BTreeSet::new();
        self.near(
            &path.bounds(),
            wanted,
            |_| true,
            |shape| {
                near.insert(shape);
                true
            },
        );
        near.into_iter().find(|n| crosses(&self.shapes[*n].path, path))
    }

    /// The group of a shape.
    pub fn group(&self, shape: usize) -> Group {
        self.shapes[shape].group
    }

    /// A shape into which a tool cuts that follows a circle, of those that are walls. Where its width is not
    /// known, its middle must not cross a contour.
    pub fn cut_by_ring(
        &self,
        circle: &Polyarc,
        tool: Tool,
        wall: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        if tool.radius_mm == 0.0 {
            return self.crossed_by(circle, wall);
        }
        let reach = tool.radius_mm - ALLOWED_DOWN_MM;
        let near = |contour: &Segment| circle.segments().any(|s| s.distance_to(contour) < reach);
        self.first(&circle.bounds().grown(reach), wall, near)
    }

    /// A shape into which a tool cuts that clears a disc, its middle up to a radius away from a place.
    pub fn cut_by_disc(
        &self,
        middle: Point2,
        radius_mm: f64,
        tool: Tool,
        wall: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        let reach = radius_mm + tool.radius_mm - ALLOWED_DOWN_MM;
        let area = Bounds2::of(middle, middle).grown(reach);
        self.first(&area, wall, |contour| contour.distance(middle) < reach)
    }

    /// A wanted shape of which a segment near an area is `hit`.
    fn first(
        &self,
        area: &Bounds2,
        wanted: impl Fn(usize) -> bool,
        hit: impl Fn(&Segment) -> bool,
    ) -> Option<usize> {
        let mut found = None;
        self.near(area, wanted, hit, |shape| {
            found = Some(shape);
            false
        });
        found
    }
}

/// Warns of leads that cut into a part. Without an offset the tool's width is not known.
pub(crate) fn check(
    number: usize,
    leads: &[(&str, Polyarc)],
    offset_mm: f64,
    contours: &Contours,
    warnings: &mut Vec<Warning>,
) {
    for (name, lead) in leads.iter().filter(|_| offset_mm != 0.0) {
        if let Some(shape) = contours.cut_into(lead, offset_mm.abs()) {
            let which =
                if shape + 1 == number { "it".into() } else { format!("shape {}", shape + 1) };
            let text =
                format!("its {name} cuts into {which}: move the start or make the lead smaller");
            warnings.push(Warning::new(number, text));
        }
    }
}
