//! The path of a cut, whatever interrupted it: pieces that lie on one line or arc are one.

use kerf_control::Made;
use kerf_geom::Arc2;
use kerf_program::{Axis, MoveKind};

/// Places closer than this are the same, mm.
const SAME: f64 = 1e-6;

/// A smoothed path is left so far beside its line, mm.
const NEAR: f64 = 0.03;

/// A cut in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    pub from: [f64; 3],
    pub to: [f64; 3],
    pub arc: Option<Arc2>,
}

impl Piece {
    /// What a move cuts in the plane, if anything.
    pub fn of(made: &Made<'_>) -> Option<Self> {
        let it = made.span.made;
        let (from, to) = (it.from.first3(), it.to.first3());
        let level = it.kind == MoveKind::Cut;
        let arc = it.arc();
        let flat = arc.is_some() || apart(from, to, Axis::X) || apart(from, to, Axis::Y);
        (level && flat).then_some(Self { from, to, arc })
    }

    /// The two as one, when the second goes on where the first ends in the same way.
    fn join(&self, next: &Self) -> Option<Self> {
        if !near(self.to, next.from) {
            return None;
        }
        let joined = |arc| Some(Self { from: self.from, to: next.to, arc });
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

fn apart(from: [f64; 3], to: [f64; 3], axis: Axis) -> bool {
    (from[axis.index()] - to[axis.index()]).abs() > SAME
}

/// Whether two places are one.
pub fn same(a: [f64; 3], b: [f64; 3]) -> bool {
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
        match path.last().and_then(|last| last.join(piece)) {
            Some(joined) => drop(path.pop().map(|_| path.push(joined))),
            None => path.push(*piece),
        }
    }
    path
}

/// Where two paths differ, heights aside when they do not count.
pub fn difference(a: &[Piece], b: &[Piece], heights: bool) -> Option<String> {
    let flat = |pieces: &[Piece]| -> Vec<Piece> {
        let lay = |p: &Piece| {
            let down = |[x, y, z]: [f64; 3]| [x, y, if heights { z } else { 0.0 }];
            Piece { from: down(p.from), to: down(p.to), ..*p }
        };
        whole(&pieces.iter().map(lay).collect::<Vec<_>>())
    };
    let (a, b) = (flat(a), flat(b));
    let alike = |(a, b): (&Piece, &Piece)| {
        let sweep = |p: &Piece| p.arc.map_or(0.0, |arc| arc.sweep_rad);
        near(a.from, b.from) && near(a.to, b.to) && (sweep(a) - sweep(b)).abs() < NEAR
    };
    let at = a.iter().zip(&b).position(|pair| !alike(pair));
    let at = at.or_else(|| (a.len() != b.len()).then(|| a.len().min(b.len())))?;
    let part = |p: &[Piece]| format!("{:#?}", &p[at.saturating_sub(1)..p.len().min(at + 3)]);
    Some(format!("{} and {} pieces, apart at {at}:\n{}\n{}", a.len(), b.len(), part(&a), part(&b)))
}
