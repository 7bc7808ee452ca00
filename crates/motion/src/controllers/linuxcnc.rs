//! LinuxCNC with G64 Pn: trapezoids of speed over the whole program, corners rounded by arcs
//! within a tolerance, small segments merged.
//!
//! What its trajectory planner does, as its documentation ("Trajectory Control", "INI
//! configuration") tells it:
//!
//! * straight feeds within the tolerance of one line are merged (`naive_cam`);
//! * at a corner an arc touches both legs and passes the corner within the tolerance P; with the
//!   angle 2β between the legs its radius is R = P·sin β/(1 − sin β), less where a leg is shorter than
//!   twice what the arc takes of it;
//! * on arcs √3/2 of the acceleration goes towards the centre, so v = √(½√3·A·R), and half of it
//!   along the path;
//! * the acceleration A of an arc is the least of the axes that move in its plane: Z slows nothing flat;
//! * from there a pass back and a pass forward give trapezoids. The pass back looks 50 segments
//!   ahead on the machine; that is enough where one braking distance is shorter, and taken so here.
//!
//! In version 2.9 the last leg before a stand has half the acceleration, as if a corner behind it were to be rounded; and the arc
//! at a corner takes at least as much of its legs as two overlapping ramps of half the acceleration would, so that a path of
//! short chords is arcs altogether. Both are told by its source; times of 2.10 fit arcs that are no larger than the speed needs.
//!
//! The times of the seven reference programs come out within 1 % of the real ones, those of 2.10 at P 0.01 and 0.05 and those of
//! 2.9 at P 0.01.

use super::Controller;
use super::block::{Direction, feed_mm_s, path_mm, trapezoid_s, within_axes};
use super::naive_cam::merged;
use crate::moves::{Move, Path};
use kerf_program::Axes;

/// Share of the acceleration towards the centre of an arc.
const ACROSS: f64 = 0.866_025_403_784_438_6;
/// Share of the acceleration along an arc.
const ALONG: f64 = 0.5;
/// Slighter turns are none, radians.
const SAME_RAD: f64 = 1e-6;
/// An axis with a smaller part of a direction stands.
const STILL: f64 = 1e-9;
/// Sharper ones cannot be rounded, radians from turning back.
const BACK_RAD: f64 = 0.02;

/// A version of LinuxCNC, as far as its times differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Release {
    /// 2.9 and before.
    #[default]
    V2_9,
    /// 2.10 and behind.
    V2_10,
}

/// A machine under LinuxCNC.
#[derive(Clone, Debug, PartialEq)]
pub struct LinuxCnc {
    /// Its version.
    pub release: Release,
    /// `MAX_VELOCITY` of the axes, mm/s.
    pub speed_mm_s: Axes,
    /// `MAX_ACCELERATION` of the axes, mm/s².
    pub accel_mm_s2: Axes,
    /// G64 P, mm; 0 is exact stop, G61.1.
    pub blend_mm: f64,
    /// G64 Q: straight feeds that lie so near one line are made as that line, mm.
    pub same_line_mm: f64,
}

/// A way that is made in one go: straight or an arc.
#[derive(Clone, Copy, Debug)]
struct Leg {
    /// First move and how many it stands for.
    moves: [usize; 2],
    mm: f64,
    top_mm_s: f64,
    accel: f64,
    start: Option<Direction>,
    end: Option<Direction>,
}

/// A piece of the trajectory with the move it is counted to.
#[derive(Clone, Copy, Debug)]
struct Piece {
    leg: usize,
    mm: f64,
    top_mm_s: f64,
    accel: f64,
    /// The machine stands before it.
    stands: bool,
}

/// The rounding of a corner: what it takes of each leg, its own length, its speed.
#[derive(Clone, Copy, Debug)]
struct Blend {
    off_mm: f64,
    mm: f64,
    mm_s: f64,
    accel: f64,
}

/// Passage from one leg to the next.
#[derive(Clone, Copy, Debug)]
enum Joint {
    Stop,
    Tangent,
    Blend(Blend),
}

impl Controller for LinuxCnc {
    fn seconds(&self, run: &[Move]) -> Vec<f64> {
        let legs = self.legs(run);
        let pieces = self.pieces(&legs);
        let mut seconds = vec![0.0; run.len()];
        for (piece, s) in pieces.iter().zip(times(&pieces)) {
            let [first, count] = legs[piece.leg].moves;
            let part = first..first + count;
            let whole: f64 = run[part.clone()].iter().map(path_mm).sum();
            for k in part {
                let share = if whole > 0.0 { path_mm(&run[k]) / whole } else { 0.0 };
                seconds[k] += s * share;
            }
        }
        seconds
    }
}

impl LinuxCnc {
    fn legs(&self, run: &[Move]) -> Vec<Leg> {
        let mut legs = Vec::new();
        let mut first = 0;
        while first < run.len() {
            let count = merged(&run[first..], self.same_line_mm);
            legs.extend(self.leg(&run[first..first + count], first));
            first += count;
        }
        if let (Release::V2_9, Some(last)) = (self.release, legs.last_mut()) {
            last.accel *= 0.5;
        }
        legs
    }

