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

use super::piece::{Piece, Shape, TINY_MM, crossing, with_xy, xy};
use super::stop::{Refused, fail};
use kerf_diag::Code;
use kerf_geom::{Arc2, Point2};
use kerf_program::{At, Axes, Command, Feed, Line, MoveKind, Settings, Sourced};
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

/// A move of the programmed path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub(super) at: At,
    pub(super) kind: MoveKind,
    pub(super) feed: Feed,
    pub(super) from: Axes,
    pub(super) to: Axes,
}

/// Commands that are to be given now; the caller gives them in this order.
type Given = Vec<Sourced>;

impl Compensator {
    /// Compensation that begins with the tool at a place; `side` is +1 for the left side, −1 for the right.
    pub(super) const fn new(side: f64, radius_mm: f64, tool: Axes) -> Self {
        Self { side, radius: radius_mm, first: true, tool, held: None, behind: Vec::new() }
    }

    /// Place of the tool, or its place when the move held back is made.
    pub(super) const fn tool(&self) -> Axes {
        self.tool
    }

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

    /// Gives the move held back and what stands behind it.
    pub(super) fn release(&mut self, settings: &Settings) -> Given {
        let mut given = Vec::new();
        if let Some(piece) = self.held.take() {
            let from = with_xy(self.tool, piece.from);
            let command = piece.command(settings, from);
            given.extend(command.map(|command| Sourced { at: piece.at, command }));
            self.tool = piece.to;
        }
        for mut sourced in std::mem::take(&mut self.behind) {
            if let Command::Line(line) = &mut sourced.command {
                line.to = with_xy(line.to, xy(self.tool));
                self.tool = line.to;
            }
            given.push(sourced);
        }
        given
    }

    /// A straight move along the programmed path.
    pub(super) fn line(&mut self, leg: &Leg, settings: &Settings) -> Result<Given, Refused> {
        let way = xy(leg.to) - xy(leg.from);
        let Some(heading) = way.normalized().filter(|_| way.length() > TINY_MM) else {
            return Ok(self.beside_moves(leg));
        };
        let beside = heading.left() * (self.side * self.radius);
        let mut piece = Piece {
            at: leg.at,
            kind: leg.kind,
            feed: leg.feed,
            from: xy(leg.from) + beside,
            to: with_xy(leg.to, xy(leg.to) + beside),
            shape: Shape::Line,
            heading: [heading, heading],
            bend: 0.0,
        };
        if !self.first {
            return self.join(piece, xy(leg.from), settings);
        }
        if way.length() <= self.radius {
            let message = "the entry move is not longer than the radius of the tool";
            return Err(fail(Code::Compensation, message, "begin further away"));
        }
        piece.from = xy(self.tool);
        Ok(self.hold_back(piece, settings))
    }

    /// An arc of the programmed path.
    pub(super) fn arc(
        &mut self,
        leg: &Leg,
        centre: [f64; 2],
        sweep: f64,
        settings: &Settings,
    ) -> Result<Given, Refused> {
        let centre = Point2::new(centre[0], centre[1]);
        let programmed = Arc2 { start: xy(leg.from), centre, sweep_rad: sweep };
        let closer = self.side * self.radius * sweep.signum();
        let shifted = |p: Point2| -> Option<Point2> {
            let radius = p.distance(centre);
            (radius - closer > TINY_MM)
                .then(|| centre + (p - centre) * ((radius - closer) / radius))
        };
        let (Some(from), Some(end)) = (shifted(xy(leg.from)), shifted(xy(leg.to))) else {
            let message = "the arc is smaller than the tool that should run inside it";
            return Err(fail(Code::Compensation, message, "use a smaller cutter"));
        };
        let piece = Piece {
            at: leg.at,
            kind: leg.kind,
            feed: leg.feed,
            from,
            to: with_xy(leg.to, end),
            shape: Shape::Arc { centre, sweep },
            heading: [programmed.direction(0.0), programmed.direction(1.0)],
            bend: sweep.signum() / programmed.start.distance(centre),
        };
        if self.first {
            let piece = entry_by_arc(piece, xy(self.tool), centre, sweep)?;
            return Ok(self.hold_back(piece, settings));
        }
        self.join(piece, xy(leg.from), settings)
    }

