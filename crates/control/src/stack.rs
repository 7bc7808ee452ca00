//! The stack of moves that is being read.
//!
//! Nothing of a stack moves before it was read to its end or, in a long one, so far ahead
//! ([`READ_AHEAD`]); from then on it is planned and made while it is read. Commands that belong to a
//! stack without being motion (switching an output on, a change of speed, a comment) are kept as
//! marks: they are carried out between two moves while the machine moves on.

use kerf_motion::{Move, Replanner};
use kerf_program::{Axes, Sourced};
use std::collections::VecDeque;

/// A stack of so many moves begins to move although it was not read to its end: the manual's rule
/// that an error keeps the whole stack from moving cannot hold for ten million lines. Memory and the
/// time to the first motion grow with it.
pub(crate) const READ_AHEAD: usize = 1 << 14;

/// Moves that are run as one, and what is done between them.
#[derive(Default)]
pub(crate) struct Stack {
    /// Moves that were read before anything began.
    pub waiting: Vec<Move>,
    /// The planner that has the moves since the stack began to move.
    pub running: Option<Running>,
    /// Number of each motion command that was read and not made; kept only while something may
    /// interrupt.
    numbers: VecDeque<u64>,
    /// Where each move ends that was read and not made: an override makes it in several pieces.
    ends: VecDeque<Axes>,
    /// Number of the last motion command that was made.
    pub last_number: Option<u64>,
    /// How many moves were read, and made.
    read: u64,
    made: u64,
    /// What is done before a move starts: how many are read before it.
    marks: VecDeque<(u64, Sourced)>,
}

/// A stack that moves.
pub(crate) struct Running {
    pub planner: Box<dyn Replanner>,
    /// When its plan begins, seconds of machine time.
    pub t0_s: f64,
}

impl Stack {
    pub fn is_empty(&self) -> bool {
        self.waiting.is_empty() && self.running.is_none() && self.marks.is_empty()
    }

    /// How many moves were read.
    pub const fn len(&self) -> u64 {
        self.read
    }

    /// Adds a move, with the number of its command when something may interrupt.
    pub fn push(&mut self, made: Move, number: Option<u64>) {
        self.read += 1;
        self.numbers.extend(number);
        self.ends.push_back(made.to);
        match &mut self.running {
            Some(running) => running.planner.push(made),
            None => self.waiting.push(made),
        }
    }

    /// Adds a command that does not end motion.
    pub fn mark(&mut self, sourced: Sourced) {
        self.marks.push_back((self.read, sourced));
    }

    /// The next command that is due before the next move.
    pub fn due(&mut self) -> Option<Sourced> {
        let due = self.marks.front().is_some_and(|(before, _)| *before <= self.made);
        if due { self.marks.pop_front().map(|(_, sourced)| sourced) } else { None }
    }

    /// A move was made, or a piece of it, that ends at a place.
    pub fn made_one(&mut self, to: Axes) {
        if self.ends.front().is_some_and(|end| !end.same_place(&to)) {
            return;
        }
        self.ends.pop_front();
        self.made += 1;
        self.last_number = self.numbers.pop_front();
    }

    /// Everything that was not made lies elsewhere.
    pub fn shift(&mut self, by: Axes) {
        self.waiting.iter_mut().for_each(|made| made.shift(by));
        self.ends.iter_mut().for_each(|end| *end = end.plus(by));
    }

    /// Number of the motion command that is made next, or of which a part is left.
    pub fn next_number(&self) -> Option<u64> {
        self.numbers.front().copied()
    }

    /// What is left of a stack that stands has to be checked and planned anew.
    pub fn stand_back(&mut self) {
        if let Some(mut running) = self.running.take() {
            self.waiting = running.planner.withdraw();
        }
    }

    /// Everything that is left of the marks; the stack is empty after that.
    pub fn clear(&mut self) -> impl Iterator<Item = Sourced> + use<> {
        std::mem::take(self).marks.into_iter().map(|(_, sourced)| sourced)
    }
}