    /// The leg of one move, or of a few that make one line.
    fn leg(&self, moves: &[Move], first: usize) -> Option<Leg> {
        let (a, b) = (&moves[0], &moves[moves.len() - 1]);
        let one = Move { from: a.from, to: b.to, ..*a };
        let made = if moves.len() > 1 { &one } else { a };
        let mm = path_mm(made);
        let curved = !matches!(made.path, Path::Line);
        let per_mm = 1.0 / mm;
        let way = |u: f64| made.derivative(u).0.map(|v| v * per_mm);
        if mm <= 0.0 {
            return None;
        }
        let along = way(0.0);
        // Only what moves in XYZ has a direction that can be rounded.
        let space = |way: Direction| (norm(&way) > 0.5).then_some(way);
        let accel = if curved {
            // Three directions tell the plane of an arc.
            self.least_accel(&[along, way(0.3), way(0.6)])
        } else {
            within_axes(&self.accel_mm_s2, &along)
        };
        let mut top_mm_s = feed_mm_s(a).min(within_axes(&self.speed_mm_s, &along));
        if let Some(arc) = made.arc() {
            let radius = arc.length() / arc.sweep_rad.abs();
            top_mm_s = top_mm_s.min((ACROSS * accel * radius).sqrt());
        }
        Some(Leg {
            moves: [first, moves.len()],
            mm,
            top_mm_s,
            accel: if curved { ALONG * accel } else { accel },
            start: space(along),
            end: space(way(1.0)),
        })
    }

    /// Returns the acceleration that each of X, Y and Z has which moves in one of these directions.
    fn least_accel(&self, ways: &[Direction]) -> f64 {
        let moves = |axis: &usize| ways.iter().any(|way| way[*axis].abs() > STILL);
        let accels = self.accel_mm_s2.first3();
        (0..3).filter(moves).map(|axis| accels[axis]).fold(f64::INFINITY, f64::min)
    }

    fn pieces(&self, legs: &[Leg]) -> Vec<Piece> {
        let mut pieces = Vec::with_capacity(2 * legs.len());
        let mut before = Joint::Stop;
        for (k, leg) in legs.iter().enumerate() {
            let after = legs.get(k + 1).map_or(Joint::Stop, |next| self.joint(leg, next));
            let mut rest_mm = leg.mm;
            if let Joint::Blend(blend) = before {
                let (mm, top_mm_s, accel) = (blend.mm, blend.mm_s, blend.accel);
                pieces.push(Piece { leg: k, mm, top_mm_s, accel, stands: false });
                rest_mm -= blend.off_mm;
            }
            if let Joint::Blend(blend) = after {
                rest_mm -= blend.off_mm;
            }
            let stands = matches!(before, Joint::Stop);
            let Leg { top_mm_s, accel, .. } = *leg;
            pieces.push(Piece { leg: k, mm: rest_mm.max(0.0), top_mm_s, accel, stands });
            before = after;
        }
        pieces
    }

    fn joint(&self, a: &Leg, b: &Leg) -> Joint {
        let (Some(end), Some(start)) = (a.end, b.start) else { return Joint::Stop };
        let cos: f64 = end.iter().zip(&start).take(3).map(|(a, b)| a * b).sum();
        let turn = (cos / (norm(&end) * norm(&start))).clamp(-1.0, 1.0).acos();
        if turn < SAME_RAD {
            return Joint::Tangent;
        }
        if turn > std::f64::consts::PI - BACK_RAD || self.blend_mm <= 0.0 {
            return Joint::Stop;
        }
        let accel = self.least_accel(&[end, start]);
        Joint::Blend(self.blend(turn, [a, b], accel))
    }

    fn blend(&self, turn: f64, [a, b]: [&Leg; 2], accel: f64) -> Blend {
        let (room_mm, top_mm_s) = (0.5 * a.mm.min(b.mm), a.top_mm_s.min(b.top_mm_s));
        let half = 0.5 * (std::f64::consts::PI - turn);
        let across = ACROSS * accel;
        let by_tolerance = self.blend_mm * half.sin() / (1.0 - half.sin());
        // No larger than the legs have room for, and than the speed needs.
        let largest = by_tolerance.min(room_mm * half.tan());
        let mm_s = (across * largest).sqrt().min(top_mm_s);
        let needed = mm_s * mm_s / across;
        let radius = match self.release {
            Release::V2_9 => {
                needed.max(largest.min(overlap_mm(largest / half.tan(), mm_s, accel) / turn))
            }
            Release::V2_10 => needed,
        };
        Blend { off_mm: radius / half.tan(), mm: radius * turn, mm_s, accel: ALONG * accel }
    }
}

/// Way at a speed while two ramps overlap, each with half an acceleration, on a part of a leg: at most to the speed that such a
/// ramp reaches on it.
fn overlap_mm(part_mm: f64, speed_mm_s: f64, accel: f64) -> f64 {
    let ramp = 0.5 * accel;
    let reached = (2.0 * ramp * part_mm).sqrt();
    reached.min(speed_mm_s) / ramp * speed_mm_s
}

fn norm(way: &Direction) -> f64 {
    way[..3].iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// Seconds of each piece, by a pass back and a pass forward.
fn times(pieces: &[Piece]) -> Vec<f64> {
    let mut entries = vec![0.0; pieces.len() + 1];
    for (k, p) in pieces.iter().enumerate().rev() {
        let top_sqr = p.top_mm_s * p.top_mm_s;
        let exit: f64 = entries[k + 1];
        entries[k + 1] = exit.min(top_sqr);
        let reach = (entries[k + 1] + 2.0 * p.accel * p.mm).min(top_sqr);
        entries[k] = if p.stands { 0.0 } else { reach };
    }
    let mut seconds = Vec::with_capacity(pieces.len());
    for (k, p) in pieces.iter().enumerate() {
        let entry = entries[k];
        entries[k + 1] = entries[k + 1].min(entry + 2.0 * p.accel * p.mm);
        seconds.push(trapezoid_s(p.mm, entry, entries[k + 1], p.top_mm_s, p.accel));
    }
    seconds
}
