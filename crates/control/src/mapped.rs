//! A program above a surface that is not flat: every place that it names is lifted by a height map.
//!
//! ```text
//!  Interpreter ──commands, as if the surface were flat──► Mapped ──pieces at their heights──► Runner
//!       ◄──places where the machine stands, lowered by the map──────┘
//! ```
//!
//! The runner knows only machine positions, the program only its own. Both languages and jobs go
//! through here, also where they are only drawn. Without a map nothing is changed.

use crate::map_pieces::Laid;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_program::{
    At, Axes, Command, FileCall, Frame, Halted, HeightMap, Host, Interpreter, MARGIN_MM, MoveKind,
    Settings, Sourced, Status, Step, StoppedBy, Watch,
};
use std::collections::VecDeque;
use std::sync::Arc;

/// A change of tools: its place and its sensor lie on the table, not on the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Changing {
    /// There is none.
    No,
    /// It has begun: what was before it may still be made.
    Begun,
    /// It moves the machine.
    Moves,
}

/// An interpreter below a height map.
pub(crate) struct Mapped<I> {
    pub inner: I,
    map: Option<Arc<HeightMap>>,
    /// Machine position of the map's X 0, Y 0, where that is not the program's own.
    lies: Option<Axes>,
    /// The machine's top, Z of the machine frame, mm.
    top_mm: f64,
    changing: Changing,
    /// Motion commands handed out: pieces.
    pieces: u64,
    /// The last piece of each motion command, and its number; kept only while something may interrupt.
    last_pieces: VecDeque<(u64, u64)>,
}

impl<I: Interpreter> Mapped<I> {
    pub const fn new(inner: I, map: Option<Arc<HeightMap>>) -> Self {
        Self {
            inner,
            map,
            lies: None,
            top_mm: f64::INFINITY,
            changing: Changing::No,
            pieces: 0,
            last_pieces: VecDeque::new(),
        }
    }

    /// The same above a map that lies at a machine position, wherever the program has its zero.
    pub const fn lying_at(mut self, zero: Axes) -> Self {
        self.lies = Some(zero);
        self
    }

    /// The same on a machine whose Z ends there, mm of the machine frame.
    pub const fn below(mut self, top_mm: f64) -> Self {
        self.top_mm = top_mm;
        self
    }

    /// The same with another state of the program.
    pub fn with(&self, inner: I) -> Self {
        let (map, last_pieces) = (self.map.clone(), self.last_pieces.clone());
        Self { inner, map, last_pieces, ..*self }
    }

    /// Machine position of the map's X 0, Y 0.
    fn zero(&self) -> Axes {
        self.lies.unwrap_or_else(|| self.inner.frame().working_zero)
    }

    fn laid(&self) -> Option<Laid<'_>> {
        let map = self.map.as_deref().filter(|_| self.changing != Changing::Moves)?;
        Some(Laid { map, zero: self.zero(), top_mm: self.top_mm })
    }

    /// The place of the program of a machine position.
    fn lowered(&self, place: Axes) -> Axes {
        self.laid().map_or(place, |laid| laid.lowered(place))
    }

    /// The number of the motion command that a piece belongs to.
    fn number_of(&self, piece: u64) -> u64 {
        if self.map.is_none() {
            return piece;
        }
        let whole = self.last_pieces.iter().find(|(last, _)| *last >= piece);
        whole.map_or_else(|| self.inner.motions(), |(_, number)| *number)
    }

    fn halted(&self, at: &Halted) -> Halted {
        let motion = at.motion.map(|piece| self.number_of(piece));
        Halted { motion, began: self.lowered(at.began), stands: self.lowered(at.stands) }
    }

    /// Lays the commands over the surface that a step added behind the first `count`, begun at a place of the program.
    fn lay(
        &mut self,
        step: Step,
        out: &mut Vec<Sourced>,
        (count, mut from, mut zero): (usize, Axes, Axes),
    ) -> Step {
        let Some(map) = self.map.clone() else { return step };
        let given = out.split_off(count);
        let motions = given.iter().filter(|it| it.command.is_motion()).count() as u64;
        let mut number = self.inner.motions() - motions;
        let watches = self.inner.takes_stops() || !self.inner.watches().is_empty();
        if !watches {
            self.last_pieces.clear();
        }
        for sourced in given {
            let laid = Laid { map: &map, zero, top_mm: self.top_mm };
            if sourced.command.is_motion() && self.changing == Changing::Begun {
                self.changing = Changing::Moves;
            }
            let is_flat = self.changing == Changing::Moves;
            let flat = || vec![sourced.command.clone()];
            let (pieces, to, kind) = match &sourced.command {
                Command::Line(line) if is_flat => (flat(), line.to, MoveKind::Jog),
                Command::Arc(arc) if is_flat => (flat(), arc.to, MoveKind::Jog),
                Command::Line(line) => (laid.line(from, line), line.to, line.kind),
                Command::Arc(arc) => (laid.arc(from, arc), arc.to, arc.kind),
                Command::Chorded(_) => continue,
                other => {
                    if let Command::Location { frame, .. } = other {
                        zero = self.lies.unwrap_or(frame.working_zero);
                    }
                    if let Command::ToolChange { begin } = other {
                        self.changing = if *begin { Changing::Begun } else { Changing::No };
                    }
                    out.push(sourced);
                    continue;
                }
            };
            let leaves =
                |piece: &Command| place_of(piece).is_some_and(|at| laid.outside_mm(at) > MARGIN_MM);
            if kind == MoveKind::Cut && pieces.iter().any(leaves) {
                return Step::Done(Status::Failed, Some(Box::new(self.outside(sourced.at, &map))));
            }
            number += 1;
            self.pieces += pieces.len() as u64;
            if watches {
                self.last_pieces.push_back((self.pieces, number));
            }
            out.extend(pieces.into_iter().map(|command| Sourced { at: sourced.at, command }));
            from = to;
        }
        step
    }

    fn outside(&self, at: At, map: &HeightMap) -> Diagnostic {
        let file = self.inner.file_name(at.file).unwrap_or_default();
        outside(SourcePlace::line(file, at.line), map, self.inner.settings())
    }

    /// State before a step: commands that are there, where the program has sent the machine, where its zero is.
    fn before(&self, out: &[Sourced]) -> (usize, Axes, Axes) {
        (out.len(), self.inner.position(), self.zero())
    }
}

