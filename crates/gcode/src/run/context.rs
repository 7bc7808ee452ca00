//! The surroundings that a block works with: the state, the host, the list of commands.

use super::core::Core;
use super::stop::{Refused, Stop};
use crate::syntax::tree::{Program, Span};
use kerf_diag::{Code, Diagnostic, Severity};
use kerf_program::{
    Answer, At, AxisSet, Button, Command, Host, Question, QuestionKind, Sourced, Status,
};
use std::sync::Arc;

/// The surroundings that a block works with.
pub(super) struct Context<'a> {
    pub(super) core: &'a mut Core,
    pub(super) host: &'a mut dyn Host,
    pub(super) out: &'a mut Vec<Sourced>,
    /// The line being executed.
    pub(super) at: At,
    /// The block's place in its line.
    pub(super) span: Span,
}

impl Context<'_> {
    /// Gives a command. With compensation it keeps its place between the moves.
    pub(super) fn emit(&mut self, command: Command) {
        let sourced = Sourced { at: self.at, command };
        match &mut self.core.place.compensator {
            Some(compensator) if !sourced.command.is_motion() => {
                if let Some(sourced) = compensator.keep(sourced) {
                    self.give(sourced);
                }
            }
            _ => self.give(sourced),
        }
    }

    /// Gives a command at once.
    pub(super) fn give(&mut self, sourced: Sourced) {
        self.core.asking.settled = false;
        self.core.progress.motions += u64::from(sourced.command.is_motion());
        self.out.push(sourced);
    }

    /// Waits until everything given so far has been carried out.
    pub(super) fn settle(&mut self) -> Result<(), Stop> {
        self.core.asking.settle(self.host)
    }

    /// Asks the operator outside a block: the answer is not kept for another attempt.
    pub(super) fn ask_at_once(&mut self, question: &Question) -> Result<Answer, Stop> {
        self.core.asking.ask_at_once(self.host, question)
    }

    /// Holds with a box until the operator, or an input, lets the program go on; Cancel ends the run.
    pub(super) fn hold_for(
        &mut self,
        kind: QuestionKind,
        text: &str,
        until: Option<(u8, bool)>,
    ) -> Result<(), Stop> {
        let answer = self.core.asking.ask(self.host, &box_of(kind, text, until))?;
        goes_on(&answer)
    }

    /// Holds outside a block until the operator lets the program go on.
    pub(super) fn hold_at_once(&mut self, text: &str) -> Result<(), Stop> {
        let answer = self.ask_at_once(&box_of(QuestionKind::Pause, text, None))?;
        goes_on(&answer)
    }

    /// A warning while running.
    pub(super) fn warn(&mut self, code: Code, message: impl Into<String>, hint: impl Into<String>) {
        let diagnostic = self.diagnostic(self.span, code, message);
        let diagnostic = diagnostic.hint(hint).severity(Severity::Warning);
        self.emit(Command::Diagnostic(Box::new(diagnostic)));
    }

    /// The diagnostic of what this block cannot do.
    pub(super) fn told(&self, refused: Refused) -> Diagnostic {
        let Refused { code, message, hint, span } = refused;
        self.diagnostic(span.unwrap_or(self.span), code, message).hint(hint)
    }

    /// A diagnostic at a part of the line, with the lines that called this one.
    pub(super) fn diagnostic(
        &self,
        span: Span,
        code: Code,
        message: impl Into<String>,
    ) -> Diagnostic {
        let place = self.program().place(self.at.line, span);
        let mut diagnostic = Diagnostic::new(code, place, message);
        diagnostic.callers = self.core.calls.callers();
        diagnostic
    }

    /// The program being executed.
    pub(super) fn program(&self) -> Arc<Program> {
        self.core.calls.program(self.at.file)
    }

    /// Offsets, unit or coordinate system changed: works them out and tells it.
    pub(super) fn relocate(&mut self) {
        let before = self.core.frame.working_zero;
        self.core.refresh();
        let zero = self.core.coordinates.working_zero;
        self.core.frame.working_zero = zero;
        let mut working = AxisSet::EMPTY;
        for axis in kerf_program::Axis::ALL {
            if zero[axis] != before[axis] {
                working.insert(axis);
            }
        }
        if !working.is_empty() {
            let frame = self.core.frame;
            self.emit(Command::Location { frame, working, base: AxisSet::EMPTY });
        }
    }
}

/// A box that holds a program.
fn box_of(kind: QuestionKind, text: &str, until: Option<(u8, bool)>) -> Question {
    Question {
        kind,
        text: text.into(),
        title: "G-code".into(),
        buttons: vec![Button::OK, Button::Cancel],
        default: 0,
        prefill: String::new(),
        icon: 0,
        until,
    }
}

/// Goes on, or ends the run at Cancel.
const fn goes_on(answer: &Answer) -> Result<(), Stop> {
    match answer {
        Answer::Button(Button::Cancel) => Err(Stop::Finished(Status::Stopped)),
        _ => Ok(()),
    }
}
