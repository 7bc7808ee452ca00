//! The path of a cut, whatever interrupted it: pieces that lie on one line or arc are one.

use kerf_control::Made;
use kerf_geom::Arc2;
use kerf_program::{Axis, MoveKind};
use std::f64::consts::TAU;

/// Places closer than this are the same, mm.
const SAME: f64 = 1e-6;

/// A smoothed path is left so far beside its line, mm.
const NEAR: f64 = 0.03;

/// Who stops while a corner is smoothed stops so far along the next line: the corner is seen there, mm.
const BLENDED: f64 = 2.0 * NEAR;

/// A cut in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    pub from: [f64; 3],
    pub to: [f64; 3],
    pub arc: Option<Arc2>,
    /// How far it leads down by the plan, also where heights are laid aside, mm.
    down_mm: f64,
}

impl Piece {
    /// What a move cuts in the plane, if anything.
    pub fn of(made: &Made<'_>) -> Option<Self> {
        let it = made.span.made;
        let (from, to) = (it.from.first3(), it.to.first3());
        let level = it.kind == MoveKind::Cut;
        let arc = it.arc();
        let flat = arc.is_some() || apart(from, to, Axis::X) || apart(from, to, Axis::Y);
        let down_mm = from[2] - to[2];
        (level && flat).then_some(Self { from, to, arc, down_mm })
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

    /// How much of it lies before a place on it.
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
}

fn turned(arc: Arc2, share: f64) -> Arc2 {
    Arc2 { sweep_rad: arc.sweep_rad * share, ..arc }
}

fn apart(from: [f64; 3], to: [f64; 3], axis: Axis) -> bool {
    (from[axis.index()] - to[axis.index()]).abs() > SAME
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

/// The path in as few pieces as possible.
pub fn whole(pieces: &[Piece]) -> Vec<Piece> {
    let mut path: Vec<Piece> = Vec::new();
    for piece in pieces.iter().filter(|p| p.arc.is_some() || !same(p.from, p.to)) {
        if let Some(again) = begun_again(&path, piece) {
            path.truncate(again);
        }
        match path.last().and_then(|last| last.join(piece)) {
            Some(joined) => drop(path.pop().map(|_| path.push(joined))),
            None => path.push(*piece),
        }
    }
    path
}

/// Where a way down along the path began that this piece begins again: one that was stopped on is made
/// from its start.
fn begun_again(path: &[Piece], piece: &Piece) -> Option<usize> {
    let slope = path.iter().rev().take_while(|p| p.down_mm > SAME).count();
    let first = path.len() - slope;
    let again = path[first..].iter().position(|p| same(p.from, piece.from));
    again.filter(|_| piece.down_mm > SAME).map(|at| first + at)
}

/// The path without its heights when they do not count.
pub fn laid(pieces: &[Piece], heights: bool) -> Vec<Piece> {
    let down = |[x, y, z]: [f64; 3]| [x, y, if heights { z } else { 0.0 }];
    let lay = |p: &Piece| Piece { from: down(p.from), to: down(p.to), ..*p };
    pieces.iter().map(lay).collect()
}

/// Adds what the next process cut to what those before it did. Of the move under way a process that dies
/// tells nothing: it was made up to where the next one begins, along the path, or is made again.
pub fn follow_on(done: &mut Vec<Piece>, next: &[Piece], path: &[Piece]) -> Result<(), String> {
    let Some(first) = next.first() else { return Ok(()) };
    let at = first.from;
    match done.last() {
        Some(last) if near(last.to, at) => {}
        Some(last) if near(last.from, at) => drop(done.pop()),
        Some(last) if last.up_to(at).is_some() => {
            let made = last.up_to(at);
            done.pop();
            done.extend(made);
        }
        _ => {
            let made = untold(done, path, at);
            done.push(made.ok_or_else(|| format!("{at:?} is not where the path goes on"))?);
        }
    }
    done.extend(next);
    Ok(())
}

/// What was made between the end of what was told and a place on the path.
fn untold(done: &[Piece], path: &[Piece], at: [f64; 3]) -> Option<Piece> {
    let (done, path) = (whole(done), whole(path));
    let under_way = done.last().zip(done.len().checked_sub(1).and_then(|last| path.get(last)));
    let rest = under_way.and_then(|(last, of)| of.beyond(last.to)?.up_to(at));
    rest.or_else(|| path.get(done.len())?.up_to(at))
}

/// Where two paths differ: to their ends, or as far as both go, but for the last piece of the shorter.
pub fn difference(a: &[Piece], b: &[Piece], to_the_end: bool) -> Option<String> {
    let (mut a, mut b) = (whole(a), whole(b));
    if !to_the_end {
        let both = a.len().min(b.len()).saturating_sub(1);
        a.truncate(both);
        b.truncate(both);
    }
    let alike = |(a, b): (&Piece, &Piece)| {
        let sweep = |p: &Piece| p.arc.map_or(0.0, |arc| arc.sweep_rad);
        let ends = |p: [f64; 3], q: [f64; 3]| p.iter().zip(q).all(|(p, q)| (p - q).abs() < BLENDED);
        ends(a.from, b.from) && ends(a.to, b.to) && (sweep(a) - sweep(b)).abs() < NEAR
    };
    let at = a.iter().zip(&b).position(|pair| !alike(pair));
    let at = at.or_else(|| (a.len() != b.len()).then(|| a.len().min(b.len())))?;
    let part = |p: &[Piece]| format!("{:#?}", &p[at.saturating_sub(1)..p.len().min(at + 3)]);
    Some(format!("{} and {} pieces, apart at {at}:\n{}\n{}", a.len(), b.len(), part(&a), part(&b)))
}
