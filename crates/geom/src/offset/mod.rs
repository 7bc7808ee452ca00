//! Parallel curves: what a tool's centre follows so that its edge follows the drawing.
//!
//! Positive is to the right of travel: outside a counter-clockwise part, inside a clockwise hole. The
//! offset of a closed contour is the set of places at that distance from it and no nearer to any other
//! part of it; arcs stay arcs, corners that open get arcs.
//!
//! # How
//!
//! 1. [`raw`]: each segment is moved sideways, arcs are put round opening corners, neighbours at closing
//!    corners are cut back to where they cross.
//! 2. [`slices`]: the raw curve is cut wherever it crosses itself; slices too near to the source go.
//! 3. [`crate::stitch`]: what is left is joined into rings.
//! 4. [`validate`]: an independent check of the result against its definition, that knows nothing of
//!    steps 1 to 3. Only what passes is returned; what fails is tried again where its coincidences fall
//!    differently.
//!
//! 5. [`chords`]: when nothing of this passes, another engine that shares no step with it.
//!
//! A wrong offset is never returned: what cannot be proved right is an error that names the place.

mod beyond;
mod chains;
mod chords;
mod clearance;
mod raw;
mod rings;
mod slices;
mod source;
mod validate;

pub use validate::CHECK_MM;

pub(crate) use raw::parallel;

use crate::pool::{self, Buffer};
use crate::{BoxTree, GeomError, Point2, Polyarc, Transform2, tol};
use source::Source;
use std::fmt;

/// What a segment of an offset is parallel to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Number of the contour.
    pub contour: usize,
    /// Number of the segment, or of the vertex when it is a corner.
    pub element: usize,
    /// An arc about a vertex instead of a parallel of a segment.
    pub corner: bool,
}

/// An offset curve and where each of its segments comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct OffsetPath {
    /// The curve.
    pub path: Polyarc,
    /// For each segment of the path what it is parallel to.
    pub origins: Vec<Origin>,
    /// How far the path may be from its distance: [`CHECK_MM`], unless it had to be made of chords; then
    /// a person should be told.
    pub within_mm: f64,
}

/// An offset that could not be made exactly; its message tells a person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coarse {
    /// How far it may be off.
    pub within_mm: f64,
}

impl Coarse {
    /// What there is to tell of some paths; nothing when all are as exact as usual.
    pub fn of(paths: &[OffsetPath]) -> Option<Self> {
        let within_mm = paths.iter().map(|path| path.within_mm).fold(0.0, f64::max);
        (within_mm > CHECK_MM).then_some(Self { within_mm })
    }
}

impl fmt::Display for Coarse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "its offset could not be made exactly: it may be off by {} mm", self.within_mm)
    }
}

/// The offset of one polyarc: rings for a closed one, pieces for an open one. Nothing remains when the
/// distance is larger than the shape allows; that is no error.
///
/// Each ring begins at the place nearest to the parallel of the source's start.
///
/// # Errors
/// Numbers that are not finite, fewer than two different vertices, a contour that crosses itself, and a
/// result that does not pass its check.
///
/// ```
/// use kerf_geom::{Point2, Polyarc, offset};
/// let square = Polyarc::rectangle(Point2::new(0.0, 0.0), Point2::new(100.0, 100.0));
/// let outside = offset(&square, 5.0)?;
/// assert_eq!(outside[0].path.start(), Some(Point2::new(0.0, -5.0)));
/// assert!((outside[0].path.signed_area() - 12_078.539_816).abs() < 1e-6);
/// # Ok::<(), kerf_geom::GeomError>(())
/// ```
pub fn offset(source: &Polyarc, distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
    offset_region(std::slice::from_ref(source), distance)
}

/// The offset of several contours together, such as a part with its holes or a pocket with its islands:
/// places at the distance from one and no nearer to any other.
///
/// # Errors
/// As [`offset`]; contours must not cross each other.
pub fn offset_region(contours: &[Polyarc], distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
    if !distance.is_finite() || distance.abs() > tol::FARTHEST_MM {
        return Err(GeomError::NotPositive { what: "the size of an offset" });
    }
    contours.iter().try_for_each(Polyarc::check)?;
    if distance.abs() <= tol::SAME_PLACE_MM {
        return Ok(contours.iter().enumerate().map(|(k, c)| unmoved(k, c)).collect());
    }
    let prepared = Prepared::new(contours)?;
    let mut found = prepared.proved(distance)?;
    for path in &mut found {
        prepared.restore(path);
    }
    Ok(found)
}

