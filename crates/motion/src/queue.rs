//! Moves that wait, in little memory.
//!
//! A long program has many moves in flight. Nearly all of them are straight, begin where the one before
//! ended, and move X, Y and Z only; of such a move only the end and the speeds are kept, exactly. What
//! is rare is kept beside it.

use crate::moves::{Basis, Move, Path};
use kerf_program::{At, Axes, MoveKind};
use std::collections::VecDeque;

/// Grows by a share of its length, so that little memory lies idle.
const GROWTH: usize = 8;
const LEAST_GROWTH: usize = 64;

/// Moves in order, exactly as they were put in.
#[derive(Clone, Debug, Default)]
pub struct Queue {
    /// Place where the first move starts.
    start: Axes,
    /// Place where the last one ends.
    end: Axes,
    held: VecDeque<Held>,
}

/// A move as it is kept.
#[derive(Clone, Debug)]
struct Held {
    /// Place where it ends, in X, Y and Z.
    to: [f64; 3],
    length_mm: f64,
    speed_mm_s: f64,
    ramp_mm_s: f64,
    accel_mm_s2: f64,
    at: At,
    rare: Option<Box<Rare>>,
    feed: f32,
    kind: MoveKind,
    basis: Basis,
    is_last_part: bool,
}

/// Details of a move that is curved, turns a rotary axis, or does not begin where the one before ended.
#[derive(Clone, Debug)]
struct Rare {
    from: Axes,
    to: Axes,
    path: Path,
}

impl Queue {
    /// Returns the number of moves that wait.
    pub fn len(&self) -> usize {
        self.held.len()
    }

    /// Returns `true` if none waits.
    pub fn is_empty(&self) -> bool {
        self.held.is_empty()
    }

    /// Memory that is taken for the moves, bytes, without what is rare.
    pub fn bytes(&self) -> usize {
        self.held.capacity() * size_of::<Held>()
    }

    /// The last move.
    pub fn push_back(&mut self, made: Move) {
        if self.is_empty() {
            self.start = made.from;
        }
        if self.held.len() == self.held.capacity() {
            self.held.reserve_exact((self.held.len() / GROWTH).max(LEAST_GROWTH));
        }
        let held = Held::new(&made, &self.end, self.is_empty());
        self.end = made.to;
        self.held.push_back(held);
    }

    /// The first move.
    pub fn push_front(&mut self, made: Move) {
        match self.held.front_mut() {
            None => self.end = made.to,
            Some(next) if next.rare.is_none() && !same(&made.to, &self.start) => {
                let (from, to) = (self.start, next.to_axes(&self.start));
                next.rare = Some(Box::new(Rare { from, to, path: Path::Line }));
            }
            Some(_) => {}
        }
        self.start = made.from;
        self.held.push_front(Held::new(&made, &made.from, true));
    }

    /// Takes the first move.
    pub fn pop_front(&mut self) -> Option<Move> {
        let made = self.held.pop_front()?.made(&self.start);
        self.start = made.to;
        Some(made)
    }

    /// The first move.
    pub fn front(&self) -> Option<Move> {
        self.iter().next()
    }

    /// All moves, in order.
    pub fn iter(&self) -> impl Iterator<Item = Move> + '_ {
        self.held.iter().scan(self.start, |from, held| {
            let made = held.made(from);
            *from = made.to;
            Some(made)
        })
    }

    /// The same moves elsewhere.
    pub fn shift(&mut self, by: Axes) {
        *self = self
            .iter()
            .map(|mut made| {
                made.shift(by);
                made
            })
            .collect();
    }
}

impl FromIterator<Move> for Queue {
    fn from_iter<T: IntoIterator<Item = Move>>(moves: T) -> Self {
        let mut queue = Self::default();
        queue.extend(moves);
        queue
    }
}

impl Extend<Move> for Queue {
    fn extend<T: IntoIterator<Item = Move>>(&mut self, moves: T) {
        moves.into_iter().for_each(|made| self.push_back(made));
    }
}

impl Held {
    /// A move after one that ended at a place; the first of all may begin anywhere.
    fn new(made: &Move, before: &Axes, first: bool) -> Self {
        let Move { at, kind, basis, from, to, path, feed, is_last_part, .. } = *made;
        let turned = (3..from.0.len()).any(|k| from.0[k].to_bits() != to.0[k].to_bits());
        let usual = path == Path::Line && !turned && (first || same(before, &from));
        Self {
            to: to.first3(),
            length_mm: made.length_mm,
            speed_mm_s: made.speed_mm_s,
            ramp_mm_s: made.ramp_mm_s,
            accel_mm_s2: made.accel_mm_s2,
            at,
            rare: (!usual).then(|| Box::new(Rare { from, to, path })),
            feed,
            kind,
            basis,
            is_last_part,
        }
    }

