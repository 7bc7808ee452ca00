//! The places where the tool's centre may go.

use crate::Cutter;
use kerf_geom::{Indexed, Point2, Polyarc, Segment};

/// Distance by which the centre may come nearer to a contour than its radius on a link, millimetres. What
/// is found here is where it leaves the region, not where rounding moves it by a hair.
const SLACK_MM: f64 = 2e-4;

/// Links are looked at at least this densely, as a share of the radius. Between two places a corner
/// of a contour can come nearer by 1/20,000 of the radius at most than it is seen to be.
const SPACING: f64 = 0.02;

/// The places at least the tool's radius away from all contours of a region, and inside it.
pub(crate) struct Inside {
    contours: Indexed,
    nearest: f64,
    step: f64,
}

impl Inside {
    pub fn of(region: &[Polyarc], cutter: &Cutter) -> Self {
        let radius = cutter.radius_mm();
        let nearest = radius - SLACK_MM.min(1e-4 * radius) - (radius - cutter.first_depth_mm());
        Self { contours: Indexed::new(region), nearest, step: SPACING * radius }
    }

    /// Returns `true` if the centre may follow a segment. Its ends are taken to be in the region, so that it is
    /// enough to look at distances.
    pub fn holds(&self, segment: &Segment) -> bool {
        let count = (segment.length() / self.step).ceil().max(1.0) as usize;
        let place = |k: usize| segment.at(k as f64 / count as f64);
        (0..=count).all(|k| !self.contours.is_nearer(place(k), self.nearest))
    }

    /// Returns `true` if the centre may go straight from one place to another.
    pub fn joins(&self, from: Point2, to: Point2) -> bool {
        self.holds(&Segment::line(from, to))
    }
}
