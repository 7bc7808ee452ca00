//! Long work that somebody waits for: it ends soon after nobody does.
//!
//! ```text
//!  act arrives ── Works::begin ── works, and asks now and then ── Awaited::is_given_up? ── ends with a reason
//!                                                                        ▲
//!        the page has gone, asks for the same again, presses Give up ────┘
//! ```

use crate::locks::lock;
use crate::refusal::problem;
use kerf_wire::{Act, Op, Problem, Why};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, Weak};

/// A piece of work that somebody waits for.
#[derive(Clone, Debug, Default)]
pub struct Awaited(Arc<AtomicBool>);

/// Gives a piece of work up when it is dropped: with the request that waits for it.
#[derive(Debug)]
pub struct WhileAsked(Awaited);

impl Awaited {
    /// Returns `true` once nobody waits for the outcome.
    pub fn is_given_up(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Marks the work as given up.
    pub fn give_up(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Goes on for as long as what is given here is held.
    pub fn while_asked(&self) -> WhileAsked {
        WhileAsked(self.clone())
    }

    /// Goes on only while somebody waits.
    ///
    /// # Errors
    /// Nobody does.
    pub fn goes_on(&self) -> Result<(), Problem> {
        let text = "this was given up before it was done: nothing was changed; ask for it again";
        if self.is_given_up() { Err(problem(Why::State, text)) } else { Ok(()) }
    }
}

impl Drop for WhileAsked {
    fn drop(&mut self) {
        self.0.give_up();
    }
}

/// Sorts of work of which a page wants one at a time: the newest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// Tool paths are made of a drawing.
    Paths,
    /// A drawing is read to be opened.
    Reading,
}

impl Sort {
    /// The sort of an act that is such work.
    pub const fn of(act: &Act) -> Option<Self> {
        match act {
            Act::Machine { .. } => Some(Self::Paths),
            Act::Draw { op: Op::Open { .. } } => Some(Self::Reading),
            _ => None,
        }
    }
}

/// Work that pages and scripts wait for.
#[derive(Debug, Default)]
pub struct Works(Mutex<Vec<Work>>);

#[derive(Debug)]
struct Work {
    /// The page or script, by its number.
    client: u32,
    sort: Option<Sort>,
    /// Gone when it is done.
    awaited: Weak<AtomicBool>,
}

impl Works {
    /// Begins what a page asks for; what it asked for before of the same sort is given up.
    pub fn begin(&self, client: u32, act: &Act) -> Awaited {
        let (awaited, sort) = (Awaited::default(), Sort::of(act));
        let mut all = lock(&self.0);
        all.retain(|work| work.awaited.strong_count() > 0);
        if sort.is_some() {
            give_up(&all, |work| work.client == client && work.sort == sort);
        }
        all.push(Work { client, sort, awaited: Arc::downgrade(&awaited.0) });
        awaited
    }

    /// A page waits for nothing any more.
    pub fn give_up(&self, client: u32) {
        give_up(&lock(&self.0), |work| work.client == client);
    }
}

fn give_up(works: &[Work], which: impl Fn(&&Work) -> bool) {
    let awaited = works.iter().filter(which).filter_map(|work| work.awaited.upgrade());
    awaited.for_each(|awaited| Awaited(awaited).give_up());
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATHS: Act = Act::Machine { drawing: None, anew: false };

    #[test]
    fn who_asks_again_gives_up_what_it_asked_for_before() {
        let works = Works::default();
        let (first, other) = (works.begin(1, &PATHS), works.begin(2, &PATHS));
        let save = works.begin(1, &Act::SaveJob);
        let second = works.begin(1, &PATHS);
        let given_up = [&first, &other, &save, &second].map(Awaited::is_given_up);
        assert_eq!(given_up, [true, false, false, false]);
        works.give_up(1);
        let given_up = [&first, &other, &save, &second].map(Awaited::is_given_up);
        assert_eq!(given_up, [true, false, true, true]);
    }

    #[test]
    fn work_ends_with_the_request_that_waits_for_it() {
        let work = Awaited::default();
        let asked = work.while_asked();
        assert!(work.goes_on().is_ok());
        drop(asked);
        assert!(work.goes_on().is_err());
    }

    #[test]
    fn what_is_done_is_not_kept() {
        let works = Works::default();
        (0..100).for_each(|_| drop(works.begin(1, &PATHS)));
        assert!(lock(&works.0).len() <= 1);
    }
}
