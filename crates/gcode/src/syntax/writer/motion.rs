//! Moves and arcs as words.

use super::Writer;
use kerf_geom::{Arc2, Point2};
use kerf_program::settings::{AxisUnit, LinearUnit, PerGroup};
use kerf_program::{AXES, Arc, Axes, Axis, Chorded, Feed, Line, MoveKind, decimal, length_places};
use std::f64::consts::TAU;
use std::fmt::Write as _;

impl Writer<'_> {
    pub(super) fn value(&self, axis: usize, internal: f64) -> String {
        let unit = if self.is_linear(Axis::ALL[axis]) { self.writing.unit.mm() } else { 1.0 };
        decimal(internal / unit, length_places(self.writing.unit))
    }

    /// A place as its words' values.
    pub(super) fn words_of(&self, place: Axes) -> [String; AXES] {
        let working = self.frame.working(place);
        std::array::from_fn(|i| self.value(i, working.0[i]))
    }

    /// Returns `true` if the controller has no such axis.
    pub(super) fn lacks(&self, axis: usize) -> bool {
        self.is_grbl() && axis >= 3
    }

    fn is_linear(&self, axis: Axis) -> bool {
        self.settings.axis_unit(axis) != AxisUnit::Degrees
    }

    /// Most controllers take A, B and C for degrees.
    fn doubt_unit(&mut self, axis: Axis) {
        let linear = axis.index() >= 3 && self.is_linear(axis);
        if linear && !std::mem::replace(&mut self.linear_told, true) {
            let unit = match self.writing.unit {
                LinearUnit::Inch => "inches",
                LinearUnit::Mm => "millimetres",
            };
            let letter = axis.letter();
            self.unsaid(format!("that {letter} is a linear axis: its words are {unit}"));
        }
    }

    /// The words of the axes that change; an arc names both axes of its plane.
    fn place(&mut self, to: Axes, plane: Option<[usize; 2]>) -> String {
        let named = |axis: usize| plane.is_some_and(|plane| plane.contains(&axis));
        let (words, here) = (self.words_of(to), self.words_of(self.position));
        let mut text = String::new();
        for (i, word) in words.into_iter().enumerate() {
            let known = self.written[i].as_ref() == Some(&word);
            let still = self.written[i].is_none() && word == here[i];
            if (!known && !still || named(i)) && self.lacks(i) {
                self.unsaid_motion(format!(
                    "{} to {word}: grbl has X, Y and Z",
                    Axis::ALL[i].letter()
                ));
            } else if !known && !still || named(i) {
                self.doubt_unit(Axis::ALL[i]);
                let _ = write!(text, " {}{word}", Axis::ALL[i].letter());
                self.written[i] = Some(word);
            }
        }
        text
    }

    pub(super) fn straight(&mut self, line: &Line) {
        let from = self.position;
        let place = self.place(line.to, None);
        self.position = line.to;
        if place.is_empty() {
            return;
        }
        let feed = match line.kind {
            MoveKind::Jog => String::new(),
            MoveKind::Cut => {
                let xy = (line.to.0[0] - from.0[0]).hypot(line.to.0[1] - from.0[1]);
                self.feed(line.feed, line.kind, xy, line.to.minus(from))
            }
        };
        let code = if line.kind == MoveKind::Jog { "G0" } else { "G1" };
        self.block(code, &format!("{place}{feed}"));
    }

    /// A block; the motion word is written when it changes.
    fn block(&mut self, code: &'static str, words: &str) {
        let code = if self.motion == code { "" } else { code };
        if !code.is_empty() {
            self.motion = code;
        }
        self.line(format!("{code}{words}").trim_start());
    }

    /// Returns `true` if an arc names its end; grbl wants that of a whole turn too.
    fn names_end(&self, is_turn: bool) -> bool {
        !is_turn || self.is_grbl()
    }

    /// The block of an arc; the plane is written when it changes.
    fn arc_block(&mut self, plane: &'static str, motion: &'static str, words: &str) {
        let changed = std::mem::replace(&mut self.plane, plane) != plane;
        let plane = if changed { format!("{plane} ") } else { String::new() };
        self.line(&format!("{plane}{motion}{words}"));
    }

    /// An arc, a turn at a time: not every controller counts turns.
    pub(super) fn arc(&mut self, arc: &Arc) {
        let start = Point2::new(self.position.0[0], self.position.0[1]);
        let centre = Point2::new(arc.centre[0], arc.centre[1]);
        let whole = Arc2 { start, centre, sweep_rad: arc.sweep_rad };
        let from = self.position;
        let turns = (arc.sweep_rad.abs() / TAU - 1e-9).ceil().max(1.0);
        for turn in 1..=turns as u32 {
            let last = f64::from(turn) >= turns;
            let share = if last { 1.0 } else { f64::from(turn) * TAU / arc.sweep_rad.abs() };
            let mut to = from.zip(arc.to, |a, b| a + (b - a) * share);
            if !last {
                let p = whole.at(share);
                (to.0[0], to.0[1]) = (p.x, p.y);
            }
            let before = f64::from(turn - 1) * TAU;
            let sweep = (arc.sweep_rad.abs() - before).min(TAU).copysign(arc.sweep_rad);
            self.turn_of_arc(
                &Arc { sweep_rad: sweep, to: if last { arc.to } else { to }, ..*arc },
                whole.length(),
            );
        }
    }

    /// At most one turn.
    fn turn_of_arc(&mut self, arc: &Arc, whole_length: f64) {
        let from = self.position;
        let (start, end) = (self.words_of(from), self.words_of(arc.to));
        let closed = start[..2] == end[..2];
        let is_turn = arc.sweep_rad.abs() > TAU - 1e-6;
        if closed && arc.sweep_rad.abs() < TAU / 2.0 {
            // Shorter than the last decimal.
            let Arc { kind, to, feed, .. } = *arc;
            return self.straight(&Line { kind, to, feed });
        }
        if closed != is_turn {
            // The ends as written would mean another arc: halves say what is meant.
            return self.halves(arc, whole_length);
        }
        let (kind, sweep) = (arc.kind, arc.sweep_rad);
        let length = Point2::new(from.0[0], from.0[1])
            .distance(Point2::new(arc.centre[0], arc.centre[1]))
            * sweep.abs();
        let place = self.place(arc.to, self.names_end(is_turn).then_some([0, 1]));
        let feed = match arc.feed {
            Feed::Time(s) => Feed::Time(s * length / whole_length.max(1e-9)),
            feed => feed,
        };
        let feed = self.feed(feed, kind, length, arc.to.minus(from));
        let i = self.value(0, arc.centre[0] - from.0[0]);
        let j = self.value(1, arc.centre[1] - from.0[1]);
        self.position = arc.to;
        self.motion = if sweep < 0.0 { "G2" } else { "G3" };
        self.arc_block("G17", self.motion, &format!("{place} I{i} J{j}{feed}"));
    }

    /// An arc of G18 or G19, where it can be said in one block; else its chords follow.
    pub(super) fn arc_in_plane(&mut self, arc: &Chorded) {
        let [u, v] = arc.axes;
        let plane = match (u, v) {
            (2, 0) => "G18",
            (1, 2) => "G19",
            _ => return,
        };
        let from = self.position;
        let (start, end) = (self.words_of(from), self.words_of(arc.to));
        let closed = start[u] == end[u] && start[v] == end[v];
        let turns = arc.sweep_rad.abs() / TAU;
        if turns > 1.0 + 1e-9 || closed != (turns > 1.0 - 1e-6) {
            return;
        }
        let offset = [0, 1].map(|n| arc.centre[n] - from.0[arc.axes[n]]);
        let length = offset[0].hypot(offset[1]) * arc.sweep_rad.abs();
        let place = self.place(arc.to, self.names_end(closed).then_some(arc.axes));
        let [a, b] = [(u, offset[0]), (v, offset[1])].map(|(axis, offset)| {
            let letter = char::from(b"IJK"[axis]);
            (axis, format!(" {letter}{}", self.value(axis, offset)))
        });
        let offsets = if a.0 < b.0 { a.1 + &b.1 } else { b.1 + &a.1 };
        // All of its length counts as in the plane: the axes of the plane share it.
        let feed = self.feed(arc.feed, MoveKind::Cut, length, Axes::default());
        self.position = arc.to;
        self.chords_left = arc.chords;
        self.motion = if arc.sweep_rad < 0.0 { "G2" } else { "G3" };
        let words = format!("{place}{offsets}{feed}");
        self.arc_block(plane, self.motion, &words);
    }

    fn halves(&mut self, arc: &Arc, whole_length: f64) {
        let from = self.position;
        let start = Point2::new(from.0[0], from.0[1]);
        let centre = Point2::new(arc.centre[0], arc.centre[1]);
        let half = arc.sweep_rad / 2.0;
        let p = Arc2 { start, centre, sweep_rad: arc.sweep_rad }.at(0.5);
        let mut middle = from.zip(arc.to, |a, b| (a + b) / 2.0);
        (middle.0[0], middle.0[1]) = (p.x, p.y);
        for to in [middle, arc.to] {
            self.turn_of_arc(&Arc { sweep_rad: half, to, ..*arc }, whole_length);
        }
    }

    /// The F word of a cutting move, if it changes; `xy` is the length of its path in XY.
    fn feed(&mut self, feed: Feed, kind: MoveKind, xy: f64, delta: Axes) -> String {
        let space = xy.hypot(delta.0[2]);
        let turned = delta.0[3].hypot(delta.0[4]).hypot(delta.0[5]);
        let linear = Axis::ALL.into_iter().any(|a| delta[a] != 0.0 && self.is_linear(a));
        let unit = if xy > 0.0 || linear { self.writing.unit.mm() } else { 1.0 };
        let speed = match feed {
            Feed::Time(seconds) => return self.inverse(seconds),
            Feed::Path(speed) => speed,
            Feed::Axis => {
                let speeds = &self.settings.speeds;
                let group = if kind == MoveKind::Jog { speeds.jog } else { speeds.cut };
                let length = if space > 0.0 { space } else { turned };
                length / slowest(&group, xy, delta).max(1e-9)
            }
        };
        let word = decimal(speed * 60.0 / unit, 6);
        let mode = if std::mem::take(&mut self.inverse) { " G94" } else { "" };
        if mode.is_empty() && self.feed.as_ref() == Some(&word) {
            return String::new();
        }
        let text = format!("{mode} F{word}");
        self.feed = Some(word);
        text
    }

    fn inverse(&mut self, seconds: f64) -> String {
        let mode = if std::mem::replace(&mut self.inverse, true) { "" } else { " G93" };
        self.feed = None;
        format!("{mode} F{}", decimal(60.0 / seconds.max(1e-6), 6))
    }
}

/// Returns the time that a move takes at the speeds of the axes (readings, A-57), seconds.
fn slowest(speeds: &PerGroup, xy: f64, delta: Axes) -> f64 {
    let others = Axis::ALL[2..].iter().map(|a| delta[*a].abs() / speeds.of(*a).max(1e-9));
    others.fold(xy / speeds.xy.max(1e-9), f64::max)
}
