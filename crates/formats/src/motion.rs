//! Drawings from the motion of a program: what G-code or a part file cuts, as shapes.
//!
//! A jog ends a shape; a run of cutting moves is one shape. Moves of Z alone at a run's ends are plunge
//! and lift and are no part of it. A shape has heights when Z varies while X or Y moves; what is cut at
//! one height is flat, and the height is told (readings, P-4).

use crate::Imported;
use crate::finding::Findings;
use kerf_drawing::{Drawing, Shape};
use kerf_geom::{Point2, Polyarc, Segment, tol};
use kerf_program::{Arc, Axes, Command, Line, MoveKind, Sourced};

/// Heights that differ by less are one, millimetres.
const SAME_HEIGHT_MM: f64 = 1e-6;

/// The drawing of a program's motion, from where the machine stands at the start.
pub fn read<'a>(commands: impl IntoIterator<Item = &'a Sourced>, start: Axes) -> Imported {
    let mut drawing = Motion { at: Spot::of(&start), ..Motion::default() };
    commands.into_iter().for_each(|sourced| drawing.follow(&sourced.command));
    drawing.lift();
    let mut findings = Findings::default();
    for z in drawing.levels.iter().take(MOST_TOLD) {
        findings.note("height", 0, format!("cut at Z {z} mm"));
    }
    let drawing = Drawing::of(drawing.shapes);
    let mut read = Imported { drawing, findings: findings.finish(), ..Imported::default() };
    read.heighten();
    read
}

/// Heights that are told.
const MOST_TOLD: usize = 5;

/// A place of the tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Spot {
    at: Point2,
    z: f64,
}

impl Spot {
    fn of(axes: &Axes) -> Self {
        Self { at: Point2::new(axes.0[0], axes.0[1]), z: axes.0[2] }
    }
}

#[derive(Default)]
struct Motion {
    at: Spot,
    /// The run of cutting moves, each with the height at its end.
    run: Vec<(Segment, f64)>,
    /// The height at the start of the run.
    from_z: f64,
    shapes: Vec<Shape>,
    levels: Vec<f64>,
    /// Lines to come that are chords of an arc in another plane.
    chords: u32,
}

impl Motion {
    fn follow(&mut self, command: &Command) {
        match command {
            Command::Line(Line { kind, to, .. }) => self.line(*kind, Spot::of(to)),
            Command::Arc(arc) => self.arc(arc),
            Command::Chorded(arc) => self.chords = arc.chords,
            _ => {}
        }
    }

    fn line(&mut self, kind: MoveKind, to: Spot) {
        let from = std::mem::replace(&mut self.at, to);
        let is_chord = self.chords > 0;
        self.chords = self.chords.saturating_sub(1);
        if kind == MoveKind::Jog {
            return self.lift();
        }
        // Plunges and lifts: the next move in the plane begins a shape at the new height.
        if from.at.distance(to.at) <= tol::SAME_PLACE_MM {
            if is_chord {
                self.merge(from.z, to.z);
            } else if from.z != to.z {
                self.lift();
            }
            return;
        }
        self.cut(Segment::line(from.at, to.at), from.z, to.z);
    }

    fn arc(&mut self, arc: &Arc) {
        let to = Spot::of(&arc.to);
        let from = std::mem::replace(&mut self.at, to);
        if arc.kind == MoveKind::Jog {
            return self.lift();
        }
        let centre = Point2::new(arc.centre[0], arc.centre[1]);
        // Several turns, or one, in parts of half a turn at most.
        let parts = (arc.sweep_rad.abs() / std::f64::consts::PI).ceil().clamp(1.0, 10_000.0);
        let sweep_rad = arc.sweep_rad / parts;
        let mut start = from.at;
        for n in 1..=parts as u32 {
            let share = f64::from(n) / parts;
            let end = if share == 1.0 {
                to.at
            } else {
                centre + (from.at - centre).rotated(arc.sweep_rad * share)
            };
            let radius = start.distance(centre);
            let part = Segment::Arc { start, end, centre, radius, sweep_rad };
            let z = |share: f64| from.z + (to.z - from.z) * share;
            self.cut(part, z(f64::from(n - 1) / parts), z(share));
            start = end;
        }
    }

    /// A chord that stands upright is no plunge: where an arc is steepest its two ends become one.
    fn merge(&mut self, from_z: f64, to_z: f64) {
        let middle = 0.5 * (from_z + to_z);
        if let Some((_, z)) = self.run.last_mut() {
            *z = middle;
        }
        self.at.z = middle;
    }

    fn cut(&mut self, segment: Segment, from_z: f64, to_z: f64) {
        if self.run.is_empty() {
            self.from_z = from_z;
        }
        self.run.push((segment, to_z));
    }

    /// Ends the run of cutting moves.
    fn lift(&mut self) {
        let run = std::mem::take(&mut self.run);
        let Some((first, last)) = run.first().zip(run.last()) else { return };
        let level = run.iter().all(|(_, z)| (z - self.from_z).abs() <= SAME_HEIGHT_MM);
        let meets = first.0.start().distance(last.0.end()) <= tol::SAME_PLACE_MM;
        let closed = meets && run.len() > 1 && (last.1 - self.from_z).abs() <= SAME_HEIGHT_MM;
        let segments: Vec<Segment> = run.iter().map(|(segment, _)| *segment).collect();
        let path = Polyarc::from_segments(&segments, closed);
        if level {
            self.tell_level(self.from_z);
            return self.shapes.push(Shape::flat(path));
        }
        let heights = std::iter::once(self.from_z).chain(run.iter().map(|(_, z)| *z));
        let heights: Vec<f64> = heights.take(path.vertices.len()).collect();
        self.shapes.push(Shape::with_heights(path, heights));
    }

    fn tell_level(&mut self, z: f64) {
        if !self.levels.iter().any(|told| (told - z).abs() <= SAME_HEIGHT_MM) {
            self.levels.push(z);
        }
    }
}
