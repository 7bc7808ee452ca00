//! The motion of a scene while it is gathered: a long one is thinned, so that memory and page stay bounded.
//!
//! ```text
//!   a──b──c─╮            a─────────╮
//!           d──e   ──►             e      b, c and d lie within the tolerance of the line from a to e
//! ```
//!
//! Whenever there are too many segments, straight ones of one kind that follow each other become one where the
//! ends between them lie within a tolerance of it; the tolerance grows until that is enough. What was merged
//! may be merged again, so a place of the path is at most twice the last tolerance away.

use crate::scene::{Segment, Shape};

/// More segments are thinned: with their times and the page made of them some 60 MB.
const MOST_SEGMENTS: usize = 400_000;
/// The first tolerance, mm: a thousandth of what a page shows of a small part.
const FINEST_MM: f64 = 0.001;
/// So many segments at most become one in a pass.
const WINDOW: usize = 16;
/// A pass that leaves more than this share has found nothing to merge.
const WORTH: f64 = 0.95;
/// Tolerances beyond this would show another part, mm.
const COARSEST_MM: f64 = 1.0;

/// Segments with their times, in order.
#[derive(Clone, Debug)]
pub struct Trail {
    /// The segments.
    pub segments: Vec<Segment>,
    /// End of each segment, seconds.
    pub times_s: Vec<f32>,
    /// Places of the rotary axis at the start and the end of each segment, degrees.
    pub turns_deg: Vec<[f32; 2]>,
    /// The number of the move that each begins with, from 0.
    moves: Vec<u32>,
    made: u32,
    most: usize,
    tolerance_mm: f64,
}

impl Default for Trail {
    fn default() -> Self {
        Self::of_at_most(MOST_SEGMENTS)
    }
}

impl Trail {
    /// An empty one that is thinned beyond so many segments.
    pub fn of_at_most(most: usize) -> Self {
        let (segments, times_s, turns_deg) = (Vec::new(), Vec::new(), Vec::new());
        Self { segments, times_s, turns_deg, moves: Vec::new(), made: 0, most, tolerance_mm: 0.0 }
    }

    /// Adds a move.
    pub fn push(&mut self, segment: Segment, time_s: f32, turn_deg: [f32; 2]) {
        if self.segments.len() >= self.most {
            self.thin();
        }
        self.segments.push(segment);
        self.times_s.push(time_s);
        self.turns_deg.push(turn_deg);
        self.moves.push(self.made);
        self.made += 1;
    }

    /// Forgets what was gathered; moves go on being counted.
    pub fn clear(&mut self) {
        let (made, most) = (self.made, self.most);
        *self = Self { made, ..Self::of_at_most(most) };
    }

    /// The segment of a move, counted from 0 over all that was added.
    pub fn segment_of(&self, number: u32) -> usize {
        if number >= self.made {
            return self.segments.len();
        }
        let behind = self.moves.partition_point(|first| *first <= number);
        behind.saturating_sub(1)
    }

    /// Returns how far a place may lie from the path that was made, mm; 0 when nothing was thinned.
    pub fn tolerance_mm(&self) -> f64 {
        2.0 * self.tolerance_mm
    }

    /// Returns the number of moves that were added.
    pub const fn moves(&self) -> u32 {
        self.made
    }

    /// Merges until a quarter of the room is free, or nothing more is found: then more room is taken.
    fn thin(&mut self) {
        let wanted = self.most - self.most / 4;
        while self.segments.len() > wanted {
            let before = self.segments.len();
            let next_mm = if self.tolerance_mm > 0.0 { self.tolerance_mm } else { FINEST_MM };
            self.pass(next_mm);
            self.tolerance_mm = next_mm;
            if self.segments.len() as f64 > before as f64 * WORTH {
                if next_mm >= COARSEST_MM {
                    self.most *= 2;
                    return;
                }
                self.tolerance_mm = next_mm * 2.0;
            }
        }
    }