/// The same by the second engine alone, which [`offset_region`] asks when the first one fails: for those
/// who compare the two.
///
/// # Errors
/// As [`offset_region`].
pub fn offset_by_chords(contours: &[Polyarc], distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
    contours.iter().try_for_each(Polyarc::check)?;
    let prepared = Prepared::new(contours)?;
    let source = Source::new(&prepared.contours);
    let why = GeomError::Unproved { why: "contours that bound no region", at: prepared.middle };
    let mut found = by_chords(&source, distance).ok_or(why)?;
    found.iter_mut().for_each(|path| prepared.restore(path));
    Ok(found)
}

/// The path beside an open one that may cross itself: every segment moved sideways, with arcs about
/// corners that open, cut back at those that close, and nothing else taken away. It is one path
/// without a break, and near a crossing it comes nearer to other parts of the source than the distance.
///
/// # Errors
/// Numbers that are not finite, fewer than two different vertices, and places where neighbours do not
/// meet: an arc or a segment that is smaller than the distance.
pub fn parallel_path(source: &Polyarc, distance: f64) -> Result<Polyarc, GeomError> {
    source.check()?;
    let source = source.tidied();
    if source.segment_count() == 0 {
        return Err(GeomError::TooFewVertices { found: source.vertices.len(), needed: 2 });
    }
    let mut pieces = Vec::new();
    let segments: Vec<_> = source.segments().collect();
    let ways: Vec<_> = segments.iter().map(source::Ways::of).collect();
    raw::append(0, (&segments, &ways, source.closed), distance, &mut pieces);
    let joints = if source.closed { pieces.len() } else { pieces.len().saturating_sub(1) };
    let broken = pieces[..joints].iter().find(|piece| piece.next.is_none());
    if let Some(piece) = broken {
        let what = "the path beside it is interrupted";
        return Err(GeomError::Impossible { what, at: piece.segment.end() });
    }
    let segments: Vec<_> = pieces.iter().map(|piece| piece.segment).collect();
    Ok(Polyarc::from_segments(&segments, source.closed))
}

/// An offset by nothing is the contour itself.
fn unmoved(contour: usize, path: &Polyarc) -> OffsetPath {
    let origin = |element| Origin { contour, element, corner: false };
    let origins = (0..path.segment_count()).map(origin).collect();
    OffsetPath { path: path.clone(), origins, within_mm: CHECK_MM }
}

/// The contours moved to the origin, without empty segments and long arcs.
struct Prepared {
    contours: Vec<Polyarc>,
    /// For each segment of all prepared contours the segment it was.
    were: Buffer<usize>,
    /// Where those of each contour begin.
    first: Buffer<usize>,
    middle: Point2,
}

impl Drop for Prepared {
    fn drop(&mut self) {
        self.contours.drain(..).for_each(|contour| pool::give(contour.vertices));
    }
}

impl Prepared {
    fn new(contours: &[Polyarc]) -> Result<Self, GeomError> {
        let mut bounds = crate::Bounds2::default();
        contours.iter().flat_map(|c| &c.vertices).for_each(|v| bounds.add(v.at));
        let middle = if bounds.is_empty() { Point2::default() } else { bounds.centre() };
        let to_origin = Point2::default() - middle;
        let (were, first) = (Buffer::default(), Buffer::default());
        let list = Vec::with_capacity(contours.len());
        let mut prepared = Self { contours: list, were, first, middle };
        for contour in contours {
            prepared.first.push(prepared.were.len());
            let mut ready = contour.tidied_with_names(&mut prepared.were);
            ready.vertices.iter_mut().for_each(|v| v.at += to_origin);
            if ready.segment_count() == 0 {
                let found = ready.vertices.len();
                return Err(GeomError::TooFewVertices { found, needed: 2 });
            }
            prepared.contours.push(ready);
        }
        Ok(prepared)
    }

