//! The fast road: runs of plain moves while no special mode holds.
//!
//! Does exactly what [`Context::execute`](super::context::Context) does with such blocks, with
//! everything that stays the same kept outside the loop.

use super::Core;
use super::arc;
use super::feed;
use super::modes;
use super::state::{FeedMode, Plane, Rates};
use crate::tree::{MoveNode, Node};
use kerf_program::{At, Command, Feed, Line, MoveKind, Sourced};

/// Bits of [`MoveNode::LETTERS`].
const AXES: u16 = 0b0000_0011_1111;
const F: u16 = 1 << 10;
const S: u16 = 1 << 11;
const IJ: u16 = 0b1100_0000;
const K: u16 = 1 << 8;
const R: u16 = 1 << 9;

/// Executes plain moves until there is another line, or so many are done.
pub(super) fn run_moves(core: &mut Core, out: &mut Vec<Sourced>, most: u64) {
    if !holds(core) {
        return;
    }
    let Some(call) = core.calls.last() else { return };
    let Some(program) = core.programs.get(call.file as usize).cloned() else { return };
    let (file, mut next) = (call.file, call.next as usize);
    let bound = if core.options.max_lines == 0 { u64::MAX } else { core.options.max_lines };
    let mut left = most.min(bound.saturating_sub(core.lines));
    let start = next;
    let before = out.len();
    let (scale, zero, relative) = (core.scale, core.zero, core.state.modal.relative);
    let active = usize::from(core.settings.axis_count);
    let idle = !((1u16 << active) - 1) & AXES;
    let mut others = 0;
    let mut position = core.position;
    let mut motion = core.state.modal.motion;
    let mut rates = core.state.modal.feed;
    let unit = core.state.modal.unit.mm();
    let mut rpm = core.state.modal.rpm;
    while left > 0
        && let Some(line) = program.lines.get(next)
    {
        let Node::Move(MoveNode { motion: code, given, first }) = line.node else { break };
        let wanted = if code < MoveNode::MODAL { Some(i32::from(code) * 10) } else { motion };
        let arc = matches!(wanted, Some(20 | 30));
        let usable = matches!(wanted, Some(0 | 10 | 20 | 30));
        if !usable || given & idle != 0 || given & AXES == 0 || (!arc && given & (IJ | K | R) != 0)
        {
            break;
        }
        let mut index = first as usize;
        let mut take = || {
            index += 1;
            program.numbers.get(index - 1).copied().unwrap_or_default()
        };
        let mut to = position;
        for (axis, place) in to.0.iter_mut().enumerate() {
            if given & (1 << axis) != 0 {
                *place = take() * scale[axis] + if relative { *place } else { zero.0[axis] };
            }
        }
        let feed;
        let command = if arc {
            if given & (K | R) != 0 || given & IJ == 0 || core.state.modal.arc_absolute {
                break;
            }
            let i = if given & (1 << 6) != 0 { take() * scale[0] } else { 0.0 };
            let j = if given & (1 << 7) != 0 { take() * scale[1] } else { 0.0 };
            let f = if given & F != 0 { Some(take()) } else { None };
            let now = f.map_or(rates, |f| Rates::new(f, unit));
            let Some(speed) = now.map(|r| r.linear / 60.0) else { break };
            let centre = [position.0[0] + i, position.0[1] + j];
            let Some(sweep) = arc::checked_sweep(position, centre, to, wanted == Some(20)) else {
                break;
            };
            feed = now;
            Command::Arc(arc::command(
                &core.settings,
                position,
                centre,
                sweep,
                to,
                Feed::Path(speed),
            ))
        } else {
            let f = if given & F != 0 { Some(take()) } else { None };
            feed = f.map_or(rates, |f| Rates::new(f, unit));
            let (kind, speed) = if wanted == Some(0) {
                (MoveKind::Jog, Feed::Axis)
            } else {
                let Some(rates) = feed else { break };
                (MoveKind::Cut, feed::along(rates, position, to))
            };
            Command::Line(Line { kind, to, feed: speed })
        };
        rates = feed;
        motion = wanted;
        next += 1;
        left -= 1;
        let at = At { file, line: next as u32 };
        if given & S != 0 {
            let wanted = take();
            if wanted != rpm {
                rpm = wanted;
                let command = Command::Spindle { number: modes::SPINDLE_NUMBER, rpm };
                out.push(Sourced { at, command });
            }
        }
        if to == position && !arc {
            continue;
        }
        position = to;
        others += 1;
        out.push(Sourced { at, command });
    }
    if next == start {
        return;
    }
    core.position = position;
    core.state.modal.motion = motion;
    core.state.modal.feed = rates;
    core.state.modal.rpm = rpm;
    core.lines += (next - start) as u64;
    core.motions += others;
    core.settled &= out.len() == before;
    core.spline_end = None;
    if let Some(call) = core.calls.last_mut() {
        call.next = next as u32;
    }
}

/// Whether nothing special holds.
fn holds(core: &Core) -> bool {
    let modal = &core.state.modal;
    core.started
        && !core.over
        && core.only.is_none()
        && core.stepping.is_off()
        && core.told.units | modal.unit_said
        && core.turned.is_none()
        && core.compensator.is_none()
        && core.beside.is_none()
        && core.probing.is_none()
        && core.cycle.is_none()
        && core.nurbs.is_none()
        && modal.feed_mode == FeedMode::PerMinute
        && modal.plane == Plane::Xy
        && core.options.proportion[0] == core.options.proportion[1]
}
