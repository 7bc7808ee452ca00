//! Which motion a block makes, and where it goes.

use super::arc::ArcWords;
use super::context::{Context, Stop};
use crate::syntax::codes::{MOTION, ONCE, g_name};
use crate::syntax::dialect::Dialect;
use crate::syntax::gathered::{AXIS_WORDS, Gathered, letters};
use kerf_diag::Code;
use kerf_program::{Axes, Axis, Command, Feed, Line, MoveKind};

impl Context<'_> {
    /// Makes the motion of a block and keeps it for the blocks behind.
    pub(super) fn set_motion(&mut self, g: &Gathered, motion: i32) -> Result<(), Stop> {
        let machine_frame = g.g[ONCE] == Some(530);
        if machine_frame && !matches!(motion, 0 | 10) {
            let message = format!("G53 with {}", g_name(motion));
            return Err(self.fail(Code::ModalConflict, message, "G53 goes with G0 and G1"));
        }
        if !matches!(motion, 730 | 810..=890) {
            self.core.cycle = None;
        }
        let spline_end = self.core.spline_end.take();
        if self.core.nurbs.is_some() && !matches!(motion, 52 | 53) {
            return Err(self.fail(Code::MissingWord, "G5.2 without G5.3", "G5.3 ends the curve"));
        }
        self.core.told.motion_lost = false;
        let modal = &mut self.core.state.modal;
        modal.motion = (motion != 800).then_some(motion);
        if matches!(motion, 0 | 10) {
            modal.before_cycle = Some(motion);
        }
        let place = letters(b"@^") | AXIS_WORDS;
        let goes = g.has_any(place) && !g.axes_taken();
        if goes || matches!(motion, 20 | 30) {
            self.doubt_unit();
        }
        let outcome = self.make_motion(g, motion, goes, spline_end);
        if self.core.options.keep_going && goes && matches!(outcome, Err(Stop::Failed(_))) {
            // What follows is read as if the move had been made, so that one mistake is told once.
            if let Ok(to) = self.target(g) {
                self.core.position = to;
            }
        }
        outcome
    }

    fn make_motion(
        &mut self,
        g: &Gathered,
        motion: i32,
        goes: bool,
        spline_end: Option<[f64; 2]>,
    ) -> Result<(), Stop> {
        match motion {
            0 if goes => self.straight(g, MoveKind::Jog),
            10 if goes => self.straight(g, MoveKind::Cut),
            20 | 30 if g.g[MOTION].is_some() && !goes && !g.has_any(letters(b"IJKR")) => {
                self.arc_without_words(motion)
            }
            20 | 30 if goes || g.has_any(letters(b"IJKR")) => {
                self.arc(&ArcWords::of(g, motion == 20), g)
            }
            50 | 51 => self.spline(g, motion, spline_end),
            52 | 53 => self.nurbs(g, motion),
            382..=385 => self.begin_probe(g, motion),
            730 | 810..=890 if self.core.options.path_only => Ok(()),
            730 | 810..=890 => self.cycle(g, motion),
            _ => Ok(()),
        }
    }

    /// A bare G2 or G3: only the mode is set, if anything.
    fn arc_without_words(&mut self, motion: i32) -> Result<(), Stop> {
        let message = format!("{} without a place or a centre", g_name(motion));
        let hint = "an arc names its end and I, J or R, as in G2 X10 Y0 I5";
        if !self.core.options.dialect.is_lenient() {
            return Err(self.fail(Code::MissingWord, message, hint));
        }
        self.warn(Code::Unusual, message, hint);
        Ok(())
    }

    fn straight(&mut self, g: &Gathered, kind: MoveKind) -> Result<(), Stop> {
        let to = self.target(g)?;
        let feed = match kind {
            MoveKind::Jog => Feed::Axis,
            MoveKind::Cut => self.feed(self.core.position, to)?,
        };
        self.line_at(kind, to, feed)
    }

    /// The place that the axis words of a block name, machine frame.
    pub(super) fn target(&self, g: &Gathered) -> Result<Axes, Stop> {
        if g.g[ONCE] == Some(530) {
            return self.machine_target(g);
        }
        if g.has_any(letters(b"@^")) {
            return self.polar_target(g);
        }
        let relative = self.core.state.modal.relative;
        let here = self.core.place_of(self.core.position);
        let values = Axis::ALL.into_iter().filter_map(|axis| {
            let value = g.get(axis.letter() as u8)? * self.core.scale[axis.index()];
            Some((axis.index(), value + if relative { here[axis] } else { 0.0 }))
        });
        Ok(self.core.moved(self.core.position, values))
    }

    fn machine_target(&self, g: &Gathered) -> Result<Axes, Stop> {
        // grbl and most routers take G53 as a place whatever G91 says.
        if self.core.state.modal.relative && self.core.options.dialect == Dialect::LinuxCnc {
            let message = "G53 while distances are relative";
            return Err(self.fail(Code::ModalConflict, message, "write G90 before it"));
        }
        if self.core.compensator.is_some() {
            return Err(self.not_compensated("G53"));
        }
        let mut to = self.core.position;
        for axis in Axis::ALL {
            if let Some(value) = g.get(axis.letter() as u8) {
                to[axis] = value * self.core.unit_of(axis);
            }
        }
        Ok(to)
    }

    /// `@` radius and `^` angle in degrees; what is not given stays.
    fn polar_target(&self, g: &Gathered) -> Result<Axes, Stop> {
        if g.has_any(letters(b"XY")) {
            let hint = "a place is given by X and Y or by @ and ^";
            return Err(self.fail(
                Code::ModalConflict,
                "polar and Cartesian words in one block",
                hint,
            ));
        }
        let here = self.core.user_position();
        let (mut radius, mut angle) = (here.0[0].hypot(here.0[1]), here.0[1].atan2(here.0[0]));
        let relative = self.core.state.modal.relative;
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
        self.target(&rest)
    }

    /// A rapid move.
    pub(super) fn line(&mut self, kind: MoveKind, to: Axes) -> Result<(), Stop> {
        self.line_at(kind, to, Feed::Axis)
    }

    /// A straight move, compensated where that is on.
    pub(super) fn line_at(&mut self, kind: MoveKind, to: Axes, feed: Feed) -> Result<(), Stop> {
        if self.core.compensator.is_some() {
            return self.compensated_line(kind, to, feed);
        }
        if to != self.core.tool_position() {
            self.emit(Command::Line(Line { kind, to, feed }));
        }
        self.core.position = to;
        self.core.beside = None;
        Ok(())
    }

    /// The axis of the block's motion code, for messages.
    pub(super) fn name_of(g: &Gathered, motion: i32) -> String {
        g_name(g.g[MOTION].unwrap_or(motion))
    }
}

impl super::Core {
    /// A machine position with some axes put to places of the coordinate system, mm.
    pub(super) fn moved(&self, from: Axes, places: impl Iterator<Item = (usize, f64)>) -> Axes {
        if self.turned.is_none() {
            let mut to = from;
            for (axis, place) in places {
                to.0[axis] = place + self.zero.0[axis];
            }
            return to;
        }
        let mut place = self.place_of(from);
        let mut in_plane = false;
        let mut to = from;
        for (axis, value) in places {
            place.0[axis] = value;
            in_plane |= axis < 2;
            if axis >= 2 {
                to.0[axis] = value + self.zero.0[axis];
            }
        }
        if in_plane {
            let machine = self.machine_of(place);
            to.0[0] = machine.0[0];
            to.0[1] = machine.0[1];
        }
        to
    }
}
