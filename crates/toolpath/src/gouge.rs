//! Whether a lead cuts into a part.

use crate::warning::Warning;
use kerf_drawing::{Drawing, Kind, Shape, crosses};
use kerf_geom::{Bounds2, BoxTree, Polyarc, Segment};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A lead may come nearer to a contour than its offset by so much, millimetres: far above what is lost
/// by rounding, far below what a cutter shows.
const ALLOWED_MM: f64 = 1e-4;

/// What the circle of a helix is called.
pub(crate) const HELIX: &str = "helix";

/// All contours of a drawing, to be asked what is near.
pub(crate) struct Contours {
    shapes: Vec<Arc<Shape>>,
    segments: Vec<(usize, Segment)>,
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
        let segments: Vec<(usize, Segment)> = BoxTree::order(&boxes)
            .into_iter()
            .map(|place| shapes[place])
            .flat_map(|n| drawing.shapes[n].path.segments().map(move |s| (n, s)))
            .collect();
        let tree = BoxTree::new(segments.iter().map(|(_, segment)| segment.bounds()));
        Self { shapes: drawing.shapes.clone(), segments, tree }
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
        self.tree.meeting(&segment.bounds().grown(reach), |n| {
            let (shape, contour) = &self.segments[n];
            if wanted(*shape) && segment.distance_to(contour) < reach {
                visit(*shape);
            }
        });
    }

    /// Calls `visit` with the shapes whose contours a tool of that radius cuts into on a path; of a tool without
    /// one with those that a closed path crosses.
    pub fn touched(&self, path: &Polyarc, radius: f64, mut visit: impl FnMut(usize)) {
        if radius > 0.0 {
            path.segments().for_each(|segment| self.nearer(&segment, radius, &mut visit));
        } else if path.closed {
            self.crossed_by(path).into_iter().for_each(visit);
        }
    }

    /// The first shape whose contour a closed path crosses.
    fn crossed_by(&self, path: &Polyarc) -> Option<usize> {
        let mut near = BTreeSet::new();
        self.tree.meeting(&path.bounds(), |n| {
            near.insert(self.segments[n].0);
        });
        near.into_iter().find(|n| crosses(&self.shapes[*n].path, path))
    }
}

/// Warns of leads that cut into a part. Without an offset the tool's width is not known: then only the
/// circle of a helix is looked at, whose middle alone may leave the side of the contour it lies on.
pub(crate) fn check(
    number: usize,
    leads: &[(&str, Polyarc)],
    offset_mm: f64,
    contours: &Contours,
    warnings: &mut Vec<Warning>,
) {
    for (name, lead) in leads {
        if offset_mm == 0.0 {
            let crossed = if *name == HELIX { contours.crossed_by(lead) } else { None };
            warnings.extend(crossed.map(|shape| no_room(number, shape)));
        } else if let Some(shape) = contours.cut_into(lead, offset_mm.abs()) {
            let which = named(number, shape);
            let text =
                format!("its {name} cuts into {which}: move the start or make the lead smaller");
            warnings.push(Warning::new(number, text));
        }
    }
}

fn named(number: usize, shape: usize) -> String {
    if shape + 1 == number { "it".into() } else { format!("shape {}", shape + 1) }
}

fn no_room(number: usize, shape: usize) -> Warning {
    let which = named(number, shape);
    let text = format!(
        "its helix has no room and cuts across {which}: move the start, make the helix smaller or take a ramp"
    );
    Warning::new(number, text)
}
