//! One move: everything a model of motion needs to know about it, and the geometry of its path.

use crate::profiler::spline::{Spline, Vec3, unit};
use kerf_geom::{Arc2, Point2};
use kerf_motion_optimal::{Leg, Shape};
use kerf_program::{At, Axes, MoveKind};

pub(crate) use kerf_motion_optimal::Basis;

/// The way from one position to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Path {
    /// Straight.
    Line,
    /// A circular arc in XY; every other axis moves in proportion to the angle.
    Arc {
        /// Centre in X and Y, mm.
        centre: [f64; 2],
        /// Swept angle, positive counter-clockwise; may exceed a turn.
        sweep_rad: f64,
        /// Chords that the circle resolution asks for; for machines that know only lines.
        chords: u32,
        /// Below the small circle size: run at ramp speed.
        small: bool,
    },
    /// A smoothed segment: a cubic in XYZ with these directions at its ends; every other axis moves
    /// in proportion. Made by the `profiler` model; the ends are those of the segment.
    Curve {
        /// Direction at the start, of length 1.
        start: [f32; 3],
        /// Direction at the end.
        end: [f32; 3],
    },
}

/// One move, ready for planning. Made by a [`Mover`](crate::Mover); never of zero length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// Its place in the sources.
    pub at: At,
    /// Cut or jog.
    pub kind: MoveKind,
    pub(crate) basis: Basis,
    /// Start, machine frame.
    pub from: Axes,
    /// End, machine frame.
    pub to: Axes,
    /// The way between.
    pub path: Path,
    /// Reference length: the length that speeds refer to, mm or degrees, always positive.
    ///
    /// With [`Feed::Axis`](kerf_program::Feed::Axis) it is the XY path when X or Y moves, else the
    /// way of the axis that needs the longest; with the other feeds it is the XYZ path, or the
    /// joint rotation when only rotary axes move.
    pub length_mm: f64,
    /// Speed asked for, along the reference length.
    pub speed_mm_s: f64,
    /// Speed from which ramps start and at which they end, along the reference length.
    pub ramp_mm_s: f64,
    /// Acceleration of the ramps, along the reference length.
    pub accel_mm_s2: f64,
    /// The operator's override: share of the speed asked for that is run, 1 for all of it.
    pub(crate) feed: f32,
    /// It ends where the move of the program does: it may be a part of that.
    pub is_last_part: bool,
}

impl Move {
    /// The highest speed, along the reference length: what is asked for, as the operator overrides it.
    pub fn top_mm_s(&self) -> f64 {
        self.speed_mm_s * f64::from(self.feed)
    }

    /// The same move under another override, a share of the speed asked for within
    /// [`Move::FEEDS`]. Jogs are not overridden.
    #[must_use]
    pub fn at_feed(mut self, share: f32) -> Self {
        if self.kind == MoveKind::Cut {
            let (least, most) = Self::FEEDS;
            self.feed = if share.is_nan() { 1.0 } else { share.clamp(least, most) };
        }
        self
    }

    /// The least and the greatest override.
    pub const FEEDS: (f32, f32) = (0.1, 2.0);

    /// Position after a share 0 … 1 of the path; exactly `from` and `to` at the ends.
    pub fn position(&self, share: f64) -> Axes {
        if share <= 0.0 {
            return self.from;
        }
        if share >= 1.0 {
            return self.to;
        }
        let straight = self.from.zip(self.to, |a, b| a * (1.0 - share) + b * share);
        if let Some(spline) = self.spline() {
            return with_xyz(straight, spline.at(share)[0]);
        }
        match self.arc() {
            None => straight,
            Some(arc) => self.on_arc(arc, straight, share),
        }
    }

    /// Change of position for a whole share of 1, at a share of the path: the direction of travel
    /// scaled to the whole move. Times speed over reference length it is the velocity of each axis.
    pub fn derivative(&self, share: f64) -> Axes {
        let mut all = self.to.minus(self.from);
        if let Some(spline) = self.spline() {
            return with_xyz(all, spline.at(share)[1]);
        }
        if let Some(arc) = self.arc() {
            let along = arc.direction(share) * arc.length();
            let gap = self.gap(arc);
            all.0[0] = along.x + gap[0];
            all.0[1] = along.y + gap[1];
        }
        all
    }

    /// Change of that derivative for a whole share of 1: zero but in X and Y of an arc and in XYZ of
    /// a curve.
    pub(crate) fn second_derivative(&self, share: f64) -> Axes {
        let mut all = Axes::default();
        if let Some(spline) = self.spline() {
            return with_xyz(all, spline.at(share)[2]);
        }
        if let Some(arc) = self.arc() {
            let place = arc.at(share);
            let square = arc.sweep_rad * arc.sweep_rad;
            all.0[0] = (arc.centre.x - place.x) * square;
            all.0[1] = (arc.centre.y - place.y) * square;
        }
        all
    }

