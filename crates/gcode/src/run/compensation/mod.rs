//! G40 … G42: the tool beside the path, for lines and arcs in XY.
//!
//! ```text
//!   programmed   ────────┐          outside corner: an arc about the corner
//!   tool (left)  ─────╮  │          inside corner: both paths end where they cross
//! ```
//!
//! The last move is held back until the next one is known, and with it everything given behind it
//! (moves of Z alone, outputs, comments), so that the order stays. The first move after G41 or G42
//! goes to the place beside its end, as LinuxCNC does it.

mod piece;

use super::context::{Context, Stop};
use super::state::Side;
use super::{Core, Plane};
use crate::syntax::codes::COMPENSATION;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_geom::{Arc2, Point2, Vec2};
use kerf_program::{Axes, Command, Feed, Line, MoveKind, Sourced};
use piece::{Piece, Shape, TINY_MM, crossing, with_xy, xy};
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// Corners that turn by less are no corners, radians (LinuxCNC's tolerance). The tool cuts them by
/// at most 0.03% of its radius.
const STRAIGHT_RAD: f64 = 0.05;
/// Straight paths that turn round by this much less than half a turn go back over themselves, radians: there
/// is no inside, and the tool goes round the end. A guess; rounding is far below it.
const REVERSAL_RAD: f64 = 1e-6;
/// Arcs that meet within this of half a turn may be a cusp, radians (the angle at which LinuxCNC takes a corner
/// for one).
const CUSP_RAD: f64 = 0.05;

/// Compensation that is on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Compensator {
    /// +1 for the left side, −1 for the right.
    side: f64,
    radius: f64,
    /// The entry move is still to come.
    first: bool,
    /// Place of the tool, or its place when the move held back is made.
    tool: Axes,
    /// The move held back.
    held: Option<Piece>,
    /// Commands that were given behind it.
    behind: Vec<Sourced>,
}

impl Compensator {
    /// Keeps a command behind the move held back; gives it back when none is.
    pub(super) fn keep(&mut self, sourced: Sourced) -> Option<Sourced> {
        if self.held.is_none() {
            return Some(sourced);
        }
        self.behind.push(sourced);
        None
    }

    /// The workpiece lies elsewhere by so much, machine frame.
    pub(super) fn nudge(&mut self, by: Axes) {
        self.tool = self.tool.plus(by);
        self.held.iter_mut().for_each(|piece| piece.nudge(by));
        self.behind.iter_mut().for_each(|sourced| sourced.command.shift(by));
    }

    fn beside(&self, heading: Vec2) -> Vec2 {
        heading.left() * (self.side * self.radius)
    }
}

impl Core {
    /// Returns the place to which the tool has been sent.
    pub(super) fn tool_position(&self) -> Axes {
        let beside = self.beside.unwrap_or(self.position);
        self.compensator.as_ref().map_or(beside, |c| c.tool)
    }
}

