//! Terms of the check of an offset.

use super::source::Source;
use crate::{GeomError, Point2};

/// A place is wrongly missing only if there is so many times the tolerance of room beyond it. A slot exactly
/// as wide as the tool has no room: its offset may come or go.
const ROOM: f64 = 10.0;

pub(super) type Checked = Result<(), GeomError>;

/// Terms of a check: the source, the distance, the tolerance.
#[derive(Clone, Copy)]
pub(super) struct Wanted<'a> {
    pub source: &'a Source<'a>,
    pub distance: f64,
    pub within: f64,
}

impl Wanted<'_> {
    /// So much room tells that something is missing.
    pub fn room(&self) -> f64 {
        ROOM * self.within
    }
}

pub(super) fn unproved(why: &'static str, at: Point2) -> Checked {
    Err(GeomError::Unproved { why, at })
}