    /// The same move elsewhere.
    pub fn shift(&mut self, by: Axes) {
        (self.from, self.to) = (self.from.plus(by), self.to.plus(by));
        if let Path::Arc { centre, .. } = &mut self.path {
            *centre = [centre[0] + by.0[0], centre[1] + by.0[1]];
        }
    }

    /// The two parts of the move before and after a share of the path.
    pub fn split(&self, share: f64) -> (Self, Self) {
        let middle = self.position(share);
        let part = |from, to, share: f64, ends: bool| Self {
            from,
            to,
            is_last_part: self.is_last_part && ends,
            length_mm: self.length_mm * share,
            path: self.path.part(share),
            ..*self
        };
        if let Path::Curve { start, end } = self.path {
            let along = unit(self.derivative(share).first3()).unwrap_or_default();
            let cut = along.map(|v| v as f32);
            let mut parts = (
                part(self.from, middle, share, share >= 1.0),
                part(middle, self.to, 1.0 - share, true),
            );
            parts.0.path = Path::Curve { start, end: cut };
            parts.1.path = Path::Curve { start: cut, end };
            return parts;
        }
        let mut after = part(middle, self.to, 1.0 - share, true);
        if let (Path::Arc { centre, .. }, Some(arc)) = (&mut after.path, self.arc()) {
            // The circle wanders with the gap; see `gap`.
            let gap = self.gap(arc);
            *centre = [centre[0] + gap[0] * share, centre[1] + gap[1] * share];
        }
        (part(self.from, middle, share, share >= 1.0), after)
    }

    /// Returns `true` if speed may run on into this move from the one before: both are cuts, and their speeds
    /// refer to the same kind of length.
    pub(crate) fn continues(&self, before: &Self) -> bool {
        let cuts = self.kind == MoveKind::Cut && before.kind == MoveKind::Cut;
        cuts && self.basis == before.basis
    }

    /// The move as the search of the `optimal` model sees it.
    pub(crate) fn leg(&self) -> Leg {
        let shape = match self.path {
            Path::Line => Shape::Line,
            Path::Curve { .. } => Shape::Curve,
            Path::Arc { centre, sweep_rad, .. } => {
                let (x, y) = (self.from.0[0] - centre[0], self.from.0[1] - centre[1]);
                Shape::Arc { radius_mm: (x * x + y * y).sqrt(), sweep_rad }
            }
        };
        let Self { from, to, basis, speed_mm_s, .. } = *self;
        Leg { from, to, shape, basis, speed_mm_s, top_mm_s: self.top_mm_s() }
    }

    /// The arc in XY, if it is one.
    pub fn arc(&self) -> Option<Arc2> {
        match self.path {
            Path::Line | Path::Curve { .. } => None,
            Path::Arc { centre, sweep_rad, .. } => Some(Arc2 {
                start: Point2::new(self.from.0[0], self.from.0[1]),
                centre: Point2::new(centre[0], centre[1]),
                sweep_rad,
            }),
        }
    }

    /// The cubic of a smoothed segment, if it is one.
    fn spline(&self) -> Option<Spline> {
        let Path::Curve { start, end } = self.path else { return None };
        let [start, end] = [start, end].map(|d| d.map(f64::from));
        Some(Spline::new(self.from.first3(), self.to.first3(), start, end))
    }

    /// Returns the offset of the end from where the arc about the centre arrives: programs give both, and
    /// they agree only within a tolerance. The difference is spread evenly along the path.
    fn gap(&self, arc: Arc2) -> [f64; 2] {
        let end = arc.end();
        [self.to.0[0] - end.x, self.to.0[1] - end.y]
    }

    fn on_arc(&self, arc: Arc2, straight: Axes, share: f64) -> Axes {
        let place = arc.at(share);
        let gap = self.gap(arc);
        let mut position = straight;
        position.0[0] = place.x + gap[0] * share;
        position.0[1] = place.y + gap[1] * share;
        position
    }
}

/// The same place with other values of X, Y and Z.
fn with_xyz(mut all: Axes, xyz: Vec3) -> Axes {
    all.0[..3].copy_from_slice(&xyz);
    all
}

impl Path {
    fn part(self, share: f64) -> Self {
        match self {
            Self::Line | Self::Curve { .. } => self,
            Self::Arc { centre, sweep_rad, chords, small } => Self::Arc {
                centre,
                sweep_rad: sweep_rad * share,
                chords: ((f64::from(chords) * share).ceil() as u32).max(1),
                small,
            },
        }
    }
}