    /// A move of Z and other axes alone: the tool stays beside the path.
    fn beside_moves(&mut self, leg: &Leg) -> Given {
        let Leg { at, kind, feed, to, .. } = *leg;
        if to == leg.from {
            return Vec::new();
        }
        if self.held.is_some() {
            let command = Command::Line(Line { kind, to, feed });
            self.behind.push(Sourced { at, command });
            return Vec::new();
        }
        self.tool = with_xy(to, xy(self.tool));
        let command = Command::Line(Line { kind, to: self.tool, feed });
        vec![Sourced { at, command }]
    }

    fn hold_back(&mut self, piece: Piece, settings: &Settings) -> Given {
        let given = self.release(settings);
        self.held = Some(piece);
        self.first = false;
        given
    }

    /// Joins the next move to the one held back, at a corner of the programmed path.
    fn join(&mut self, next: Piece, corner: Point2, settings: &Settings) -> Result<Given, Refused> {
        let Some(before) = self.held else { return Ok(self.hold_back(next, settings)) };
        let (d, e) = (before.heading[1], next.heading[0]);
        let angle = d.cross(e).atan2(d.dot(e));
        let outside = match turns_back(angle, self.side * (before.bend + next.bend), self.radius) {
            Some(outside) => outside,
            None => angle * self.side < 0.0,
        };
        if angle.abs() < STRAIGHT_RAD {
            let next = Piece { from: before.end(), ..next };
            return Ok(self.hold_back(next, settings));
        }
        if !outside {
            return self.inside_corner(before, next, settings);
        }
        // Round the end of a path that turns back, whichever way rounding has it turn.
        let angle = if angle * self.side < 0.0 { angle } else { angle - TAU * self.side };
        let around = self.outside_corner(&before, &next, corner, angle);
        let mut given = self.hold_back(around, settings);
        given.extend(self.hold_back(next, settings));
        Ok(given)
    }

    /// The arc of the tool about an outside corner.
    fn outside_corner(&self, before: &Piece, next: &Piece, corner: Point2, angle: f64) -> Piece {
        let height = self.behind.iter().rev().find_map(|s| match &s.command {
            Command::Line(line) => Some(line.to),
            _ => None,
        });
        Piece {
            at: next.at,
            kind: next.kind,
            feed: if matches!(next.feed, Feed::Time(_)) { before.feed } else { next.feed },
            from: before.end(),
            to: with_xy(height.unwrap_or(before.to), next.from),
            shape: Shape::Arc { centre: corner, sweep: angle },
            heading: [before.heading[1], next.heading[0]],
            bend: 0.0,
        }
    }

    /// At an inside corner both moves end where they cross.
    fn inside_corner(
        &mut self,
        before: Piece,
        next: Piece,
        settings: &Settings,
    ) -> Result<Given, Refused> {
        let trimmed = crossing(&before, &next, before.end())
            .and_then(|p| Some((before.ending_at(p)?, next.starting_at(p)?)));
        let Some((before, next)) = trimmed else {
            let message = "the tool does not fit into this inside corner";
            return Err(fail(Code::Compensation, message, "use a smaller cutter, or longer moves"));
        };
        self.held = Some(before);
        Ok(self.hold_back(next, settings))
    }
}

/// An entry by arc: from where the tool is to the place beside the end, tangent there.
fn entry_by_arc(
    mut piece: Piece,
    tool: Point2,
    centre: Point2,
    sweep: f64,
) -> Result<Piece, Refused> {
    let end = piece.end();
    let lost = || {
        let message = "the tool cannot be led onto the path by this arc";
        fail(Code::Compensation, message, "enter along a straight line")
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
    Ok(piece)
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
