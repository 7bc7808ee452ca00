//! The record that a plot is made of: the motion of a run, moment by moment, and what belongs to
//! stretches of it.

use super::curve::Curve;
use crate::scene::Unit;
use kerf_program::{AXES, Axis, MoveKind};

/// Marks of lines at most; more could not be told apart.
const MOST_LINES: usize = 20_000;

/// Speed, acceleration and jerk of something, mm or degrees and seconds.
pub type Rates = [f64; 3];

/// The motion at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moment {
    /// Machine time, seconds.
    pub t_s: f64,
    /// Way made since the start, mm.
    pub at_mm: f64,
    /// Along the path.
    pub path: Rates,
    /// Size of the acceleration in all directions, mm/s².
    pub total_accel: f64,
    /// The speed that the program asks for, mm/s; 0 while nothing moves.
    pub programmed: f64,
    /// Of every axis.
    pub axes: [Rates; AXES],
}

/// Activity of the machine in a stretch of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    /// It cuts.
    Cut,
    /// It jogs.
    Jog,
    /// It stands.
    Stand,
}

impl From<MoveKind> for Doing {
    fn from(kind: MoveKind) -> Self {
        match kind {
            MoveKind::Cut => Self::Cut,
            MoveKind::Jog => Self::Jog,
        }
    }
}

/// A place in time and along the path: seconds and mm.
pub type Place = [f64; 2];

/// A stretch from one place to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stretch {
    pub from: Place,
    pub to: Place,
    pub doing: Doing,
}

/// Curves over one abscissa.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct CurvesOverAbscissa {
    pub programmed: Curve,
    pub path: [Curve; 3],
    pub total_accel: Curve,
    pub axes: Vec<(Axis, [Curve; 3])>,
}

/// The motion of a run, ready to be drawn. Made by pushing moments in order of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Heading.
    pub title: String,
    /// A line below it: the model of motion, what was left out.
    pub note: String,
    /// The user's unit of length.
    pub unit: Unit,
    pub(super) over: [CurvesOverAbscissa; 2],
    pub(super) stretches: Vec<Stretch>,
    pub(super) lines: Vec<(Place, u32)>,
    pub(super) toolpaths: Vec<(Place, String)>,
    pub(super) start: Place,
    pub(super) end: Place,
}

impl Plot {
    /// A plot without motion, with curves of these axes beside that of the path.
    pub fn new(title: String, axes: &[Axis]) -> Self {
        let curves = || axes.iter().map(|axis| (*axis, Default::default())).collect();
        let over = || CurvesOverAbscissa { axes: curves(), ..CurvesOverAbscissa::default() };
        Self {
            title,
            note: String::new(),
            unit: Unit::MM,
            over: [over(), over()],
            stretches: Vec::new(),
            lines: Vec::new(),
            toolpaths: Vec::new(),
            start: [0.0; 2],
            end: [0.0; 2],
        }
    }

    /// The plot begins here and not at zero.
    pub fn begin(&mut self, at: Place) {
        (self.start, self.end) = (at, at);
    }

    /// The motion at a time, not before the last one.
    pub fn push(&mut self, moment: &Moment) {
        self.end = [moment.t_s, moment.at_mm];
        for (over, x) in self.over.iter_mut().zip(self.end) {
            over.push(x, moment);
        }
    }

    /// A stretch in which the machine does one thing.
    pub fn doing(&mut self, from: Place, to: Place, doing: Doing) {
        match self.stretches.last_mut() {
            Some(last) if last.doing == doing => last.to = to,
            _ => self.stretches.push(Stretch { from, to, doing }),
        }
    }

    /// A line of the program begins to move the machine.
    pub fn line(&mut self, at: Place, line: u32) {
        let same = self.lines.last().is_some_and(|(_, last)| *last == line);
        if !same && self.lines.len() < MOST_LINES {
            self.lines.push((at, line));
        }
    }

    /// A tool path begins. One that begins where the last did names it more closely, and one of
    /// the same name goes on with it.
    pub fn toolpath(&mut self, at: Place, name: String) {
        match self.toolpaths.last_mut() {
            Some((_, last)) if *last == name => {}
            Some((place, last)) if *place == at => *last = format!("{last} · {name}"),
            _ => self.toolpaths.push((at, name)),
        }
    }
}

impl CurvesOverAbscissa {
    fn push(&mut self, x: f64, moment: &Moment) {
        self.programmed.push(x, moment.programmed);
        self.total_accel.push(x, moment.total_accel);
        for (curve, y) in self.path.iter_mut().zip(moment.path) {
            curve.push(x, y);
        }
        for (axis, curves) in &mut self.axes {
            for (curve, y) in curves.iter_mut().zip(moment.axes[axis.index()]) {
                curve.push(x, y);
            }
        }
    }
}
