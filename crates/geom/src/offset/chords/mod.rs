//! The second engine: what a round tool covers, put together from polygons.
//!
//! Asked only when nothing of the first engine passes the check. It shares no step with it: everything
//! within the distance of the source is a union of simple pieces ([`cover`]), a library that computes with
//! whole numbers unites them, and the boundary tells which parallel curve follows which. These curves are
//! exact; so are the places where they meet, unless they meet so flatly that the polygon's corner has to do
//! ([`refit`]). What comes out is held to the same check as the first engine's result, and when it passes
//! only with a larger tolerance, the path says so.

mod cover;
mod refit;

use super::path::OffsetPath;
use super::rings::started_like_source;
use super::source::Source;
use crate::{Point2, Polyarc};
use cover::Polygon;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::overlay::{FloatOverlay, OverlayOptions};

/// Tolerance of a path of chords that is not exact: ten times the chords, and still a tenth of what a
/// good machine repeats to.
pub(super) const LOOSE_MM: f64 = 1e-3;

/// More segments than this take longer than anybody waits for a second opinion.
const MOST_SEGMENTS: usize = 20_000;

/// The offset, not yet checked; nothing when the contours bound no region, or when the boundary cannot be
/// told apart.
pub(super) fn offset(source: &Source, distance: f64) -> Option<Vec<OffsetPath>> {
    if source.segments().len() > MOST_SEGMENTS {
        return None;
    }
    let covered = Covered::of(source, distance)?;
    let curves = refit::Curves::of(source, distance);
    let mut found = Vec::new();
    for polygon in covered.boundary() {
        for path in curves.along(&polygon, covered.open)? {
            let closed = path.path.closed;
            found.push(if closed { started_like_source(source, distance, path) } else { path });
        }
    }
    Some(found)
}

/// The region and what lies within the distance of its contours.
struct Covered {
    region: Vec<Polygon>,
    pieces: Vec<Polygon>,
    rule: OverlayRule,
    open: bool,
    /// The contours run the other way round than the boundary: outer ones clockwise.
    turned: bool,
}

impl Covered {
    fn of(source: &Source, distance: f64) -> Option<Self> {
        let open = source.contours.iter().all(|c| !c.closed);
        if open {
            let pieces = cover::both_sides(source, distance);
            let (region, rule) = (Vec::new(), OverlayRule::Clip);
            // The boundary runs along the right of the contours, and back along their left.
            return Some(Self { region, pieces, rule, open, turned: distance < 0.0 });
        }
        if source.contours.iter().any(|c| !c.closed) {
            return None;
        }
        let turned = runs_clockwise(source.contours)?;
        let pieces = cover::one_side(source, distance);
        let grows = (distance > 0.0) != turned;
        let rule = if grows { OverlayRule::Union } else { OverlayRule::Difference };
        let region = source.contours.iter().map(cover::flattened).collect();
        Some(Self { region, pieces, rule, open, turned })
    }

    /// The boundary of the result, in the direction of the contours.
    fn boundary(&self) -> Vec<Vec<Point2>> {
        // Corners between parallels of lines that go straight on are wanted, too.
        let mut options = OverlayOptions::<f64, i64>::default();
        options.preserve_output_collinear = true;
        let mut overlay = FloatOverlay::<[f64; 2], i64>::from_subj_and_clip_custom(
            &self.region,
            &self.pieces,
            options,
            Default::default(),
        );
        let shapes = overlay.overlay(self.rule, FillRule::NonZero);
        let places = |ring: Polygon| -> Vec<Point2> {
            let places = ring.into_iter().map(|[x, y]| Point2::new(x, y));
            if self.turned { places.rev().collect() } else { places.collect() }
        };
        shapes.into_iter().flatten().map(places).collect()
    }
}

/// Returns `true` if outer contours run clockwise; nothing when contours do not bound a region together.
fn runs_clockwise(contours: &[Polyarc]) -> Option<bool> {
    let around = |n: usize, at: Point2| {
        let others = contours.iter().enumerate().filter(|(other, _)| *other != n);
        others.filter(|(_, other)| other.bounds().holds(at) && other.winding(at) != 0).count()
    };
    let clockwise = contours.iter().enumerate().map(|(n, contour)| {
        let is_hole = around(n, contour.start()?) % 2 == 1;
        Some((contour.signed_area() < 0.0) != is_hole)
    });
    let ways = clockwise.collect::<Option<Vec<bool>>>()?;
    let first = *ways.first()?;
    ways.iter().all(|way| *way == first).then_some(first)
}
