//! Whether a lead cuts into a part.

use crate::warning::Warning;
use kerf_drawing::{Drawing, Kind, Shape};
use kerf_geom::{Bounds2, BoxTree, Point2, Polyarc, Segment};

/// A lead may come nearer to a contour than its offset by so much, millimetres: far above what is lost
/// by rounding, far below what a cutter shows.
const ALLOWED_MM: f64 = 1e-4;

/// Places of a lead that are looked at.
const PROBES: u32 = 32;

/// All contours of a drawing, to be asked what is near.
pub(crate) struct Contours {
    segments: Vec<(usize, Segment)>,
    tree: BoxTree,
}

impl Contours {
    /// The closed shapes of a drawing.
    pub fn of(drawing: &Drawing) -> Self {
        let closed = |shape: &Shape| shape.is_closed() && shape.kind() == Kind::Polyarc;
        let shapes = drawing.shapes.iter().enumerate().filter(|(_, shape)| closed(shape));
        let segments: Vec<(usize, Segment)> =
            shapes.flat_map(|(n, shape)| shape.path.segments().map(move |s| (n, s))).collect();
        let tree = BoxTree::new(segments.iter().map(|(_, segment)| segment.bounds()));
        Self { segments, tree }
    }

    /// The shape whose contour a tool of that radius would cut into on a lead, if there is one.
    fn cut_into(&self, lead: &Polyarc, radius: f64) -> Option<usize> {
        let reach = radius - ALLOWED_MM;
        let probe = |n: u32| lead.place_after(lead.length() * f64::from(n) / f64::from(PROBES));
        (0..=PROBES).filter_map(probe).find_map(|place| self.nearer(place.at, reach))
    }

    /// Calls `visit` with every shape whose contour lies nearer to a segment than a tool of that radius
    /// allows.
    pub fn passed(&self, segment: &Segment, radius: f64, mut visit: impl FnMut(usize)) {
        let reach = radius - ALLOWED_MM;
        self.tree.meeting(&segment.bounds().grown(reach), |n| {
            let (shape, contour) = &self.segments[n];
            if comes_nearer(segment, 0.0, 1.0, contour, reach) {
                visit(*shape);
            }
        });
    }

    fn nearer(&self, place: Point2, reach: f64) -> Option<usize> {
        let mut found: Option<usize> = None;
        self.tree.meeting(&Bounds2::of(place, place).grown(reach), |n| {
            let (shape, segment) = &self.segments[n];
            if segment.distance(place) < reach {
                found = Some(found.map_or(*shape, |least| least.min(*shape)));
            }
        });
        found
    }
}

/// Whether some place of a part of a segment lies nearer to another one than `reach`. No place of the part
/// is farther from its middle than half its length: a part is divided until that decides.
fn comes_nearer(segment: &Segment, from: f64, to: f64, other: &Segment, reach: f64) -> bool {
    let middle = 0.5 * (from + to);
    let distance = other.distance(segment.at(middle));
    let half = 0.5 * (to - from) * segment.length();
    if distance < reach {
        return true;
    }
    if distance - half >= reach || half < ALLOWED_MM {
        return false;
    }
    comes_nearer(segment, from, middle, other, reach)
        || comes_nearer(segment, middle, to, other, reach)
}

/// Warns of leads that cut into a part. Without an offset the tool's width is not known, and nothing
/// can be said.
pub(crate) fn check(
    number: usize,
    leads: &[(&str, Polyarc)],
    offset_mm: f64,
    contours: &Contours,
    warnings: &mut Vec<Warning>,
) {
    if offset_mm == 0.0 {
        return;
    }
    for (name, lead) in leads {
        if let Some(shape) = contours.cut_into(lead, offset_mm.abs()) {
            let which =
                if shape + 1 == number { "it".into() } else { format!("shape {}", shape + 1) };
            let text =
                format!("its {name} cuts into {which}: move the start or make the lead smaller");
            warnings.push(Warning::new(number, text));
        }
    }
}