impl Context<'_> {
    /// G40, G41, G41.1, G42, G42.1.
    pub(super) fn compensation(&mut self, g: &Gathered) -> Result<(), Stop> {
        let Some(code) = g.g[COMPENSATION] else { return Ok(()) };
        if code == 400 {
            return self.end_compensation();
        }
        if self.core.compensator.is_some() {
            let message = "compensation is on already";
            return Err(self.fail(Code::Compensation, message, "G40 turns it off first"));
        }
        if self.core.state.modal.plane != Plane::Xy {
            let message = "compensation outside the XY plane";
            return Err(self.fail(Code::Compensation, message, "write G17 before it"));
        }
        let radius = self.tool_radius(g, matches!(code, 411 | 421))?;
        let side = if matches!(code, 410 | 411) { Side::Left } else { Side::Right };
        // A negative diameter, as tool tables have for measured tools, is the other side; so is the side of a
        // file that FP mirrors.
        let left = (side == Side::Left) == (radius >= 0.0);
        let sign = if left == self.core.options.mirrors() { -1.0 } else { 1.0 };
        self.core.state.modal.compensation = Some((side, radius));
        self.core.compensator = Some(Compensator {
            side: sign,
            radius: radius.abs(),
            first: true,
            tool: self.core.tool_position(),
            held: None,
            behind: Vec::new(),
        });
        Ok(())
    }

    fn tool_radius(&mut self, g: &Gathered, given: bool) -> Result<f64, Stop> {
        if given {
            let Some(d) = g.get(b'D') else {
                let hint = "G41.1 D6 compensates for a cutter of that diameter";
                return Err(self.fail(Code::MissingWord, "G41.1 and G42.1 need D", hint));
            };
            return Ok(d * self.core.state.modal.unit.mm() / 2.0);
        }
        let spindle = self.core.state.tool;
        let number = g.tool(b'D').filter(|d| *d > 0).unwrap_or(spindle);
        if g.tool(b'D') == Some(0) {
            let message = "D0 is no tool";
            let hint = format!(
                "the one in the spindle counts: tool {spindle}; leave D out, or name the tool"
            );
            self.warn(Code::Unusual, message, hint);
        }
        if number == 0 {
            return Ok(self.cutter_of_settings("no tool is in the spindle".into()));
        }
        if let Some(tool) = self.core.state.tools.get(&number) {
            return Ok(tool.diameter_mm / 2.0);
        }
        Ok(self.cutter_of_settings(format!("the diameter of tool {number} is not known")))
    }

    /// The radius of the cutter of the settings, for want of a better one: none at all would cut too large.
    fn cutter_of_settings(&mut self, why: String) -> f64 {
        let diameter = self.core.settings.cutter.diameter_mm;
        let hint = format!("the cutter of the settings is taken: {diameter:.3} mm");
        self.warn(Code::Unusual, why, hint);
        diameter / 2.0
    }

    /// Returns the error of something that compensation does not allow.
    pub(super) fn not_compensated(&self, what: &str) -> Stop {
        let message = format!("{what} while cutter compensation is on");
        self.fail(Code::Compensation, message, "write G40 before it")
    }

    /// G40, or the end of the program: what is held back is made.
    pub(super) fn end_compensation(&mut self) -> Result<(), Stop> {
        self.release();
        // The program goes on from the place on its path; the tool comes back with the next move.
        if let Some(compensator) = self.core.compensator.take() {
            let beside = compensator.tool != self.core.position;
            self.core.beside = beside.then_some(compensator.tool);
        }
        self.core.state.modal.compensation = None;
        Ok(())
    }

    /// A curve cannot begin while the tool is still beside the path.
    pub(super) fn need_straight(&self) -> Result<(), Stop> {
        if self.core.beside.is_none() {
            return Ok(());
        }
        let message = "the first move after G40 is no straight one";
        Err(self.fail(Code::Compensation, message, "lead the tool off the path by G0 or G1"))
    }

    /// Gives the move held back and what stands behind it.
    fn release(&mut self) {
        let Some(compensator) = &mut self.core.compensator else { return };
        let (held, behind) = (compensator.held.take(), std::mem::take(&mut compensator.behind));
        let before = compensator.tool;
        if let Some(piece) = held {
            let from = with_xy(before, piece.from);
            if let Some(command) = piece.command(self.core, from) {
                self.give(Sourced { at: piece.at, command });
            }
            self.set_tool_place(piece.to);
        }
        for mut sourced in behind {
            if let Command::Line(line) = &mut sourced.command {
                let place = self.core.tool_position();
                line.to = with_xy(line.to, xy(place));
                let to = line.to;
                self.set_tool_place(to);
            }
            self.give(sourced);
        }
    }

    fn set_tool_place(&mut self, place: Axes) {
        if let Some(compensator) = &mut self.core.compensator {
            compensator.tool = place;
        }
    }

    /// A straight move along the programmed path.
    pub(super) fn compensated_line(
        &mut self,
        kind: MoveKind,
        to: Axes,
        feed: Feed,
    ) -> Result<(), Stop> {
        let Some(compensator) = self.core.compensator.clone() else { return Ok(()) };
        let corner = self.core.position;
        let way = xy(to) - xy(corner);
        let Some(heading) = way.normalized().filter(|_| way.length() > TINY_MM) else {
            self.beside_moves(kind, to, feed);
            return Ok(());
        };
        let beside = compensator.beside(heading);
        let mut piece = Piece {
            at: self.at,
            kind,
            feed,
            from: xy(corner) + beside,
            to: with_xy(to, xy(to) + beside),
            shape: Shape::Line,
            heading: [heading, heading],
            bend: 0.0,
        };
        if compensator.first {
            if way.length() <= compensator.radius {
                let message = "the entry move is not longer than the radius of the tool";
                return Err(self.fail(Code::Compensation, message, "begin further away"));
            }
            piece.from = xy(compensator.tool);
            self.hold_back(piece);
        } else {
            self.join(piece, xy(corner))?;
        }
        self.core.position = to;
        Ok(())
    }

    /// An arc of the programmed path.
    pub(super) fn compensated_arc(
        &mut self,
        centre: [f64; 2],
        sweep: f64,
        to: Axes,
        feed: Feed,
    ) -> Result<(), Stop> {
        let Some(compensator) = self.core.compensator.clone() else { return Ok(()) };
        let (corner, centre) = (self.core.position, Point2::new(centre[0], centre[1]));
        let programmed = Arc2 { start: xy(corner), centre, sweep_rad: sweep };
        let closer = compensator.side * compensator.radius * sweep.signum();
        let shifted = |p: Point2| -> Option<Point2> {
            let radius = p.distance(centre);
            (radius - closer > TINY_MM)
                .then(|| centre + (p - centre) * ((radius - closer) / radius))
        };
        let (Some(from), Some(end)) = (shifted(xy(corner)), shifted(xy(to))) else {
            let message = "the arc is smaller than the tool that should run inside it";
            return Err(self.fail(Code::Compensation, message, "use a smaller cutter"));
        };
        let piece = Piece {
            at: self.at,
            kind: MoveKind::Cut,
            feed,
            from,
            to: with_xy(to, end),
            shape: Shape::Arc { centre, sweep },
            heading: [programmed.direction(0.0), programmed.direction(1.0)],
            bend: sweep.signum() / programmed.start.distance(centre),
        };
        if compensator.first {
            self.enter_by_arc(piece, xy(compensator.tool), centre, sweep)?;
        } else {
            self.join(piece, xy(corner))?;
        }
        self.core.position = to;
        Ok(())
    }

    /// An entry by arc: from where the tool is to the place beside the end, tangent there.
    fn enter_by_arc(
        &mut self,
        mut piece: Piece,
        tool: Point2,
        centre: Point2,
        sweep: f64,
    ) -> Result<(), Stop> {
        let end = piece.end();
        let lost = || {
            let message = "the tool cannot be led onto the path by this arc";
            self.fail(Code::Compensation, message, "enter along a straight line")
        };
        let inward = (centre - end).normalized().ok_or_else(lost)?;
        let chord = tool - end;
        // The centre lies on the radius at the end, as far from the tool as from the end.
        let across = 2.0 * chord.dot(inward);
        let radius = chord.dot(chord) / across;
        if !radius.is_finite() || radius.abs() < TINY_MM {
            return Err(lost());
        }
        let middle = end + inward * radius;
        let (a, b) = (tool - middle, end - middle);
        let mut angle = a.cross(b).atan2(a.dot(b));
        if angle * sweep < 0.0 {
            angle += TAU.copysign(sweep);
        }
        piece.from = tool;
        piece.shape = Shape::Arc { centre: middle, sweep: angle };
        self.hold_back(piece);
        Ok(())
    }

    /// A move of Z and other axes alone: the tool stays beside the path.
    fn beside_moves(&mut self, kind: MoveKind, to: Axes, feed: Feed) {
        if to == self.core.position {
            return;
        }
        self.core.position = to;
        let command = Command::Line(Line { kind, to, feed });
        let at = self.at;
        let Some(compensator) = &mut self.core.compensator else { return };
        if compensator.held.is_some() {
            compensator.behind.push(Sourced { at, command });
            return;
        }
        let place = with_xy(to, xy(compensator.tool));
        compensator.tool = place;
        let command = Command::Line(Line { kind, to: place, feed });
        self.give(Sourced { at, command });
    }

    fn hold_back(&mut self, piece: Piece) {
        self.release();
        if let Some(compensator) = &mut self.core.compensator {
            compensator.held = Some(piece);
            compensator.first = false;
        }
    }

    /// Joins the next move to the one held back, at a corner of the programmed path.
    fn join(&mut self, next: Piece, corner: Point2) -> Result<(), Stop> {
        let Some(compensator) = &self.core.compensator else { return Ok(()) };
        let (side, radius, held) = (compensator.side, compensator.radius, compensator.held);
        let Some(before) = held else {
            self.hold_back(next);
            return Ok(());
        };
        let (d, e) = (before.heading[1], next.heading[0]);
        let angle = d.cross(e).atan2(d.dot(e));
        let outside = match turns_back(angle, side * (before.bend + next.bend), radius) {
            Some(outside) => outside,
            None => angle * side < 0.0,
        };
        if angle.abs() < STRAIGHT_RAD {
            let next = Piece { from: before.end(), ..next };
            self.hold_back(next);
        } else if outside {
            // Round the end of a path that turns back, whichever way rounding has it turn.
            let angle = if angle * side < 0.0 { angle } else { angle - TAU * side };
            self.round_corner(&before, &next, corner, angle);
            self.hold_back(next);
        } else {
            self.inside_corner(before, next)?;
        }
        Ok(())
    }

    /// Round an outside corner.
    fn round_corner(&mut self, before: &Piece, next: &Piece, corner: Point2, angle: f64) {
        let height = match &self.core.compensator {
            Some(c) => c.behind.iter().rev().find_map(|s| match &s.command {
                Command::Line(line) => Some(line.to),
                _ => None,
            }),
            None => None,
        };
        let level = height.unwrap_or(before.to);
        let around = Piece {
            at: next.at,
            kind: next.kind,
            feed: if matches!(next.feed, Feed::Time(_)) { before.feed } else { next.feed },
            from: before.end(),
            to: with_xy(level, next.from),
            shape: Shape::Arc { centre: corner, sweep: angle },
            heading: [before.heading[1], next.heading[0]],
            bend: 0.0,
        };
        self.hold_back(around);
    }

    /// At an inside corner both moves end where they cross.
    fn inside_corner(&mut self, before: Piece, next: Piece) -> Result<(), Stop> {
        let trimmed = crossing(&before, &next, before.end())
            .and_then(|p| Some((before.ending_at(p)?, next.starting_at(p)?)));
        let Some((before, next)) = trimmed else {
            let message = "the tool does not fit into this inside corner";
            return Err(self.fail(
                Code::Compensation,
                message,
                "use a smaller cutter, or longer moves",
            ));
        };
        if let Some(compensator) = &mut self.core.compensator {
            compensator.held = Some(before);
        }
        self.hold_back(next);
        Ok(())
    }
}

/// Tells whether a path that turns back on itself has its corner outside; `None` where it does not turn back, and
/// the angle decides. `bend` is how much the two ways together bend towards the tool's side, 1/mm: with half a turn
/// between them the way back lies beyond the way there when it is above zero, between the tool and it when below.
///
/// ```text
///      ╲_   tool   _╱          both arcs fall away from the tool: inside
///        ╲________╱  ◄ cusp
/// ```
///
/// Ways that leave each other at a small angle and cross again within a radius of the tool are a cusp too.
fn turns_back(angle: f64, bend: f64, radius: f64) -> Option<bool> {
    let short = PI - angle.abs();
    let cusp = short <= (bend.abs() * radius / 2.0).min(CUSP_RAD);
    (cusp || short < REVERSAL_RAD).then_some(bend >= 0.0)
}
