//! The fast road: runs of plain moves while no special mode holds.
//!
//! Does exactly what [`execute`](super::execute::execute) does with such blocks, with
//! everything that stays the same kept outside the loop.

use super::core::Core;
use super::spindle::SPINDLE_NUMBER;
use super::state::{FeedMode, Plane, Rates};
use super::{feed, round};
use crate::syntax::moves;
use crate::syntax::text::after_line_end;
use crate::syntax::tree::PlainMove;
use kerf_program::{AXES, At, Axes, Command, Feed, Line, MoveKind, Settings, Sourced};
use std::sync::Arc;

/// Bits of [`PlainMove::LETTERS`].
const AXIS_WORDS: u16 = 0b0000_0011_1111;
const XY: u16 = 0b11;
const ABC: u16 = 0b11_1000;
const IJ: u16 = 1 << I | 1 << J;
const KR: u16 = 1 << 8 | 1 << 9;
/// Places in [`PlainMove::LETTERS`].
const I: usize = 6;
const J: usize = 7;
const F: usize = 10;
const S: usize = 11;

/// Executes plain moves until there is another line, or so many are done.
pub(super) fn run_moves(core: &mut Core, out: &mut Vec<Sourced>, most: u64) {
    if !holds(core) {
        return;
    }
    let Some(call) = core.calls.open.last() else { return };
    let Some(program) = core.calls.programs.get(call.file as usize).cloned() else { return };
    let bound = if core.options.max_lines == 0 { u64::MAX } else { core.options.max_lines };
    let most = most.min(bound.saturating_sub(core.progress.lines));
    let (first, before) = (call.next, out.len());
    let mut road = Road::of(core, call.file, first);
    let Some(line) = program.line(first + 1) else { return };
    let (bytes, mut start) = (program.text.as_bytes(), line.start as usize);
    let mut plain = PlainMove::default();
    for _ in 0..program.lines.moves_from(first, u32::try_from(most).unwrap_or(u32::MAX)) {
        let Some(end) = moves::read(bytes, start, &mut plain) else { break };
        if road.go(&plain, out).is_none() {
            break;
        }
        start = after_line_end(bytes, end);
    }
    road.arrive(core, first, out.len() == before);
}

/// Returns `true` if nothing special holds.
fn holds(core: &Core) -> bool {
    let modal = &core.state.modal;
    let (progress, place, sequels) = (&core.progress, &core.place, &core.sequels);
    progress.started
        && !progress.over
        && progress.only.is_none()
        && progress.stepping.is_off()
        && core.told.units | modal.unit_said
        && core.coordinates.turned.is_none()
        && place.compensator.is_none()
        && place.beside.is_none()
        && core.under_way.probing.is_none()
        && sequels.cycle.is_none()
        && sequels.nurbs.is_none()
        && modal.feed_mode == FeedMode::PerMinute
        && modal.plane == Plane::Xy
        && core.options.proportion[0] == core.options.proportion[1]
}

/// Values that the moves of a run share, and those that they change.
struct Road {
    settings: Arc<Settings>,
    file: u32,
    scale: [f64; AXES],
    zero: Axes,
    relative: bool,
    /// Centres of arcs are places (G90.1): not for this road.
    arc_absolute: bool,
    /// Axes that are not switched on.
    idle: u16,
    /// grbl refuses some moves, which the careful road tells.
    grbl: bool,
    /// Millimetres of a unit.
    unit: f64,
    /// Number of lines of the file that lie behind.
    line: u32,
    position: Axes,
    motion: Option<i32>,
    /// The last of them that was straight.
    straight: Option<i32>,
    rates: Option<Rates>,
    rpm: f64,
    motions: u64,
}

impl Road {
    fn of(core: &Core, file: u32, line: u32) -> Self {
        let modal = &core.state.modal;
        let active = u32::from(core.settings.axis_count);
        Self {
            settings: core.settings.clone(),
            file,
            scale: core.coordinates.scale,
            zero: core.coordinates.zero,
            relative: modal.relative,
            arc_absolute: modal.arc_absolute,
            idle: AXIS_WORDS & u16::MAX.checked_shl(active).unwrap_or(0),
            grbl: core.options.dialect.is_of_grbl(),
            unit: modal.unit.mm(),
            line,
            position: core.place.programmed,
            motion: modal.motion,
            straight: modal.before_cycle,
            rates: modal.feed,
            rpm: modal.rpm,
            motions: 0,
        }
    }

