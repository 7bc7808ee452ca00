//! The surroundings that a block works with: the state, the host, the list of commands.

use super::Core;
use crate::syntax::gathered::Fault;
use crate::syntax::tree::{Program, Span};
use kerf_diag::{Code, Diagnostic, Place, Severity};
use kerf_program::{
    Answer, At, AxisSet, Button, Command, Host, HostError, Question, QuestionKind, Sourced, Status,
};
use std::sync::Arc;
use std::task::Poll;

/// Reason why a block did not complete.
#[derive(Debug)]
pub(super) enum Stop {
    /// The host has no answer yet; nothing has happened.
    Waiting,
    /// The commands given so far are carried out first, then the block begins again.
    Again,
    /// An error.
    Failed(Box<Diagnostic>),
    /// The run ends.
    Finished(Status),
}

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
        match &mut self.core.compensator {
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
        self.core.settled = false;
        self.core.motions += u64::from(sourced.command.is_motion());
        self.out.push(sourced);
    }

    /// Waits until everything given so far has been carried out.
    pub(super) fn settle(&mut self) -> Result<(), Stop> {
        if self.core.settled || self.core.at_rest {
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
    pub(super) fn ask(&mut self, question: &Question) -> Result<Answer, Stop> {
        if let Some(answer) = self.core.asked.get(self.core.taken).cloned() {
            self.core.taken += 1;
            return Ok(answer);
        }
        let answer = self.ask_at_once(question)?;
        self.core.asked.push(answer.clone());
        self.core.taken += 1;
        Ok(answer)
    }

    /// Asks the operator outside a block: the answer is not kept for another attempt.
    pub(super) fn ask_at_once(&mut self, question: &Question) -> Result<Answer, Stop> {
        self.settle()?;
        match self.host.ask(question) {
            Poll::Ready(answer) => Ok(answer),
            Poll::Pending => Err(Stop::Waiting),
        }
    }

    /// Holds until the operator, or an input, lets the program go on.
    pub(super) fn pause(&mut self, text: &str, until: Option<(u8, bool)>) -> Result<(), Stop> {
        self.hold_for(QuestionKind::Pause, text, until)
    }

    /// Holds outside a block until the operator lets the program go on.
    pub(super) fn hold_at_once(&mut self, text: &str) -> Result<(), Stop> {
        let answer = self.ask_at_once(&box_of(QuestionKind::Pause, text, None))?;
        goes_on(&answer)
    }

    /// The same with a box of some kind; Cancel ends the run.
    pub(super) fn hold_for(
        &mut self,
        kind: QuestionKind,
        text: &str,
        until: Option<(u8, bool)>,
    ) -> Result<(), Stop> {
        let answer = self.ask(&box_of(kind, text, until))?;
        goes_on(&answer)
    }

    /// An error at the block.
    pub(super) fn fail(
        &self,
        code: Code,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> Stop {
        self.faulty(Fault::new(code, self.span, message).hint(hint))
    }

    /// An error.
    pub(super) fn faulty(&self, fault: Fault) -> Stop {
        let diagnostic = self.diagnostic(fault.span, fault.code, fault.message).hint(fault.hint);
        Stop::Failed(Box::new(diagnostic))
    }

    /// A warning while running.
    pub(super) fn warn(&mut self, code: Code, message: impl Into<String>, hint: impl Into<String>) {
        let diagnostic = self.diagnostic(self.span, code, message);
        let diagnostic = diagnostic.hint(hint).severity(Severity::Warning);
        self.emit(Command::Diagnostic(Box::new(diagnostic)));
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
        diagnostic.callers = self.callers();
        diagnostic
    }

    /// The lines that called the innermost subroutine, innermost first.
    fn callers(&self) -> Vec<Place> {
        let outer = self.core.calls.iter().rev().skip(1).take(8);
        let place = |c: &super::core::Call| {
            let program = self.core.programs.get(c.file as usize)?;
            Some(program.place(c.next, Span::default()))
        };
        outer.filter_map(place).collect()
    }

    /// The error of a refused request to the host.
    pub(super) fn refused(&self, error: HostError) -> Stop {
        let (code, what) = match error {
            HostError::NotFound(what) => (Code::FileNotFound, what),
            HostError::NotAllowed(what) => (Code::FileNotAllowed, what),
            HostError::EndOfFile => (Code::EndOfFile, "end of file".into()),
            HostError::Disabled(what) | HostError::Refused(what) => (Code::FileError, what),
        };
        self.fail(code, what, "")
    }

    /// The program being executed.
    pub(super) fn program(&self) -> Arc<Program> {
        self.core.programs.get(self.at.file as usize).cloned().unwrap_or_default()
    }

    /// Offsets, unit or coordinate system changed: works them out and tells it.
    pub(super) fn relocate(&mut self) {
        let before = self.core.frame.working_zero;
        self.core.refresh();
        let zero = self.core.working_zero();
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
