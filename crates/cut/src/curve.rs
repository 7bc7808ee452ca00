//! Circular and elliptic paths: the one geometry behind CC, CP, CG and CA.
//!
//! A clock angle `a` names the place `C + (rx·sin a, ry·cos a)`, rx and ry being the radius times
//! the proportions; a negative proportion mirrors and so turns the sense of travel round. The path
//! of the cutter runs beside that at half its diameter along the outward normal. With equal
//! proportions that is a circle and stays an exact arc; otherwise it comes as chords no longer than
//! the circle resolution. (Readings, Circle angles and Ellipses.)

use crate::passes::Outline;
use crate::segments::chord_count;
use crate::step::{Step, Trail};
use crate::{Context, CutError, Direction, Side};
use kerf_geom::{Point2, Vec2, clock_to_vec, vec_to_clock};
use kerf_program::MoveKind;
use std::f64::consts::TAU;

/// Proportions that differ less than this share count as equal: they come from divisions.
const EQUAL_PROPORTIONS: f64 = 1e-9;

/// An end closer than this to where it should be is there: .00001 in, below what files can write.
pub(crate) const SAME_PLACE_MM: f64 = 2.54e-4;

/// A nominal circle, what becomes of it, and which part of it is cut.
pub(crate) struct Shape {
    /// Radius before proportions and cutter.
    pub radius_mm: f64,
    /// Which side the cutter runs on.
    pub side: Side,
    /// Which way round, before mirroring.
    pub turn: Direction,
    /// Clock angle of the first place.
    pub begin_deg: f64,
    /// Swept angle, 0 … 360.
    pub sweep_deg: f64,
    /// The command's proportions; the file's are applied as well.
    pub proportion: [f64; 2],
}

/// A place that a curve is tied to.
pub(crate) enum Anchor {
    /// The place of the begin angle on the path.
    Begin(Point2),
    /// The centre.
    Centre(Point2),
}

/// The path of the cutter's centre.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    begin: Point2,
    /// End of travel; for a circle with an end point of the user's, up to a rounding beside it.
    end: Point2,
    centre: Point2,
    /// Nominal half axes in X and Y, negative when mirrored.
    half: [f64; 2],
    /// Distance of the path outside the nominal shape.
    offset: f64,
    begin_deg: f64,
    sweep_deg: f64,
    /// +1 when clock angles grow.
    sense: f64,
    resolution_mm: f64,
    small_mm: f64,
    /// Distance of pocket rings.
    step_mm: f64,
    cutter_mm: f64,
}

impl Curve {
    /// The path of a shape; an error when it leaves no room for the cutter.
    pub fn new(shape: &Shape, anchor: Anchor, context: &Context) -> Result<Self, CutError> {
        let half = [0, 1].map(|i| shape.radius_mm * shape.proportion[i] * context.scale[i]);
        let mut curve = Self {
            begin: Point2::default(),
            end: Point2::default(),
            centre: Point2::default(),
            half: evened(half),
            offset: shape.side.offset_mm(context.cutter_mm),
            begin_deg: shape.begin_deg,
            sweep_deg: shape.sweep_deg,
            sense: shape.turn.sign(),
            resolution_mm: context.circle_mm,
            small_mm: context.small_circle_mm,
            step_mm: context.cutter_mm * (1.0 - context.overlap_percent / 100.0),
            cutter_mm: context.cutter_mm,
        };
        curve.check_room()?;
        curve.place(anchor);
        Ok(curve)
    }

    /// Ends at this place instead of the computed one, which is nearly the same.
    pub fn ending_at(mut self, end: Point2) -> Self {
        self.end = end;
        self
    }

    fn check_room(&self) -> Result<(), CutError> {
        let (short, long) = (self.half[0].abs().min(self.half[1].abs()), self.longest_half());
        // Smallest radius of curvature; that of a circle is its radius.
        let curvature_mm = if self.is_round() { long } else { short * short / long };
        let room = if self.is_round() {
            curvature_mm + self.offset > 0.0
        } else {
            curvature_mm + self.offset >= 0.0
        };
        if room && short > 0.0 {
            return Ok(());
        }
        Err(CutError::CutterLargerThanHole {
            cutter_mm: self.cutter_mm,
            hole_mm: 2.0 * curvature_mm,
        })
    }

    fn place(&mut self, anchor: Anchor) {
        let arm = self.arm(self.begin_deg);
        (self.begin, self.centre) = match anchor {
            Anchor::Begin(begin) => (begin, begin - arm),
            Anchor::Centre(centre) => (centre + arm, centre),
        };
        self.end = if self.is_closed() {
            self.begin
        } else {
            self.centre + self.arm(self.begin_deg + self.sense * self.sweep_deg)
        };
    }

    fn is_round(&self) -> bool {
        self.half[0].abs() == self.half[1].abs()
    }

    fn longest_half(&self) -> f64 {
        self.half[0].abs().max(self.half[1].abs())
    }

    /// Distance of the path from the centre where that is largest.
    fn reach(&self) -> f64 {
        self.longest_half() + self.offset
    }

