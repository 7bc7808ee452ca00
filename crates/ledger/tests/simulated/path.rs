//! The path of a cut, whatever interrupted it.

use crate::simulated::alike::{self, Point};
use kerf_geom::Arc2;
use kerf_program::{Axes, MoveKind};
use kerf_trace::ExecutedMove;
use std::f64::consts::TAU;

/// Places closer than this are the same, mm.
const SAME: f64 = 1e-6;

/// A smoothed path is left so far beside its line, mm.
const NEAR: f64 = 0.03;

/// So many ways that a cut may have gone are followed.
const MOST_WAYS: usize = 32;

/// Arcs are compared by chords that lie so far beside them, mm.
const CHORD: f64 = 1e-3;

/// Tells whether a way is one in the plane. One down that was stopped in a smoothed corner begins beside its line.
pub fn is_flat(from: [f64; 3], to: [f64; 3], turns: bool) -> bool {
    let along = (to[0] - from[0]).hypot(to[1] - from[1]);
    let plunges = along < NEAR && (to[2] - from[2]).abs() > 10.0 * along;
    turns || (along > SAME && !plunges)
}

/// A cut in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    pub from: [f64; 3],
    pub to: [f64; 3],
    pub arc: Option<Arc2>,
    /// The line of the program, or the number of the shape.
    pub line: u32,
    /// Height that it leads down by the plan, mm.
    down_mm: f64,
}

impl Piece {
    /// Takes the piece that a move cuts in the plane, if it cuts one.
    pub fn of(made: &ExecutedMove<'_>) -> Option<Self> {
        let it = made.span.made;
        let (from, to) = (it.from.first3(), it.to.first3());
        let level = it.kind == MoveKind::Cut;
        let arc = it.arc();
        let down_mm = from[2] - to[2];
        (level && is_flat(from, to, arc.is_some())).then_some(Self {
            from,
            to,
            arc,
            line: it.at.line,
            down_mm,
        })
    }

    /// The two as one, when the second goes on where the first ends in the same way.
    fn join(&self, next: &Self) -> Option<Self> {
        if !near(self.to, next.from) {
            return None;
        }
        let joined =
            |arc| Some(Self { to: next.to, arc, down_mm: self.down_mm + next.down_mm, ..*self });
        match (self.arc, next.arc) {
            (None, None) => straight(self, next).then(|| joined(None))?,
            (Some(a), Some(b)) => {
                let turn = a.sweep_rad.signum() == b.sweep_rad.signum();
                let whole = a.sweep_rad + b.sweep_rad;
                // A path of two arcs that make more than a circle is none that was interrupted.
                let fits = turn && a.centre.distance(b.centre) < NEAR && whole.abs() < 6.3;
                fits.then(|| joined(Some(Arc2 { sweep_rad: whole, ..a })))?
            }
            _ => None,
        }
    }
}

impl Piece {
    /// Tells whether it leads down by plan.
    pub fn goes_down(&self) -> bool {
        self.down_mm > SAME
    }

