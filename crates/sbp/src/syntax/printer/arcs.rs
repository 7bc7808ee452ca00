//! Arcs as CG.
//!
//! CG takes an end nearer than a quarter micrometre to the start for a whole circle, and moves the
//! centre so that both ends are equally far from it. So an arc is written in parts where rounding
//! would be taken for something else: a turn at a time, and nearly whole turns in halves.

use super::SbpPrinter;
use super::moves::fields;
use kerf_geom::{Arc2, Point2};
use kerf_program::{Arc, Axes, Axis, Feed, Line};
use std::f64::consts::{PI, TAU};

/// Ends nearer than this are one place for CG, mm; its own bound and some room.
const ONE_PLACE_MM: f64 = 3e-4;
/// Ends nearer than this are one place exactly: a whole circle, mm.
const SAME_MM: f64 = 1e-7;
/// An arc longer than this that is no whole circle is written in halves, radians: its ends are so
/// near each other that CG's correction of the centre would be seen.
const LONG_RAD: f64 = 1.5 * PI;
/// CG takes an end that lies no farther beside the circle, mm; its own bound and some room.
const MOST_BESIDE_MM: f64 = 0.25;
/// Largest distance of chords from an arc that CG cannot make, mm.
const CHORD_MM: f64 = 0.005;

impl SbpPrinter<'_> {
    pub(super) fn arc(&mut self, arc: &Arc) {
        self.lower();
        let from = self.places.position;
        if (3..6).any(|i| arc.to.0[i] != from.0[i]) {
            self.unsaid("an arc while other axes turn: chords within 0.005 mm");
            let radius = flat(from, arc).radius().max(CHORD_MM);
            let step = 2.0 * (1.0 - CHORD_MM / radius).clamp(-1.0, 1.0).acos();
            return self.parts(arc, (arc.sweep_rad.abs() / step.max(1e-3)).ceil(), Self::chord);
        }
        let turns = (arc.sweep_rad.abs() / TAU - 1e-9).ceil().max(1.0);
        self.parts(arc, turns, Self::turn_of_arc);
    }

    /// An arc in so many equal parts.
    fn parts(&mut self, arc: &Arc, count: f64, write: fn(&mut Self, &Arc)) {
        let from = self.places.position;
        let path = flat(from, arc);
        let feed = match arc.feed {
            Feed::Time(seconds) => Feed::Time(seconds / count),
            feed => feed,
        };
        let mut part = 1.0;
        while part <= count {
            let share = part / count;
            let mut to = from.zip(arc.to, |a, b| a + (b - a) * share);
            if part < count {
                let place = path.at(share);
                (to[Axis::X], to[Axis::Y]) = (place.x, place.y);
            } else {
                to = arc.to;
            }
            write(self, &Arc { to, feed, sweep_rad: arc.sweep_rad / count, ..*arc });
            part += 1.0;
        }
    }

    fn chord(&mut self, arc: &Arc) {
        let Arc { kind, to, feed, .. } = *arc;
        self.straight(&Line { kind, to, feed });
    }

    /// At most one turn.
    fn turn_of_arc(&mut self, arc: &Arc) {
        let from = self.places.position;
        let (dx, dy) = (arc.to.0[0] - from.0[0], arc.to.0[1] - from.0[1]);
        let chord = dx.hypot(dy);
        let whole = chord <= SAME_MM && arc.sweep_rad.abs() > TAU - 1e-6;
        if chord <= ONE_PLACE_MM && arc.sweep_rad.abs() < PI / 2.0 {
            // Too short to be told from a place.
            self.chord(arc);
        } else if !whole && (chord <= ONE_PLACE_MM || arc.sweep_rad.abs() > LONG_RAD) {
            self.parts(arc, 2.0, Self::one_arc);
        } else {
            self.one_arc(arc);
        }
    }

    /// One CG, and a line where the end lies too far beside the circle for it.
    fn one_arc(&mut self, arc: &Arc) {
        let from = self.places.position;
        let path = flat(from, arc);
        let beside = path.centre.distance(Point2::new(arc.to.0[0], arc.to.0[1])) - path.radius();
        if beside.abs() > MOST_BESIDE_MM {
            let mut to = arc.to;
            let end = path.end();
            (to[Axis::X], to[Axis::Y]) = (end.x, end.y);
            self.one_arc(&Arc { to, ..*arc });
            return self.chord(arc);
        }
        let delta = arc.to.minus(from);
        self.speed(arc.feed, path.length(), delta);
        let (start, end) = (self.places.values(from), self.places.values(arc.to));
        let [x, y] = [&end[0], &end[1]];
        let i = self.places.length(arc.centre[0] - from.0[0]);
        let j = self.places.length(arc.centre[1] - from.0[1]);
        let turn = if arc.sweep_rad < 0.0 { "1" } else { "-1" };
        let words = [x.as_str(), y, &i, &j, "T", turn].map(|v| Some(v.to_string()));
        let mut text = fields("CG,", &words);
        if start[2] != end[2] {
            // Written values differ by exactly this, so that no error adds up.
            let [before, after] = [&start[2], &end[2]].map(|v| v.parse().unwrap_or(0.0));
            let plunge = self.places.length((after - before) * self.printing.unit.mm());
            text += &format!(",{plunge},1,,,3,1");
            self.places.wrote(Axis::Z, end[2].clone());
        }
        self.places.wrote(Axis::X, x.clone());
        self.places.wrote(Axis::Y, y.clone());
        self.places.position = arc.to;
        self.line(&text);
    }
}

fn flat(from: Axes, arc: &Arc) -> Arc2 {
    Arc2 {
        start: Point2::new(from.0[0], from.0[1]),
        centre: Point2::new(arc.centre[0], arc.centre[1]),
        sweep_rad: arc.sweep_rad,
    }
}
