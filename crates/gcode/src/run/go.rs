//! Where the words of a block lead, and straight moves there.

use super::compensation::Leg;
use super::context::Context;
use super::core::Core;
use super::stop::{Refused, Stop, fail};
use crate::syntax::codes::ONCE;
use crate::syntax::dialect::Dialect;
use crate::syntax::gathered::{Gathered, letters};
use kerf_diag::Code;
use kerf_program::{Axes, Axis, Command, Feed, Line, MoveKind};

/// The place that the axis words of a block name, machine frame.
pub(super) fn target(core: &Core, g: &Gathered) -> Result<Axes, Refused> {
    if g.g[ONCE] == Some(530) {
        return machine_target(core, g);
    }
    if g.has_any(letters(b"@^")) {
        return polar_target(core, g);
    }
    let (coordinates, position) = (&core.coordinates, core.place.programmed);
    let relative = core.state.modal.relative;
    let here = coordinates.place_of(position);
    let values = Axis::ALL.into_iter().filter_map(|axis| {
        let value = g.get(axis.letter() as u8)? * coordinates.scale[axis.index()];
        Some((axis.index(), value + if relative { here[axis] } else { 0.0 }))
    });
    Ok(coordinates.moved(position, values))
}

fn machine_target(core: &Core, g: &Gathered) -> Result<Axes, Refused> {
    let modal = &core.state.modal;
    // grbl and most routers take G53 as a place whatever G91 says.
    if modal.relative && core.options.dialect == Dialect::LinuxCnc {
        let message = "G53 while distances are relative";
        return Err(fail(Code::ModalConflict, message, "write G90 before it"));
    }
    core.place.need_uncompensated("G53")?;
    let mut to = core.place.programmed;
    for axis in Axis::ALL {
        if let Some(value) = g.get(axis.letter() as u8) {
            to[axis] = value * modal.unit_of(&core.settings, axis);
        }
    }
    Ok(to)
}

/// `@` radius and `^` angle in degrees; what is not given stays.
fn polar_target(core: &Core, g: &Gathered) -> Result<Axes, Refused> {
    if g.has_any(letters(b"XY")) {
        let message = "polar and Cartesian words in one block";
        return Err(fail(
            Code::ModalConflict,
            message,
            "a place is given by X and Y or by @ and ^",
        ));
    }
    let coordinates = &core.coordinates;
    let here = coordinates.to_user(coordinates.place_of(core.place.programmed));
    let (mut radius, mut angle) = (here.0[0].hypot(here.0[1]), here.0[1].atan2(here.0[0]));
    let relative = core.state.modal.relative;
    if let Some(r) = g.get(b'@') {
        radius = if relative { radius + r } else { r };
    }
    if let Some(a) = g.get(b'^') {
        angle = if relative { angle + a.to_radians() } else { a.to_radians() };
    }
    let mut rest = g.clone();
    let (x, y) = (radius * angle.cos(), radius * angle.sin());
    rest.clear(b'@');
    rest.clear(b'^');
    rest.set(b'X', if relative { x - here.0[0] } else { x });
    rest.set(b'Y', if relative { y - here.0[1] } else { y });
    target(core, &rest)
}

/// A rapid move.
pub(super) fn line(c: &mut Context<'_>, kind: MoveKind, to: Axes) -> Result<(), Stop> {
    line_at(c, kind, to, Feed::Axis)
}

/// A straight move, compensated where that is on.
pub(super) fn line_at(
    c: &mut Context<'_>,
    kind: MoveKind,
    to: Axes,
    feed: Feed,
) -> Result<(), Stop> {
    let place = &mut c.core.place;
    if let Some(compensator) = &mut place.compensator {
        let leg = Leg { at: c.at, kind, feed, from: place.programmed, to };
        let given = compensator.line(&leg, &c.core.settings)?;
        place.programmed = to;
        given.into_iter().for_each(|sourced| c.give(sourced));
        return Ok(());
    }
    if to != place.tool() {
        c.emit(Command::Line(Line { kind, to, feed }));
    }
    c.core.place.arrive(to);
    Ok(())
}
