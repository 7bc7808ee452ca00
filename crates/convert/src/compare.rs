//! Checks that two programs move the tool the same way.
//!
//! Every conversion is read back and compared with what the source does, so that a file that would
//! move otherwise is never handed out. Lines have to be lines to the same places, arcs have to be
//! arcs on the same circle; they may come in several parts.

use kerf_program::{Arc, At, Axes, Axis, Chorded, Command, Line, MoveKind, Sourced};

/// Greatest distance between places that count as one, mm or degrees.
pub const SAME_MM: f64 = 1e-6;
/// Greatest distance of chords from an arc that could not stay one, mm.
const CHORD_MM: f64 = 0.0051;
/// Greatest distance between the centres of arcs in other planes, mm: what rounding its words makes.
const CENTRE_MM: f64 = 2e-5;
/// Greatest difference between the angles of such arcs, radians.
const TURN_RAD: f64 = 1e-4;
/// Arcs with nearer ends than this may have become lines, mm.
const SHORT_MM: f64 = 4e-4;

/// Place where two programs part.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The line of the first program.
    pub at: At,
    /// The line of the second one, 0 when it has nothing more.
    pub line: u32,
    /// Difference, in words.
    pub what: String,
}

/// Options of a comparison.
#[derive(Clone, Copy, Debug)]
pub struct Comparing {
    /// Place where both begin.
    pub start: Axes,
    /// Motions of tool changes are left out: they are each machine's own.
    pub own_tool_changes: bool,
    /// Greatest distance between places that count as one, mm or degrees.
    pub same_mm: f64,
    /// Arcs beside which other axes turn are chords in the second program.
    pub chords: bool,
}

/// Compares what two programs do.
///
/// # Errors
/// The first place where the second moves otherwise.
pub fn same_motion<'a>(
    first: impl Iterator<Item = &'a Sourced>,
    second: impl Iterator<Item = &'a Sourced>,
    how: Comparing,
) -> Result<(), Difference> {
    let second = Motions::new(second, how);
    let mut pair = Pair { second, kept: None, here: how.start, how, raised: false };
    let mut first = Motions::new(first, how);
    while let Some((at, _, motion)) = first.next() {
        let compared = match (first.chorded.take(), pair.next_chorded()) {
            (Some(arc), Some(other)) => {
                for _ in 1..arc.chords {
                    first.next();
                }
                pair.chorded(&arc, &other)
            }
            _ => pair.follow(&motion),
        };
        compared.map_err(|what| Difference { at, line: pair.second.last, what })?;
    }
    let last = At { file: 0, line: first.last };
    match pair.more() {
        None => Ok(()),
        Some((_, motion)) => {
            let what = format!("one more motion to {}", place(motion.to()));
            Err(Difference { at: last, line: pair.second.last, what })
        }
    }
}

/// A motion that goes somewhere.
#[derive(Clone, Copy, Debug)]
enum Motion {
    Line(Line),
    Arc(Arc),
}

impl Motion {
    const fn to(&self) -> Axes {
        match self {
            Self::Line(line) => line.to,
            Self::Arc(arc) => arc.to,
        }
    }
}

/// The motions of a program one after the other.
struct Motions<I> {
    commands: I,
    here: Axes,
    /// Motions of tool changes are left out.
    own: bool,
    same_mm: f64,
    changing: bool,
    /// A tool was changed since the last motion.
    changed: bool,
    /// Line of the last motion.
    last: u32,
    /// The arc whose first chord the last motion is.
    chorded: Option<Chorded>,
}

impl<'a, I: Iterator<Item = &'a Sourced>> Motions<I> {
    const fn new(commands: I, how: Comparing) -> Self {
        let (here, own) = (how.start, how.own_tool_changes);
        Self {
            commands,
            here,
            own,
            same_mm: how.same_mm,
            changing: false,
            changed: false,
            last: 0,
            chorded: None,
        }
    }

    /// The next motion: its line, where it begins, what it is.
    fn next(&mut self) -> Option<(At, Axes, Motion)> {
        loop {
            let sourced = self.commands.next()?;
            let motion = match &sourced.command {
                Command::Line(line) => Motion::Line(*line),
                Command::Arc(arc) => Motion::Arc(*arc),
                Command::Chorded(arc) => {
                    self.chorded = Some(*arc);
                    continue;
                }
                Command::ToolChange { begin } => {
                    self.changing = self.own && *begin;
                    self.changed |= self.own && !*begin;
                    continue;
                }
                _ => continue,
            };
            let still = matches!(motion, Motion::Line(_))
                && near_within(self.here, motion.to(), self.same_mm);
            if still {
                continue;
            }
            let from = std::mem::replace(&mut self.here, motion.to());
            if !self.changing {
                self.last = sourced.at.line;
                return Some((sourced.at, from, motion));
            }
        }
    }
}