    /// Tells whether it begins at one of these places, or between two of them.
    pub fn begins_by(&self, places: &[Axes]) -> bool {
        let lay = |at: &Axes| {
            let [x, y, z] = at.first3();
            [x, y, if self.from[2] == 0.0 { 0.0 } else { z }]
        };
        let between = |pair: &[Axes]| {
            let (a, b) = (lay(&pair[0]), lay(&pair[1]));
            let middle = [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]));
            let reach = alike::distance(a, b) * 0.5 + NEAR;
            alike::distance(middle, self.from) <= reach
        };
        places.windows(2).any(between)
    }

    /// The part of it that leads to a place on it.
    fn up_to(&self, at: [f64; 3]) -> Option<Self> {
        let share = self.share(at)?;
        Some(Self { to: at, arc: self.arc.map(|arc| turned(arc, share)), ..*self })
    }

    /// The part of it that begins at a place on it.
    fn beyond(&self, at: [f64; 3]) -> Option<Self> {
        let share = self.share(at)?;
        Some(Self { from: at, arc: self.arc.map(|arc| turned(arc, 1.0 - share)), ..*self })
    }

    /// Share of it that lies before a place on it.
    fn share(&self, at: [f64; 3]) -> Option<f64> {
        let share = match self.arc {
            Some(arc) => {
                let angle = |p: [f64; 3]| (p[1] - arc.centre.y).atan2(p[0] - arc.centre.x);
                let turn = (angle(at) - angle(self.from)) * arc.sweep_rad.signum();
                // As good as at its start.
                let turn = turn.rem_euclid(TAU);
                let turn = if TAU - turn < 1e-3 { 0.0 } else { turn };
                turn / arc.sweep_rad.abs()
            }
            None => {
                let way = [0, 1, 2].map(|i| self.to[i] - self.from[i]);
                let gone = [0, 1, 2].map(|i| at[i] - self.from[i]);
                let dot =
                    |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
                dot(gone, way) / dot(way, way)
            }
        };
        let share = if (-1e-3..=1.0 + 1e-3).contains(&share) {
            share.clamp(0.0, 1.0)
        } else {
            return None;
        };
        near(self.at(share), at).then_some(share)
    }

    /// The place at a share of it.
    fn at(&self, share: f64) -> [f64; 3] {
        let mut at = [0, 1, 2].map(|i| self.from[i] + (self.to[i] - self.from[i]) * share);
        if let Some(arc) = self.arc {
            let [x, y] = [self.from[0] - arc.centre.x, self.from[1] - arc.centre.y];
            let (sin, cos) = (arc.sweep_rad * share).sin_cos();
            at[0] = arc.centre.x + x * cos - y * sin;
            at[1] = arc.centre.y + x * sin + y * cos;
        }
        at
    }

    /// Places on it, its end among them, so close that lines between them are as good as it.
    fn places(&self) -> impl Iterator<Item = Point> {
        let count = self.arc.map_or(1, |arc| {
            let radius = arc.start.distance(arc.centre).max(CHORD);
            let step = 2.0 * (1.0 - CHORD / radius).clamp(-1.0, 1.0).acos();
            (arc.sweep_rad.abs() / step).ceil().max(1.0) as u32
        });
        (1..=count).map(
            move |n| if n == count { self.to } else { self.at(f64::from(n) / f64::from(count)) },
        )
    }
}

fn turned(arc: Arc2, share: f64) -> Arc2 {
    Arc2 { sweep_rad: arc.sweep_rad * share, ..arc }
}

fn same(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME)
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < NEAR)
}

fn straight(a: &Piece, b: &Piece) -> bool {
    let way = |p: &Piece| [0, 1, 2].map(|i| p.to[i] - p.from[i]);
    let (u, v) = (way(a), way(b));
    let length = |w: [f64; 3]| w.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (lu, lv) = (length(u), length(v));
    if lu < SAME || lv < SAME {
        return true;
    }
    // How far the corner lies beside the line from end to end.
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let dot: f64 = u.iter().zip(v).map(|(u, v)| u * v).sum();
    dot > 0.0 && length(cross) / (lu + lv) < NEAR
}

/// The path without what was begun again, and without pieces that lead nowhere.
fn once(pieces: &[Piece]) -> Vec<Piece> {
    let mut path: Vec<Piece> = Vec::new();
    for piece in pieces.iter().filter(|p| p.arc.is_some() || !same(p.from, p.to)) {
        if let Some(again) = begun_again(&path, piece) {
            path.truncate(again);
        }
        path.push(*piece);
    }
    path
}

/// The path in as few pieces as possible: what a stop took apart is one again.
fn joined(path: Vec<Piece>) -> Vec<Piece> {
    let mut moves: Vec<Piece> = Vec::new();
    for piece in path {
        match moves.last().and_then(|last| last.join(&piece)) {
            Some(both) => drop(moves.pop().map(|_| moves.push(both))),
            None => moves.push(piece),
        }
    }
    moves
}

/// The path as places, its pieces joined by lines, and of each place the piece that it is on.
fn track(path: &[Piece]) -> (Vec<Point>, Vec<usize>) {
    let (mut places, mut on) = (Vec::new(), Vec::new());
    for (n, piece) in path.iter().enumerate() {
        let begins = places.last().is_none_or(|last| !same(*last, piece.from));
        for place in begins.then_some(piece.from).into_iter().chain(piece.places()) {
            places.push(place);
            on.push(n);
        }
    }
    (places, on)
}

/// Finds the beginning of a way down along the path that this piece begins again: one that was stopped on is made
/// from its start.
fn begun_again(path: &[Piece], piece: &Piece) -> Option<usize> {
    let slope = path.iter().rev().take_while(|p| p.down_mm > SAME).count();
    let first = path.len() - slope;
    let again = path[first..].iter().position(|p| same(p.from, piece.from));
    again.filter(|_| piece.goes_down()).map(|at| first + at)
}

