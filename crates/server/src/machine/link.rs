//! What pages want of a machine that runs, from the threads that hear it to the one that drives.

use kerf_control::{Press, Wish};
use std::collections::VecDeque;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A jog that nobody renews ends after this time.
pub const DEAD_MAN: Duration = Duration::from_millis(250);

/// What pages want; whoever waits for it is woken.
#[derive(Debug, Default)]
pub struct Link {
    wanted: Mutex<Wanted>,
    changed: Condvar,
    /// Variables that are shown while programs run.
    watched: Mutex<Vec<String>>,
}

/// What pages want.
#[derive(Debug, Default)]
pub struct Wanted {
    /// Stop; stays until it was heard.
    pub stop: bool,
    /// Kerf ends: what runs is stopped, nobody answers any more, nothing else begins.
    pub leaves: bool,
    /// The run was told to stop, and ramps down.
    stopping: bool,
    /// Hold.
    pub hold: bool,
    /// Go on after a hold.
    pub resume: bool,
    /// A new feed override.
    pub feed: Option<f32>,
    /// The number of the question that is open: nobody has answered it yet, but for a jog.
    question: Option<u32>,
    /// Its answer.
    answer: Option<String>,
    /// The jog that is made.
    pub jog: Option<Held>,
    /// Switches that are moved.
    pub presses: VecDeque<Press>,
}

/// A key that is held.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    /// Its jog.
    pub seq: u32,
    /// Whose.
    pub client: u32,
    /// When it was last renewed.
    pub renewed: Instant,
    /// It was let go.
    pub released: bool,
    /// The run was told so, and ramps down.
    ending: bool,
}

impl Held {
    /// A key that was pressed just now.
    pub fn pressed(client: u32, seq: u32) -> Self {
        Self { seq, client, renewed: Instant::now(), released: false, ending: false }
    }

    /// Whether nobody holds the key any more.
    pub fn is_over(&self) -> bool {
        self.released || self.renewed.elapsed() > DEAD_MAN
    }
}

impl Wanted {
    /// What the run is to do now, told once. A jog ends at whatever is wanted.
    pub fn wish(&mut self) -> Option<Wish> {
        if let Some(held) = &mut self.jog {
            let over = held.is_over() || self.stop || self.hold;
            let told = std::mem::replace(&mut held.ending, over);
            return if over && !told { Some(Wish::End) } else { self.pressed() };
        }
        if self.stop && !std::mem::replace(&mut self.stopping, true) {
            return Some(Wish::Stop);
        }
        if std::mem::take(&mut self.hold) {
            return Some(Wish::Hold);
        }
        self.pressed().or_else(|| self.feed.take().map(Wish::Feed))
    }

    /// A question is open from now on; one that is asked again is the same.
    pub fn ask(&mut self, question: u32) {
        if self.question.replace(question) != Some(question) {
            self.answer = None;
        }
    }

    /// Answers a question. Whether that counts: it is open, and nobody was faster.
    pub fn give(&mut self, question: u32, words: String) -> bool {
        let counts = self.question == Some(question) && self.answer.is_none();
        if counts {
            self.answer = Some(words);
        }
        counts
    }

    /// The answer to the open question.
    pub const fn given(&mut self) -> Option<String> {
        self.answer.take()
    }

    /// Nobody can answer any more, nor move the tool meanwhile.
    pub fn close(&mut self) {
        (self.question, self.answer, self.jog) = (None, None, None);
    }

    /// A switch that is moved.
    fn pressed(&mut self) -> Option<Wish> {
        self.presses.pop_front().map(|Press { number, on }| Wish::Input { number, on })
    }

    /// Whether a stop is wanted; it is heard now.
    pub fn hear_stop(&mut self) -> bool {
        self.stopping = false;
        std::mem::take(&mut self.stop)
    }

    /// Whether whoever waits for somebody is to give up: a stop is wanted, and heard now, or nobody is there.
    pub fn gives_up(&mut self) -> bool {
        self.hear_stop() || self.leaves
    }
}

impl Link {
    /// What is wanted.
    pub fn lock(&self) -> MutexGuard<'_, Wanted> {
        self.wanted.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Wants something.
    pub fn want<T>(&self, change: impl FnOnce(&mut Wanted) -> T) -> T {
        let result = change(&mut self.lock());
        self.changed.notify_all();
        result
    }

    /// Variables that are shown while programs run.
    pub fn watched(&self) -> Vec<String> {
        self.watched.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Shows other variables from now on.
    pub fn watch(&self, names: Vec<String>) {
        *self.watched.lock().unwrap_or_else(PoisonError::into_inner) = names;
    }

    /// Waits until something is wanted, or a time has passed.
    pub fn wait<'a>(
        &self,
        wanted: MutexGuard<'a, Wanted>,
        most: Duration,
    ) -> MutexGuard<'a, Wanted> {
        let waited = self.changed.wait_timeout(wanted, most);
        waited.map_or_else(|poisoned| poisoned.into_inner().0, |(wanted, _)| wanted)
    }

    /// A run begins, for as long as a key is held where it is a jog: what was wanted of the one before is forgotten.
    pub fn begin(&self, jog: Option<Held>) {
        let mut wanted = self.lock();
        let leaves = wanted.leaves;
        *wanted = Wanted { jog, leaves, stop: leaves, ..Wanted::default() };
    }

    /// The page of a jog has gone, or released the key.
    pub fn release(&self, is_it: impl Fn(&Held) -> bool) {
        self.want(|wanted| {
            if let Some(held) = wanted.jog.as_mut().filter(|held| is_it(held)) {
                held.released = true;
            }
        });
    }
}
