//! G2 and G3.
//!
//! In XY an arc stays an arc. In the other planes, and where FP stretches X and Y differently, it is
//! given as chords that lie within the tolerance; those of a circle are announced as its chords.

use super::arc_words::ArcWords;
use super::compensation::Leg;
use super::context::Context;
use super::core::Core;
use super::flat::Flat;
use super::round::{self, chords_within, distance};
use super::state::Plane;
use super::stop::Stop;
use super::{feed, go, spatial};
use crate::syntax::gathered::Gathered;
use kerf_program::{Axes, Chorded, Command, Feed, Line, MoveKind};

/// An arc by its words.
pub(super) fn arc(c: &mut Context<'_>, words: &ArcWords, g: &Gathered) -> Result<(), Stop> {
    c.core.place.need_on_path()?;
    let to = go::target(c.core, g)?;
    if let Some(arc) = spatial::spatial(c.core, words, to)? {
        let feed = feed::feed(c, moving(c.core, to))?;
        spatial::spatial_arc(c, &arc, to, feed);
        return Ok(());
    }
    let core = &*c.core;
    let ends = [core.place.programmed, to].map(|place| core.coordinates.place_of(place));
    let flat = Flat::new(words, ends, &core.state.modal, &core.options)?;
    let feed = feed::feed(c, moving(c.core, to))?;
    let plane = c.core.state.modal.plane;
    if plane == Plane::Xy && c.core.options.keeps_circles() {
        return round_arc(c, &flat, to, feed);
    }
    c.core.place.need_uncompensated(match plane {
        Plane::Xy => "arcs that the proportions of the file stretch",
        _ => "arcs in this plane",
    })?;
    let [u, v, _] = plane.axes();
    chords(c, &flat, [u, v], to, feed);
    Ok(())
}

/// A place that is surely another one, so that the feed of a whole turn counts along the path.
fn moving(core: &Core, to: Axes) -> Axes {
    let mut other = to;
    if to.first3() == core.place.programmed.first3() {
        other.0[0] += 1.0;
    }
    other
}

fn round_arc(c: &mut Context<'_>, flat: &Flat, to: Axes, feed: Feed) -> Result<(), Stop> {
    let Core { options, coordinates, settings, place, .. } = &mut *c.core;
    let from = place.programmed;
    let mut middle = coordinates.place_of(from);
    for (i, value) in flat.centre.into_iter().enumerate() {
        middle.0[i] = value * options.proportion[i];
    }
    let middle = coordinates.machine_of(middle);
    let centre = [middle.0[0], middle.0[1]];
    let sweep = if options.mirrors() { -flat.sweep } else { flat.sweep };
    if let Some(compensator) = &mut place.compensator {
        let leg = Leg { at: c.at, kind: MoveKind::Cut, feed, from, to };
        let given = compensator.arc(&leg, centre, sweep, settings)?;
        place.programmed = to;
        given.into_iter().for_each(|sourced| c.give(sourced));
        return Ok(());
    }
    let arc = round::command(settings, from, centre, sweep, to, feed);
    place.programmed = to;
    c.emit(Command::Arc(arc));
    Ok(())
}

/// An arc as chords; the other axes move evenly.
fn chords(c: &mut Context<'_>, flat: &Flat, [u, v]: [usize; 2], to: Axes, feed: Feed) {
    let (r1, r2) = (distance(flat.from, flat.centre), distance(flat.to, flat.centre));
    let proportion = c.core.options.proportion;
    let largest = proportion[u].abs().max(proportion[v].abs()).max(1.0);
    let count = chords_within(r1.max(r2), flat.sweep, c.core.options.tolerance_mm / largest);
    if let Some(chorded) = chorded(c.core, flat, [u, v], to, feed, count) {
        c.emit(Command::Chorded(chorded));
    }
    let feed = feed::part(feed, count);
    let start = (flat.from[1] - flat.centre[1]).atan2(flat.from[0] - flat.centre[0]);
    let begin = c.core.place.programmed;
    for i in 1..=count {
        let share = f64::from(i) / f64::from(count);
        let (sin, cos) = (start + flat.sweep * share).sin_cos();
        let radius = r1 + (r2 - r1) * share;
        let even = begin.zip(to, |a, b| a + (b - a) * share);
        let places = [
            (u, (flat.centre[0] + radius * cos) * proportion[u]),
            (v, (flat.centre[1] + radius * sin) * proportion[v]),
        ];
        let moved = c.core.coordinates.moved(even, places.into_iter());
        let next = if i == count { to } else { moved };
        c.core.place.programmed = next;
        c.emit(Command::Line(Line { kind: MoveKind::Cut, to: next, feed }));
    }
}

/// Returns the circle that the chords of an arc follow, unless FP stretches or the system turns it.
fn chorded(
    core: &Core,
    flat: &Flat,
    axes: [usize; 2],
    to: Axes,
    feed: Feed,
    chords: u32,
) -> Option<Chorded> {
    let [u, v] = axes;
    let (proportion, coordinates) = (core.options.proportion, &core.coordinates);
    let is_circle = proportion[u] == proportion[v] && coordinates.turned.is_none();
    let centre = [(0, u), (1, v)]
        .map(|(n, axis)| flat.centre[n] * proportion[axis] + coordinates.zero.0[axis]);
    let sweep_rad = flat.sweep;
    is_circle.then_some(Chorded { chords, axes, centre, sweep_rad, to, feed })
}
