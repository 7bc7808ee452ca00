//! Moves of the plan at hand that were handed to the controller.

use super::chords::nearest;
use kerf_machine::driver::Ticket;
use kerf_program::{At, Axes};
use std::collections::VecDeque;

/// A chord of a move with the order that makes it.
#[derive(Clone, Copy, Debug)]
pub struct Chord {
    pub ticket: Ticket,
    /// Share of the move at its end.
    pub share: f64,
    pub to: Axes,
}

/// A move that was handed over.
#[derive(Clone, Debug)]
pub struct Handed {
    pub at: At,
    pub from: Axes,
    pub chords: Vec<Chord>,
    /// Share of it that the machine was seen to have made: a circle comes by its beginning once more.
    pub seen: f64,
}

/// Between two looks a machine makes no more of a move than this share: what lies farther on the way is another round.
const LEAP: f64 = 0.5;

impl Handed {
    /// The order that ends it.
    pub fn last(&self) -> Ticket {
        self.chords.last().map_or(0, |chord| chord.ticket)
    }

    /// Returns the distance of a place from what is not done of it, and the share of the move there.
    fn nearest(&self, done: Ticket, place: Axes) -> Option<(f64, f64)> {
        let (mut from, mut begin, mut best) = (self.from, 0.0, None::<(f64, f64)>);
        for chord in &self.chords {
            let is_ahead = chord.share >= self.seen && begin <= self.seen + LEAP;
            if chord.ticket > done && (is_ahead || self.seen == 0.0) {
                let (far, along) = nearest(from, chord.to, place);
                let share = begin + (chord.share - begin) * along;
                if best.is_none_or(|(least, _)| far < least - CLOSER_MM) {
                    best = Some((far, share));
                }
            }
            (from, begin) = (chord.to, chord.share);
        }
        best
    }
}

/// Distance by which a later move must lie closer to a report to be taken for the present one, mm: reports are rounded
/// to thousandths.
const CLOSER_MM: f64 = 0.002;

/// Moves of one plan, in order.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// The number of the first one in its plan.
    first: usize,
    moves: VecDeque<Handed>,
    /// The last order of the plan before.
    pub before: Ticket,
}

impl Row {
    /// Another plan begins.
    pub fn begin(&mut self) {
        let before = self.moves.back().map_or(self.before, Handed::last);
        *self = Self { before, ..Self::default() };
    }

    /// The number of the next move that is to be handed over.
    pub fn next(&self) -> usize {
        self.first + self.moves.len()
    }

    /// A move was handed over.
    pub fn push(&mut self, handed: Handed) {
        self.moves.push_back(handed);
    }

    /// The run has come to a move: those before it are over.
    pub fn come_to(&mut self, index: usize) {
        while self.first < index && !self.moves.is_empty() {
            self.before = self.moves.pop_front().map_or(self.before, |handed| handed.last());
            self.first += 1;
        }
        if self.moves.is_empty() {
            self.first = self.first.max(index);
        }
    }

    /// The share of the last move that was handed over at which a place is nearest.
    pub fn along_last(&self, place: Axes) -> f64 {
        let last = self.moves.back().and_then(|handed| handed.nearest(0, place));
        last.map_or(1.0, |(_, share)| share)
    }

    /// The move that an order belongs to.
    pub fn at(&self, ticket: Ticket) -> Option<At> {
        self.moves.iter().find(|handed| handed.last() >= ticket).map(|handed| handed.at)
    }

    /// The share of a move that is made; 1 when all of it is.
    pub fn share(&self, index: usize, done: Ticket, place: Option<Axes>) -> f64 {
        let Some(handed) = index.checked_sub(self.first).and_then(|n| self.moves.get(n)) else {
            return 0.0;
        };
        if handed.last() <= done {
            return 1.0;
        }
        let begun =
            self.moves.get(index.wrapping_sub(self.first + 1)).is_none_or(|it| it.last() <= done);
        let near = place.filter(|_| begun).and_then(|place| handed.nearest(done, place));
        // Only what is done is made to its end.
        near.map_or(0.0, |(_, share)| share.min(1.0 - f64::EPSILON))
    }

    /// The machine was seen to have made a share of a move.
    pub fn sees(&mut self, index: usize, share: f64) {
        let handed = index.checked_sub(self.first).and_then(|n| self.moves.get_mut(n));
        if let Some(handed) = handed.filter(|it| (it.seen..=it.seen + LEAP).contains(&share)) {
            handed.seen = share;
        }
    }

    /// The move on which a place lies, and the share of it there.
    pub fn locate(&self, done: Ticket, place: Axes) -> Option<(usize, f64)> {
        let mut best: Option<(f64, usize, f64)> = None;
        for (n, handed) in self.moves.iter().enumerate() {
            let Some((far, share)) = handed.nearest(done, place) else { continue };
            if best.is_none_or(|(least, ..)| far < least - CLOSER_MM) {
                best = Some((far, self.first + n, share));
            }
        }
        let last = self.moves.len().checked_sub(1).map(|n| (self.first + n, 1.0));
        best.map(|(_, index, share)| (index, share)).or(last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_circle_that_comes_by_its_beginning_is_not_begun_anew() {
        let on = |share: f64| Axes::xyz((share * TAU).cos(), (share * TAU).sin(), 0.0);
        let chord = |n: u32| {
            let share = f64::from(n) / 64.0;
            Chord { ticket: 1, share, to: on(share) }
        };
        let chords = (1..=64).map(chord).collect();
        let mut row = Row::default();
        row.push(Handed { at: At::default(), from: on(0.0), chords, seen: 0.0 });
        for n in 0..=20 {
            let share = f64::from(n) / 20.0;
            let told = row.share(0, 0, Some(on(share)));
            assert!((told - share).abs() < 0.02, "{told} of {share}");
            row.sees(0, told);
        }
        assert_eq!(row.locate(0, on(1.0)).map(|(_, share)| share > 0.98), Some(true));
    }
}
