//! Places for commands in the board: one pool for all motors and outputs.
//!
//! A command takes its place on arrival and frees it when it is loaded: at the end of the one before, which is the
//! clock from which it counts.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The pool, as the host knows it: never fuller than it is told here.
#[derive(Clone, Debug)]
pub struct Places {
    most: usize,
    /// Clocks at which the commands that were sent are loaded, the first on top.
    taken: BinaryHeap<Reverse<u64>>,
}

impl Places {
    pub fn new(most: usize) -> Self {
        Self { most, taken: BinaryHeap::new() }
    }

    pub fn is_full(&self) -> bool {
        self.taken.len() >= self.most
    }

    pub fn take(&mut self, until: u64) {
        self.taken.push(Reverse(until));
    }

    /// Commands that were loaded before a clock have freed their places.
    pub fn free(&mut self, now: u64) {
        while self.taken.peek().is_some_and(|Reverse(until)| *until < now) {
            self.taken.pop();
        }
    }

    pub fn free_all(&mut self) {
        self.taken.clear();
    }
}
