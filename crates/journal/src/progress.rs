//! Progress of a run: written while it goes on, so that a kill at any instant loses at most the
//! motion in flight.

use super::batch::Batch;
use super::reached::Reached;
use super::scribe::{Hurry, Scribe};
use super::writer::Writer;
use super::{Registry, contents};
use std::time::{Duration, Instant};

/// Time between two writings where machine time is not the time of the world; a move takes a microsecond then and a
/// writing twenty.
pub(crate) const EVERY: Duration = Duration::from_millis(10);

/// Writes how far a run is.
#[derive(Debug)]
pub(crate) struct Progress {
    hand: Hand,
    /// The changes that are not written yet, nor posted.
    batch: Batch,
    /// Number of the next step. `None`: the run cannot be taken up, and the steps in the file are those of
    /// another that can.
    next_step: Option<i64>,
    written: Option<Reached>,
    last: Instant,
    /// Reason for which it cannot be written; the run goes on.
    trouble: Option<String>,
    /// The reason was told.
    told: bool,
}

/// The hand that writes.
#[derive(Debug)]
enum Hand {
    /// The thread that has something to write, before it goes on.
    Own(Writer),
    /// A thread; it may be behind.
    Scribe(Scribe),
}

impl Progress {
    /// Of a run whose next step has this number; of one that is not taken up, none.
    pub(super) fn new(registry: Registry, next_step: Option<i64>) -> Self {
        Self {
            hand: Hand::Own(Writer::new(registry)),
            batch: Batch::default(),
            next_step,
            written: None,
            last: Instant::now(),
            trouble: None,
            told: false,
        }
    }

    /// Hands writing to a thread: the machine's thread waits for no disk from now on.
    pub(super) fn writes_behind(&mut self, hurry: Option<Hurry>) {
        let Hand::Own(writer) = &self.hand else { return };
        match Scribe::begin(Writer::new(writer.registry.clone()), hurry) {
            Ok(scribe) => self.hand = Hand::Scribe(scribe),
            Err(error) => self.trouble = Some(format!("the thread that writes: {error}")),
        }
    }

    /// Adds something that the world told. It is in the file before what follows from it.
    pub(crate) fn add_step(&mut self, step: Vec<u8>) {
        if let Some(number) = &mut self.next_step {
            self.batch.steps.push((*number, step));
            *number += 1;
        }
    }

    /// The number of the last step.
    pub(crate) fn last_step(&self) -> Option<i64> {
        Some(self.next_step? - 1)
    }

    /// Forgets what the world told from a step on.
    pub(crate) fn drop_steps(&mut self, from: i64) {
        self.batch.drop_from(from);
        self.hand_over();
    }

    /// Forgets the last step: it is told again.
    pub(crate) fn take_back(&mut self) {
        if let Some(last) = self.last_step() {
            self.drop_steps(last);
            self.next_step = Some(last);
        }
    }

    /// Adds a file that a step speaks of; tells its name.
    pub(crate) fn add_content(&mut self, bytes: &[u8]) -> String {
        let hash = contents::hash(bytes);
        if self.next_step.is_some() {
            self.batch.contents.insert(hash.clone(), bytes.to_vec());
        }
        hash
    }

    /// Gives a key a value, where a thread writes it; tells whether one does.
    pub(crate) fn gives(&mut self, key: &str, value: Option<&str>) -> bool {
        let by_thread = matches!(self.hand, Hand::Scribe(_));
        if by_thread {
            self.batch.values.insert(key.to_owned(), value.map(str::to_owned));
            self.hand_over();
        }
        by_thread
    }

    /// Tells whether the value of a key is not on record yet.
    pub(crate) fn owes(&self, key: &str) -> bool {
        matches!(&self.hand, Hand::Scribe(scribe) if scribe.owes(key))
    }

    /// Writes, if it is time to.
    pub(crate) fn pass(&mut self, reached: &Reached) {
        if self.last.elapsed() >= EVERY {
            self.write(reached);
        }
    }

    /// Writes that the machine is about to move, unless the file says so already; it waits for the disk.
    pub(crate) fn set_off(&mut self, reached: &Reached) {
        if !self.written.as_ref().is_some_and(|written| written.moving) {
            self.write(reached);
            self.settle();
        }
    }

    /// Writes now, or lets the thread do it that writes.
    pub(crate) fn write(&mut self, reached: &Reached) {
        let same = self.written.as_ref() == Some(reached) && self.new_failure().is_none();
        if same && !self.batch.changes_steps() {
            return;
        }
        self.last = Instant::now();
        self.batch.reached = Some(reached.clone());
        if self.hand_over() {
            self.written = Some(reached.clone());
        }
    }

    /// Waits until everything is on record; no longer than until somebody wants the machine to stop.
    pub(crate) fn settle(&self) {
        if let Hand::Scribe(scribe) = &self.hand {
            scribe.settle();
        }
    }

    /// Hands over what there is; whether nothing of it is left to be handed over.
    fn hand_over(&mut self) -> bool {
        match &mut self.hand {
            Hand::Scribe(scribe) => {
                scribe.post(std::mem::take(&mut self.batch));
                true
            }
            Hand::Own(writer) => {
                if let Err(error) = writer.write(&self.batch) {
                    self.trouble = Some(error.to_string());
                    return false;
                }
                let batch = std::mem::take(&mut self.batch);
                self.trouble = writer.meet_others(&batch).err().map(|error| error.to_string());
                self.told &= self.trouble.is_some();
                true
            }
        }
    }

    /// The reason for which the batch handed over last is not on record.
    fn new_failure(&self) -> Option<String> {
        match &self.hand {
            Hand::Scribe(scribe) => scribe.trouble(),
            Hand::Own(_) => self.trouble.clone(),
        }
    }

    /// Returns why the file cannot be written, when that was not told yet.
    pub(crate) fn new_trouble(&mut self) -> Option<String> {
        if let Hand::Scribe(scribe) = &self.hand {
            self.trouble = scribe.trouble();
        }
        let before = std::mem::replace(&mut self.told, self.trouble.is_some());
        self.trouble.clone().filter(|_| !before)
    }
}
