//! G40 … G42: cutter compensation on and off.

use super::compensation::Compensator;
use super::context::Context;
use super::state::{Plane, Side};
use super::stop::{Stop, fail};
use crate::syntax::codes::COMPENSATION;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;

/// G40, G41, G41.1, G42, G42.1.
pub(super) fn compensation(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let Some(code) = g.g[COMPENSATION] else { return Ok(()) };
    if code == 400 {
        end_compensation(c);
        return Ok(());
    }
    if c.core.place.compensator.is_some() {
        let message = "compensation is on already";
        return Err(fail(Code::Compensation, message, "G40 turns it off first"));
    }
    if c.core.state.modal.plane != Plane::Xy {
        let message = "compensation outside the XY plane";
        return Err(fail(Code::Compensation, message, "write G17 before it"));
    }
    let radius = tool_radius(c, g, matches!(code, 411 | 421))?;
    let side = if matches!(code, 410 | 411) { Side::Left } else { Side::Right };
    // A negative diameter, as tool tables have for measured tools, is the other side; so is the side of a
    // file that FP mirrors.
    let left = (side == Side::Left) == (radius >= 0.0);
    let sign = if left == c.core.options.mirrors() { -1.0 } else { 1.0 };
    c.core.state.modal.compensation = Some((side, radius));
    let compensator = Compensator::new(sign, radius.abs(), c.core.place.tool());
    c.core.place.compensator = Some(compensator);
    Ok(())
}

fn tool_radius(c: &mut Context<'_>, g: &Gathered, given: bool) -> Result<f64, Stop> {
    if given {
        let Some(d) = g.get(b'D') else {
            let hint = "G41.1 D6 compensates for a cutter of that diameter";
            return Err(fail(Code::MissingWord, "G41.1 and G42.1 need D", hint));
        };
        return Ok(d * c.core.state.modal.unit.mm() / 2.0);
    }
    let spindle = c.core.state.tool;
    let number = g.tool(b'D').filter(|d| *d > 0).unwrap_or(spindle);
    if g.tool(b'D') == Some(0) {
        let message = "D0 is no tool";
        let hint =
            format!("the one in the spindle counts: tool {spindle}; leave D out, or name the tool");
        c.warn(Code::Unusual, message, hint);
    }
    if number == 0 {
        return Ok(cutter_of_settings(c, "no tool is in the spindle".into()));
    }
    if let Some(tool) = c.core.state.tools.get(&number) {
        return Ok(tool.diameter_mm / 2.0);
    }
    Ok(cutter_of_settings(c, format!("the diameter of tool {number} is not known")))
}

/// The radius of the cutter of the settings, for want of a better one: none at all would cut too large.
fn cutter_of_settings(c: &mut Context<'_>, why: String) -> f64 {
    let diameter = c.core.settings.cutter.diameter_mm;
    let hint = format!("the cutter of the settings is taken: {diameter:.3} mm");
    c.warn(Code::Unusual, why, hint);
    diameter / 2.0
}

/// G40, or the end of the program: what is held back is made.
pub(super) fn end_compensation(c: &mut Context<'_>) {
    let place = &mut c.core.place;
    // The program goes on from the place on its path; the tool comes back with the next move.
    if let Some(mut compensator) = place.compensator.take() {
        let given = compensator.release(&c.core.settings);
        let beside = compensator.tool() != place.programmed;
        place.beside = beside.then_some(compensator.tool());
        given.into_iter().for_each(|sourced| c.give(sourced));
    }
    c.core.state.modal.compensation = None;
}
