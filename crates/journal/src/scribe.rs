//! The thread that writes how far a run is: the machine's own thread never waits for a disk while something moves.
//!
//! ```text
//!  machine's thread ── post ──► Slate (one batch: what is newer joins what is not written yet) ──► Scribe ──► journal
//!         └────────── settle ◄── all is written, or tried in vain, or somebody wants the machine to stop
//! ```

use super::JournalError;
use super::batch::Batch;
use super::writer::Writer;
use std::collections::BTreeSet;
use std::fmt;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// A wait for the disk asks this often whether the machine is to stop.
const LOOK: Duration = Duration::from_millis(2);

/// Tells, from any thread, whether somebody wants the machine to stop and was not heard yet.
#[derive(Clone)]
pub struct Hurry(Arc<dyn Fn() -> bool + Send + Sync>);

impl Hurry {
    /// One that asks this.
    pub fn new(stops: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Arc::new(stops))
    }
}

impl fmt::Debug for Hurry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Hurry").finish_non_exhaustive()
    }
}

/// The batch that is written next.
#[derive(Debug, Default)]
struct Slate {
    next: Option<Batch>,
    /// A batch is being written.
    writes: bool,
    /// Keys whose values are not on record yet.
    owes: BTreeSet<String>,
    /// The reason for which the last one is not on record.
    trouble: Option<JournalError>,
    /// The last batch was handed over.
    ends: bool,
}

/// A thread that writes what is posted. Dropped, it writes what is left.
#[derive(Debug)]
pub(super) struct Scribe {
    slate: Arc<(Mutex<Slate>, Condvar)>,
    hurry: Option<Hurry>,
    thread: Option<JoinHandle<()>>,
}

impl Scribe {
    pub(super) fn begin(mut writer: Writer, hurry: Option<Hurry>) -> std::io::Result<Self> {
        let slate = Arc::<(Mutex<Slate>, Condvar)>::default();
        let its = slate.clone();
        let writes = move || while_posted(&its, &mut writer);
        let thread = thread::Builder::new().name("scribe".into()).spawn(writes)?;
        Ok(Self { slate, hurry, thread: Some(thread) })
    }

    /// Puts down what is to be on record soon.
    pub(super) fn post(&self, batch: Batch) {
        let mut slate = lock(&self.slate.0);
        slate.owes.extend(batch.values.keys().cloned());
        match &mut slate.next {
            Some(next) => next.join(batch),
            none => *none = Some(batch),
        }
        drop(slate);
        self.slate.1.notify_all();
    }

    /// Waits until everything was written, or tried in vain; no longer than until the machine is to stop.
    pub(super) fn settle(&self) {
        let mut slate = lock(&self.slate.0);
        while slate.next.is_some() || slate.writes {
            if self.hurry.as_ref().is_some_and(|hurry| hurry.0()) {
                return;
            }
            slate =
                self.slate.1.wait_timeout(slate, LOOK).unwrap_or_else(PoisonError::into_inner).0;
        }
    }

    /// Tells whether the value of a key is not on record yet.
    pub(super) fn owes(&self, key: &str) -> bool {
        lock(&self.slate.0).owes.contains(key)
    }

    /// The reason for which the last batch is not on record, or was not told to other programs.
    pub(super) fn trouble(&self) -> Option<String> {
        lock(&self.slate.0).trouble.as_ref().map(ToString::to_string)
    }
}

impl Drop for Scribe {
    fn drop(&mut self) {
        lock(&self.slate.0).ends = true;
        self.slate.1.notify_all();
        drop(self.thread.take().map(JoinHandle::join));
    }
}

