//! The moves of a stack that were read and are not planned to the last: the window in which a model
//! looks ahead.

use crate::moves::Move;
use crate::profile::Profile;

/// Moves in order with the speeds that are allowed in them, the oldest first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ahead {
    /// Number of moves of the stack that lie before.
    pub begun: usize,
    pub moves: Vec<Move>,
    /// One for each move that was looked at, in order.
    pub caps: Vec<Profile>,
}

impl Ahead {
    /// Takes the first moves out, with their caps.
    pub fn take(&mut self, count: usize) -> (Vec<Move>, Vec<Profile>) {
        self.begun += count;
        (first(&mut self.moves, count), first(&mut self.caps, count))
    }

    /// Number in the stack of a move of the window. Only differences matter: it may run over.
    pub const fn number(&self, index: usize) -> u32 {
        self.begun.wrapping_add(index) as u32
    }

    /// Index in the window of a move of the stack.
    pub const fn index(&self, number: u32) -> usize {
        number.wrapping_sub(self.begun as u32) as usize
    }
}

/// Takes the first items out of a list, in the room where they lie; the list gets as much for those to come.
fn first<T: Copy>(all: &mut Vec<T>, count: usize) -> Vec<T> {
    let mut left = Vec::with_capacity(all.capacity());
    left.extend_from_slice(&all[count..]);
    all.truncate(count);
    std::mem::replace(all, left)
}
