//! An arc in two axes, from its words.

use super::arc_words::ArcWords;
use super::round::{SAME_MM, agree, distance, sweep};
use super::session::Options;
use super::state::Modal;
use super::stop::{Refused, fail};
use crate::syntax::dialect::Dialect;
use kerf_diag::Code;
use kerf_program::Axes;
use kerf_program::settings::LinearUnit;
use std::f64::consts::TAU;

/// A radius word may be so much shorter than half the way, mm; programs round to few places.
const SHORT_RADIUS_MM: f64 = 0.0127;

/// An arc in two axes of its plane, in the file's proportions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flat {
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    pub(super) centre: [f64; 2],
    pub(super) sweep: f64,
}

impl Flat {
    /// The arc between two places of the coordinate system, in the plane in force.
    pub(super) fn new(
        words: &ArcWords,
        [start, end]: [Axes; 2],
        modal: &Modal,
        options: &Options,
    ) -> Result<Self, Refused> {
        let [u, v, w] = modal.plane.axes();
        need_in_plane(words, w, options.dialect)?;
        let proportion = options.proportion;
        let plain = |place: Axes| [place.0[u] / proportion[u], place.0[v] / proportion[v]];
        let (from, to) = (plain(start), plain(end));
        let unit = modal.unit.mm();
        let offsets = [words.offsets[u].map(|o| o * unit), words.offsets[v].map(|o| o * unit)];
        let centre = match (words.radius, offsets) {
            (Some(_), [Some(_), _] | [_, Some(_)]) => {
                let hint = "an arc is given by its centre or by its radius";
                return Err(fail(Code::ModalConflict, "R together with I, J or K", hint));
            }
            (Some(r), _) => centre_by_radius(from, to, r * unit, words.clockwise)?,
            (None, [None, None]) => {
                let hint = "give the centre (I and J in G17) or the radius R";
                return Err(fail(Code::MissingWord, "an arc without centre or radius", hint));
            }
            (None, offsets) => centre_by_offsets(from, offsets, modal.arc_absolute)?,
        };
        check_radii(from, to, centre, modal.unit)?;
        let once = sweep(from, centre, to, words.clockwise);
        let more = (words.turns - 1.0) * TAU;
        Ok(Self { from, to, centre, sweep: once + more.copysign(once) })
    }
}

/// Refuses an offset at right angles to the plane, and a number of turns that is none.
fn need_in_plane(words: &ArcWords, normal: usize, dialect: Dialect) -> Result<(), Refused> {
    // Many posts write I, J and K to every arc; a zero moves nothing.
    let strict = dialect == Dialect::LinuxCnc;
    if words.offsets[normal].is_some_and(|o| o != 0.0 || strict) {
        let letter = b"IJK"[normal] as char;
        let message = format!("{letter} does not lie in the plane of this arc");
        let hint = "G17 takes I and J, G18 I and K, G19 J and K";
        return Err(fail(Code::ArcPlane, message, hint));
    }
    if words.turns < 1.0 || words.turns.fract() != 0.0 {
        let message = format!("P of an arc is its number of turns, not {}", words.turns);
        return Err(fail(Code::OutOfRange, message, "P is a whole number from 1"));
    }
    Ok(())
}

fn centre_by_offsets(
    from: [f64; 2],
    offsets: [Option<f64>; 2],
    absolute: bool,
) -> Result<[f64; 2], Refused> {
    if !absolute {
        return Ok([from[0] + offsets[0].unwrap_or(0.0), from[1] + offsets[1].unwrap_or(0.0)]);
    }
    let [Some(a), Some(b)] = offsets else {
        let hint = "G90.1 makes the centre a place: both values are needed";
        return Err(fail(Code::MissingWord, "half a centre", hint));
    };
    Ok([a, b])
}

/// The centre of an arc by its radius; a negative one takes the long way round.
fn centre_by_radius(
    from: [f64; 2],
    to: [f64; 2],
    radius: f64,
    clockwise: bool,
) -> Result<[f64; 2], Refused> {
    let way = distance(from, to);
    let half = way / 2.0;
    if half < SAME_MM {
        let message = "an arc by radius that ends where it begins";
        return Err(fail(Code::BadArc, message, "a whole circle needs its centre (I and J)"));
    }
    let size = radius.abs();
    if half - size > SHORT_RADIUS_MM {
        let message = format!("the radius {size:.4} mm is too short: the end is {way:.4} mm away");
        return Err(fail(Code::BadArc, message, "the radius is at least half the way"));
    }
    let height = (size * size - half * half).max(0.0).sqrt();
    let left = clockwise == (radius < 0.0);
    let height = if left { height } else { -height };
    let along = [(to[0] - from[0]) / way, (to[1] - from[1]) / way];
    let middle = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
    Ok([middle[0] - along[1] * height, middle[1] + along[0] * height])
}

fn check_radii(
    from: [f64; 2],
    to: [f64; 2],
    centre: [f64; 2],
    unit: LinearUnit,
) -> Result<(), Refused> {
    let (r1, r2) = (distance(from, centre), distance(to, centre));
    if r1 == 0.0 || r2 == 0.0 {
        let hint = "the centre lies on an end of the arc";
        return Err(fail(Code::BadArc, "an arc without a radius", hint));
    }
    if agree(r1, r2) {
        return Ok(());
    }
    let (a, b, symbol) = (r1 / unit.mm(), r2 / unit.mm(), unit.symbol());
    let message = format!(
        "the end is not on the circle: radius {a:.4} {symbol} at the start, {b:.4} at the end"
    );
    let hint = "check I and J; G90.1 makes them places, G91.1 distances from the start";
    Err(fail(Code::BadArc, message, hint))
}