    /// Returns the place where it ends, if it is not rare.
    fn to_axes(&self, from: &Axes) -> Axes {
        let mut to = *from;
        to.0[..3].copy_from_slice(&self.to);
        to
    }

    fn made(&self, before: &Axes) -> Move {
        let usual = || Rare { from: *before, to: self.to_axes(before), path: Path::Line };
        let Rare { from, to, path } = self.rare.as_deref().cloned().unwrap_or_else(usual);
        Move {
            at: self.at,
            kind: self.kind,
            basis: self.basis,
            from,
            to,
            path,
            length_mm: self.length_mm,
            speed_mm_s: self.speed_mm_s,
            ramp_mm_s: self.ramp_mm_s,
            accel_mm_s2: self.accel_mm_s2,
            feed: self.feed,
            is_last_part: self.is_last_part,
        }
    }
}

/// To the last bit.
fn same(a: &Axes, b: &Axes) -> bool {
    a.0.map(f64::to_bits) == b.0.map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mover;
    use kerf_program::{Arc, Feed, Line, Settings};

    /// Lines, a turn of a rotary axis, an arc, and a move that begins elsewhere.
    fn moves() -> Vec<Move> {
        let mut mover = Mover::new(Axes::xyz(1.0, 2.0, -0.0), &Settings::default());
        let line = |to| Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
        let arc = Arc {
            kind: MoveKind::Cut,
            to: Axes::xyz(0.0, 10.0, 2.0),
            centre: [5.0, 5.0],
            sweep_rad: 3.0,
            feed: Feed::Path(20.0),
            chords: 12,
            small: true,
        };
        let at = |line| At { file: 3, line };
        let mut moves: Vec<Move> = (0..40)
            .filter_map(|k| mover.line(at(k), &line(Axes::xyz(f64::from(k), 0.1, 0.3))))
            .collect();
        moves.extend(mover.arc(at(41), &arc));
        moves.extend(mover.line(at(42), &line(Axes([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]))));
        moves.extend(mover.line(at(43), &line(Axes([2.0, 2.0, 3.0, 4.0, 5.0, 6.0]))));
        mover.set_position(Axes::splat(7.0));
        moves.extend(mover.line(at(44), &line(Axes::splat(8.0))));
        moves.extend(mover.line(at(45), &line(Axes::splat(-0.0))));
        moves.push(moves[3].at_feed(0.7).split(0.3).0);
        moves
    }

    #[test]
    fn moves_come_out_as_they_were_put_in_at_either_end() {
        let moves = moves();
        let queue: Queue = moves.iter().copied().collect();
        assert_eq!((queue.len(), queue.iter().collect::<Vec<_>>()), (moves.len(), moves.clone()));
        let mut turned = Queue::default();
        moves.iter().rev().for_each(|made| turned.push_front(*made));
        turned.push_back(moves[0]);
        let out: Vec<Move> = std::iter::from_fn(|| turned.pop_front()).collect();
        assert_eq!(out, [&moves[..], &moves[..1]].concat());
    }

    #[test]
    fn moves_that_wait_are_shifted_with_their_arcs() {
        let by = Axes::xyz(1.5, -2.5, 0.25);
        let mut queue: Queue = moves().into_iter().collect();
        queue.shift(by);
        let shifted = moves().into_iter().map(|mut made| {
            made.shift(by);
            made
        });
        assert!(queue.iter().eq(shifted));
    }

    #[test]
    fn a_segment_in_flight_takes_less_than_a_hundred_bytes() {
        assert!(size_of::<Held>() <= 80, "{}", size_of::<Held>());
        let mut queue = Queue::default();
        let mut mover = Mover::new(Axes::default(), &Settings::default());
        for k in 0..20_000u32 {
            let to = Axes::xyz(f64::from(k % 100), f64::from(k / 100), f64::from(k % 7));
            let line = Line { kind: MoveKind::Cut, to, feed: Feed::Path(20.0) };
            mover.line(At::default(), &line).into_iter().for_each(|made| queue.push_back(made));
            assert!(queue.len() < 1000 || queue.bytes() <= 100 * queue.len(), "{k}");
        }
        assert!(queue.held.iter().all(|held| held.rare.is_none()));
    }
}
