//! Work that takes longer than a moment, off the threads that talk with pages.
//!
//! ```text
//!  request ──► RequestScope (who asks) ──► lane: short ──► 2 threads
//!                                       long  ──► cores − 1, at least one
//! ```
//!
//! Everything is done here but what is known to be fast. Who asks has one job at a time in each lane, and takes turns with
//! the others; what nobody waits for any more is not begun.

mod turns;

use crate::locks::lock;
use crate::memory::{Memory, REFUSED};
use crate::priority::Yields;
use crate::refusal::problem;
use kerf_wire::{Problem, Why};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use tokio::sync::oneshot;
use turns::Turns;

/// Threads for what is short: one may wait for the disk.
const SHORT: usize = 2;

/// The one who asks: a paired device by its number; [`HERE`] at the machine itself.
pub type Customer = u32;

/// Customer for whoever sits at the machine.
pub const HERE: Customer = 0;
/// The server itself: previews, and what follows on a run.
pub const KERF: Customer = u32::MAX;

/// Lane for work, by how long it takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lane {
    /// Usually a moment.
    Short,
    /// Perhaps seconds.
    Long,
}

/// The threads, and what waits for them.
#[derive(Debug)]
pub struct Pool {
    /// Long work of paired devices is refused where it is tight.
    memory: Memory,
    short: Arc<Queue>,
    long: Arc<Queue>,
}

/// Work that waits in a lane.
#[derive(Debug, Default)]
struct Queue {
    turns: Mutex<Turns>,
    more: Condvar,
}

impl Pool {
    /// Begins the threads.
    ///
    /// # Errors
    /// The system gives none.
    pub fn begin(memory: Memory) -> std::io::Result<Self> {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let pool = Self { memory, short: Arc::default(), long: Arc::default() };
        for _ in 0..SHORT {
            begin("short work", Yields::Aside, &pool.short)?;
        }
        for _ in 0..(cores - 1).max(1) {
            begin("long work", Yields::Last, &pool.long)?;
        }
        Ok(pool)
    }

    /// Has something done.
    ///
    /// # Errors
    /// Too much of this customer, or of all, waits already; or memory is tight.
    pub fn give(
        &self,
        lane: Lane,
        customer: Customer,
        job: impl FnOnce() + Send + 'static,
    ) -> Result<(), Problem> {
        let is_of_device = ![HERE, KERF].contains(&customer);
        if is_of_device && lane == Lane::Long && self.memory.is_tight() {
            return Err(problem(Why::Server, REFUSED));
        }
        let queue = match lane {
            Lane::Short => &self.short,
            Lane::Long => &self.long,
        };
        if !lock(&queue.turns).add(customer, Box::new(job)) {
            let text = "too much was asked for and is not done yet: wait a moment, then ask again";
            return Err(problem(Why::Server, text));
        }
        queue.more.notify_one();
        Ok(())
    }

    /// Has something done, and waits for it. It is not begun where nobody waits any more.
    ///
    /// # Errors
    /// As [`Pool::give`]; or it failed in the server.
    pub async fn done<T: Send + 'static>(
        &self,
        lane: Lane,
        customer: Customer,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, Problem> {
        let (tell, told) = oneshot::channel();
        self.give(lane, customer, move || {
            if !tell.is_closed() {
                // Whoever waited may have gone meanwhile.
                drop(tell.send(work()));
            }
        })?;
        told.await.map_err(|_| problem(Why::Server, "this failed in the server"))
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        for queue in [&self.short, &self.long] {
            lock(&queue.turns).end();
            queue.more.notify_all();
        }
    }
}

fn begin(name: &str, yields: Yields, queue: &Arc<Queue>) -> std::io::Result<()> {
    let queue = queue.clone();
    let work = move || {
        yields.hold();
        queue.work();
    };
    thread::Builder::new().name(name.into()).spawn(work).map(drop)
}

impl Queue {
    /// Works until the server ends.
    fn work(&self) {
        let mut turns = lock(&self.turns);
        loop {
            if let Some((customer, job)) = turns.next() {
                drop(turns);
                // What fails is told by whoever waits for it; this thread has others to serve.
                drop(catch_unwind(AssertUnwindSafe(job)));
                turns = lock(&self.turns);
                turns.done(customer);
                self.more.notify_one();
            } else if turns.is_over() {
                return;
            } else {
                turns = self.more.wait(turns).unwrap_or_else(PoisonError::into_inner);
            }
        }
    }
}

tokio::task_local! {
    /// Whose request a task serves.
    static SCOPE: RequestScope;
}

/// Whose request is served, and who does the work for it.
#[derive(Clone, Debug)]
pub struct RequestScope {
    pool: Arc<Pool>,
    customer: Customer,
}

impl RequestScope {
    /// Makes the scope of a customer's requests.
    pub const fn of(pool: Arc<Pool>, customer: Customer) -> Self {
        Self { pool, customer }
    }

    /// Serves a request of theirs.
    pub async fn serve<T>(self, request: impl Future<Output = T>) -> T {
        SCOPE.scope(self, request).await
    }

    /// Whose request this task serves.
    ///
    /// # Errors
    /// It serves none.
    pub fn present() -> Result<Self, Problem> {
        let none = |_| problem(Why::Server, "this was asked for by nobody");
        SCOPE.try_with(Self::clone).map_err(none)
    }

    /// Has something done for them, and waits for it.
    ///
    /// # Errors
    /// As [`Pool::done`].
    pub async fn done<T: Send + 'static>(
        &self,
        lane: Lane,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, Problem> {
        self.pool.done(lane, self.customer, work).await
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use futures_util::FutureExt;
    use std::sync::mpsc::channel;
    use tokio::runtime::Builder;

    #[test]
    fn what_panics_takes_no_thread_along() {
        let pool = Pool::begin(Memory::default()).unwrap();
        let runtime = Builder::new_current_thread().build().unwrap();
        for _ in 0..2 * SHORT {
            let failed = runtime.block_on(pool.done(Lane::Short, HERE, || panic!("as it may")));
            let failed: Problem = failed.map(|(): ()| ()).unwrap_err();
            assert_eq!(failed.text, "this failed in the server");
        }
        assert_eq!(runtime.block_on(pool.done(Lane::Short, HERE, || 7)), Ok(7));
    }

    #[test]
    fn what_nobody_waits_for_is_not_begun() {
        let pool = Pool::begin(Memory::default()).unwrap();
        let (go, gone) = channel::<()>();
        // One job a customer at a time: the second waits for the first.
        pool.give(Lane::Long, 1, move || _ = gone.recv()).unwrap();
        let (tell, told) = channel();
        let given_up = pool.done(Lane::Long, 1, move || _ = tell.send(()));
        assert!(given_up.now_or_never().is_none());
        let waiting = pool.done(Lane::Long, 1, || 3);
        drop(go);
        let runtime = Builder::new_current_thread().build().unwrap();
        assert_eq!(runtime.block_on(waiting), Ok(3));
        assert!(told.try_recv().is_err(), "it was given up before it began");
    }
}
