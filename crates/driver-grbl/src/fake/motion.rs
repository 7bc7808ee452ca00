//! The motion of the fake: along the moves of its planner, as fast as it can still slow down for what lies
//! ahead.

use kerf_machine::driver::{Axes, way_mm};
use std::collections::VecDeque;

/// Acceleration where its settings name none, mm/s².
const ACCEL_MM_S2: f64 = 400.0;

/// A move leaves the planner so long before its end, seconds.
const SEGMENTS_S: f64 = 0.05;

#[derive(Clone, Copy, Debug)]
struct Block {
    to: Axes,
    way: Axes,
    length_mm: f64,
    speed_mm_s: f64,
    /// Acceleration along it, mm/s².
    accel_mm_s2: f64,
    /// It is a rapid move.
    rapid: bool,
    /// The number of its line.
    line: u32,
    /// The speed at which it may begin.
    entry_mm_s: f64,
}

/// Moves of the planner, and the state of the motion.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    /// Moves that the planner holds.
    holds: usize,
    /// What the axes can do, mm/s²: `$120` and those behind it.
    pub accel_mm_s2: [f64; 3],
    /// Distance by which a corner may be cut in thought, mm: the larger this is, the faster the corner is passed (`$11`).
    pub junction_mm: f64,
    blocks: VecDeque<Block>,
    pub position: Axes,
    pub speed_mm_s: f64,
    /// The share of their speed at which moves are made, and that of rapid moves.
    pub feed: f64,
    pub rapid: f64,
    pub held: bool,
    pub stands: usize,
    pub rests: Vec<Axes>,
    pub way_mm: f64,
}

impl Motion {
    /// A machine at zero whose planner holds so many moves.
    pub fn new(holds: usize) -> Self {
        Self { holds, feed: 1.0, rapid: 1.0, ..Self::default() }
    }

    /// A straight move joins the row; none when it is shorter than a step.
    pub fn push(&mut self, from: Axes, to: Axes, speed_mm_s: f64, (rapid, line): (bool, u32)) {
        let length_mm = way_mm(from, to);
        if length_mm < 0.002 {
            return;
        }
        let way = to.minus(from);
        let way = Axes(way.0.map(|v| v / length_mm));
        let before = self.blocks.back();
        let entry_mm_s = before.map_or(0.0, |before| self.corner(before, way).min(speed_mm_s));
        let accel_mm_s2 = self.along(way);
        self.blocks.push_back(Block {
            to,
            way,
            length_mm,
            speed_mm_s,
            accel_mm_s2,
            rapid,
            line,
            entry_mm_s,
        });
    }

    /// The acceleration along a way at which no axis exceeds its own, mm/s².
    fn along(&self, way: Axes) -> f64 {
        let axes = self.accel_mm_s2.iter().zip(way.0).filter(|(_, share)| share.abs() > 1e-9);
        let most = axes.map(|(own, share)| own / share.abs()).fold(f64::INFINITY, f64::min);
        if most.is_finite() && most > 0.0 { most } else { ACCEL_MM_S2 }
    }

    /// Returns the speed at which the corner between a move and the next one may be passed.
    fn corner(&self, before: &Block, way: Axes) -> f64 {
        let cosine: f64 = before.way.0.iter().zip(way.0).map(|(a, b)| a * b).sum();
        let half_sine = ((1.0 + cosine) / 2.0).max(0.0).sqrt();
        if half_sine > 0.999_999 {
            return before.speed_mm_s;
        }
        let change = way.minus(before.way);
        let size = change.0.iter().map(|v| v * v).sum::<f64>().sqrt();
        let accel = self.along(Axes(change.0.map(|v| v / size)));
        (accel * self.junction_mm * half_sine / (1.0 - half_sine)).sqrt().min(before.speed_mm_s)
    }

    /// Returns `true` if nothing is left to make.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// For how many moves there is room.
    pub fn free(&self) -> usize {
        (self.holds + self.cut()).saturating_sub(self.blocks.len()).min(self.holds)
    }

    /// The number of the line whose move is first in the planner; 0 where it has none.
    pub fn line(&self) -> u32 {
        self.blocks.get(self.cut()).map_or(0, |block| block.line)
    }

    /// Moves that are out of the planner and not made.
    fn cut(&self) -> usize {
        let mut ahead_mm = 0.0;
        let cut = self.blocks.iter().take_while(|block| {
            ahead_mm += left(block, self.position).min(block.length_mm);
            ahead_mm <= self.speed_mm_s * SEGMENTS_S
        });
        cut.count()
    }

    /// Nothing is left.
    pub fn clear(&mut self) {
        self.blocks.clear();
        self.speed_mm_s = 0.0;
    }

    /// It stands elsewhere.
    pub fn put(&mut self, position: Axes) {
        self.clear();
        self.position = position;
    }

    /// Goes on for a moment.
    pub fn step(&mut self, step_s: f64) {
        let before = self.speed_mm_s;
        self.speed_mm_s = self.next_speed(step_s);
        let mut by = self.speed_mm_s * step_s;
        self.way_mm += by;
        while by > 0.0
            && let Some(first) = self.blocks.front()
        {
            let left = left(first, self.position);
            if by < left {
                let way = first.way;
                self.position = self.position.zip(way, |place, way| place + way * by);
                break;
            }
            by -= left;
            self.position = first.to;
            self.blocks.pop_front();
        }
        if self.blocks.is_empty() {
            self.speed_mm_s = 0.0;
        }
        if before > 0.0 && self.speed_mm_s == 0.0 {
            self.stands += 1;
            self.rests.push(self.position);
        }
    }

    /// As fast as wanted, gained or lost steadily, slow enough for every corner and for the end.
    fn next_speed(&self, step_s: f64) -> f64 {
        let Some(first) = self.blocks.front() else { return 0.0 };
        let change = first.accel_mm_s2 * step_s;
        if self.held {
            return (self.speed_mm_s - change).max(0.0);
        }
        let share = if first.rapid { self.rapid } else { self.feed };
        let most = (first.speed_mm_s * share).max(self.speed_mm_s - change);
        let most = most.min(self.speed_mm_s + change);
        // What is behind those that the planner holds was not there yet when the segments of this moment were cut.
        let known = self.blocks.iter().take(self.holds).skip(1);
        let exit_sqr = known.rev().fold(0.0, |exit_sqr: f64, block| {
            (exit_sqr + 2.0 * block.accel_mm_s2 * block.length_mm).min(block.entry_mm_s.powi(2))
        });
        let brakes_sqr = exit_sqr + 2.0 * first.accel_mm_s2 * left(first, self.position);
        most.min(brakes_sqr.sqrt()).max(change)
    }
}

fn left(block: &Block, position: Axes) -> f64 {
    way_mm(position, block.to)
}