/// The error that a cut at a place of a source leaves the map.
pub(crate) fn outside(place: SourcePlace, map: &HeightMap, settings: &Settings) -> Diagnostic {
    let unit_mm = settings.linear_unit.mm();
    let [low, high] =
        map.bounds().map(|corner| corner.map(|v| kerf_program::decimal(v / unit_mm, 3)));
    let message = format!(
        "the cut leaves the height map, which holds from X {} Y {} to X {} Y {}",
        low[0], low[1], high[0], high[1]
    );
    let hint = "probe a larger grid, or take the map off: kerf map off";
    Diagnostic::new(Code::OutsideMap, place, message).hint(hint)
}

/// The end of a move.
const fn place_of(command: &Command) -> Option<Axes> {
    match command {
        Command::Line(line) => Some(line.to),
        Command::Arc(arc) => Some(arc.to),
        _ => None,
    }
}

impl<I: Interpreter> Interpreter for Mapped<I> {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        let before = self.before(out);
        let step = self.inner.step(host, out);
        self.lay(step, out, before)
    }

    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        let before = self.before(out);
        let step = self.inner.run(host, out, lines);
        self.lay(step, out, before)
    }

    fn interrupt(&mut self, watch: &Watch, motion: Option<u64>, position: Axes) {
        let motion = motion.map(|piece| self.number_of(piece));
        self.inner.interrupt(watch, motion, self.lowered(position));
        self.last_pieces.clear();
    }

    fn takes_stops(&self) -> bool {
        self.inner.takes_stops()
    }

    fn stopped(&mut self, by: StoppedBy, halted: &Halted) {
        self.inner.stopped(by, &self.halted(halted));
        self.last_pieces.clear();
    }

    fn comes_on(&self, halted: &Halted) -> Vec<u8> {
        self.inner.comes_on(&self.halted(halted))
    }

    fn fired(&mut self, halted: &Halted) {
        self.inner.fired(&self.halted(halted));
    }

    fn moved(&mut self, position: Axes) {
        self.inner.moved(self.lowered(position));
    }

    fn nudge(&mut self, by: Axes) {
        // The surface is that of the workpiece, which lies elsewhere.
        self.lies = self.lies.map(|zero| zero.plus(by));
        self.inner.nudge(by);
    }

    fn carried_out(&mut self, motion: u64) {
        if self.map.is_none() {
            return self.inner.carried_out(motion);
        }
        let whole = self.last_pieces.partition_point(|(last, _)| *last <= motion);
        if let Some((_, number)) = self.last_pieces.drain(..whole).next_back() {
            self.inner.carried_out(number);
        }
    }

    fn stop(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        let before = self.before(out);
        let step = self.inner.stop(host, out);
        self.lay(step, out, before)
    }

    fn limit(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        let before = self.before(out);
        let step = self.inner.limit(host, out);
        self.lay(step, out, before)
    }

    fn watches(&self) -> Vec<Watch> {
        self.inner.watches()
    }

    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        self.inner.file_name(file)
    }

    fn file_call(&self, file: u32) -> Option<FileCall> {
        self.inner.file_call(file)
    }

    fn call_stack(&self) -> Vec<At> {
        self.inner.call_stack()
    }

    fn motions(&self) -> u64 {
        if self.map.is_some() { self.pieces } else { self.inner.motions() }
    }

    fn lines(&self) -> u64 {
        self.inner.lines()
    }

    fn settings(&self) -> &Arc<Settings> {
        self.inner.settings()
    }

    fn frame(&self) -> &Frame {
        self.inner.frame()
    }

    fn position(&self) -> Axes {
        let place = self.inner.position();
        self.laid().map_or(place, |laid| laid.lifted(place))
    }

    fn variables(&self) -> Vec<(String, String)> {
        self.inner.variables()
    }
}
