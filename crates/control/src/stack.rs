//! The stack of moves that is being read: nothing of it moves until it is complete.
//!
//! Commands that belong to a stack without being motion (switching an output on, a change of speed, a
//! comment) are kept as marks: they are carried out between two moves while the machine moves on.

use kerf_motion::Move;
use kerf_program::Sourced;

/// Moves that are run as one, and what is done between them.
#[derive(Debug, Default)]
pub(crate) struct Stack {
    pub moves: Vec<Move>,
    /// Number of each motion command of `moves`; kept only while something may interrupt.
    pub numbers: Vec<u64>,
    /// What is done before the move of this index starts, in order.
    pub marks: Vec<(usize, Sourced)>,
}

impl Stack {
    pub fn is_empty(&self) -> bool {
        self.moves.is_empty() && self.marks.is_empty()
    }

    /// Adds a command that does not end motion.
    pub fn mark(&mut self, sourced: Sourced) {
        self.marks.push((self.moves.len(), sourced));
    }

    /// What is left when so many moves were made: the rest of them, and the marks that were not
    /// carried out.
    pub fn after(
        mut self,
        made: usize,
        rest: Vec<Move>,
        marks: impl Iterator<Item = (usize, Sourced)>,
    ) -> Self {
        self.moves = rest;
        self.numbers.drain(..made.min(self.numbers.len()));
        self.marks =
            marks.map(|(before, sourced)| (before.saturating_sub(made), sourced)).collect();
        self
    }
}
