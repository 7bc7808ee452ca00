//! The stack of moves that is being read.
//!
//! Nothing of a stack moves before it was read to its end or, in a long one, so far ahead
//! ([`READ_AHEAD`]); from then on it is planned and made while it is read. Commands that belong to a
//! stack without being motion (switching an output on, a change of speed, a comment) are kept as
//! marks: they are carried out between two moves while the machine moves on.

use kerf_motion::{Move, Plan, Queue, Replanner};
use kerf_program::{Axes, Sourced};
use std::collections::VecDeque;

/// A stack of so many moves begins to move although it was not read to its end: the manual's rule
/// that an error keeps the whole stack from moving cannot hold for ten million lines. Memory and the
/// time to the first motion grow with it.
pub(crate) const READ_AHEAD: usize = 1 << 14;

/// Moves that the planner gets at a time.
const AT_ONCE: usize = 512;

/// Moves that are run as one, and what is done between them.
#[derive(Default)]
pub(crate) struct Stack {
    /// Moves that were read before anything began.
    pub waiting: Queue,
    /// The planner that has the moves since the stack began to move.
    pub running: Option<Running>,
    /// Number of each motion command that was read and not made; kept only while something may
    /// interrupt.
    numbers: VecDeque<u64>,
    /// Number of the last motion command that was made.
    pub last_number: Option<u64>,
    /// Number of moves that were read, and made.
    read: u64,
    made: u64,
    /// Number of moves that were read when the last one of a file was.
    files_until: u64,
    /// Commands that are carried out before a move starts, with the number of moves read before each.
    marks: VecDeque<(u64, Sourced)>,
}

/// A stack that moves.
pub(crate) struct Running {
    pub planner: Box<dyn Replanner>,
    /// Moves that the planner does not have yet: it gets them as far as a piece of plan takes.
    pub waiting: Queue,
    /// Begin of its plan, seconds of machine time.
    pub t0_s: f64,
}

impl Running {
    /// The next piece of plan that no later move can change, or any when the stack is complete. Moves are
    /// planned at a share of their feed. One whole piece is as much as is known, up to [`READ_AHEAD`] moves.
    pub fn next(&mut self, complete: bool, share: f32, whole: bool) -> Option<Plan> {
        if whole {
            self.hand(READ_AHEAD, share);
        }
        loop {
            let ends = complete && self.waiting.is_empty();
            let piece = if whole && ends { self.planner.finish() } else { self.planner.take() };
            if piece.is_some() {
                return piece;
            }
            if self.waiting.is_empty() {
                return if complete { self.planner.finish() } else { None };
            }
            self.hand(AT_ONCE, share);
        }
    }

    /// Adds a move. The planner gets it at once where none waits before it.
    fn push(&mut self, made: Move) {
        if self.waiting.is_empty() {
            self.planner.push(made);
        } else {
            self.waiting.push_back(made);
        }
    }

    /// The planner gets moves that wait, so many at most.
    fn hand(&mut self, most: usize, share: f32) {
        for made in (0..most).map_while(|_| self.waiting.pop_front()) {
            self.planner.push(made.at_feed(share));
        }
    }

    /// The moves that did not come out.
    pub fn withdraw(mut self) -> impl Iterator<Item = Move> {
        self.planner
            .withdraw()
            .into_iter()
            .chain(std::iter::from_fn(move || self.waiting.pop_front()))
    }
}

impl Stack {
    pub fn is_empty(&self) -> bool {
        self.waiting.is_empty() && self.running.is_none() && self.marks.is_empty()
    }

    /// Returns the number of moves that were read.
    pub const fn len(&self) -> u64 {
        self.read
    }

    /// Adds a move, with the number of its command when something may interrupt.
    pub fn push(&mut self, made: Move, number: Option<u64>) {
        self.read += 1;
        if let Some(number) = number {
            self.numbers.push_back(number);
        }
        match &mut self.running {
            Some(running) => running.push(made),
            None => self.waiting.push_back(made),
        }
    }

    /// The move that was added last is one of a file, not of what was typed.
    pub const fn came_from_file(&mut self) {
        self.files_until = self.read;
    }

    /// Returns `true` if a move of a file is still to be made, or is being made.
    pub const fn moves_file(&self) -> bool {
        self.made < self.files_until
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

    /// Returns the number of moves that are made before something marked is carried out.
    pub fn before_mark(&self) -> usize {
        self.marks
            .front()
            .map_or(usize::MAX, |(before, _)| before.saturating_sub(self.made) as usize)
    }

    /// A move was made, or a part of it: an override makes it in several.
    pub fn made_one(&mut self, made: &Move) {
        if made.is_last_part {
            self.made += 1;
            self.last_number = self.numbers.pop_front();
        }
    }

    /// Everything that was not made lies elsewhere.
    pub fn shift(&mut self, by: Axes) {
        self.waiting.shift(by);
    }

    /// Number of the motion command that is made next, or of which a part is left.
    pub fn next_number(&self) -> Option<u64> {
        self.numbers.front().copied()
    }

    /// Takes back what is left of a stack that stands, to be checked and planned anew.
    pub fn stand_back(&mut self) {
        if let Some(running) = self.running.take() {
            self.waiting = running.withdraw().collect();
        }
    }

    /// Everything that is left of the marks; the stack is empty after that.
    pub fn clear(&mut self) -> impl Iterator<Item = Sourced> + use<> {
        std::mem::take(self).marks.into_iter().map(|(_, sourced)| sourced)
    }
}
