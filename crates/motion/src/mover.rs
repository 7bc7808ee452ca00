//! Commands to moves: which length a speed refers to, how fast the move may be, and how steep its
//! ramps (command reference, VS, VR, VU; readings, A-57).

use crate::moves::{Basis, Move, Path};
use kerf_geom::{Arc2, Point2};
use kerf_program::settings::{NO_SHIFT_JOG_MM_S, PerGroup, Ramps};
use kerf_program::{Arc, At, Axes, Axis, Command, Feed, Line, MoveKind, Settings};

/// Shorter ways do not count as motion, mm or degrees. Far below a step of any machine; keeps
/// rounding noise of X and Y from turning a plunge into an XY move.
const STILL_MM: f64 = 1e-9;

/// Coordinates and lengths beyond this are mistakes and refused, mm or degrees: arithmetic stays far
/// from where numbers end.
const FAR_MM: f64 = 1e12;

/// No move is slower, mm/s or degrees/s: a speed of zero in the settings must not stop time.
const MIN_SPEED_MM_S: f64 = 1e-4;

/// No move is faster, mm/s or degrees/s: keeps arithmetic finite, nothing else.
const MAX_SPEED_MM_S: f64 = 1e9;

/// No ramp is steeper, mm/s²: stands for "at once" when the ramp rate is zero.
const MAX_ACCEL_MM_S2: f64 = 1e12;

/// Turns commands into moves: keeps the position and what the settings in force say about speed.
#[derive(Clone, Debug)]
pub struct Mover {
    position: Axes,
    cut: Pace,
    jog: Pace,
}

/// Speeds and ramps of one kind of move.
#[derive(Clone, Copy, Debug)]
struct Pace {
    speed: PerGroup,
    ramp: PerGroup,
    accel: PerGroup,
    /// Step interval divider: everything runs so many times slower.
    divider: f64,
}

/// Ways of the groups of axes in one move, without signs.
struct Extent {
    xy: f64,
    others: [f64; 4],
}

impl Mover {
    /// Starts at a position, with the settings in force.
    pub fn new(start: Axes, settings: &Settings) -> Self {
        Self { position: start, cut: Pace::cut(settings), jog: Pace::jog(settings) }
    }

    /// Returns the place where the last move ended, machine frame.
    pub const fn position(&self) -> Axes {
        self.position
    }

    /// The machine is somewhere else now.
    pub const fn set_position(&mut self, position: Axes) {
        self.position = position;
    }

    /// From here on these settings hold.
    pub fn settings(&mut self, settings: &Settings) {
        self.cut = Pace::cut(settings);
        self.jog = Pace::jog(settings);
    }

    /// The move of a straight command; `None` when nothing moves, or when a coordinate is not a
    /// number or beyond all reason (such a command is refused: the position stays).
    ///
    /// A feed along the path or by time is taken as it is: the axis speeds of the settings hold for
    /// [`Feed::Axis`] only.
    pub fn line(&mut self, at: At, line: &Line) -> Option<Move> {
        let delta = line.to.minus(self.position);
        let extent = Extent::new(length2(delta.0[0], delta.0[1]), delta);
        self.make(at, line.kind, line.to, Path::Line, line.feed, &extent)
    }

    /// The move of a circular command; `None` as for [`Mover::line`]. An arc without radius or
    /// without sweep becomes a straight move.
    pub fn arc(&mut self, at: At, arc: &Arc) -> Option<Move> {
        let start = Point2::new(self.position.0[0], self.position.0[1]);
        let centre = Point2::new(arc.centre[0], arc.centre[1]);
        let length = Arc2 { start, centre, sweep_rad: arc.sweep_rad }.length();
        if arc.centre.iter().any(|v| !in_reach(*v)) {
            return None;
        }
        if length <= STILL_MM {
            let line = Line { kind: arc.kind, to: arc.to, feed: arc.feed };
            return self.line(at, &line);
        }
        let Arc { centre, sweep_rad, chords, small, .. } = *arc;
        let extent = Extent::new(length, arc.to.minus(self.position));
        let path = Path::Arc { centre, sweep_rad, chords, small };
        self.make(at, arc.kind, arc.to, path, arc.feed, &extent)
    }

    /// The axis of a motion command that would go beyond all reason, and where it would end, mm or degrees. The
    /// mover refuses such a command; whoever runs a program says so.
    pub fn beyond(command: &Command) -> Option<(Axis, f64)> {
        let (to, [x, y]) = match command {
            Command::Line(line) => (line.to, [0.0; 2]),
            Command::Arc(arc) => (arc.to, arc.centre),
            _ => return None,
        };
        let places = Axis::ALL.into_iter().map(|axis| (axis, to[axis]));
        let mut places = places.chain([(Axis::X, x), (Axis::Y, y)]);
        places.find(|(_, place)| !in_reach(*place))
    }

