//! From contours as they come to an offset that passed its check, by one engine or the other.

use super::path::{CHECK_MM, OffsetPath, Proposer};
use super::scratch::{Buffer, Scratch};
use super::source::Source;
use super::{buried, chords, raw, rings, slices, validate};
use crate::{Bounds2, BoxTree, GeomError, Point2, Polyarc, Transform2};

/// The contours moved to the origin, without empty segments and long arcs.
pub(super) struct Prepared<'s> {
    scratch: &'s Scratch,
    contours: Vec<Polyarc>,
    /// For each segment of all prepared contours the segment it was.
    were: Buffer<'s, usize>,
    /// Place in `were` at which the segments of each contour begin.
    first: Buffer<'s, usize>,
    middle: Point2,
}

impl Drop for Prepared<'_> {
    fn drop(&mut self) {
        self.contours.drain(..).for_each(|contour| self.scratch.give(contour.vertices));
    }
}

impl<'s> Prepared<'s> {
    pub fn new(contours: &[Polyarc], scratch: &'s Scratch) -> Result<Self, GeomError> {
        let mut bounds = Bounds2::default();
        contours.iter().flat_map(|c| &c.vertices).for_each(|v| bounds.add(v.at));
        let middle = if bounds.is_empty() { Point2::default() } else { bounds.centre() };
        let to_origin = Point2::default() - middle;
        let (were, first) = (Buffer::new(scratch), Buffer::new(scratch));
        let list = Vec::with_capacity(contours.len());
        let mut prepared = Self { scratch, contours: list, were, first, middle };
        for contour in contours {
            prepared.first.push(prepared.were.len());
            let mut ready = contour.tidied_with_names(scratch.take(), &mut prepared.were);
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
    pub fn proved(
        &self,
        distance: f64,
        first: Option<&Proposer>,
    ) -> Result<Vec<OffsetPath>, GeomError> {
        let source = Source::new(&self.contours, self.scratch);
        let tangle = GeomError::Unproved { why: "a tangle of crossings", at: Point2::default() };
        let checked = |found: Vec<OffsetPath>| {
            validate::validate(&source, distance, &found, CHECK_MM).map(|()| found)
        };
        let proposed = match first {
            Some(propose) => propose(&self.contours, distance),
            None => attempt(&source, distance),
        };
        let proposed = proposed.ok_or(tangle).and_then(checked);
        let Err(why) = proposed else { return proposed };
        self.crossing().map_or(Ok(()), Err)?;
        let again = SECOND_ATTEMPTS.iter().filter(|_| first.is_none());
        for &(turn_rad, longer) in again {
            let found = self.attempt_turned(distance + longer, turn_rad);
            if let Some(Ok(found)) = found.map(checked) {
                return Ok(found);
            }
        }
        by_chords(&source, distance).ok_or_else(|| self.error_at_source(why))
    }

    /// The offset by the second engine alone.
    pub fn by_chords(&self, distance: f64) -> Result<Vec<OffsetPath>, GeomError> {
        let why = GeomError::Unproved { why: "contours that bound no region", at: self.middle };
        by_chords(&Source::new(&self.contours, self.scratch), distance).ok_or(why)
    }

    /// The offset of the turned contours, turned back.
    fn attempt_turned(&self, distance: f64, turn_rad: f64) -> Option<Vec<OffsetPath>> {
        let turn = Transform2::turned(Point2::default(), turn_rad);
        let back = Transform2::turned(Point2::default(), -turn_rad);
        let turned: Vec<Polyarc> = self.contours.iter().map(|c| c.similar(&turn)).collect();
        let mut found = attempt(&Source::new(&turned, self.scratch), distance)?;
        found.iter_mut().for_each(|offset| offset.path = offset.path.similar(&back));
        Some(found)
    }

    /// Finds a contour that crosses itself or another, if there is one: what has no inside has no offset.
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
    pub fn restore(&self, offset: &mut OffsetPath) {
        let back = self.middle - Point2::default();
        offset.path.vertices.iter_mut().for_each(|v| v.at += back);
        for origin in &mut offset.origins {
            origin.element = self.were[self.first[origin.contour] + origin.element];
        }
    }
}

/// Attempts after the first one fails its check: the shape turned by some angle, which makes other
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
    let scratch = source.scratch;
    let mut pieces = Buffer::new(scratch);
    for (number, contour) in source.contours.iter().enumerate() {
        let (segments, ways) = source.of_contour(number);
        raw::append(scratch, number, (segments, ways, contour.closed), distance, &mut pieces);
    }
    let mut tree = slices::index(scratch, &pieces);
    if buried::is_crowded(&tree) {
        buried::drop_buried(&mut pieces, source, distance);
        tree = slices::index(scratch, &pieces);
    }
    let caps = raw::caps(source.contours, distance);
    let slices = slices::valid_slices(&pieces, &tree, &caps, source, distance);
    scratch.give(tree.into_list());
    let slices = slices?;
    Some(rings::rings(source, distance, &pieces, &slices))
}
