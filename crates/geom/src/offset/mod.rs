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

mod aside;
mod beyond;
mod buried;
mod chains;
mod chord;
mod chords;
mod clearance;
mod complete;
mod cuts;
mod elements;
mod path;
mod prepared;
mod raw;
mod rings;
mod scratch;
mod slices;
mod source;
mod validate;
mod wanted;

pub use path::{CHECK_MM, Coarse, OffsetPath, Origin, Proposer};

pub(crate) use raw::parallel;

use crate::{GeomError, Polyarc, tol};
use prepared::Prepared;
use scratch::Scratch;

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
    Offsetter::default().offset(source, distance)
}

/// The offset of several contours together, such as a part with its holes or a pocket with its islands:
/// places at the distance from one and no nearer to any other.
///
/// # Errors
/// As [`offset`]; contours must not cross each other.
pub fn offset_region(contours: &[Polyarc], distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
    Offsetter::default().region(contours, distance)
}

/// Makes offsets: the first engine proposes, the check decides, and what it refuses the second engine makes.
/// One that is kept makes those of many shapes in the same buffers, which takes half of the time for small ones.
///
/// The first engine is Kerf's own, unless another one is given; then only its proposals are held to the
/// check, and it may even lie.
///
/// ```
/// use kerf_geom::{Offsetter, Point2, Polyarc, offset};
/// let square = Polyarc::rectangle(Point2::new(0.0, 0.0), Point2::new(9.0, 9.0));
/// let liar = |contours: &[Polyarc], _: f64| offset(&contours[0], 1.0).ok();
/// let found = Offsetter::with_first(&liar).offset(&square, 2.0)?;
/// assert!((found[0].path.length() - offset(&square, 2.0)?[0].path.length()).abs() < 1e-9);
/// # Ok::<(), kerf_geom::GeomError>(())
/// ```
#[derive(Default)]
pub struct Offsetter<'a> {
    first: Option<&'a Proposer<'a>>,
    scratch: Scratch,
}

impl<'a> Offsetter<'a> {
    /// With another first engine.
    pub fn with_first(first: &'a Proposer<'a>) -> Self {
        Self { first: Some(first), scratch: Scratch::default() }
    }

    /// As [`offset`].
    ///
    /// # Errors
    /// As [`offset`].
    pub fn offset(&self, source: &Polyarc, distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
        self.region(std::slice::from_ref(source), distance)
    }

    /// As [`offset_region`].
    ///
    /// # Errors
    /// As [`offset_region`].
    pub fn region(
        &self,
        contours: &[Polyarc],
        distance: f64,
    ) -> Result<Vec<OffsetPath>, GeomError> {
        checked_input(contours, distance)?;
        if distance.abs() <= tol::SAME_PLACE_MM {
            return Ok(contours.iter().enumerate().map(|(k, c)| unmoved(k, c)).collect());
        }
        let prepared = Prepared::new(contours, &self.scratch)?;
        let mut found = prepared.proved(distance, self.first)?;
        found.iter_mut().for_each(|path| prepared.restore(path));
        Ok(found)
    }
}

fn checked_input(contours: &[Polyarc], distance: f64) -> Result<(), GeomError> {
    if !distance.is_finite() || distance.abs() > tol::FARTHEST_MM {
        return Err(GeomError::OffsetTooFar);
    }
    contours.iter().try_for_each(Polyarc::check)
}

/// The same by the second engine alone, which [`offset_region`] asks when the first one fails: for those
/// who compare the two.
///
/// # Errors
/// As [`offset_region`].
pub fn offset_by_chords(contours: &[Polyarc], distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
    checked_input(contours, distance)?;
    let scratch = Scratch::default();
    let prepared = Prepared::new(contours, &scratch)?;
    let mut found = prepared.by_chords(distance)?;
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
    let ways: Vec<_> = segments.iter().map(elements::Ways::of).collect();
    raw::append(&Scratch::default(), 0, (&segments, &ways, source.closed), distance, &mut pieces);
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
