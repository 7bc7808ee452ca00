//! The contours that are offset, and how far places are from them.

use super::elements::{Range2, Ways};
use super::scratch::{Buffer, Scratch};
use crate::segment::square;
use crate::{Bounds2, Indexed, Point2, Polyarc, Segment};
use std::cell::Cell;

/// All segments of all contours with an index.
pub(super) struct Source<'a> {
    pub contours: &'a [Polyarc],
    /// Number of the first segment of each contour.
    pub first: Buffer<'a, usize>,
    /// Store of the lists that later steps fill.
    pub scratch: &'a Scratch,
    indexed: Indexed,
    ways: Buffer<'a, Ways>,
    /// Number of times the contours wind round what lies to the left of one of them: the one that was asked last, as
    /// questions come in the order of contours.
    left_of: Cell<Option<(usize, Option<i32>)>>,
}

impl Drop for Source<'_> {
    fn drop(&mut self) {
        let (segments, boxes) = std::mem::take(&mut self.indexed).into_lists();
        self.scratch.give(segments);
        self.scratch.give(boxes);
    }
}

impl<'a> Source<'a> {
    pub fn new(contours: &'a [Polyarc], scratch: &'a Scratch) -> Self {
        let mut first = Buffer::new(scratch);
        let mut count = 0;
        for contour in contours {
            first.push(count);
            count += contour.segment_count();
        }
        let indexed = Indexed::in_lists((scratch.take(), scratch.take()), contours);
        let ways = Buffer::of(scratch, indexed.segments().iter().map(Ways::of));
        Self { contours, first, scratch, indexed, ways, left_of: Cell::new(None) }
    }

    /// The segments of all contours, numbered through.
    pub fn segments(&self) -> &[Segment] {
        self.indexed.segments()
    }

    /// Those of one contour.
    pub fn of_contour(&self, number: usize) -> (&[Segment], &[Ways]) {
        let end = self.first.get(number + 1).copied().unwrap_or(self.segments().len());
        let own = self.first[number]..end;
        (&self.segments()[own.clone()], &self.ways[own])
    }

    /// The directions of all segments.
    pub fn ways(&self) -> &[Ways] {
        &self.ways
    }

    /// Runs of numbers of segments that may lie nearer than `limit` to something within bounds.
    pub fn runs_near(&self, bounds: &Bounds2, limit: f64, found: &mut Vec<Range2>) {
        let (middle, half) = (bounds.centre(), square(bounds.size()).sqrt() * 0.5);
        let (area, reach) = (bounds.grown(limit), (limit + half) * (limit + half));
        let enter = |b: &Bounds2| b.meets(&area) && b.distance_squared(middle) < reach;
        self.indexed.tree().search_runs(enter, |run| match found.last_mut() {
            Some(last) if last.1 == run.start => last.1 = run.end,
            _ => found.push((run.start, run.end)),
        });
    }

    /// Returns `true` if there are so few segments that all of them are looked at, wherever something is asked.
    pub fn is_small(&self) -> bool {
        self.indexed.tree().is_small()
    }

    /// The boxes of all segments.
    pub fn boxes(&self) -> &[Bounds2] {
        self.indexed.tree().leaves()
    }

    /// Counts how often the contours wind round a place.
    pub fn winding(&self, place: Point2) -> i32 {
        self.indexed.winding(place)
    }

    /// Counts how often they wind round places beside a segment, on the side of an offset; nothing where some of them
    /// are open. To the left of a contour it is once more than to its right.
    pub fn winding_beside(&self, segment: usize, distance: f64) -> Option<i32> {
        if self.contours.iter().any(|c| !c.closed) {
            return None;
        }
        let own = self.first.partition_point(|first| *first <= segment).checked_sub(1)?;
        let left = match self.left_of.get() {
            Some((asked, left)) if asked == own => left,
            _ => self.winding_left_of(own),
        };
        self.left_of.set(Some((own, left)));
        Some(left? - i32::from(distance > 0.0))
    }

    fn winding_left_of(&self, own: usize) -> Option<i32> {
        let (contour, place) = (&self.contours[own], self.contours[own].start()?);
        let others =
            self.contours.iter().enumerate().filter(|(n, c)| *n != own && c.bounds().holds(place));
        let around: i32 = others.map(|(_, other)| other.winding(place)).sum();
        Some(around + i32::from(contour.signed_area() > 0.0))
    }

    /// Tells whether a segment or one beside it lies nearer to a place than `limit`.
    pub fn neighbours_nearer(&self, segment: usize, place: Point2, limit: f64) -> bool {
        let neighbours = segment.saturating_sub(1)..(segment + 2).min(self.segments().len());
        self.segments()[neighbours].iter().any(|s| s.is_nearer(place, limit))
    }

    /// Tells whether some segment lies nearer to a place than `limit`.
    pub fn is_nearer(&self, place: Point2, limit: f64) -> bool {
        self.indexed.is_nearer(place, limit)
    }
}