    /// Makes a move; `None`, and nothing done, when it is none for this road.
    fn go(&mut self, plain: &PlainMove, out: &mut Vec<Sourced>) -> Option<()> {
        let named = plain.motion < PlainMove::MODAL;
        let motion = if named { i32::from(plain.motion) * 10 } else { self.motion? };
        let given = plain.given;
        let doubtful = self.grbl && (given & ABC != 0 || motion > 10 && given & XY == 0);
        if doubtful || given & self.idle != 0 || given & AXIS_WORDS == 0 {
            return None;
        }
        let to = self.target(plain);
        let (command, rates) = match motion {
            0 | 10 if given & (IJ | KR) == 0 => self.straight(motion == 0, to, plain)?,
            20 | 30 => self.arc(motion == 20, to, plain)?,
            _ => return None,
        };
        (self.rates, self.motion) = (rates, Some(motion));
        if motion <= 10 {
            self.straight = Some(motion);
        }
        self.line += 1;
        let at = At { file: self.file, line: self.line };
        if let Some(rpm) = plain.value(S).filter(|rpm| *rpm != self.rpm) {
            self.rpm = rpm;
            let command = Command::Spindle { number: SPINDLE_NUMBER, rpm };
            out.push(Sourced { at, command });
        }
        if to != self.position || motion > 10 {
            self.position = to;
            self.motions += 1;
            out.push(Sourced { at, command });
        }
        Some(())
    }

    /// The place that the axis words name.
    fn target(&self, plain: &PlainMove) -> Axes {
        let mut to = self.position;
        for (axis, place) in to.0.iter_mut().enumerate() {
            if let Some(value) = plain.value(axis) {
                let from = if self.relative { *place } else { self.zero.0[axis] };
                *place = value * self.scale[axis] + from;
            }
        }
        to
    }

    /// G0 or G1, and the rates in force with it.
    fn straight(&self, jog: bool, to: Axes, plain: &PlainMove) -> Option<(Command, Option<Rates>)> {
        let rates = self.rates_with(plain);
        let (kind, feed) = if jog {
            (MoveKind::Jog, Feed::Axis)
        } else {
            (MoveKind::Cut, feed::along(rates?, &self.settings, self.position, to))
        };
        Some((Command::Line(Line { kind, to, feed }), rates))
    }

    /// G2 or G3 about a centre, and the rates in force with it.
    fn arc(
        &self,
        clockwise: bool,
        to: Axes,
        plain: &PlainMove,
    ) -> Option<(Command, Option<Rates>)> {
        if plain.given & KR != 0 || plain.given & IJ == 0 || self.arc_absolute {
            return None;
        }
        let [x, y, ..] = self.position.0;
        let i = plain.value(I).unwrap_or(0.0) * self.scale[0];
        let j = plain.value(J).unwrap_or(0.0) * self.scale[1];
        let rates = self.rates_with(plain);
        let feed = Feed::Path(rates?.linear / 60.0);
        let centre = [x + i, y + j];
        let sweep = round::checked_sweep(self.position, centre, to, clockwise)?;
        let arc = round::command(&self.settings, self.position, centre, sweep, to, feed);
        Some((Command::Arc(arc), rates))
    }

    fn rates_with(&self, plain: &PlainMove) -> Option<Rates> {
        plain.value(F).map_or(self.rates, |f| Rates::new(f, self.unit))
    }

    /// Hands over what the moves have changed.
    fn arrive(self, core: &mut Core, first: u32, silent: bool) {
        if self.line == first {
            return;
        }
        core.place.programmed = self.position;
        let modal = &mut core.state.modal;
        (modal.motion, modal.feed, modal.rpm) = (self.motion, self.rates, self.rpm);
        modal.before_cycle = self.straight;
        core.progress.lines += u64::from(self.line - first);
        core.progress.motions += self.motions;
        core.asking.settled &= silent;
        core.sequels.spline_end = None;
        core.told.motion_lost = false;
        core.calls.go_on_at(self.line);
    }
}
