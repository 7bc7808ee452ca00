//! A curve given by its places and directions, replaced by arcs that stay near it.

use super::biarc::{Station, biarc};
use crate::{GeomError, Point2, Polyarc, Segment, Transform2, Vec2, tol};

/// Most halvings of a piece of a curve. The distance of a biarc falls with the cube of its length, so 2^13 pieces
/// follow an arc of a kilometre within a micrometre; what needs more lies where doubles have no micrometres.
const MOST_HALVINGS: u32 = 13;

/// Places of a piece that are held against its arcs, besides its ends.
const PROBES: u32 = 8;

/// Replaces a curve by lines and arcs whose tangents agree, at most `tolerance` away from it.
///
/// `at` tells place and direction of travel (of any length) at a parameter; `breaks` are the
/// parameters between which the curve is smooth, first to last. Each smooth part is halved until two
/// arcs follow it ([`biarc`]). The distance is measured at [`PROBES`] places of each part, against
/// half of the tolerance: between probes the distance of a smooth curve from its biarc grows by far
/// less than that.
pub fn curve(at: &dyn Fn(f64) -> (Point2, Vec2), breaks: &[f64], tolerance: f64) -> Polyarc {
    let mut fitting = Fitting { at, within: 0.5 * tolerance, segments: Vec::new() };
    for ends in breaks.windows(2) {
        fitting.part(ends[0], ends[1], MOST_HALVINGS);
    }
    let at = |t: &f64| at(*t).0;
    match (fitting.segments.is_empty(), breaks.first()) {
        (true, Some(first)) => Polyarc::lines([at(first)], false),
        _ => Polyarc::from_segments(&fitting.segments, false),
    }
}

struct Fitting<'a> {
    at: &'a dyn Fn(f64) -> (Point2, Vec2),
    within: f64,
    segments: Vec<Segment>,
}

impl Fitting<'_> {
    fn part(&mut self, from: f64, to: f64, halvings: u32) {
        let (a, b) = ((self.at)(from).0, (self.at)(to).0);
        // What is no place stays none however often it is halved.
        let halvings = if a.distance(b).is_finite() { halvings } else { 0 };
        if let Some(pair) = self.pair(from, to).filter(|pair| self.follows(pair, from, to)) {
            self.push(&pair);
        } else if halvings == 0 || a.distance(b) <= tol::SAME_PLACE_MM && self.is_still(from, to) {
            self.push(&[Segment::line(a, b)]);
        } else {
            let middle = 0.5 * (from + to);
            self.part(from, middle, halvings - 1);
            self.part(middle, to, halvings - 1);
        }
    }

    fn pair(&self, from: f64, to: f64) -> Option<[Segment; 2]> {
        let start = self.station(from, to - from)?;
        let end = self.station(to, from - to)?;
        biarc(start, Station { along: -end.along, ..end })
    }

    /// The place at a parameter with the direction into the part. At a corner each side has its own
    /// direction, so it is taken a little inside; where the curve stands still (control points that
    /// coincide) it is that of the way it goes from there.
    fn station(&self, t: f64, into: f64) -> Option<Station> {
        let at = (self.at)(t).0;
        let along = (self.at)(t + 1e-9 * into).1 * into.signum();
        let way = || ((self.at)(t + 1e-6 * into).0 - at).normalized();
        Some(Station { at, along: along.normalized().or_else(way)? })
    }

    fn follows(&self, pair: &[Segment; 2], from: f64, to: f64) -> bool {
        (1..PROBES).all(|n| {
            let t = from + (to - from) * f64::from(n) / f64::from(PROBES);
            let place = (self.at)(t).0;
            pair.iter().any(|segment| segment.distance(place) <= self.within)
        })
    }

    /// Tells whether a part whose ends meet goes nowhere between them.
    fn is_still(&self, from: f64, to: f64) -> bool {
        let start = (self.at)(from).0;
        let place = |n| (self.at)(from + (to - from) * f64::from(n) / f64::from(PROBES)).0;
        (1..PROBES).all(|n| place(n).distance(start) <= tol::SAME_PLACE_MM)
    }

    fn push(&mut self, segments: &[Segment]) {
        let long = segments.iter().filter(|segment| segment.length() > tol::SAME_PLACE_MM);
        self.segments.extend(long.copied());
    }
}

/// A polyarc under any affine map. Where circles do not stay circles the arcs are replaced within the
/// tolerance; a closed polyarc stays closed.
///
/// # Errors
/// The map flattens the plane and the path has arcs.
pub fn affine(path: &Polyarc, map: &Transform2, tolerance: f64) -> Result<Polyarc, GeomError> {
    let straight = path.vertices.iter().all(|vertex| vertex.bulge == 0.0);
    if straight || map.keeps_circles() {
        return Ok(path.similar(map));
    }
    if map.determinant() == 0.0 {
        return Err(GeomError::Flattened);
    }
    let mut segments = Vec::new();
    for segment in path.segments() {
        match segment {
            Segment::Line { start, end } => {
                segments.push(Segment::line(map.apply(start), map.apply(end)));
            }
            Segment::Arc { .. } => {
                let at = |t: f64| (map.apply(segment.at(t)), map.turn(segment.direction(t)));
                segments.extend(curve(&at, &[0.0, 0.5, 1.0], tolerance).segments());
            }
        }
    }
    Ok(Polyarc::from_segments(&segments, path.closed))
}