struct Pair<I> {
    second: Motions<I>,
    /// A motion of the second that was looked at and is still to be compared.
    kept: Option<(Axes, Motion)>,
    /// Place of the first program.
    here: Axes,
    how: Comparing,
    /// The second may stand higher, behind a change of tools.
    raised: bool,
}

impl<'a, I: Iterator<Item = &'a Sourced>> Pair<I> {
    fn next(&mut self) -> Option<(Axes, Motion)> {
        if let Some(kept) = self.kept.take() {
            return Some(kept);
        }
        let next = self.second.next();
        self.raised |= std::mem::take(&mut self.second.changed);
        next.map(|(_, from, motion)| (from, motion))
    }

    /// Returns the motion that the second makes more than the first. That it comes down again from where a
    /// change of tools has lifted it is no more.
    fn more(&mut self) -> Option<(Axes, Motion)> {
        loop {
            let (began, motion) = self.next()?;
            let comes_back = self.raised && self.near(motion.to(), self.here);
            if !comes_back {
                return Some((began, motion));
            }
        }
    }

    /// The arc that the next motions are chords of.
    fn next_chorded(&mut self) -> Option<Chorded> {
        if self.kept.is_none() {
            self.kept = self.next();
        }
        self.second.chorded.take()
    }

    /// An arc of another plane that stayed one.
    fn chorded(&mut self, arc: &Chorded, other: &Chorded) -> Result<(), String> {
        for _ in 0..other.chords {
            self.next();
        }
        self.here = arc.to;
        let centres = (arc.centre[0] - other.centre[0]).hypot(arc.centre[1] - other.centre[1]);
        let same = arc.axes == other.axes
            && centres <= CENTRE_MM
            && (arc.sweep_rad - other.sweep_rad).abs() <= TURN_RAD
            && self.near(arc.to, other.to);
        if same { Ok(()) } else { Err(format!("an arc to {} became another one", place(arc.to))) }
    }

    fn close(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.how.same_mm
    }

    fn near(&self, a: Axes, b: Axes) -> bool {
        near_within(a, b, self.how.same_mm)
    }

    fn follow(&mut self, motion: &Motion) -> Result<(), String> {
        let from = std::mem::replace(&mut self.here, motion.to());
        match motion {
            Motion::Line(line) => self.line(line, from),
            Motion::Arc(arc) => self.arc(arc, from),
        }
    }

    fn line(&mut self, line: &Line, from: Axes) -> Result<(), String> {
        loop {
            let next = self.next();
            let began = next.map_or(self.second.here, |(began, _)| began);
            if self.raised && self.near(began, line.to) {
                // The change of tools has lifted it there already.
                (self.kept, self.raised) = (next, false);
                return Ok(());
            }
            let Some((_, Motion::Line(other))) = next else {
                return Err(format!("no line to {}", place(line.to)));
            };
            if self.raised {
                let lifts = (0..6).all(|i| i == 2 || self.close(began.0[i], other.to.0[i]));
                let comes_down = lifts && self.close(other.to.0[2], from.0[2]);
                if comes_down && !self.near(line.to, other.to) {
                    self.raised = false;
                    continue;
                }
                let beside = (0..6).all(|i| i == 2 || self.close(line.to.0[i], other.to.0[i]));
                if beside && line.kind == MoveKind::Jog && other.kind == MoveKind::Jog {
                    self.raised = !self.close(line.to.0[2], other.to.0[2]);
                    return Ok(());
                }
            }
            self.raised &= !self.close(line.to.0[2], other.to.0[2]);
            if !self.near(line.to, other.to) {
                return Err(format!("{} became {}", place(line.to), place(other.to)));
            }
            if line.kind != other.kind {
                return Err("a jog became a cut, or a cut a jog".into());
            }
            return Ok(());
        }
    }

