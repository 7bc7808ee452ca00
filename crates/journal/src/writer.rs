//! Writing of what a run has come to, and telling other programs of it.

use super::batch::Batch;
use super::reached::PROGRESS;
use super::rows::{Table, json};
use super::{JournalError, Live, Registry};

/// Writes batches into a journal, and tells other programs what they see.
#[derive(Debug)]
pub(super) struct Writer {
    pub registry: Registry,
    /// The status that other programs saw last.
    published: Option<Live>,
}

impl Writer {
    pub(super) const fn new(registry: Registry) -> Self {
        Self { registry, published: None }
    }

    /// Writes a batch; then other programs see it. What they wrote is taken over.
    pub(super) fn write(&mut self, batch: &Batch) -> Result<(), JournalError> {
        self.registry.store.write(|rows| {
            if let Some(from) = batch.dropped_from {
                rows.remove_from(Table::Step, from)?;
            }
            let (contents, steps) = (&batch.contents, &batch.steps);
            contents.iter().try_for_each(|(hash, bytes)| rows.keep_content(hash, bytes))?;
            let mut values = batch.values.iter();
            values.try_for_each(|(key, value)| rows.set(Table::Value, key, value.as_deref()))?;
            steps.iter().try_for_each(|(n, step)| rows.put(Table::Step, n, step))?;
            match &batch.reached {
                Some(reached) => rows.put(Table::Fact, PROGRESS, &json(reached)?),
                None => Ok(()),
            }
        })
    }

    /// Tells other programs what they see, and takes what they wrote.
    pub(super) fn meet_others(&mut self, batch: &Batch) -> Result<(), JournalError> {
        let Some(reached) = &batch.reached else { return Ok(()) };
        let live = reached.live();
        match self.published.replace(live) {
            Some(before) if before == live => {}
            _ => self.registry.publish(&live)?,
        }
        self.registry.take_in()
    }
}
