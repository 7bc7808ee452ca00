//! Draws moves into a path.

use super::path::{Path, Segment};
use super::rotary;
use kerf_motion::{Move, Path as Way};
use kerf_program::{Axis, MoveKind};
use kerf_trace::ExecutedMove;
use kerf_wire::preview::{CUT, GAP, JOG};

/// Greatest distance of a chord from its arc, mm: finer than a pixel of any view.
const CHORD_MM: f64 = 0.01;
/// Most chords of a move.
const MOST: f64 = 720.0;
/// Chords of a smoothed corner.
const CURVE: f64 = 6.0;
/// The path goes on elsewhere when it jumps further than that, mm.
const JUMP_MM: f64 = 1e-3;

/// A path that grows by moves.
#[derive(Debug)]
pub struct Pen {
    /// The path.
    pub path: Path,
    /// Angle by which the work has turned at each vertex, degrees; nothing where no axis turns it.
    pub turns_deg: Option<Vec<f32>>,
    at: [f64; 3],
}

impl Pen {
    /// A path that begins at a place, machine frame.
    pub fn new(start: [f64; 3]) -> Self {
        Self { path: Path::new(start, CHORD_MM), turns_deg: None, at: start }
    }

    /// The same, of work that an axis turns.
    pub fn rotary(start: [f64; 3], turn_deg: f64) -> Self {
        Self { turns_deg: Some(vec![turn_deg as f32]), ..Self::new(start) }
    }

    /// Begins anew where it is, behind so many moves.
    pub fn clear(&mut self, made: u32) {
        self.path = Path::new(self.at, CHORD_MM);
        let turn_deg = self.turns_deg.as_ref().and_then(|turns| turns.last()).copied();
        self.turns_deg = turn_deg.map(|turn| vec![turn]);
        let gap = Segment { end_s: 0.0, line: 0, made, kind: GAP };
        self.push(self.at, turn_deg.map_or(0.0, f64::from), gap);
    }

    fn push(&mut self, to: [f64; 3], turn_deg: f64, segment: Segment) {
        self.path.push(to, segment);
        if let Some(turns) = &mut self.turns_deg {
            turns.push(turn_deg as f32);
        }
    }

    /// Draws a move, as one of a line and with its number.
    pub fn follow(&mut self, made: &ExecutedMove<'_>, line: u32, number: u32) {
        let span = made.span;
        let [t0_s, t1_s] = [span.t0_s, span.t1_s].map(|t| made.t0_s + t);
        let step = span.made;
        let kind = if step.kind == MoveKind::Cut { CUT } else { JOG };
        let segment =
            |end_s: f64, kind: u8| Segment { end_s: end_s as f32, line, made: number, kind };
        let from = step.from.first3();
        if jumps(self.at, from) {
            self.push(from, step.from[Axis::B], segment(t0_s, GAP));
        }
        let turned = self.turns_deg.as_ref().map_or(0.0, |_| step.to[Axis::B] - step.from[Axis::B]);
        let chords = chords(step).max(rotary::chords(turned));
        for n in 1..=chords as u32 {
            let share = f64::from(n) / chords;
            let end_s = t0_s + (t1_s - t0_s) * share;
            let place = step.position(share);
            self.push(place.first3(), place[Axis::B], segment(end_s, kind));
        }
        self.at = step.to.first3();
    }
}

fn jumps(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).any(|i| (a[i] - b[i]).abs() > JUMP_MM)
}

/// Returns the number of chords that a move is drawn with.
fn chords(step: &Move) -> f64 {
    match step.path {
        Way::Line => 1.0,
        Way::Curve { .. } => CURVE,
        Way::Arc { centre, sweep_rad, .. } => {
            let [x, y, _] = step.from.first3();
            let radius = (x - centre[0]).hypot(y - centre[1]).max(CHORD_MM);
            let each_rad = 2.0 * (1.0 - CHORD_MM / radius).acos().max(0.05);
            (sweep_rad.abs() / each_rad).ceil().clamp(2.0, MOST)
        }
    }
}