/// The path as it is compared: without its heights where those are the sheet's, and going down only where
/// that is planned.
pub fn laid(pieces: &[Piece], heights: bool, slopes: impl Fn(u32) -> bool) -> Vec<Piece> {
    let down = |[x, y, z]: [f64; 3]| [x, y, if heights { z } else { 0.0 }];
    let lay = |p: &Piece| {
        let down_mm = if slopes(p.line) { p.down_mm } else { 0.0 };
        Piece { from: down(p.from), to: down(p.to), down_mm, ..*p }
    };
    pieces.iter().map(lay).collect()
}

/// Cuts of processes that followed on each other: all that they may have been, for of the move under way a process
/// that dies tells nothing.
pub struct Done {
    ways: Vec<Vec<Piece>>,
    /// Place at which it left the path.
    lost: Option<String>,
}

impl Done {
    pub fn nothing() -> Self {
        Self { ways: vec![Vec::new()], lost: None }
    }

    /// Adds what the next process cut. The move under way was made up to where this one begins, along the path,
    /// or is made again. Where ways lie side by side, which of these it was is what follows the path; where both
    /// do, what comes after tells.
    pub fn follow_on(&mut self, next: &[Piece], path: &[Piece]) {
        let Some(first) = next.first() else { return };
        let mut ways: Vec<Vec<Piece>> =
            self.ways.iter().flat_map(|done| ways_on(done, first, path)).collect();
        ways.iter_mut().for_each(|way| way.extend(next));
        if ways.is_empty() {
            let lost = format!("{:?} is not where the path goes on", first.from);
            self.lost.get_or_insert(lost);
            return;
        }
        let (along, mut beside): (Vec<_>, Vec<_>) =
            ways.into_iter().partition(|way| difference(way, path, false).is_none());
        beside.truncate(1);
        self.ways = if along.is_empty() { beside } else { along };
        self.ways.truncate(MOST_WAYS);
    }

    /// Finds the place at which it differs from a path: to the end, or as far as both go.
    pub fn differs(&self, path: &[Piece], to_the_end: bool) -> Option<String> {
        let lost = self.lost.clone().filter(|_| to_the_end);
        let difference = |way: &Vec<Piece>| difference(path, way, to_the_end);
        lost.or_else(|| self.ways.iter().map(difference).min()?)
    }
}

/// Ways that may have been done when the next process begins with a piece.
fn ways_on(done: &[Piece], first: &Piece, path: &[Piece]) -> Vec<Vec<Piece>> {
    let at = first.from;
    let mut ways = Vec::new();
    let with = |before: &[Piece], piece: Piece| [before, &[piece]].concat();
    if let Some((last, before)) = done.split_last() {
        // It goes on there, or a move up from the work led there, of which nothing is known.
        ways.push(done.to_vec());
        if near(last.from, at) {
            ways.push(before.to_vec());
        }
        ways.extend(last.up_to(at).map(|made| with(before, made)));
    }
    ways.extend(untold(done, path, at).map(|made| with(done, made)));
    ways
}

/// Piece that was made between the end of what was told and a place on the path.
fn untold(done: &[Piece], path: &[Piece], at: [f64; 3]) -> Option<Piece> {
    let (done, path) = (once(done), joined(once(path)));
    let Some(last) = done.last() else { return path.first()?.up_to(at) };
    let ((made, _), (all, on)) = (track(&done), track(&path));
    let ends = alike::compare(&made, &all, NEAR).first_ends;
    // The piece that it ends on, or the next one.
    ends.into_iter().find_map(|place| {
        let n = on[place];
        let rest = path[n].beyond(last.to).and_then(|rest| rest.up_to(at));
        rest.or_else(|| path.get(n + 1)?.up_to(at))
    })
}

/// Finds the place at which two paths differ: to their ends, or as far as both go.
fn difference(a: &[Piece], b: &[Piece], to_the_end: bool) -> Option<String> {
    let (a, b) = (once(a), once(b));
    let ((places, on), (others, other_on)) = (track(&a), track(&b));
    let common = alike::compare(&places, &others, NEAR);
    if common.whole || (!to_the_end && common.as_far_as_both_go) {
        return None;
    }
    let part = |p: &[Piece], on: &[usize], place: usize| {
        let n = on.get(place).copied().unwrap_or_default();
        format!("piece {n}: {:#?}", &p[n.saturating_sub(1).min(p.len())..p.len().min(n + 3)])
    };
    let (i, j) = common.furthest;
    let (length, other) = (a.len(), b.len());
    let (here, there) = (part(&a, &on, i), part(&b, &other_on, j));
    Some(format!("{length} and {other} pieces, apart in\n{here}\nand\n{there}"))
}
