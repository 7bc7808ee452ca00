//! G2 and G3.
//!
//! In XY an arc stays an arc. In the other planes, and where FP stretches X and Y differently, it is
//! given as chords that lie within the tolerance; those of a circle are announced as its chords.

use super::context::{Context, Stop};
use super::state::Plane;
use crate::syntax::dialect::Dialect;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::{Arc, Axes, Chorded, Command, Feed, Line, MoveKind, Settings};
use std::f64::consts::{PI, TAU};

/// Ends this close together make a whole turn, mm.
const SAME_MM: f64 = 1e-7;
/// Radii at the two ends may differ by so much, whatever the radius (LinuxCNC, grbl: close to this).
const RADII_MM: f64 = 0.0254;
/// They may differ by this share of the radius …
const RADII_SHARE: f64 = 0.001;
/// … but never by more than this, mm.
const RADII_MOST_MM: f64 = 2.54;
/// A radius word may be so much shorter than half the way, mm; programs round to few places.
const SHORT_RADIUS_MM: f64 = 0.0127;
/// Chords of one arc; more is a number out of all proportion.
const MOST_CHORDS: f64 = 100_000.0;

/// The words of an arc.
#[derive(Clone, Copy, Debug)]
pub(super) struct ArcWords {
    clockwise: bool,
    /// I, J, K.
    offsets: [Option<f64>; 3],
    radius: Option<f64>,
    turns: f64,
}

impl ArcWords {
    pub(super) fn of(g: &Gathered, clockwise: bool) -> Self {
        Self {
            clockwise,
            offsets: [g.get(b'I'), g.get(b'J'), g.get(b'K')],
            radius: g.get(b'R'),
            turns: g.get(b'P').unwrap_or(1.0),
        }
    }

    pub(super) const fn is_clockwise(&self) -> bool {
        self.clockwise
    }

    /// I, J and K, when all are given and nothing else.
    pub(super) fn all_offsets(&self) -> Option<[f64; 3]> {
        let [Some(i), Some(j), Some(k)] = self.offsets else { return None };
        (self.radius.is_none() && self.turns == 1.0).then_some([i, j, k])
    }
}

/// An arc in two axes of its plane.
#[derive(Clone, Copy, Debug)]
struct Flat {
    from: [f64; 2],
    to: [f64; 2],
    centre: [f64; 2],
    sweep: f64,
}

