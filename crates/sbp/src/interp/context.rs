//! What an effect works with: the state, the host, the list of commands.

use super::{Core, Status};
use crate::tree::{Program, Span};
use kerf_cut::Step as CutStep;
use kerf_diag::{Code, Diagnostic, Severity};
use kerf_geom::Vec2;
use kerf_program::{
    Answer, Arc as ArcMove, At, Axes, Axis, AxisSet, Command, Feed, Host, HostError, Line,
    MoveKind, Question, Settings, Sourced,
};
use std::sync::Arc;
use std::task::Poll;

/// Why a statement did not complete.
#[derive(Debug)]
pub enum Stop {
    /// The host has no answer yet; nothing has happened.
    Waiting,
    /// An error.
    Failed(Box<Diagnostic>),
    /// The run ends.
    Finished(Status),
}

/// What an effect works with.
pub struct Context<'a> {
    pub(crate) core: &'a mut Core,
    pub(crate) host: &'a mut dyn Host,
    pub(crate) out: &'a mut Vec<Sourced>,
    /// The line being executed.
    pub(crate) at: At,
    /// The statement's place in its line.
    pub(crate) span: Span,
}

impl Context<'_> {
    /// The settings in force.
    pub(crate) fn settings(&self) -> &Settings {
        &self.core.settings
    }

    /// Changes settings and tells everyone behind.
    pub(crate) fn change_settings(&mut self, change: impl FnOnce(&mut Settings)) {
        let before = self.core.settings.clone();
        change(Arc::make_mut(&mut self.core.settings));
        if before != self.core.settings {
            self.core.refresh_scale();
            let settings = self.core.settings.clone();
            self.emit(Command::Settings(settings));
        }
    }

    /// Gives a command.
    pub(crate) fn emit(&mut self, command: Command) {
        self.core.settled = false;
        self.out.push(Sourced { at: self.at, command });
    }

    /// Waits until everything given so far has been carried out.
    pub(crate) fn settle(&mut self) -> Result<(), Stop> {
        self.interrupt_tabs();
        if self.core.settled {
            return Ok(());
        }
        match self.host.settle() {
            Poll::Ready(()) => {
                self.core.settled = true;
                Ok(())
            }
            Poll::Pending => Err(Stop::Waiting),
        }
    }

    /// Asks the operator.
    pub(crate) fn ask(&mut self, question: &Question) -> Result<Answer, Stop> {
        self.settle()?;
        match self.host.ask(question) {
            Poll::Ready(answer) => Ok(answer),
            Poll::Pending => Err(Stop::Waiting),
        }
    }

    /// An error at the statement.
    pub(crate) fn fail(&self, code: Code, message: impl Into<String>) -> Stop {
        self.fail_at(self.span, code, message, "")
    }

    /// An error at a part of the line, with a hint.
    pub(crate) fn fail_at(
        &self,
        span: Span,
        code: Code,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> Stop {
        Stop::Failed(Box::new(self.diagnostic(span, code, message).hint(hint)))
    }

    /// A warning or note while running.
    pub(crate) fn warn(&mut self, code: Code, message: impl Into<String>, hint: impl Into<String>) {
        let diagnostic =
            self.diagnostic(self.span, code, message).hint(hint).severity(Severity::Warning);
        self.emit(Command::Diagnostic(Box::new(diagnostic)));
    }

    /// A diagnostic at a part of the line, with the files that called this one.
    pub(crate) fn diagnostic(
        &self,
        span: Span,
        code: Code,
        message: impl Into<String>,
    ) -> Diagnostic {
        let place = self.program().place(self.at.line, span);
        let mut diagnostic = Diagnostic::new(code, place, message);
        let callers = self.core.levels.iter().rev().skip(1);
        diagnostic.callers = callers
            .filter_map(|l| {
                let program = self.core.programs.get(l.file as usize)?;
                Some(program.place(l.next, Span::default()))
            })
            .collect();
        diagnostic
    }

    /// The error of a refused request to the host.
    pub(crate) fn refused(&self, error: HostError) -> Stop {
        match error {
            HostError::NotFound(what) => self.fail(Code::FileNotFound, what),
            HostError::NotAllowed(what) => self.fail(Code::FileNotAllowed, what),
            HostError::EndOfFile => self.fail(Code::EndOfFile, "end of file"),
            HostError::Disabled(what) => self.fail(Code::ShellDisabled, what),
            HostError::Refused(what) => self.fail(Code::FileError, what),
        }
    }

    /// The program being executed.
    pub(crate) fn program(&self) -> Arc<Program> {
        self.core.programs.get(self.at.file as usize).cloned().unwrap_or_default()
    }

    /// Refuses an axis that VD has not switched on.
    pub(crate) fn need_axis(&self, axis: Axis) -> Result<(), Stop> {
        if axis.index() < usize::from(self.settings().axis_count) {
            return Ok(());
        }
        let message = format!("{} axis not active", axis.letter());
        let hint =
            format!("switch it on with VD,,{} or in the machine's configuration", axis.index() + 1);
        Err(self.fail_at(self.span, Code::AxisNotActive, message, hint))
    }

    /// A straight move to a machine position.
    pub(crate) fn line(&mut self, kind: MoveKind, to: Axes) {
        if to == self.core.position {
            return;
        }
        let delta = Vec2::new(to.0[0] - self.core.position.0[0], to.0[1] - self.core.position.0[1]);
        if delta != Vec2::default() {
            self.core.heading = Some(kerf_geom::vec_to_clock(delta));
        }
        if self.tabs_hold() {
            let step = CutStep::Line { kind, to: self.core.frame.working(to).first3() };
            let only_xyz = to.0[3..] == self.core.position.0[3..];
            if only_xyz {
                self.through_tabs(step);
                self.core.position = to;
                return;
            }
            self.interrupt_tabs();
        }
        self.core.position = to;
        self.motion(Command::Line(Line { kind, to, feed: Feed::Axis }));
    }

    /// Carries out the steps of a cut; they are in working millimetres.
    pub(crate) fn cut_steps(&mut self, steps: &[CutStep]) {
        for step in steps {
            match *step {
                CutStep::Line { kind, to } => {
                    let target = self.machine_of(to);
                    self.line(kind, target);
                }
                CutStep::Arc { centre, sweep_rad, to, .. } => {
                    self.remember_heading(centre, sweep_rad, to);
                    if self.tabs_hold() {
                        self.through_tabs(*step);
                        self.core.position = self.machine_of(to);
                    } else {
                        self.plain_step(self.at, *step);
                    }
                }
            }
        }
    }

    fn remember_heading(&mut self, centre: [f64; 2], sweep_rad: f64, to: [f64; 3]) {
        let radial = Vec2::new(to[0] - centre[0], to[1] - centre[1]);
        let along = if sweep_rad < 0.0 { -radial.left() } else { radial.left() };
        self.core.heading = Some(kerf_geom::vec_to_clock(along));
    }

    /// Machine position of working X, Y, Z, the other axes where they are.
    pub(crate) fn machine_of(&self, working: [f64; 3]) -> Axes {
        let mut to = self.core.position;
        for (axis, value) in Axis::ALL.into_iter().zip(working) {
            to[axis] = value + self.core.frame.working_zero[axis];
        }
        to
    }

    /// Gives one step as a motion command.
    fn plain_step(&mut self, at: At, step: CutStep) {
        let command = match step {
            CutStep::Line { kind, to } => {
                let to = self.machine_of(to);
                self.core.position = to;
                Command::Line(Line { kind, to, feed: Feed::Axis })
            }
            CutStep::Arc { centre, sweep_rad, to, chords, small } => {
                let zero = self.core.frame.working_zero;
                let to = self.machine_of(to);
                self.core.position = to;
                let centre = [centre[0] + zero[Axis::X], centre[1] + zero[Axis::Y]];
                Command::Arc(ArcMove {
                    kind: MoveKind::Cut,
                    centre,
                    sweep_rad,
                    to,
                    feed: Feed::Axis,
                    chords,
                    small,
                })
            }
        };
        let here = std::mem::replace(&mut self.at, at);
        self.motion(command);
        self.at = here;
    }

    fn motion(&mut self, command: Command) {
        self.core.motions += 1;
        self.emit(command);
    }

    /// Whether moves go through the tab filter now.
    fn tabs_hold(&self) -> bool {
        self.core.tabs.is_some()
    }

    fn through_tabs(&mut self, step: CutStep) {
        let from = self.core.working().first3();
        let mut cut = Vec::new();
        if let Some(tabs) = self.core.tabs.as_mut() {
            tabs.push(from, step, self.at, &mut cut);
        }
        self.after_tabs(cut);
    }

    /// The path is interrupted but not over: what is buffered goes out.
    pub(crate) fn interrupt_tabs(&mut self) {
        let mut cut = Vec::new();
        if let Some(tabs) = self.core.tabs.as_mut() {
            tabs.flush(&mut cut);
        }
        self.after_tabs(cut);
    }

    /// The tabbed path is over.
    pub(crate) fn end_tabs(&mut self) {
        let mut cut = Vec::new();
        if let Some(mut tabs) = self.core.tabs.take() {
            tabs.path_end(&mut cut);
        }
        self.after_tabs(cut);
    }

    fn after_tabs(&mut self, cut: Vec<(At, CutStep)>) {
        let planned = self.core.position;
        for (at, step) in cut {
            self.plain_step(at, step);
        }
        self.core.position = planned;
    }

    /// Tells that locations changed.
    pub(crate) fn location_changed(&mut self, working: AxisSet, base: AxisSet) {
        let frame = self.core.frame;
        self.emit(Command::Location { frame, working, base });
    }
}
