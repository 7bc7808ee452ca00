//! The definition of an offset, checked on a result. Nothing here knows how the result was made.
//!
//! - *At its distance, on its side*: each segment says what it is parallel to; that is held against the
//!   source ([`super::aside`]).
//! - *Nowhere nearer*: each segment is held against all of the source that is near ([`super::clearance`]). Two
//!   strands that cross would each come too near to the other's source just behind the crossing, so rings that
//!   pass are simple.
//! - *Complete*: the parallel of each source segment and the arc of each corner is walked; where it has
//!   room on its far side it must belong to the result ([`super::complete`]).

use super::aside::follows_origin;
use super::clearance::too_near;
use super::complete::{Coverage, complete};
use super::path::OffsetPath;
use super::scratch::Buffer;
use super::source::Source;
use super::wanted::{Checked, Wanted, unproved};
use crate::{Polyarc, Segment};

/// Checks that `found` is the offset of the source within a tolerance, usually [`CHECK_MM`](super::CHECK_MM).
pub(super) fn validate(
    source: &Source,
    distance: f64,
    found: &[OffsetPath],
    within: f64,
) -> Checked {
    let wanted = Wanted { source, distance, within };
    let mut segments: Buffer<Segment> = Buffer::new(source.scratch);
    found.iter().for_each(|f| segments.extend(f.path.segments()));
    if let Some(odd) = found.iter().find(|f| f.origins.len() != f.path.segment_count()) {
        return unproved("a piece without extent", odd.path.start().unwrap_or_default());
    }
    let origins = found.iter().flat_map(|f| &f.origins);
    for (segment, origin) in segments.iter().zip(origins) {
        let known = |contour: &Polyarc| origin.element < contour.segment_count();
        if !source.contours.get(origin.contour).is_some_and(known) {
            return unproved("parallel to nothing", segment.start());
        }
        follows_origin(&wanted, segment, origin)?;
    }
    if let Some(at) = too_near(source, distance, within, &segments) {
        return unproved("nearer to another part of the source", at);
    }
    complete(&wanted, &Coverage::new(&wanted, found, segments))
}
