//! The snapshot that every page shows, and those who are told when it changes.

use crate::history::History;
use crate::last_runs::{LastRuns, now_s};
use crate::preview::Typed;
use crate::problems::ProblemLog;
use axum::extract::ws::Utf8Bytes;
use kerf_wire::{
    Change, CurrentRun, LastRun, Message, Mode, Motion, Opened, RunRecord, Snapshot, State, ToPage,
    Tone,
};
use std::io;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError, TryLockError};
use tokio::sync::broadcast;

/// Changes that a slow page may be behind before it gets a snapshot instead.
const BEHIND: usize = 256;

/// The snapshot and its readers.
#[derive(Debug)]
pub struct Hub {
    snapshot: Mutex<Arc<Snapshot>>,
    pages: broadcast::Sender<Arc<Broadcast>>,
    problems: OnceLock<ProblemLog>,
    /// Record of how files ran.
    pub ran: LastRuns,
    /// History of runs, and what is to be done.
    pub history: History,
    typed: Mutex<Typed>,
}

/// A message for every page. Its text is made once, by whoever sends it first, and never while others wait to change
/// something.
#[derive(Debug)]
pub struct Broadcast {
    message: ToPage,
    text: OnceLock<Utf8Bytes>,
}

impl Broadcast {
    /// The message.
    pub const fn message(&self) -> &ToPage {
        &self.message
    }

    /// The message as it goes over the socket.
    pub fn text(&self) -> Utf8Bytes {
        self.text.get_or_init(|| text(&self.message)).clone()
    }
}

impl Hub {
    /// Begins with a snapshot.
    pub fn new(snapshot: Snapshot) -> Self {
        Self {
            snapshot: Mutex::new(Arc::new(snapshot)),
            pages: broadcast::channel(BEHIND).0,
            problems: OnceLock::new(),
            ran: LastRuns::default(),
            history: History::default(),
            typed: Mutex::default(),
        }
    }

    /// Sets the log that keeps warnings and errors.
    pub fn keep(&self, problems: ProblemLog) {
        // There is one for a server.
        drop(self.problems.set(problems));
    }

    /// The snapshot, for reading; nobody changes anything meanwhile.
    pub fn read<T>(&self, read: impl FnOnce(&Snapshot) -> T) -> T {
        read(&self.lock())
    }

    /// The snapshot as it is now, for whoever takes longer over it.
    pub fn now(&self) -> Arc<Snapshot> {
        self.lock().clone()
    }

    /// State of the machine, as pages are told.
    pub fn state(&self) -> State {
        self.read(|now| now.machine.state)
    }

    /// Changes that are taken over and told, in one go.
    pub fn change(&self, changes: Vec<Change>) {
        self.changing(|_| changes);
    }

    /// Changes that follow from what is there: nobody else changes anything between.
    pub fn changing(&self, make: impl FnOnce(&Snapshot) -> Vec<Change>) {
        self.take_over(self.lock(), make);
    }