    fn arc(&mut self, arc: &Arc, from: Axes) -> Result<(), String> {
        let circle = Circle::new(arc, from, self.how.same_mm);
        let short = circle.chord < SHORT_MM && arc.sweep_rad.abs() < 2.0;
        if short && self.near(from, arc.to) {
            return Ok(());
        }
        let mut left = arc.sweep_rad.abs();
        loop {
            let Some((began, next)) = self.next() else {
                return Err(format!("no arc to {}", place(arc.to)));
            };
            match next {
                Motion::Arc(other) => {
                    circle.holds(&other, began)?;
                    left -= other.sweep_rad * arc.sweep_rad.signum();
                }
                Motion::Line(line) if short && self.near(line.to, arc.to) => return Ok(()),
                Motion::Line(line) if self.raised => {
                    self.raised = false;
                    let lifts = (0..6).all(|i| i == 2 || self.close(began.0[i], line.to.0[i]));
                    if !lifts || !self.close(line.to.0[2], from.0[2]) {
                        return Err("another way behind a change of tools".into());
                    }
                    continue;
                }
                Motion::Line(line) if self.how.chords => {
                    circle.near(line.to, CHORD_MM)?;
                    if self.near(line.to, arc.to) {
                        return Ok(());
                    }
                    continue;
                }
                Motion::Line(_) => return Err("an arc became lines".into()),
            }
            if left < circle.angle_slack() {
                return self.end_of_arc(arc, next.to(), left, &circle);
            }
        }
    }

    /// The whole sweep was made.
    fn end_of_arc(
        &mut self,
        arc: &Arc,
        to: Axes,
        left: f64,
        circle: &Circle,
    ) -> Result<(), String> {
        if left < -circle.angle_slack() || !near_within(to, arc.to, circle.slack) {
            return Err(format!("an arc to {} became one to {}", place(arc.to), place(to)));
        }
        if !self.near(to, arc.to) {
            // A line brings it to the end that is named.
            self.kept = self.next();
            if let Some((_, Motion::Line(line))) = self.kept
                && self.near(line.to, arc.to)
            {
                self.kept = None;
            }
        }
        Ok(())
    }
}

/// The circle of an arc. Its ends may not be equally far from the centre: files carry few decimals;
/// how much they differ is how exactly the path is known.
struct Circle {
    centre: [f64; 2],
    radius: f64,
    slack: f64,
    chord: f64,
}

impl Circle {
    fn new(arc: &Arc, from: Axes, same_mm: f64) -> Self {
        let radius = |p: Axes| (p.0[0] - arc.centre[0]).hypot(p.0[1] - arc.centre[1]);
        let (r1, r2) = (radius(from), radius(arc.to));
        let chord = (from.0[0] - arc.to.0[0]).hypot(from.0[1] - arc.to.0[1]);
        Self {
            centre: arc.centre,
            radius: (r1 + r2) / 2.0,
            slack: same_mm + (r1 - r2).abs(),
            chord,
        }
    }

    /// The angle that the slack is at the radius, and a tenth of a milliradian.
    fn angle_slack(&self) -> f64 {
        self.slack / self.radius.max(1e-9) + 1e-4
    }

    fn near(&self, place_of: Axes, slack: f64) -> Result<(), String> {
        let r = (place_of.0[0] - self.centre[0]).hypot(place_of.0[1] - self.centre[1]);
        let off = (r - self.radius).abs();
        if off <= slack {
            return Ok(());
        }
        Err(format!("{off:.7} mm beside the circle at {}", place(place_of)))
    }

    /// Checks that another arc runs on this circle.
    fn holds(&self, arc: &Arc, from: Axes) -> Result<(), String> {
        for i in 0..=8 {
            let angle = arc.sweep_rad * f64::from(i) / 8.0;
            let (sin, cos) = angle.sin_cos();
            let [dx, dy] = [0, 1].map(|k| from.0[k] - arc.centre[k]);
            let mut at = from;
            at.0[0] = arc.centre[0] + dx * cos - dy * sin;
            at.0[1] = arc.centre[1] + dx * sin + dy * cos;
            self.near(at, self.slack)?;
        }
        Ok(())
    }
}

fn near_within(a: Axes, b: Axes, slack: f64) -> bool {
    a.0.iter().zip(b.0).all(|(a, b)| (a - b).abs() <= slack)
}

fn place(at: Axes) -> String {
    let letter = |axis: Axis| format!("{}{:.6}", axis.letter(), at[axis]);
    Axis::ALL.map(letter).join(" ")
}
