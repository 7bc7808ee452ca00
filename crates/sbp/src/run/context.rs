//! The surroundings that an effect works with: the state, the host, the list of commands.

use super::{Core, cutting};
use crate::tree::{Program, Span};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_program::Status;
use kerf_program::{
    Answer, At, Axis, AxisSet, Command, Host, HostError, Question, Settings, Sourced,
};
use std::sync::Arc;
use std::task::Poll;

/// Reason why a statement did not complete.
#[derive(Debug)]
pub enum Stop {
    /// The host has no answer yet; nothing has happened.
    Waiting,
    /// An error.
    Failed(Box<Diagnostic>),
    /// The run ends.
    Finished(Status),
}

/// The surroundings that an effect works with.
pub struct Context<'a> {
    pub(crate) core: &'a mut Core,
    /// The file of the line being executed.
    pub(crate) program: &'a Program,
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
        &self.core.values.settings
    }

    /// Changes settings and tells everyone behind.
    pub(crate) fn change_settings(&mut self, change: impl FnOnce(&mut Settings)) {
        let before = self.core.values.settings.clone();
        change(Arc::make_mut(&mut self.core.values.settings));
        if before.torch_on() && !self.settings().torch_on() {
            self.core.place.adrift.insert(Axis::Z);
        }
        if before != self.core.values.settings {
            self.core.refresh_scale();
            let settings = self.core.values.settings.clone();
            self.emit(Command::Settings(settings));
        }
    }

    /// Gives a command. Moves that wait in the tab filter come first.
    pub(crate) fn emit(&mut self, command: Command) {
        if !command.is_motion() {
            cutting::interrupt_tabs(self);
        }
        // Nobody has to wait for what is only told. A command that warns and then waits would
        // otherwise wait again each time it is repeated, for ever.
        self.core.given.settled &= matches!(command, Command::Diagnostic(_));
        self.out.push(Sourced { at: self.at, command });
    }

    /// Waits until everything given so far has been carried out.
    pub(crate) fn settle(&mut self) -> Result<(), Stop> {
        cutting::interrupt_tabs(self);
        if self.core.given.settled {
            return Ok(());
        }
        match self.host.settle() {
            Poll::Ready(()) => {
                self.core.given.settled = true;
                Ok(())
            }
            Poll::Pending => Err(Stop::Waiting),
        }
    }

    /// Asks the operator. A step may ask several times: what was answered stays when it is repeated.
    pub(crate) fn ask(&mut self, question: &Question) -> Result<Answer, Stop> {
        self.settle()?;
        let host = &mut *self.host;
        match self.core.answers.next(|| host.ask(question)) {
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

    /// A warning while running.
    pub(crate) fn warn(&mut self, code: Code, message: impl Into<String>, hint: impl Into<String>) {
        self.tell(Severity::Warning, code, message, hint);
    }

    /// A note while running.
    pub(crate) fn note(&mut self, code: Code, message: impl Into<String>, hint: impl Into<String>) {
        self.tell(Severity::Note, code, message, hint);
    }

    fn tell(
        &mut self,
        severity: Severity,
        code: Code,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) {
        let diagnostic = self.diagnostic(self.span, code, message).hint(hint).severity(severity);
        self.emit(Command::Diagnostic(Box::new(diagnostic)));
    }

    /// A diagnostic at a part of the line, with the files that called this one.
    pub(crate) fn diagnostic(
        &self,
        span: Span,
        code: Code,
        message: impl Into<String>,
    ) -> Diagnostic {
        let place = self.program.place(self.at.line, span);
        let mut diagnostic = Diagnostic::new(code, place, message);
        diagnostic.callers = self.callers();
        diagnostic
    }

    /// The lines that called the innermost file, innermost first.
    pub(crate) fn callers(&self) -> Vec<SourcePlace> {
        self.core.flow.callers(&self.core.files)
    }

    /// The error of a refused request to the host.
    pub(crate) fn refused(&self, error: HostError) -> Stop {
        let (code, what) = error.into_message();
        self.fail(code, what)
    }

    /// Refuses an axis that VD has not switched on, or that MI keeps moving.
    pub(crate) fn need_axis(&self, axis: Axis) -> Result<(), Stop> {
        if self.core.place.independent.contains(axis) {
            let letter = axis.letter();
            let message = format!("{letter} axis is moving by itself");
            let hint = format!("MI,{letter},1,0 stops it");
            return Err(self.fail_at(self.span, Code::NotSupported, message, hint));
        }
        self.need_active(axis)
    }

    /// Refuses an axis that VD has not switched on.
    pub(crate) fn need_active(&self, axis: Axis) -> Result<(), Stop> {
        let letter = axis.letter();
        if axis.index() < usize::from(self.settings().axis_count) {
            return Ok(());
        }
        let message = format!("{letter} axis not active");
        let hint =
            format!("switch it on with VD,,{} or in the machine's configuration", axis.index() + 1);
        Err(self.fail_at(self.span, Code::AxisNotActive, message, hint))
    }

    /// Tells that locations changed.
    pub(crate) fn location_changed(&mut self, working: AxisSet, base: AxisSet) {
        let frame = self.core.place.frame;
        self.emit(Command::Location { frame, working, base });
    }
}