    fn make(
        &mut self,
        at: At,
        kind: MoveKind,
        to: Axes,
        path: Path,
        feed: Feed,
        extent: &Extent,
    ) -> Option<Move> {
        let sane = to.0.into_iter().all(in_reach);
        let pace = if kind == MoveKind::Jog { &self.jog } else { &self.cut };
        let (basis, length_mm, time_s) = extent.reference(feed, &pace.speed);
        if !(sane && length_mm > STILL_MM && in_reach(length_mm)) {
            return None;
        }
        let from = std::mem::replace(&mut self.position, to);
        let slower = pace.divider;
        Some(Move {
            at,
            kind,
            basis,
            from,
            to,
            path,
            length_mm,
            speed_mm_s: within(length_mm / time_s, MIN_SPEED_MM_S, MAX_SPEED_MM_S) / slower,
            ramp_mm_s: extent.along(length_mm, &pace.ramp) / slower,
            accel_mm_s2: extent.along(length_mm, &pace.accel) / (slower * slower),
            feed: 1.0,
            is_last_part: true,
        })
    }
}

impl Pace {
    fn cut(settings: &Settings) -> Self {
        let ramps = &settings.ramps;
        Self::new(settings.speeds.cut, ramps.cut, ramps.cut_rate_mm, settings)
    }

    fn jog(settings: &Settings) -> Self {
        let mut speed = settings.speeds.jog;
        if settings.resolution.no_shift {
            speed.xy = speed.xy.min(NO_SHIFT_JOG_MM_S);
            speed.z = speed.z.min(NO_SHIFT_JOG_MM_S);
        }
        let ramps = &settings.ramps;
        Self::new(speed, ramps.jog, ramps.jog_rate_mm, settings)
    }

    fn new(speed: PerGroup, ramp: PerGroup, rate_mm: f64, settings: &Settings) -> Self {
        let ramp = each(ramp, |v| within(v, 0.0, MAX_SPEED_MM_S));
        Self {
            speed: each(speed, |v| within(v, MIN_SPEED_MM_S, MAX_SPEED_MM_S)),
            ramp,
            accel: each(ramp, |v| {
                within(Ramps::acceleration_mm_s2(v, rate_mm.max(0.0)), 1.0, MAX_ACCEL_MM_S2)
            }),
            divider: f64::from(settings.resolution.divider.max(1)),
        }
    }
}

impl Extent {
    fn new(xy: f64, delta: Axes) -> Self {
        Self { xy, others: std::array::from_fn(|i| delta.0[i + 2].abs()) }
    }

    /// Returns what the speed is measured along, that length, and the time it takes at the speeds given.
    fn reference(&self, feed: Feed, speed: &PerGroup) -> (Basis, f64, f64) {
        match feed {
            Feed::Axis => self.by_axis(speed),
            Feed::Path(mm_s) => {
                let (basis, length) = self.by_path();
                (basis, length, length / mm_s.max(MIN_SPEED_MM_S))
            }
            Feed::Time(s) => {
                let (basis, length) = self.by_path();
                (basis, length, s)
            }
        }
    }

    /// Readings, A-57: the XY speed when X or Y moves, reduced so that no other axis exceeds its own; else
    /// the slowest of the axes that move.
    fn by_axis(&self, speed: &PerGroup) -> (Basis, f64, f64) {
        let mut slowest = (Basis::Xy, self.xy, self.xy / speed.xy);
        for (i, way) in self.others.into_iter().enumerate() {
            let time = way / speed.of(OTHERS[i]);
            if time > slowest.2 {
                slowest = (Basis::Axis(i as u8), way, time);
            }
        }
        if self.xy > STILL_MM { (Basis::Xy, self.xy, slowest.2) } else { slowest }
    }

    fn by_path(&self) -> (Basis, f64) {
        let [z, a, b, c] = self.others;
        let space = length2(self.xy, z);
        if space > STILL_MM {
            (Basis::Space, space)
        } else {
            (Basis::Rotary, length2(length2(a, b), c))
        }
    }

    /// The greatest value along the reference length at which no axis exceeds its own.
    fn along(&self, length: f64, own: &PerGroup) -> f64 {
        let mut limit = f64::INFINITY;
        if self.xy > STILL_MM {
            limit = own.xy * (length / self.xy);
        }
        for (axis, way) in OTHERS.into_iter().zip(self.others) {
            if way > STILL_MM {
                limit = limit.min(own.of(axis) * (length / way));
            }
        }
        limit
    }
}

/// Axes beside X and Y.
const OTHERS: [Axis; 4] = [Axis::Z, Axis::A, Axis::B, Axis::C];

fn each(group: PerGroup, f: impl Fn(f64) -> f64) -> PerGroup {
    PerGroup { xy: f(group.xy), z: f(group.z), a: f(group.a), b: f(group.b), c: f(group.c) }
}

/// The value kept between two bounds; the lower one when it is not a number.
fn within(value: f64, low: f64, high: f64) -> f64 {
    value.max(low).min(high)
}

/// Returns `true` if a coordinate or length is a number and not beyond all reason.
fn in_reach(v: f64) -> bool {
    v.abs() < FAR_MM
}

/// Length of a vector. Coordinates are in a range where squares are safe, so `hypot`, which is slow,
/// is not needed.
fn length2(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}