    /// The first attempt that passes the check.
    fn proved(&self, distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
        let source = Source::new(&self.contours);
        let tangle = GeomError::Unproved { why: "a tangle of crossings", at: Point2::default() };
        let checked = |found: Vec<OffsetPath>| {
            validate::validate(&source, distance, &found, CHECK_MM).map(|()| found)
        };
        let first = attempt(&source, distance).ok_or(tangle).and_then(checked);
        let Err(why) = first else { return first };
        self.crossing().map_or(Ok(()), Err)?;
        for (turn_rad, longer) in SECOND_ATTEMPTS {
            let found = self.attempt_turned(distance + longer, turn_rad);
            if let Some(Ok(found)) = found.map(checked) {
                return Ok(found);
            }
        }
        by_chords(&source, distance).ok_or_else(|| self.error_at_source(why))
    }

    /// The offset of the turned contours, turned back.
    fn attempt_turned(&self, distance: f64, turn_rad: f64) -> Option<Vec<OffsetPath>> {
        let turn = Transform2::turned(Point2::default(), turn_rad);
        let back = Transform2::turned(Point2::default(), -turn_rad);
        let turned: Vec<Polyarc> = self.contours.iter().map(|c| c.similar(&turn)).collect();
        let mut found = attempt(&Source::new(&turned), distance)?;
        found.iter_mut().for_each(|offset| offset.path = offset.path.similar(&back));
        Some(found)
    }

    /// Where a contour crosses itself or another, if one does: what has no inside has no offset.
    fn crossing(&self) -> Option<GeomError> {
        let back = self.middle - Point2::default();
        let boxes = BoxTree::new(self.contours.iter().map(Polyarc::bounds));
        let mut pairs: Vec<(usize, usize)> = (0..self.contours.len()).map(|k| (k, k)).collect();
        boxes.own_pairs(|a, b| pairs.push((a, b)));
        pairs.into_iter().find_map(|(first, second)| {
            let (a, b) = (&self.contours[first], &self.contours[second]);
            let found =
                if first == second { a.crosses_itself() } else { a.crossings(b).first().copied() };
            let at = found?.first.at + back;
            Some(GeomError::Crosses { first, second, at })
        })
    }

    /// An error with its place where the source is.
    fn error_at_source(&self, error: GeomError) -> GeomError {
        let back = self.middle - Point2::default();
        match error {
            GeomError::Unproved { why, at } => GeomError::Unproved { why, at: at + back },
            other => other,
        }
    }

    /// Back to where the source is, with the source's numbers.
    fn restore(&self, offset: &mut OffsetPath) {
        let back = self.middle - Point2::default();
        offset.path.vertices.iter_mut().for_each(|v| v.at += back);
        for origin in &mut offset.origins {
            origin.element = self.were[self.first[origin.contour] + origin.element];
        }
    }
}

/// What is tried when the first attempt fails its check: the shape turned by some angle, which makes other
/// roundings of coincident curves, and in the end an offset that differs by less than the check can see.
const SECOND_ATTEMPTS: [(f64, f64); 4] = [(0.7, 0.0), (2.9, 0.0), (1.3, 2e-7), (0.3, -2e-7)];

/// The offset of the second engine, exact or as exact as it can be; nothing when neither passes the check.
/// That nothing is left at all has to be certain.
fn by_chords(source: &Source, distance: f64) -> Option<Vec<OffsetPath>> {
    let mut found = chords::offset(source, distance)?;
    let tolerances = [CHECK_MM, chords::LOOSE_MM];
    let known = if found.is_empty() { &tolerances[..1] } else { &tolerances };
    let passes = |within: &&f64| validate::validate(source, distance, &found, **within).is_ok();
    let within_mm = *known.iter().find(passes)?;
    found.iter_mut().for_each(|path| path.within_mm = within_mm);
    Some(found)
}

/// Steps 1 to 3; nothing when the raw offset is a tangle.
fn attempt(source: &Source, distance: f64) -> Option<Vec<OffsetPath>> {
    let mut pieces = Buffer::default();
    for (number, contour) in source.contours.iter().enumerate() {
        let (segments, ways) = source.of_contour(number);
        raw::append(number, (segments, ways, contour.closed), distance, &mut pieces);
    }
    let mut tree = slices::index(&pieces);
    if slices::is_crowded(&tree) {
        slices::drop_buried(&mut pieces, source, distance);
        tree = slices::index(&pieces);
    }
    let caps = raw::caps(source.contours, distance);
    let slices = slices::valid_slices(&pieces, &tree, &caps, source, distance)?;
    Some(rings::rings(source, distance, &pieces, &slices))
}
