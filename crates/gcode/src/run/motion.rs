//! Which motion a block makes, and where it goes.

use super::arc_words::ArcWords;
use super::context::Context;
use super::modes::doubt_unit;
use super::probe::begin_probe;
use super::stop::{Stop, fail};
use super::{arc, cycles, feed, go, spline};
use crate::syntax::codes::{MOTION, ONCE, g_name};
use crate::syntax::gathered::{AXIS_WORDS, Gathered, letters};
use kerf_diag::Code;
use kerf_program::{Feed, MoveKind};

/// Makes the motion of a block and keeps it for the blocks behind.
pub(super) fn set_motion(c: &mut Context<'_>, g: &Gathered, motion: i32) -> Result<(), Stop> {
    let machine_frame = g.g[ONCE] == Some(530);
    if machine_frame && !matches!(motion, 0 | 10) {
        let message = format!("G53 with {}", g_name(motion));
        return Err(fail(Code::ModalConflict, message, "G53 goes with G0 and G1"));
    }
    if !matches!(motion, 730 | 810..=890) {
        c.core.sequels.cycle = None;
    }
    let spline_end = c.core.sequels.spline_end.take();
    if c.core.sequels.nurbs.is_some() && !matches!(motion, 52 | 53) {
        return Err(fail(Code::MissingWord, "G5.2 without G5.3", "G5.3 ends the curve"));
    }
    c.core.told.motion_lost = false;
    let modal = &mut c.core.state.modal;
    modal.motion = (motion != 800).then_some(motion);
    if matches!(motion, 0 | 10) {
        modal.before_cycle = Some(motion);
    }
    let place = letters(b"@^") | AXIS_WORDS;
    let goes = g.has_any(place) && !g.axes_taken();
    if goes || matches!(motion, 20 | 30) {
        doubt_unit(c);
    }
    let outcome = make_motion(c, g, motion, goes, spline_end);
    if c.core.options.keep_going && goes && outcome.as_ref().is_err_and(Stop::is_error) {
        // What follows is read as if the move had been made, so that one mistake is told once.
        if let Ok(to) = go::target(c.core, g) {
            c.core.place.programmed = to;
        }
    }
    outcome
}

fn make_motion(
    c: &mut Context<'_>,
    g: &Gathered,
    motion: i32,
    goes: bool,
    spline_end: Option<[f64; 2]>,
) -> Result<(), Stop> {
    match motion {
        0 if goes => straight(c, g, MoveKind::Jog),
        10 if goes => straight(c, g, MoveKind::Cut),
        20 | 30 if g.g[MOTION].is_some() && !goes && !g.has_any(letters(b"IJKR")) => {
            arc_without_words(c, motion)
        }
        20 | 30 if goes || g.has_any(letters(b"IJKR")) => {
            arc::arc(c, &ArcWords::of(g, motion == 20), g)
        }
        50 | 51 => spline::spline(c, g, motion, spline_end),
        52 | 53 => spline::nurbs(c, g, motion),
        382..=385 => begin_probe(c, g, motion),
        730 | 810..=890 if c.core.options.path_only => Ok(()),
        730 | 810..=890 => cycles::cycle(c, g, motion),
        _ => Ok(()),
    }
}

/// A bare G2 or G3: only the mode is set, if anything.
fn arc_without_words(c: &mut Context<'_>, motion: i32) -> Result<(), Stop> {
    let message = format!("{} without a place or a centre", g_name(motion));
    let hint = "an arc names its end and I, J or R, as in G2 X10 Y0 I5";
    if !c.core.options.dialect.is_lenient() {
        return Err(fail(Code::MissingWord, message, hint));
    }
    c.warn(Code::Unusual, message, hint);
    Ok(())
}

fn straight(c: &mut Context<'_>, g: &Gathered, kind: MoveKind) -> Result<(), Stop> {
    let to = go::target(c.core, g)?;
    let feed = match kind {
        MoveKind::Jog => Feed::Axis,
        MoveKind::Cut => feed::feed(c, to)?,
    };
    go::line_at(c, kind, to, feed)
}
