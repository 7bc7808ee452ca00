//! Turns of customers: everybody in turn, one job of each at a time.

use super::Customer;
use std::collections::{BTreeSet, VecDeque};
use std::fmt;

/// Jobs of one customer that wait, at most.
const EACH: usize = 32;
/// Jobs of all.
const ALL: usize = 512;

/// Something to do.
pub type Task = Box<dyn FnOnce() + Send>;

/// Jobs that wait.
#[derive(Default)]
pub struct Turns {
    waiting: VecDeque<(Customer, VecDeque<Task>)>,
    busy: BTreeSet<Customer>,
    over: bool,
}

impl fmt::Debug for Turns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Turns").field("waiting", &self.len()).field("busy", &self.busy).finish()
    }
}

impl Turns {
    fn len(&self) -> usize {
        self.waiting.iter().map(|(_, jobs)| jobs.len()).sum()
    }

    /// One more waits; not where too many do.
    pub fn add(&mut self, customer: Customer, job: Task) -> bool {
        if self.over || self.len() >= ALL {
            return false;
        }
        let own = self.waiting.iter_mut().find(|(of, _)| *of == customer);
        match own {
            Some((_, jobs)) if jobs.len() >= EACH => return false,
            Some((_, jobs)) => jobs.push_back(job),
            None => self.waiting.push_back((customer, VecDeque::from([job]))),
        }
        true
    }

    /// The next one: of the customer who has waited longest and for whom nothing is done.
    pub fn next(&mut self) -> Option<(Customer, Task)> {
        let place = self.waiting.iter().position(|(of, _)| !self.busy.contains(of))?;
        let (customer, mut jobs) = self.waiting.remove(place)?;
        let job = jobs.pop_front()?;
        if !jobs.is_empty() {
            self.waiting.push_back((customer, jobs));
        }
        self.busy.insert(customer);
        Some((customer, job))
    }

    /// Notes that the job of a customer is over.
    pub fn done(&mut self, customer: Customer) {
        self.busy.remove(&customer);
    }

    /// Drops what waits and takes nothing more.
    pub fn end(&mut self) {
        self.over = true;
        self.waiting.clear();
    }

    /// Returns `true` after the end.
    pub const fn is_over(&self) -> bool {
        self.over
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn job() -> Task {
        Box::new(|| ())
    }

    fn order(turns: &mut Turns) -> Vec<Customer> {
        std::iter::from_fn(|| turns.next().map(|(customer, _)| customer)).collect()
    }

    #[test]
    fn everybody_has_a_turn_and_one_job_at_a_time() {
        let mut turns = Turns::default();
        for customer in [1, 1, 1, 2, 3] {
            assert!(turns.add(customer, job()));
        }
        assert_eq!(order(&mut turns), [1, 2, 3]);
        turns.done(1);
        assert_eq!(order(&mut turns), [1]);
        turns.done(1);
        assert!(turns.add(2, job()));
        turns.done(2);
        assert_eq!(order(&mut turns), [1, 2]);
    }

    #[test]
    fn who_asks_for_too_much_is_refused_and_others_are_not() {
        let mut turns = Turns::default();
        let taken = (0..2 * EACH).filter(|_| turns.add(1, job())).count();
        assert_eq!(taken, EACH);
        assert!(turns.add(2, job()));
        let all = (3..1000).filter(|customer| turns.add(*customer, job())).count();
        assert_eq!(all + EACH + 1, ALL);
    }
}
