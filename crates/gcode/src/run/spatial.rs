//! Arcs in any plane: G2 and G3 with I, J and K whose ends lie on one circle in space.
//!
//! Controllers do not agree on them; the dialect `generic` reads what no reading in the plane of
//! G17, G18 or G19 fits (readings, P-6). The arc turns about the normal of the plane through
//! start, centre and end, taken so that it looks the same way as the axis of the plane in force.

use super::arc_words::ArcWords;
use super::context::Context;
use super::core::Core;
use super::feed;
use super::round::{chords_within, is_round};
use super::stop::{Refused, fail};
use kerf_diag::Code;
use kerf_program::{Axes, Command, Feed, Line, MoveKind};
use std::f64::consts::TAU;

/// The distances of start and end from the centre may differ by so much, mm.
const RADII_MM: f64 = 0.01;
/// Start, centre and end lie on one line when the sine of their angle is less than this.
const LEAST_SINE: f64 = 1e-9;

type V3 = [f64; 3];

fn minus(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: V3) -> f64 {
    dot(a, a).sqrt()
}

fn times(a: V3, by: f64) -> V3 {
    a.map(|v| v * by)
}

/// An arc in space, in the file's proportions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spatial {
    centre: V3,
    /// From the centre to the start, and at right angles to it in the direction of counter-clockwise.
    arms: [V3; 2],
    sweep: f64,
}

/// Reason why three places are no arc.
#[derive(Clone, Copy, Debug, PartialEq)]
enum NoArc {
    /// Distances of the ends from the centre.
    Radii(f64, f64),
    /// They lie on a line.
    OneLine,
}

impl Spatial {
    /// `up` is the axis of the plane in force.
    fn new(from: V3, centre: V3, to: V3, up: usize, clockwise: bool) -> Result<Self, NoArc> {
        let (a, b) = (minus(from, centre), minus(to, centre));
        let (r1, r2) = (length(a), length(b));
        if r1 == 0.0 || (r1 - r2).abs() > RADII_MM {
            return Err(NoArc::Radii(r1, r2));
        }
        let normal = cross(a, b);
        let size = length(normal);
        if size <= LEAST_SINE * r1 * r2 {
            return Err(NoArc::OneLine);
        }
        // Of a plane that holds the axis, the first other axis decides.
        let looks = [up, (up + 1) % 3, (up + 2) % 3].map(|axis| normal[axis]);
        let side = looks.into_iter().find(|part| part.abs() > LEAST_SINE * size).unwrap_or(1.0);
        let normal = times(normal, side.signum() / size);
        let beside = cross(normal, a);
        let turned = dot(b, beside).atan2(dot(b, a)).rem_euclid(TAU);
        let sweep = if clockwise { turned - TAU } else { turned };
        Ok(Self { centre, arms: [a, beside], sweep })
    }

    fn at(&self, share: f64) -> V3 {
        let (sin, cos) = (self.sweep * share).sin_cos();
        let [a, b] = self.arms;
        std::array::from_fn(|i| self.centre[i] + a[i] * cos + b[i] * sin)
    }
}

/// The arc in space that words mean which are none in the plane in force; nothing when they may be.
pub(super) fn spatial(core: &Core, words: &ArcWords, to: Axes) -> Result<Option<Spatial>, Refused> {
    let Core { options, coordinates, place, state, .. } = core;
    let Some(offsets) = words.all_offsets() else { return Ok(None) };
    if !options.dialect.is_lenient() || place.compensator.is_some() {
        return Ok(None);
    }
    let plain = |place: Axes| -> V3 { std::array::from_fn(|i| place.0[i] / options.proportion[i]) };
    let from = plain(coordinates.place_of(place.programmed));
    let end = plain(coordinates.place_of(to));
    let offsets = offsets.map(|o| o * state.modal.unit.mm());
    let absolute = state.modal.arc_absolute;
    let centre: V3 =
        std::array::from_fn(|i| if absolute { offsets[i] } else { from[i] + offsets[i] });
    let [u, v, w] = state.modal.plane.axes();
    let flat = |a: V3| [a[u], a[v]];
    if centre[w] == from[w] && is_round(flat(from), flat(centre), flat(end)) {
        return Ok(None);
    }
    match Spatial::new(from, centre, end, w, words.clockwise) {
        Ok(arc) => Ok(Some(arc)),
        // Nothing of an arc in space: what is wrong in the plane is told.
        Err(NoArc::Radii(..)) if centre[w] == from[w] => Ok(None),
        Err(NoArc::Radii(r1, r2)) => {
            let message = format!(
                "the end is not on the circle: {r1:.4} mm from the centre at the start, {r2:.4} at the end"
            );
            let hint = "check I, J and K; G90.1 makes them places, G91.1 distances from the start";
            Err(fail(Code::BadArc, message, hint))
        }
        Err(NoArc::OneLine) => {
            let message = "start, centre and end lie on one line: the plane of the arc is open";
            Err(fail(Code::BadArc, message, "divide the arc in two"))
        }
    }
}

/// An arc in space as chords.
pub(super) fn spatial_arc(c: &mut Context<'_>, arc: &Spatial, to: Axes, feed: Feed) {
    let proportion = c.core.options.proportion;
    let largest = proportion.iter().fold(1.0f64, |most, p| most.max(p.abs()));
    let within = c.core.options.tolerance_mm / largest;
    // An even number, so that the middle of the arc is a place of the path.
    let count = chords_within(length(arc.arms[0]), arc.sweep, within).div_ceil(2) * 2;
    let feed = feed::part(feed, count);
    let begin = c.core.place.programmed;
    for n in 1..=count {
        let share = f64::from(n) / f64::from(count);
        let even = begin.zip(to, |a, b| a + (b - a) * share);
        let place = arc.at(share);
        let places = (0..3).map(|axis| (axis, place[axis] * proportion[axis]));
        let next = if n == count { to } else { c.core.coordinates.moved(even, places) };
        c.core.place.programmed = next;
        c.emit(Command::Line(Line { kind: MoveKind::Cut, to: next, feed }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(to: V3, up: usize, clockwise: bool) -> Result<Spatial, NoArc> {
        Spatial::new([10.0, 0.0, 0.0], [0.0; 3], to, up, clockwise)
    }

    fn near(place: V3, expected: V3) {
        assert!(length(minus(place, expected)) < 1e-4, "{place:?} is not {expected:?}");
    }

    #[test]
    fn the_normal_looks_up() {
        let slanted = arc([0.0, 8.0, 6.0], 2, false).map(|arc| (arc.sweep, arc.at(0.5)));
        let (sweep, middle) = slanted.unwrap_or_default();
        assert!((sweep.to_degrees() - 90.0).abs() < 1e-9);
        near(middle, [7.0711, 5.6569, 4.2426]);
        let back = arc([0.0, 8.0, 6.0], 2, true).map_or(0.0, |arc| arc.sweep);
        assert!((back.to_degrees() + 270.0).abs() < 1e-9);
        // Seen from below it is the other one.
        let below = arc([0.0, -8.0, -6.0], 2, false).map_or(0.0, |arc| arc.sweep);
        assert!((below.to_degrees() - 270.0).abs() < 1e-9);
    }

    #[test]
    fn what_is_no_arc() {
        assert_eq!(arc([-10.0, 0.0, 0.0], 2, false).err(), Some(NoArc::OneLine));
        assert_eq!(arc([0.0, 8.0, 5.0], 2, false).err(), Some(NoArc::Radii(10.0, 89f64.sqrt())));
    }
}
