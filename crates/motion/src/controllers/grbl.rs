//! grbl 1.1 and what follows it: trapezoids of speed, corners by junction deviation, a short
//! look-ahead, arcs cut into chords on board, fed over a serial line.
//!
//! Formulas from grbl's own documentation and source notes (version 1.1): the speed at a corner
//! between directions a and b is v² = A·δ·s/(1 − s), where δ is the junction deviation, s the sine of
//! half the angle between the legs, and A the acceleration that the axes allow along b − a. It is the
//! speed on a circle that touches both legs and passes the corner at the distance δ; the tool
//! follows the legs all the same, and its velocity jumps at the corner. An arc of radius r and angle
//! φ becomes ⌊φ·r / 2√(t·(2r − t))⌋ chords for the arc tolerance t.
//!
//! What is simulated, block by block: when the block's line has arrived and there was room for it;
//! the highest entry speed of each block in the buffer such that the machine can stand at the end of
//! the last; the trapezoid that follows.

use super::Controller;
use super::block::{Direction, feed_mm_s, trapezoid_s, way, within_axes};
use super::link::{Line, Link};
use crate::moves::{Move, Path};
use kerf_geom::Arc2;
use kerf_program::{AXES, Axes, MoveKind};

/// Decimals of coordinates in the lines sent.
const DECIMALS: usize = 3;
/// Chords of one arc at most.
const MOST_CHORDS: f64 = 1e5;

/// A grbl board and its settings; defaults are those of version 1.1 where it has any.
#[derive(Clone, Debug, PartialEq)]
pub struct Grbl {
    /// `$110` to `$112`, mm/s.
    pub speed_mm_s: Axes,
    /// `$120` to `$122`, mm/s².
    pub accel_mm_s2: Axes,
    /// `$11`, mm.
    pub junction_deviation_mm: f64,
    /// `$12`, mm.
    pub arc_tolerance_mm: f64,
    /// Blocks of the planner's buffer, of which one stays free.
    pub blocks: usize,
    /// The line that feeds it; `None` when lines are there at once.
    pub link: Option<Link>,
}

impl Grbl {
    /// With speeds and accelerations of the axes.
    pub fn new(speed_mm_s: Axes, accel_mm_s2: Axes) -> Self {
        Self {
            speed_mm_s,
            accel_mm_s2,
            junction_deviation_mm: 0.01,
            arc_tolerance_mm: 0.002,
            blocks: 16,
            link: Some(Link::default()),
        }
    }
}

/// A straight piece in the planner's buffer.
#[derive(Clone, Copy, Debug)]
struct Block {
    /// The move it belongs to.
    owner: usize,
    mm: f64,
    top_mm_s: f64,
    accel: f64,
    /// The square of the speed at which the corner before it may be passed.
    corner_sqr: f64,
    /// Bytes of the line that begins with it.
    bytes: usize,
}

impl Controller for Grbl {
    fn seconds(&self, run: &[Move]) -> Vec<f64> {
        let blocks = self.blocks_of(run);
        let mut seconds = vec![0.0; run.len()];
        let mut before_s = 0.0;
        for (block, end_s) in blocks.iter().zip(self.ends_s(&blocks)) {
            seconds[block.owner] += end_s - before_s;
            before_s = end_s;
        }
        seconds
    }
}

impl Grbl {
    fn blocks_of(&self, run: &[Move]) -> Vec<Block> {
        let mut blocks: Vec<Block> = Vec::with_capacity(run.len());
        let mut before: Option<Direction> = None;
        let mut words = Words::default();
        for (owner, m) in run.iter().enumerate() {
            let feed = feed_mm_s(m);
            let mut bytes = words.bytes(m, feed);
            let chords = self.chords(m);
            let mut from = m.from;
            for k in 1..=chords {
                let to = m.position(f64::from(k) / f64::from(chords));
                let Some((way, mm)) = way(from, to) else { continue };
                let top_mm_s = feed.min(within_axes(&self.speed_mm_s, &way));
                let accel = within_axes(&self.accel_mm_s2, &way);
                let slower = blocks.last().map_or(0.0, |b| b.top_mm_s.min(top_mm_s));
                let corner = before.map_or(0.0, |before| self.corner_sqr(&before, &way));
                let corner_sqr = corner.min(slower * slower);
                blocks.push(Block { owner, mm, top_mm_s, accel, corner_sqr, bytes });
                (from, before, bytes) = (to, Some(way), 0);
            }
        }
        blocks
    }

