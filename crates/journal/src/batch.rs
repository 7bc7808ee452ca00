//! Changes of the record of a run that are made together.

use super::reached::Reached;
use std::collections::BTreeMap;

/// Changes of the record that are made together.
#[derive(Debug, Default)]
pub(super) struct Batch {
    /// Steps from this number on are no more; those below are newer.
    pub dropped_from: Option<i64>,
    /// Steps that the world told: number and text.
    pub steps: Vec<(i64, Vec<u8>)>,
    /// Files that steps speak of, by their hashes.
    pub contents: BTreeMap<String, Vec<u8>>,
    /// New values, by their keys; nothing removes one.
    pub values: BTreeMap<String, Option<String>>,
    /// The progress of the run; `None` where that is on record.
    pub reached: Option<Reached>,
}

impl Batch {
    /// Steps from a number on are no more.
    pub(super) fn drop_from(&mut self, from: i64) {
        self.steps.retain(|(number, _)| *number < from);
        self.dropped_from = Some(self.dropped_from.map_or(from, |before| before.min(from)));
    }

    /// Takes a later batch in.
    pub(super) fn join(&mut self, later: Self) {
        if let Some(from) = later.dropped_from {
            self.drop_from(from);
        }
        self.steps.extend(later.steps);
        self.contents.extend(later.contents);
        self.values.extend(later.values);
        self.reached = later.reached.or_else(|| self.reached.take());
    }

    /// Tells whether steps are added or dropped.
    pub(super) const fn changes_steps(&self) -> bool {
        !self.steps.is_empty() || self.dropped_from.is_some()
    }
}