/// Writes until nothing more comes. What could not be written is tried again with what comes next.
fn while_posted((slate, woken): &(Mutex<Slate>, Condvar), writer: &mut Writer) {
    let mut failed: Option<Batch> = None;
    loop {
        let mut at = lock(slate);
        while at.next.is_none() && !at.ends {
            at = woken.wait(at).unwrap_or_else(PoisonError::into_inner);
        }
        let Some(next) = at.next.take() else { return };
        at.writes = true;
        drop(at);
        let batch = match failed.take() {
            Some(mut batch) => {
                batch.join(next);
                batch
            }
            None => next,
        };
        let written = writer.write(&batch);
        let met = written.is_ok().then(|| writer.meet_others(&batch));
        let mut at = lock(slate);
        at.writes = false;
        if written.is_ok() && at.next.is_none() {
            at.owes.clear();
        }
        at.trouble = match (written, met) {
            (Err(error), _) => {
                failed = Some(batch);
                Some(error)
            }
            (Ok(()), met) => met.and_then(Result::err),
        };
        drop(at);
        woken.notify_all();
    }
}

fn lock(slate: &Mutex<Slate>) -> MutexGuard<'_, Slate> {
    slate.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::Journal;
    use crate::reached::{PROGRESS, Reached};
    use crate::rows::Table;
    use std::sync::atomic::{AtomicBool, Ordering};

    fn step(number: i64, text: &str) -> (i64, Vec<u8>) {
        (number, format!("\"{text}\"").into_bytes())
    }

    fn made(moves: u64, steps: Vec<(i64, Vec<u8>)>) -> Batch {
        let reached = Some(Reached { made: moves, ..Reached::default() });
        Batch { reached, steps, ..Batch::default() }
    }

    fn steps(journal: &Journal) -> Vec<String> {
        let all = journal.store.read(|rows| rows.all(Table::Step)).unwrap();
        all.into_iter().map(|(_, text)| text).collect()
    }

    /// A database that is held stands for a disk that does not answer.
    #[test]
    fn nobody_waits_for_a_disk_while_the_machine_is_to_stop() {
        let folder = tempfile::tempdir().unwrap();
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let stops = Arc::new(AtomicBool::new(true));
        let its = stops.clone();
        let hurry = Hurry::new(move || its.load(Ordering::Relaxed));
        let scribe = Scribe::begin(Writer::new(journal.registry.clone()), Some(hurry)).unwrap();
        let disk = journal.store.opened();
        scribe.post(made(1, vec![step(1, "a"), step(2, "b")]));
        scribe.post(Batch { dropped_from: Some(2), ..Batch::default() });
        scribe.post(made(2, vec![step(2, "c"), step(3, "d")]));
        scribe.settle();
        drop(disk);
        stops.store(false, Ordering::Relaxed);
        scribe.settle();
        assert_eq!(scribe.trouble(), None);
        assert_eq!(steps(&journal), ["\"a\"", "\"c\"", "\"d\""]);
    }

    #[test]
    fn what_is_posted_last_is_written_before_the_end() {
        let folder = tempfile::tempdir().unwrap();
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let scribe = Scribe::begin(Writer::new(journal.registry.clone()), None).unwrap();
        (1..=50).for_each(|n| scribe.post(made(n as u64, vec![step(n, "x")])));
        drop(scribe);
        let text = journal.store.read(|rows| rows.text(Table::Fact, PROGRESS)).unwrap().unwrap();
        let reached: Reached = serde_json::from_str(&text).unwrap();
        assert_eq!((reached.made, steps(&journal).len()), (50, 50));
    }

    #[test]
    fn what_the_disk_refused_is_written_with_what_comes_next() {
        let folder = tempfile::tempdir().unwrap();
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let scribe = Scribe::begin(Writer::new(journal.registry.clone()), None).unwrap();
        let query_only = |on| {
            journal.store.opened().connection.pragma_update(None, "query_only", on).unwrap();
        };
        query_only(true);
        scribe.post(made(1, vec![step(1, "a")]));
        scribe.settle();
        assert!(scribe.trouble().is_some());
        query_only(false);
        scribe.post(made(2, vec![step(2, "b")]));
        // The trouble before is none of this wait.
        scribe.settle();
        assert_eq!(scribe.trouble(), None);
        assert_eq!(steps(&journal), ["\"a\"", "\"b\""]);
    }
}