/// The swept angle of an arc about a centre, positive counter-clockwise; a whole turn when the ends
/// are one place.
fn sweep(from: [f64; 2], centre: [f64; 2], to: [f64; 2], clockwise: bool) -> f64 {
    let a = [from[0] - centre[0], from[1] - centre[1]];
    let b = [to[0] - centre[0], to[1] - centre[1]];
    let turn = if (from[0] - to[0]).abs() < SAME_MM && (from[1] - to[1]).abs() < SAME_MM {
        TAU
    } else {
        let (cross, dot) = (a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        let left = cross.atan2(dot);
        let forward = if clockwise { -left } else { left };
        if forward <= 0.0 { forward + TAU } else { forward }
    };
    if clockwise { -turn } else { turn }
}

/// Returns `true` if two radii count as one.
fn agree(r1: f64, r2: f64) -> bool {
    let difference = (r1 - r2).abs();
    difference <= RADII_MM || difference <= RADII_MOST_MM && difference <= RADII_SHARE * r1.max(r2)
}

/// Returns `true` if two places lie on one circle about a centre.
pub(super) fn is_round(from: [f64; 2], centre: [f64; 2], to: [f64; 2]) -> bool {
    let (r1, r2) = (distance(from, centre), distance(to, centre));
    r1 > 0.0 && r2 > 0.0 && agree(r1, r2)
}

/// The sweep of an arc in XY by its centre; `None` when it is none.
pub(super) fn checked_sweep(
    from: Axes,
    centre: [f64; 2],
    to: Axes,
    clockwise: bool,
) -> Option<f64> {
    let (from, to) = ([from.0[0], from.0[1]], [to.0[0], to.0[1]]);
    is_round(from, centre, to).then(|| sweep(from, centre, to, clockwise))
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    (x * x + y * y).sqrt()
}

/// The command of an arc in XY, machine frame.
pub(super) fn command(
    settings: &Settings,
    from: Axes,
    centre: [f64; 2],
    sweep_rad: f64,
    to: Axes,
    feed: Feed,
) -> Arc {
    let radius = distance([from.0[0], from.0[1]], centre);
    let chords = radius * sweep_rad.abs() / settings.resolution.circle_mm.max(1e-3);
    Arc {
        kind: MoveKind::Cut,
        centre,
        sweep_rad,
        to,
        feed,
        chords: (chords.ceil().min(MOST_CHORDS) as u32).max(1),
        small: 2.0 * radius < settings.ramps.small_circle_mm,
    }
}

/// Returns the number of chords with which an arc stays within a tolerance.
pub(super) fn chords_within(radius: f64, sweep: f64, tolerance: f64) -> u32 {
    let share = (1.0 - tolerance / radius.max(tolerance)).clamp(-1.0, 1.0);
    let step = (2.0 * share.acos()).clamp(1e-3, PI / 4.0);
    (sweep.abs() / step).ceil().clamp(1.0, MOST_CHORDS) as u32
}

impl Context<'_> {
    /// An arc by its words.
    pub(super) fn arc(&mut self, words: &ArcWords, g: &Gathered) -> Result<(), Stop> {
        self.need_straight()?;
        let to = self.target(g)?;
        let plane = self.core.state.modal.plane;
        if let Some(arc) = self.spatial(words, to)? {
            let feed = self.feed(self.core.position, self.moving(to))?;
            self.spatial_arc(&arc, to, feed);
            return Ok(());
        }
        let [u, v, w] = plane.axes();
        let flat = self.flat(words, to, [u, v, w])?;
        let feed = self.feed(self.core.position, self.moving(to))?;
        if plane == Plane::Xy && self.core.options.keeps_circles() {
            return self.round_arc(&flat, to, feed);
        }
        if self.core.compensator.is_some() {
            let what = match plane {
                Plane::Xy => "arcs that the proportions of the file stretch",
                _ => "arcs in this plane",
            };
            return Err(self.not_compensated(what));
        }
        self.chords(&flat, [u, v], to, feed)
    }

    /// A place that is surely another one, so that the feed of a whole turn counts along the path.
    fn moving(&self, to: Axes) -> Axes {
        let mut other = to;
        if (0..3).all(|i| to.0[i] == self.core.position.0[i]) {
            other.0[0] += 1.0;
        }
        other
    }

    /// The arc in the two axes of its plane, in the file's proportions.
    fn flat(&self, words: &ArcWords, to: Axes, [u, v, w]: [usize; 3]) -> Result<Flat, Stop> {
        // Many posts write I, J and K to every arc; a zero moves nothing.
        let strict = self.core.options.dialect == Dialect::LinuxCnc;
        if words.offsets[w].is_some_and(|o| o != 0.0 || strict) {
            let letter = b"IJK"[w] as char;
            let message = format!("{letter} does not lie in the plane of this arc");
            return Err(self.fail(
                Code::ArcPlane,
                message,
                "G17 takes I and J, G18 I and K, G19 J and K",
            ));
        }
        if words.turns < 1.0 || words.turns.fract() != 0.0 {
            let message = format!("P of an arc is its number of turns, not {}", words.turns);
            return Err(self.fail(Code::OutOfRange, message, "P is a whole number from 1"));
        }
        let proportion = |axis: usize| self.core.options.proportion[axis];
        let plain = |place: Axes| [place.0[u] / proportion(u), place.0[v] / proportion(v)];
        let from = plain(self.core.place_of(self.core.position));
        let end = plain(self.core.place_of(to));
        let unit = self.core.state.modal.unit.mm();
        let offsets = [words.offsets[u].map(|o| o * unit), words.offsets[v].map(|o| o * unit)];
        let centre = match (words.radius, offsets) {
            (Some(_), [Some(_), _] | [_, Some(_)]) => {
                let hint = "an arc is given by its centre or by its radius";
                return Err(self.fail(Code::ModalConflict, "R together with I, J or K", hint));
            }
            (Some(r), _) => self.centre_by_radius(from, end, r * unit, words.clockwise)?,
            (None, [None, None]) => {
                let hint = "give the centre (I and J in G17) or the radius R";
                return Err(self.fail(Code::MissingWord, "an arc without centre or radius", hint));
            }
            (None, offsets) => self.centre_by_offsets(from, offsets)?,
        };
        self.check_radii(from, end, centre)?;
        let once = sweep(from, centre, end, words.clockwise);
        let more = (words.turns - 1.0) * TAU;
        Ok(Flat { from, to: end, centre, sweep: once + more.copysign(once) })
    }

    fn centre_by_offsets(
        &self,
        from: [f64; 2],
        offsets: [Option<f64>; 2],
    ) -> Result<[f64; 2], Stop> {
        if !self.core.state.modal.arc_absolute {
            return Ok([from[0] + offsets[0].unwrap_or(0.0), from[1] + offsets[1].unwrap_or(0.0)]);
        }
        let [Some(a), Some(b)] = offsets else {
            let hint = "G90.1 makes the centre a place: both values are needed";
            return Err(self.fail(Code::MissingWord, "half a centre", hint));
        };
        Ok([a, b])
    }

    /// The centre of an arc by its radius; a negative one takes the long way round.
    fn centre_by_radius(
        &self,
        from: [f64; 2],
        to: [f64; 2],
        radius: f64,
        clockwise: bool,
    ) -> Result<[f64; 2], Stop> {
        let way = distance(from, to);
        let half = way / 2.0;
        if half < SAME_MM {
            let hint = "a whole circle needs its centre (I and J)";
            return Err(self.fail(
                Code::BadArc,
                "an arc by radius that ends where it begins",
                hint,
            ));
        }
        let size = radius.abs();
        if half - size > SHORT_RADIUS_MM {
            let message =
                format!("the radius {:.4} mm is too short: the end is {way:.4} mm away", size);
            return Err(self.fail(Code::BadArc, message, "the radius is at least half the way"));
        }
        let height = (size * size - half * half).max(0.0).sqrt();
        let left = clockwise == (radius < 0.0);
        let height = if left { height } else { -height };
        let along = [(to[0] - from[0]) / way, (to[1] - from[1]) / way];
        let middle = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
        Ok([middle[0] - along[1] * height, middle[1] + along[0] * height])
    }

    fn check_radii(&self, from: [f64; 2], to: [f64; 2], centre: [f64; 2]) -> Result<(), Stop> {
        let (r1, r2) = (distance(from, centre), distance(to, centre));
        if r1 == 0.0 || r2 == 0.0 {
            let hint = "the centre lies on an end of the arc";
            return Err(self.fail(Code::BadArc, "an arc without a radius", hint));
        }
        if agree(r1, r2) {
            return Ok(());
        }
        let unit = self.core.state.modal.unit;
        let (a, b, symbol) = (r1 / unit.mm(), r2 / unit.mm(), unit.symbol());
        let message = format!(
            "the end is not on the circle: radius {a:.4} {symbol} at the start, {b:.4} at the end"
        );
        let hint = "check I and J; G90.1 makes them places, G91.1 distances from the start";
        Err(self.fail(Code::BadArc, message, hint))
    }

    fn round_arc(&mut self, flat: &Flat, to: Axes, feed: Feed) -> Result<(), Stop> {
        let mut place = self.core.place_of(self.core.position);
        for (i, c) in flat.centre.into_iter().enumerate() {
            place.0[i] = c * self.core.options.proportion[i];
        }
        let centre = self.core.machine_of(place);
        let centre = [centre.0[0], centre.0[1]];
        let sweep = if self.core.options.mirrors() { -flat.sweep } else { flat.sweep };
        if self.core.compensator.is_some() {
            return self.compensated_arc(centre, sweep, to, feed);
        }
        let arc = command(&self.core.settings, self.core.position, centre, sweep, to, feed);
        self.core.position = to;
        self.emit(Command::Arc(arc));
        Ok(())
    }

    /// An arc as chords; the other axes move evenly.
    fn chords(
        &mut self,
        flat: &Flat,
        [u, v]: [usize; 2],
        to: Axes,
        feed: Feed,
    ) -> Result<(), Stop> {
        let (r1, r2) = (distance(flat.from, flat.centre), distance(flat.to, flat.centre));
        let proportion = self.core.options.proportion;
        let largest = proportion[u].abs().max(proportion[v].abs()).max(1.0);
        let count = chords_within(r1.max(r2), flat.sweep, self.core.options.tolerance_mm / largest);
        if let Some(chorded) = self.chorded(flat, [u, v], to, feed, count) {
            self.emit(Command::Chorded(chorded));
        }
        let feed = match feed {
            Feed::Time(s) => Feed::Time(s / f64::from(count)),
            feed => feed,
        };
        let start = (flat.from[1] - flat.centre[1]).atan2(flat.from[0] - flat.centre[0]);
        let begin = self.core.position;
        for i in 1..count {
            let share = f64::from(i) / f64::from(count);
            let (sin, cos) = (start + flat.sweep * share).sin_cos();
            let radius = r1 + (r2 - r1) * share;
            let even = begin.zip(to, |a, b| a + (b - a) * share);
            let places = [
                (u, (flat.centre[0] + radius * cos) * proportion[u]),
                (v, (flat.centre[1] + radius * sin) * proportion[v]),
            ];
            let next = self.core.moved(even, places.into_iter());
            self.core.position = next;
            self.emit(Command::Line(Line { kind: MoveKind::Cut, to: next, feed }));
        }
        self.core.position = to;
        self.emit(Command::Line(Line { kind: MoveKind::Cut, to, feed }));
        Ok(())
    }

    /// Returns the circle that the chords of an arc follow, unless FP stretches or the system turns it.
    fn chorded(
        &self,
        flat: &Flat,
        axes: [usize; 2],
        to: Axes,
        feed: Feed,
        chords: u32,
    ) -> Option<Chorded> {
        let [u, v] = axes;
        let proportion = self.core.options.proportion;
        let is_circle = proportion[u] == proportion[v] && self.core.turned.is_none();
        let centre = [(0, u), (1, v)]
            .map(|(n, axis)| flat.centre[n] * proportion[axis] + self.core.zero.0[axis]);
        let sweep_rad = flat.sweep;
        is_circle.then_some(Chorded { chords, axes, centre, sweep_rad, to, feed })
    }
}
