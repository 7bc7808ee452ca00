//! Arcs as CG.
//!
//! CG takes an end nearer than a quarter micrometre to the start for a whole circle, and moves the
//! centre so that both ends are equally far from it. So an arc is written in parts where rounding
//! would be taken for something else: a turn at a time, and nearly whole turns in halves.

use super::file::SbpPrinter;
use super::places::fields;
use super::{moves, speeds};
use kerf_geom::{Arc2, Point2};
use kerf_program::{Arc, Axes, Axis, Feed, Line, MoveKind};
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

pub(super) fn arc(p: &mut SbpPrinter<'_>, arc: &Arc) {
    moves::lower(p);
    let from = p.places.position;
    if (3..6).any(|i| arc.to.0[i] != from.0[i]) {
        p.unsaid("an arc while other axes turn: chords within 0.005 mm");
        let radius = flat(from, arc).radius().max(CHORD_MM);
        let step = 2.0 * (1.0 - CHORD_MM / radius).clamp(-1.0, 1.0).acos();
        return parts(p, arc, (arc.sweep_rad.abs() / step.max(1e-3)).ceil(), write_chord);
    }
    let turns = (arc.sweep_rad.abs() / TAU - 1e-9).ceil().max(1.0);
    parts(p, arc, turns, turn_of_arc);
}

/// An arc in so many equal parts.
fn parts(p: &mut SbpPrinter<'_>, arc: &Arc, count: f64, write: fn(&mut SbpPrinter<'_>, &Arc)) {
    let from = p.places.position;
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
        write(p, &Arc { to, feed, sweep_rad: arc.sweep_rad / count, ..*arc });
        part += 1.0;
    }
}

fn write_chord(p: &mut SbpPrinter<'_>, arc: &Arc) {
    let Arc { kind, to, feed, .. } = *arc;
    moves::straight(p, &Line { kind, to, feed });
}

/// At most one turn.
fn turn_of_arc(p: &mut SbpPrinter<'_>, arc: &Arc) {
    let from = p.places.position;
    let (dx, dy) = (arc.to.0[0] - from.0[0], arc.to.0[1] - from.0[1]);
    let chord = dx.hypot(dy);
    let whole = chord <= SAME_MM && arc.sweep_rad.abs() > TAU - 1e-6;
    if chord <= ONE_PLACE_MM && arc.sweep_rad.abs() < PI / 2.0 {
        // Too short to be told from a place.
        write_chord(p, arc);
    } else if !whole && (chord <= ONE_PLACE_MM || arc.sweep_rad.abs() > LONG_RAD) {
        parts(p, arc, 2.0, one_arc);
    } else {
        one_arc(p, arc);
    }
}

/// One CG, and a line where the end lies too far beside the circle for it.
fn one_arc(p: &mut SbpPrinter<'_>, arc: &Arc) {
    let from = p.places.position;
    let path = flat(from, arc);
    let beside = path.centre.distance(Point2::new(arc.to.0[0], arc.to.0[1])) - path.radius();
    if beside.abs() > MOST_BESIDE_MM {
        let mut to = arc.to;
        let end = path.end();
        (to[Axis::X], to[Axis::Y]) = (end.x, end.y);
        one_arc(p, &Arc { to, ..*arc });
        return write_chord(p, arc);
    }
    let delta = arc.to.minus(from);
    speeds::speed(p, MoveKind::Cut, arc.feed, path.length(), delta);
    let (start, end) = (p.places.values(from), p.places.values(arc.to));
    let [x, y] = [&end[0], &end[1]];
    let i = p.places.length(arc.centre[0] - from.0[0]);
    let j = p.places.length(arc.centre[1] - from.0[1]);
    let turn = if arc.sweep_rad < 0.0 { "1" } else { "-1" };
    let words = [x.as_str(), y, &i, &j, "T", turn].map(|v| Some(v.to_string()));
    let mut text = fields("CG,", &words);
    if start[2] != end[2] {
        // Written values differ by exactly this, so that no error adds up.
        let [before, after] = [&start[2], &end[2]].map(|v| v.parse().unwrap_or(0.0));
        let plunge = p.places.length((after - before) * p.printing.unit.mm());
        text += &format!(",{plunge},1,,,3,1");
        p.places.wrote(Axis::Z, end[2].clone());
    }
    p.places.wrote(Axis::X, x.clone());
    p.places.wrote(Axis::Y, y.clone());
    p.places.position = arc.to;
    p.line(&text);
}

fn flat(from: Axes, arc: &Arc) -> Arc2 {
    Arc2 {
        start: Point2::new(from.0[0], from.0[1]),
        centre: Point2::new(arc.centre[0], arc.centre[1]),
        sweep_rad: arc.sweep_rad,
    }
}