    /// The square of the speed at which a corner may be passed.
    fn corner_sqr(&self, a: &Direction, b: &Direction) -> f64 {
        let cos = -a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        if cos > 0.999_999 {
            return 0.0;
        }
        if cos < -0.999_999 {
            return f64::INFINITY;
        }
        let change: Direction = std::array::from_fn(|k| b[k] - a[k]);
        let size = change.iter().map(|v| v * v).sum::<f64>().sqrt();
        let accel = within_axes(&self.accel_mm_s2, &change.map(|v| v / size));
        let sine = (0.5 * (1.0 - cos)).sqrt();
        accel * self.junction_deviation_mm * sine / (1.0 - sine)
    }

    fn chords(&self, m: &Move) -> u32 {
        match m.path {
            Path::Line | Path::Curve { .. } => 1,
            Path::Arc { .. } => m.arc().map_or(1, |arc| self.chords_of(arc)),
        }
    }

    fn chords_of(&self, arc: Arc2) -> u32 {
        let (length, tolerance) = (arc.length(), self.arc_tolerance_mm);
        let radius = length / arc.sweep_rad.abs();
        let reach = (tolerance * (2.0 * radius - tolerance)).max(0.0).sqrt();
        (0.5 * length / reach).floor().clamp(1.0, MOST_CHORDS) as u32
    }

    /// Computes the time at which each block is made, seconds.
    fn ends_s(&self, blocks: &[Block]) -> Vec<f64> {
        let room = self.blocks.max(2) - 1;
        let (mut ends, mut known) = (Vec::with_capacity(blocks.len()), Vec::new());
        let mut line = Line::new(self.link);
        let (mut now_s, mut entry_sqr) = (0.0f64, 0.0);
        for (k, block) in blocks.iter().enumerate() {
            while known.len() < blocks.len().min(k + room) {
                known.push(self.read_s(blocks, &known, &ends, &mut line));
            }
            now_s = now_s.max(known[k]);
            let reach_sqr = entry_sqr + 2.0 * block.accel * block.mm;
            let fastest_sqr = reach_sqr.min(block.top_mm_s * block.top_mm_s);
            let [top, accel] = [block.top_mm_s, block.accel];
            // What arrives later than this comes too late to be counted on.
            let free_s = trapezoid_s(block.mm, entry_sqr, fastest_sqr, top, accel);
            let in_time = known[k + 1..].iter().take_while(|t| **t <= now_s + free_s);
            let exit_sqr = entry(&blocks[k + 1..k + 1 + in_time.count()]).min(reach_sqr);
            now_s += trapezoid_s(block.mm, entry_sqr, exit_sqr, top, accel);
            entry_sqr = exit_sqr;
            ends.push(now_s);
        }
        ends
    }

    /// Returns the time at which the next block gets into the buffer.
    fn read_s(&self, blocks: &[Block], known: &[f64], ends: &[f64], line: &mut Line) -> f64 {
        let (next, room) = (known.len(), self.blocks.max(2) - 1);
        let freed_s = next.checked_sub(room).and_then(|k| ends.get(k)).copied().unwrap_or(0.0);
        let before_s = known.last().copied().unwrap_or(0.0);
        let bytes = blocks[next].bytes;
        if bytes == 0 {
            return before_s.max(freed_s);
        }
        let read_s = line.arrival_s(bytes).max(before_s).max(freed_s);
        line.read(bytes, read_s);
        read_s
    }
}

/// The square of the highest speed at which blocks may be entered so that the machine can stand at
/// the end of the last; none are entered at 0.
fn entry(blocks: &[Block]) -> f64 {
    blocks.iter().rev().fold(0.0, |exit: f64, b| b.corner_sqr.min(exit + 2.0 * b.accel * b.mm))
}

/// Words that were sent last, so that lines say only what is new.
#[derive(Default)]
struct Words {
    motion: u8,
    feed: Option<f64>,
}

impl Words {
    /// Bytes of a move's line: words that change, coordinates with three decimals, end of line.
    fn bytes(&mut self, m: &Move, feed_mm_s: f64) -> usize {
        let motion = match (m.kind, m.path) {
            (_, Path::Arc { sweep_rad, .. }) => 2 + u8::from(sweep_rad > 0.0),
            (MoveKind::Jog, _) => 0,
            (MoveKind::Cut, _) => 1,
        };
        let number = |v: f64| 1 + format!("{v:.DECIMALS$}").len();
        let moved = (0..AXES).filter(|k| m.from.0[*k] != m.to.0[*k]);
        let mut bytes = 1 + moved.map(|k| number(m.to.0[k])).sum::<usize>();
        if let Path::Arc { centre, .. } = m.path {
            bytes += number(centre[0] - m.from.0[0]) + number(centre[1] - m.from.0[1]);
        }
        if std::mem::replace(&mut self.motion, motion) != motion || bytes == 1 {
            bytes += 2;
        }
        if feed_mm_s.is_finite() && self.feed.replace(feed_mm_s) != Some(feed_mm_s) {
            bytes += 1 + format!("{:.0}", feed_mm_s * 60.0).len();
        }
        bytes
    }
}