    /// From the centre to the place of a clock angle on the path.
    fn arm(&self, clock_deg: f64) -> Vec2 {
        let unit = clock_to_vec(clock_deg);
        let [rx, ry] = self.half;
        if self.is_round() {
            return unit.scaled(rx.signum(), ry.signum()) * self.reach();
        }
        let normal = Vec2::new(unit.x / rx, unit.y / ry).normalized().unwrap_or_default();
        unit.scaled(rx, ry) + normal * self.offset
    }

    /// Mathematical swept angle of the path.
    fn sweep_rad(&self) -> f64 {
        let mirrored = self.half[0] * self.half[1] < 0.0;
        let clockwise = (self.sense > 0.0) != mirrored;
        let turn = self.sweep_deg / 360.0 * TAU;
        if clockwise { -turn } else { turn }
    }

    /// Chords of the whole shape when `factor` times as large.
    fn chords(&self, factor: f64) -> u32 {
        let [a, b] = self.half.map(f64::abs);
        // The parallel of an ellipse is longer than the ellipse where the curve is tight.
        let stretch = if self.offset > 0.0 { self.offset * a.max(b) / a.min(b) } else { 0.0 };
        let longest = if self.is_round() { self.reach() } else { self.longest_half() + stretch };
        chord_count(TAU * longest * factor, self.sweep_deg / 360.0, self.resolution_mm)
    }

    /// Follows the path drawn in towards the centre; `factor` 1 is the path itself.
    fn turn(&self, factor: f64, z: [f64; 2], trail: &mut Trail) {
        let end = if factor == 1.0 { self.end } else { trail.xy() };
        if self.is_round() {
            self.round_turn(factor, end, z[1], trail);
        } else {
            self.chord_turn(factor, end, z, trail);
        }
    }

    fn round_turn(&self, factor: f64, end: Point2, z: f64, trail: &mut Trail) {
        let arm = self.arm(self.begin_deg + self.sense * self.sweep_deg) * factor;
        let reached = if self.is_closed() { trail.xy() } else { self.centre + arm };
        let near = reached.distance(end) <= SAME_PLACE_MM;
        let to = if near { end } else { reached };
        trail.push(Step::Arc {
            centre: [self.centre.x, self.centre.y],
            sweep_rad: self.sweep_rad(),
            to: [to.x, to.y, z],
            chords: self.chords(factor),
            small: 2.0 * self.reach() * factor < self.small_mm,
        });
        trail.line(MoveKind::Cut, end);
    }

    fn chord_turn(&self, factor: f64, end: Point2, z: [f64; 2], trail: &mut Trail) {
        let chords = self.chords(factor);
        for i in 1..chords {
            let share = f64::from(i) / f64::from(chords);
            let arm = self.arm(self.begin_deg + self.sense * self.sweep_deg * share) * factor;
            let at = self.centre + arm;
            let height = z[0] + (z[1] - z[0]) * share;
            trail.push(Step::Line { kind: MoveKind::Cut, to: [at.x, at.y, height] });
        }
        trail.push(Step::Line { kind: MoveKind::Cut, to: [end.x, end.y, z[1]] });
    }

    fn ring_count(&self) -> f64 {
        // A ring that comes out with radius 0 is the centre move.
        (self.reach() / self.step_mm - 1e-9).ceil().max(1.0)
    }
}

/// Half axes that are equal but for rounding made exactly equal.
fn evened([x, y]: [f64; 2]) -> [f64; 2] {
    let equal = (x.abs() - y.abs()).abs() <= EQUAL_PROPORTIONS * x.abs();
    if equal { [x, x.abs().copysign(y)] } else { [x, y] }
}

impl Outline for Curve {
    fn begin(&self) -> Point2 {
        self.begin
    }

    fn is_closed(&self) -> bool {
        self.sweep_deg >= 360.0
    }

    fn step_count(&self, pocket: bool) -> f64 {
        let turn = if self.is_round() { 2.0 } else { f64::from(self.chords(1.0)) };
        if pocket { (turn + 1.0) * self.ring_count() } else { turn }
    }

    fn follow(&self, z: [f64; 2], trail: &mut Trail) {
        self.turn(1.0, z, trail);
    }

    /// Rings towards the centre, the next one begins a step further in on the begin radius.
    ///
    /// An ellipse is drawn in evenly, so that its rings are a step apart along the long axis and
    /// closer elsewhere.
    fn clear(&self, trail: &mut Trail) {
        let z = trail.at[2];
        let inward = self.begin - self.centre;
        let mut left = self.reach();
        for ring in 0..self.ring_count() as u32 {
            left = self.reach() - f64::from(ring) * self.step_mm;
            let factor = left / self.reach();
            if ring > 0 {
                trail.line(MoveKind::Cut, self.centre + inward * factor);
            }
            self.turn(factor, [z, z], trail);
        }
        if left > self.cutter_mm / 2.0 {
            trail.line(MoveKind::Cut, self.centre);
        }
    }

    fn heading_deg(&self) -> f64 {
        let unit = clock_to_vec(self.begin_deg + self.sense * self.sweep_deg);
        // Derivative of (rx·sin a, ry·cos a) along the way.
        let along = Vec2::new(unit.y * self.half[0], -unit.x * self.half[1]);
        vec_to_clock(along * self.sense)
    }
}