    /// The same, unless that would have to wait for somebody: then nothing is made.
    pub fn changing_if_free(&self, make: impl FnOnce(&Snapshot) -> Vec<Change>) {
        let free = match self.snapshot.try_lock() {
            Ok(snapshot) => Some(snapshot),
            Err(TryLockError::Poisoned(poisoned)) => Some(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => None,
        };
        if let Some(snapshot) = free {
            self.take_over(snapshot, make);
        }
    }

    fn take_over(
        &self,
        mut snapshot: MutexGuard<'_, Arc<Snapshot>>,
        make: impl FnOnce(&Snapshot) -> Vec<Change>,
    ) {
        let changes = make(&snapshot);
        if changes.is_empty() {
            return;
        }
        let present = Arc::make_mut(&mut snapshot);
        for change in &changes {
            present.apply(change.clone());
        }
        let told =
            Arc::new(Broadcast { message: ToPage::Changes { changes }, text: OnceLock::new() });
        // Nobody listening is no error.
        drop(self.pages.send(told.clone()));
        drop(snapshot);
        if let (Some(problems), ToPage::Changes { changes }) = (self.problems.get(), &told.message)
        {
            problems.note(changes);
        }
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

    /// Returns the path of what was typed, as it is drawn.
    pub fn typed(&self) -> MutexGuard<'_, Typed> {
        self.typed.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Clears the path of what was typed until now.
    pub fn draws_typed_anew(&self) {
        self.changing(|now| {
            let mut typed = self.typed();
            typed.clear();
            let begun = now.typed.segments > 0;
            begun.then(|| Change::Typed { typed: typed.summary() }).into_iter().collect()
        });
    }

    /// Another file is on the screen, or it runs: what was typed before is over, but for a preview, which draws all.
    pub fn moves_on(&self) {
        if self.read(|now| now.machine.mode != Mode::Preview) {
            self.draws_typed_anew();
        }
    }

    /// The last run of a file, also of one under the name that it had then; `hash` is that by which it runs under a name.
    pub fn last_run(&self, name: &str, hash: impl Fn(&str) -> String) -> Option<LastRun> {
        self.history.names_of(name).iter().find_map(|name| self.ran.of(&hash(name)))
    }

    /// A run is over: it is the last one of its file, and all of it is made where it came to its end. A file that was
    /// called by a typed line is known by now.
    pub fn ended(&self, job: CurrentRun) {
        let mut over = None;
        self.changing(|now| {
            let job = match now.job.clone().filter(|now| now.run == job.run) {
                Some(CurrentRun { hash, seconds, silent, .. }) => {
                    CurrentRun { hash, seconds, silent, ..job }
                }
                None => job,
            };
            let mut changes = Vec::new();
            if let (Some(hash), Some(ended)) = (&job.hash, &job.ended) {
                let Motion { line, elapsed: seconds, .. } = now.motion;
                let last = LastRun { ended: ended.clone(), at: now_s(), line, seconds };
                self.ran.put(hash, last.clone());
                let opened = now.opened.clone().filter(|opened| opened.hash == *hash);
                let file = opened.as_ref().map_or_else(|| job.file.clone(), |it| it.name.clone());
                over = Some(record(now, file, last.clone()));
                let ran = opened.map(|opened| Opened { ran: Some(last), ..opened });
                changes.extend(ran.map(|opened| Change::Opened { opened: Some(opened) }));
            }
            if job.ended.as_deref() == Some("ok") {
                let motion = Motion { progress: 1.0, remaining: 0.0, ..now.motion };
                changes.push(Change::Motion { motion });
            }
            changes.push(Change::Job { job: Some(job) });
            changes
        });
        self.writes_down(over.map_or(Ok(()), |over| self.history.ends(over)));
        if let Err(error) = self.ran.keep() {
            let text = format!("when files ran last is only known until Kerf ends: {error}");
            self.say(Tone::Warning, text);
        }
    }

    /// A file begins to run.
    pub fn begins(&self, job: &CurrentRun) {
        let run = self.read(|now| record(now, job.file.clone(), LastRun::default()));
        let run = RunRecord { begun: now_s(), ended: None, ..run };
        self.writes_down(self.history.begins(run));
    }

    /// Tells where the history of runs could not be written down.
    pub fn writes_down(&self, written: io::Result<()>) {
        if let Err(error) = written {
            let text = format!("the history of runs is only known until Kerf ends: {error}");
            self.say(Tone::Warning, text);
        }
    }

    /// A line for the message area.
    pub fn say(&self, tone: Tone, text: impl Into<String>) {
        self.tell(Message { tone, text: text.into(), ..Message::default() });
    }

    /// Adds a message to those that pages show.
    pub fn tell(&self, message: Message) {
        self.change(vec![Change::Messages { messages: vec![message] }]);
    }

    /// The snapshot and everything that changes after it.
    pub fn listen(&self) -> (Arc<Snapshot>, broadcast::Receiver<Arc<Broadcast>>) {
        let snapshot = self.lock();
        (snapshot.clone(), self.pages.subscribe())
    }

    fn lock(&self) -> MutexGuard<'_, Arc<Snapshot>> {
        self.snapshot.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The record of a run that is over.
fn record(
    now: &Snapshot,
    file: String,
    LastRun { ended, at, line, seconds }: LastRun,
) -> RunRecord {
    let by = now.lease.as_ref().map(|lease| lease.device.clone()).unwrap_or_default();
    RunRecord {
        file,
        begun: at.saturating_sub(seconds as u64),
        seconds,
        ended: Some(ended),
        line,
        by,
    }
}

/// A message as it goes over the socket.
pub fn text(message: &ToPage) -> Utf8Bytes {
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
        assert!(changes.try_recv().unwrap().text().contains("after"));
        assert!(changes.try_recv().is_err());
        assert_eq!(hub.read(|s| s.messages.len()), 2);
    }

    #[test]
    fn the_machine_waits_for_nobody_who_changes_something() {
        let hub = Hub::new(Snapshot::default());
        hub.changing(|_| {
            hub.changing_if_free(|_| unreachable!("somebody else changes something"));
            Vec::new()
        });
        let line = |_: &Snapshot| vec![Change::Printed { lines: vec!["told".into()] }];
        hub.changing_if_free(line);
        assert_eq!(hub.read(|s| s.printed.len()), 1);
    }
}