    fn pass(&mut self, tolerance_mm: f64) {
        let (mut kept, mut start) = (0, 0);
        while start < self.segments.len() {
            let end = self.reach(start, tolerance_mm);
            let first = self.segments[start];
            let last = self.segments[end - 1];
            let turn = [self.turns_deg[start][0], self.turns_deg[end - 1][1]];
            let one = end == start + 1;
            self.segments[kept] = if one { first } else { Segment { from: first.from, ..last } };
            self.times_s[kept] = self.times_s[end - 1];
            self.turns_deg[kept] = turn;
            self.moves[kept] = self.moves[start];
            kept += 1;
            start = end;
        }
        self.segments.truncate(kept);
        self.times_s.truncate(kept);
        self.turns_deg.truncate(kept);
        self.moves.truncate(kept);
    }

    /// Behind the last segment that may become one with those from `start` on.
    fn reach(&self, start: usize, tolerance_mm: f64) -> usize {
        let first = &self.segments[start];
        let most = (start + WINDOW).min(self.segments.len());
        let mut end = start + 1;
        while end < most && self.joins(end) {
            let to = self.segments[end].to;
            let mut between = self.segments[start..end].iter();
            if !between.all(|s| off_line(s.to, first.from, to) <= tolerance_mm) {
                break;
            }
            end += 1;
        }
        end
    }

    /// Returns `true` if a segment goes on straight on as the one before it does: of one kind, without a gap or a turn.
    fn joins(&self, at: usize) -> bool {
        let (before, here) = (&self.segments[at - 1], &self.segments[at]);
        let straight = before.shape == Shape::Line && here.shape == Shape::Line;
        let [turn, turned] = [self.turns_deg[at - 1], self.turns_deg[at]];
        let still = turn[0] == turn[1] && turned == turn;
        straight
            && still
            && before.kind == here.kind
            && before.to == here.from
            && here.is_drawable()
    }
}

/// The distance of a place from the line between two others.
fn off_line(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let sub = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (way, place) = (sub(b, a), sub(p, a));
    let length = dot(way, way);
    let share = if length > 0.0 { (dot(place, way) / length).clamp(0.0, 1.0) } else { 0.0 };
    let off = sub(place, way.map(|w| w * share));
    dot(off, off).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::MoveKind;

    fn trail(points: impl Iterator<Item = [f64; 3]>, most: usize) -> Trail {
        let mut trail = Trail::of_at_most(most);
        let mut from = [0.0; 3];
        for (n, to) in points.enumerate() {
            let line = n as u32 + 1;
            let segment = Segment { kind: MoveKind::Cut, from, to, shape: Shape::Line, line };
            trail.push(segment, line as f32, [0.0; 2]);
            from = to;
        }
        trail
    }

    #[test]
    fn a_long_path_is_thinned_within_its_tolerance() {
        // A circle of 50 mm in 100,000 pieces.
        let place = |n: u32| {
            let angle = f64::from(n) / 1e5 * std::f64::consts::TAU;
            [50.0 * angle.sin(), 50.0 - 50.0 * angle.cos(), 0.0]
        };
        let trail = trail((1..=100_000).map(place), 1000);
        assert!(
            trail.segments.len() <= 1000 && trail.moves() == 100_000,
            "{}",
            trail.segments.len()
        );
        let off = trail.tolerance_mm();
        assert!(off > 0.0 && off < 0.1, "{off}");
        for n in (1..=100_000_u32).step_by(97) {
            let segment = &trail.segments[trail.segment_of(n - 1)];
            assert!(off_line(place(n), segment.from, segment.to) <= off, "{n}");
        }
        // Nothing of the path is missing, and the ends are those of the program.
        assert!(trail.segments.windows(2).all(|pair| pair[0].to == pair[1].from));
        let last = trail.segments.last().map(|s| (s.to, s.line));
        assert_eq!(last, Some((place(100_000), 100_000)));
        assert_eq!(trail.times_s.last(), Some(&100_000.0));
    }

    #[test]
    fn a_short_path_and_corners_stay() {
        let zigzag = |n: u32| [f64::from(n), f64::from(n % 2) * 10.0, 0.0];
        let short = trail((1..=900).map(zigzag), 1000);
        assert_eq!((short.segments.len(), short.tolerance_mm()), (900, 0.0));
        // Nothing can be merged: more room is taken.
        let long = trail((1..=5000).map(zigzag), 1000);
        assert_eq!(long.segments.len(), 5000);
        assert_eq!(long.segment_of(4321), 4321);
    }
}
