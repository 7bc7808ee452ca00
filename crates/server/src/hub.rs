//! What every page shows, and who is told when it changes.

use crate::problems::ProblemLog;
use crate::ran::{Ran, now_s};
use kerf_wire::{Change, Job, LastRun, Message, Opened, Snapshot, ToPage, Tone};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use tokio::sync::broadcast;

/// Changes that a slow page may be behind before it gets a snapshot instead.
const BEHIND: usize = 1024;

/// The snapshot and its readers.
#[derive(Debug)]
pub struct Hub {
    snapshot: Mutex<Snapshot>,
    pages: broadcast::Sender<Arc<str>>,
    problems: OnceLock<ProblemLog>,
    /// How files ran.
    pub ran: Ran,
}

impl Hub {
    /// Begins with a snapshot.
    pub fn new(snapshot: Snapshot) -> Self {
        Self {
            snapshot: Mutex::new(snapshot),
            pages: broadcast::channel(BEHIND).0,
            problems: OnceLock::new(),
            ran: Ran::default(),
        }
    }

    /// From now on warnings and errors are on record.
    pub fn keep(&self, problems: ProblemLog) {
        // There is one for a server.
        drop(self.problems.set(problems));
    }

    /// The snapshot, for reading.
    pub fn read<T>(&self, read: impl FnOnce(&Snapshot) -> T) -> T {
        read(&self.lock())
    }

    /// Changes that are taken over and told, in one go.
    pub fn change(&self, changes: Vec<Change>) {
        self.changing(|_| changes);
    }

    /// Changes that follow from what is there: nobody else changes anything between.
    pub fn changing(&self, make: impl FnOnce(&Snapshot) -> Vec<Change>) {
        let mut snapshot = self.lock();
        let changes = make(&snapshot);
        if changes.is_empty() {
            return;
        }
        for change in &changes {
            snapshot.apply(change.clone());
        }
        self.problems.get().into_iter().for_each(|problems| problems.note(&changes));
        // Nobody listening is no error.
        drop(self.pages.send(text(&ToPage::Changes { changes })));
    }

    /// The picture of the open file is empty from now on, or is drawn again.
    pub fn cleared(&self, cleared: bool) {
        self.changing(|now| match &now.opened {
            Some(opened) if opened.cleared != cleared => {
                let opened = Some(Opened { cleared, ..opened.clone() });
                vec![Change::Opened { opened }]
            }
            _ => Vec::new(),
        });
    }

    /// A run is over: it is the last one of its file.
    pub fn ended(&self, job: Job) {
        self.changing(|now| {
            let mut changes = Vec::new();
            if let (Some(hash), Some(ended)) = (&job.hash, &job.ended) {
                let line = now.motion.line;
                let last = LastRun { ended: ended.clone(), at: now_s(), line };
                self.ran.put(hash, last.clone());
                let opened = now.opened.clone().filter(|opened| opened.hash == *hash);
                let ran = opened.map(|opened| Opened { ran: Some(last), ..opened });
                changes.extend(ran.map(|opened| Change::Opened { opened: Some(opened) }));
            }
            changes.push(Change::Job { job: Some(job) });
            changes
        });
    }

    /// A line for the message area.
    pub fn say(&self, tone: Tone, text: impl Into<String>) {
        let message = Message { tone, text: text.into(), run: 0 };
        self.change(vec![Change::Messages { messages: vec![message] }]);
    }

    /// The snapshot and everything that changes after it.
    pub fn listen(&self) -> (Snapshot, broadcast::Receiver<Arc<str>>) {
        let snapshot = self.lock();
        (snapshot.clone(), self.pages.subscribe())
    }

    fn lock(&self) -> MutexGuard<'_, Snapshot> {
        self.snapshot.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A message as it goes over the socket.
pub fn text(message: &ToPage) -> Arc<str> {
    serde_json::to_string(message).unwrap_or_default().into()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_page_gets_what_changes_behind_its_snapshot() {
        let hub = Hub::new(Snapshot::default());
        hub.say(Tone::Note, "before");
        let (snapshot, mut changes) = hub.listen();
        hub.say(Tone::Note, "after");
        assert_eq!(snapshot.messages.len(), 1);
        assert!(changes.try_recv().unwrap().contains("after"));
        assert!(changes.try_recv().is_err());
        assert_eq!(hub.read(|s| s.messages.len()), 2);
    }
}
