//! The motion of the fake: along its moves with one acceleration, slowing down for nothing but the end and a hold.

use kerf_machine::driver::{Axes, way_mm};
use std::collections::VecDeque;

/// Acceleration along the path, mm/s².
const ACCEL_MM_S2: f64 = 400.0;

/// Moves that wait, and the state of the motion.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    moves: VecDeque<(Axes, f64, u32)>,
    pub position: Axes,
    pub speed_mm_s: f64,
    passed: Option<u32>,
    pub stands: usize,
}

impl Motion {
    /// A straight move joins the row.
    pub fn push(&mut self, to: Axes, speed_mm_s: f64, ticket: u32) {
        self.moves.push_back((to, speed_mm_s, ticket));
    }

    /// Returns `true` if nothing is left to make.
    pub fn is_empty(&self) -> bool {
        self.moves.is_empty()
    }

    /// Takes the ticket of the last move that was made since it was asked.
    pub const fn passed(&mut self) -> Option<u32> {
        self.passed.take()
    }

    /// Nothing is left.
    pub fn clear(&mut self) {
        self.moves.clear();
        self.speed_mm_s = 0.0;
    }

    /// It stands elsewhere.
    pub fn put(&mut self, position: Axes) {
        self.clear();
        self.position = position;
    }

    /// Goes on for a moment, at a share of the speeds, or slows down.
    pub fn step(&mut self, step_s: f64, share: f64, slows: bool) {
        let before = self.speed_mm_s;
        let change = ACCEL_MM_S2 * step_s;
        self.speed_mm_s = match self.moves.front() {
            None => 0.0,
            Some(_) if slows => (before - change).max(0.0),
            Some((_, most, _)) => {
                let end = (2.0 * ACCEL_MM_S2 * self.left_mm()).sqrt().max(change);
                (most * share).max(before - change).min(before + change).min(end)
            }
        };
        self.go(self.speed_mm_s * step_s);
        if self.moves.is_empty() {
            self.speed_mm_s = 0.0;
        }
        self.stands += usize::from(before > 0.0 && self.speed_mm_s == 0.0);
    }

    fn left_mm(&self) -> f64 {
        let mut from = self.position;
        let ways = self.moves.iter().map(|(to, ..)| way_mm(std::mem::replace(&mut from, *to), *to));
        ways.sum()
    }

    fn go(&mut self, way_left_mm: f64) {
        let mut by_mm = way_left_mm;
        while let Some((to, _, ticket)) = self.moves.front().copied() {
            let left_mm = way_mm(self.position, to);
            if by_mm <= 0.0 && left_mm > 0.0 {
                return;
            }
            if by_mm < left_mm {
                let share = by_mm / left_mm;
                self.position = self.position.zip(to, |from, to| from + (to - from) * share);
                return;
            }
            by_mm -= left_mm;
            (self.position, self.passed) = (to, Some(ticket));
            self.moves.pop_front();
        }
    }
}
