//! How far a run is: written while it goes on, so that a kill at any instant loses at most the
//! motion in flight.

use super::rows::Table;
use super::{Journal, JournalError, Live, Placed, json, mirror};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Name of the fact.
pub(super) const PROGRESS: &str = "progress";

/// Where machine time is not the time of the world, so much of the latter passes between two
/// writings; a move takes a microsecond then and a writing twenty.
pub(crate) const EVERY: Duration = Duration::from_millis(10);

/// How far a run is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Reached {
    /// Moves made since it began.
    pub made: u64,
    /// How much of the move behind those is made, 0 … 1.
    #[serde(default)]
    pub within: f64,
    /// The operator stopped it there and gave it up.
    #[serde(default)]
    pub stopped: bool,
    /// The machine moves: it is near `place`.
    pub moving: bool,
    /// Where it was last.
    pub place: Placed,
    /// What other programs see, but for the machine's motion.
    #[serde(default)]
    pub live: Live,
    /// The part file of the last move.
    pub file: String,
    /// Its line.
    pub line: u32,
}

/// Writes how far a run is.
#[derive(Debug)]
pub(crate) struct Progress {
    journal: Journal,
    /// What the world told and is not in the file yet: number and text.
    steps: Vec<(i64, Vec<u8>)>,
    /// Files that steps speak of, by their hashes.
    contents: BTreeMap<String, Vec<u8>>,
    /// Number of the next one. `None`: the run cannot be taken up, and the steps in the file are those of
    /// another that can.
    next_step: Option<i64>,
    written: Option<Reached>,
    /// What other programs saw last.
    published: Option<Live>,
    last: Instant,
    /// Why it cannot be written; the run goes on.
    trouble: Option<JournalError>,
    /// That was told.
    told: bool,
}

impl Progress {
    /// Of a run whose next step has this number; of one that is not taken up, none.
    pub(super) fn new(journal: Journal, next_step: Option<i64>) -> Self {
        Self {
            journal,
            steps: Vec::new(),
            contents: BTreeMap::new(),
            next_step,
            written: None,
            published: None,
            last: Instant::now(),
            trouble: None,
            told: false,
        }
    }

    /// Adds something that the world told. It is in the file before what follows from it.
    pub(crate) fn add_step(&mut self, step: Vec<u8>) {
        if let Some(number) = &mut self.next_step {
            self.steps.push((*number, step));
            *number += 1;
        }
    }

    /// The number of the last step.
    pub(crate) fn last_step(&self) -> Option<i64> {
        Some(self.next_step? - 1)
    }

    /// Forgets what the world told from a step on.
    pub(crate) fn drop_steps(&mut self, from: i64) {
        self.steps.retain(|(number, _)| *number < from);
        let dropped = self.journal.write(|rows| rows.remove_from(Table::Step, from));
        self.trouble = dropped.err().or_else(|| self.trouble.take());
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
        let hash = super::contents::hash(bytes);
        if self.next_step.is_some() {
            self.contents.insert(hash.clone(), bytes.to_vec());
        }
        hash
    }

    /// Writes, if it is time to.
    pub(crate) fn pass(&mut self, reached: &Reached) {
        if self.last.elapsed() >= EVERY {
            self.write(reached);
        }
    }

    /// Writes that the machine is about to move, unless the file says so already.
    pub(crate) fn set_off(&mut self, reached: &Reached) {
        if !self.written.as_ref().is_some_and(|written| written.moving) {
            self.write(reached);
        }
    }

    /// Writes now.
    pub(crate) fn write(&mut self, reached: &Reached) {
        if self.steps.is_empty() && self.written.as_ref() == Some(reached) {
            return;
        }
        self.last = Instant::now();
        let (steps, contents) = (&self.steps, &self.contents);
        let written = self.journal.write(|rows| {
            contents.iter().try_for_each(|(hash, bytes)| rows.keep_content(hash, bytes))?;
            steps.iter().try_for_each(|(n, step)| rows.put(Table::Step, n, step))?;
            rows.put(Table::Fact, PROGRESS, &json(reached)?)
        });
        match written {
            Ok(()) => {
                self.steps.clear();
                self.contents.clear();
                self.written = Some(reached.clone());
                (self.trouble, self.told) = (None, false);
                self.meet_others(reached.live());
            }
            Err(error) => self.trouble = Some(error),
        }
    }

    /// Tells other programs what they see, and takes what they wrote.
    fn meet_others(&mut self, live: Live) {
        let told = match self.published.replace(live) {
            Some(before) if before == live => Ok(()),
            _ => mirror::publish(&self.journal, &live),
        };
        self.trouble = told.and_then(|()| self.journal.take_in()).err();
    }

    /// Why the file cannot be written, when that was not told yet.
    pub(crate) fn new_trouble(&mut self) -> Option<String> {
        let trouble = self.trouble.as_ref().filter(|_| !self.told)?.to_string();
        self.told = true;
        Some(trouble)
    }
}
