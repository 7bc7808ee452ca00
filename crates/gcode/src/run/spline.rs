//! G5, G5.1, G5.2: curves, given as lines that lie within the tolerance.

use super::context::Context;
use super::core::Core;
use super::curve::{Nurbs, cubic, shares};
use super::state::Plane;
use super::stop::{Refused, Stop, fail};
use super::{feed, go};
use crate::syntax::codes::{MOTION, g_name};
use crate::syntax::gathered::{Gathered, letters};
use kerf_diag::Code;
use kerf_program::{Axes, MoveKind};

/// The block's motion code, for messages.
fn name_of(g: &Gathered, motion: i32) -> String {
    g_name(g.g[MOTION].unwrap_or(motion))
}

fn need_xy(core: &Core, code: &str) -> Result<(), Refused> {
    core.place.need_on_path()?;
    core.place.need_uncompensated("a curve")?;
    if core.state.modal.plane == Plane::Xy {
        return Ok(());
    }
    Err(fail(Code::ArcPlane, format!("{code} outside the XY plane"), "write G17 before it"))
}

/// G5 (cubic) and G5.1 (quadratic).
pub(super) fn spline(
    c: &mut Context<'_>,
    g: &Gathered,
    motion: i32,
    before: Option<[f64; 2]>,
) -> Result<(), Stop> {
    let name = name_of(g, motion);
    need_xy(c.core, &name)?;
    if g.has_any(letters(b"ZABC")) {
        let message = format!("{name} with an axis beside X and Y");
        return Err(fail(Code::ArcPlane, message, "curves lie in XY"));
    }
    let here = c.core.coordinates.place_of(c.core.place.programmed);
    let from = [here.0[0], here.0[1]];
    let to = go::target(c.core, g)?;
    let end = c.core.coordinates.place_of(to);
    let end = [end.0[0], end.0[1]];
    let offset = |a: u8, b: u8| {
        let scale = c.core.coordinates.scale;
        (g.has(a) || g.has(b)).then(|| [g.or_zero(a) * scale[0], g.or_zero(b) * scale[1]])
    };
    let first = offset(b'I', b'J');
    if motion == 51 {
        let Some(d) = first.filter(|_| !g.has_any(letters(b"PQ"))) else {
            return Err(fail(
                Code::MissingWord,
                "G5.1 needs I and J",
                "they lead from the start to the control point",
            ));
        };
        let control = [from[0] + d[0], from[1] + d[1]];
        let third = |a: f64, b: f64| a + (b - a) * 2.0 / 3.0;
        let c1 = [third(from[0], control[0]), third(from[1], control[1])];
        let c2 = [third(end[0], control[0]), third(end[1], control[1])];
        return curve(c, |t| cubic(from, c1, c2, end, t), to, 1);
    }
    let (Some(first), Some(last)) = (first.or(before.map(|[p, q]| [-p, -q])), offset(b'P', b'Q'))
    else {
        let hint =
            "I J lead from the start to the first control point, P Q from the end to the second";
        return Err(fail(Code::MissingWord, "G5 needs I, J, P and Q", hint));
    };
    let c1 = [from[0] + first[0], from[1] + first[1]];
    let c2 = [end[0] + last[0], end[1] + last[1]];
    curve(c, |t| cubic(from, c1, c2, end, t), to, 1)?;
    c.core.sequels.spline_end = Some(last);
    Ok(())
}

/// G5.2 begins a curve and gives points of it, G5.3 ends it.
pub(super) fn nurbs(c: &mut Context<'_>, g: &Gathered, motion: i32) -> Result<(), Stop> {
    need_xy(c.core, &name_of(g, motion))?;
    if motion == 53 {
        c.core.state.modal.motion = None;
        return end_nurbs(c);
    }
    let core = &mut *c.core;
    let mut nurbs = match core.sequels.nurbs.take() {
        Some(nurbs) => nurbs,
        None => {
            let here = core.coordinates.place_of(core.place.programmed);
            Nurbs::new(g.get(b'L').unwrap_or(3.0), [here.0[0], here.0[1]])?
        }
    };
    let weight = g.get(b'P').unwrap_or(1.0);
    nurbs.need_weight(weight)?;
    if g.has_any(letters(b"XY")) {
        let at = core.coordinates.place_of(go::target(core, g)?);
        nurbs.push([at.0[0], at.0[1]], weight);
    }
    core.sequels.nurbs = Some(nurbs);
    Ok(())
}

fn end_nurbs(c: &mut Context<'_>) -> Result<(), Stop> {
    let Some(nurbs) = c.core.sequels.nurbs.take() else {
        return Err(fail(Code::MissingWord, "G5.3 without G5.2", "G5.2 begins the curve"));
    };
    nurbs.need_points()?;
    let Some(end) = nurbs.end() else { return Ok(()) };
    let from = c.core.place.programmed;
    let to = c.core.coordinates.moved(from, [(0, end[0]), (1, end[1])].into_iter());
    curve(c, |t| nurbs.at(t), to, nurbs.len() as u32)
}

/// Lines along a curve with parameter 0 … 1 and so many spans, ending at a machine position.
fn curve(
    c: &mut Context<'_>,
    at: impl Fn(f64) -> [f64; 2],
    to: Axes,
    spans: u32,
) -> Result<(), Stop> {
    let shares = shares(&at, spans, c.core.options.tolerance_mm);
    let feed = feed::feed(c, to)?;
    let feed = feed::part(feed, shares.len() as u32 + 1);
    for share in shares {
        let [x, y] = at(share);
        let from = c.core.place.programmed;
        let next = c.core.coordinates.moved(from, [(0, x), (1, y)].into_iter());
        go::line_at(c, MoveKind::Cut, next, feed)?;
    }
    go::line_at(c, MoveKind::Cut, to, feed)
}
