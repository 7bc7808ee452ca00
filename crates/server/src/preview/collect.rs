//! The path of a run.

use super::path::{Path, Segment};
use crate::machine::Planning;
use kerf_control::{Event, Made, Repetitions, Sink};
use kerf_diag::Diagnostic;
use kerf_motion::{Move, Path as Way};
use kerf_program::MoveKind;
use kerf_wire::preview::{CUT, GAP, JOG};

/// How far a chord may leave its arc, mm: finer than a pixel of any view.
const CHORD_MM: f64 = 0.01;
/// Most chords of a move.
const MOST: f64 = 720.0;
/// Chords of a smoothed corner.
const CURVE: f64 = 6.0;
/// The path goes on elsewhere when it jumps further than that, mm.
const JUMP_MM: f64 = 1e-3;

/// Collects moves, their times, and what was found.
#[derive(Debug)]
pub struct Collector {
    /// The path.
    pub path: Path,
    /// When each move is over.
    pub plan: Planning,
    /// What was found.
    pub findings: Vec<Diagnostic>,
    /// Findings that come again and again.
    again: Repetitions,
    at: [f64; 3],
    /// Line of the part file itself that was made last: what a file it calls does belongs to it.
    line: u32,
}

impl Collector {
    /// A path that begins at a place, machine frame.
    pub fn new(start: [f64; 3]) -> Self {
        let path = Path::new(start, CHORD_MM);
        let (plan, findings, again) = Default::default();
        Self { path, plan, findings, again, at: start, line: 0 }
    }

    /// Tells how often something was found again; nothing more comes.
    pub fn tell_rest(&mut self) {
        self.findings.extend(self.again.told());
    }

    fn clear(&mut self) {
        let made = self.plan.moves();
        self.path = Path::new(self.at, CHORD_MM);
        let gap = Segment { end_s: 0.0, line: 0, made, kind: GAP };
        self.path.push(self.at, gap);
    }

    fn follow(&mut self, made: &Made<'_>) {
        let span = made.span;
        let [t0_s, t1_s] = [span.t0_s, span.t1_s].map(|t| made.t0_s + t);
        let step = span.made;
        if step.at.file == 0 {
            self.line = step.at.line;
        }
        let number = self.plan.moves();
        let kind = if step.kind == MoveKind::Cut { CUT } else { JOG };
        let segment = |end_s: f64, kind: u8| Segment {
            end_s: end_s as f32,
            line: self.line,
            made: number,
            kind,
        };
        let from = step.from.first3();
        if jumps(self.at, from) {
            self.path.push(from, segment(t0_s, GAP));
        }
        let chords = chords(step);
        for n in 1..=chords as u32 {
            let share = f64::from(n) / chords;
            let end_s = t0_s + (t1_s - t0_s) * share;
            self.path.push(step.position(share).first3(), segment(end_s, kind));
        }
        self.at = step.to.first3();
        self.plan.add(made);
    }
}

fn jumps(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).any(|i| (a[i] - b[i]).abs() > JUMP_MM)
}

/// How many chords a move is drawn with.
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

impl Sink for Collector {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Clear { .. } => self.clear(),
            Event::Diag(found) if self.again.is_new(found) => self.findings.push((**found).clone()),
            _ => {}
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn made(&mut self, made: &Made<'_>) {
        self.follow(made);
    }
}
