//! What may not move: moves that would leave the table, anything while a stop input is active or the
//! enclosure is open.

use crate::runner::{Over, Runner};
use crate::session::LimitPolicy;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_motion::Move;
use kerf_program::{
    Answer, At, Button, Command, Interpreter, Question, QuestionKind, Sourced, Status,
};
use kerf_sim::Violation;

/// What is told when the interlock forbids motion or a spindle.
const ENCLOSURE_OPEN: &str = "enclosure open";

impl<I: Interpreter> Runner<'_, I> {
    /// Nothing moves that would leave the table, or while a stop input is active.
    pub(crate) fn check(&mut self, moves: &[Move]) -> Result<(), Over> {
        let Some(first) = moves.first() else { return Ok(()) };
        if self.lists_limits() {
            self.list_violations(moves);
        } else if let Some(violation) = self.world.machine.first_outside(moves) {
            self.ask_about_limit(moves, &violation)?;
        }
        self.stop_inputs_rest(first.at)
    }

    /// Nothing moves while a stop input is active.
    pub(crate) fn stop_inputs_rest(&self, at: At) -> Result<(), Over> {
        let Some(input) = self.world.machine.stop_input() else { return Ok(()) };
        let active = format!("stop input {input} is active: nothing may move");
        Err(self.stop_input(at, active))
    }

    /// A stop input ends the run; an open enclosure says so itself.
    pub(crate) fn stop_input(&self, at: At, message: String) -> Over {
        let open = self.world.machine.open_enclosure().is_some();
        let message = if open { ENCLOSURE_OPEN.into() } else { message };
        self.over(Status::Stopped, Code::InputStop, at, message)
    }

    /// Whether a move of a stack that moves already would leave the table: whatever comes before it is
    /// made first, and then it is a stack of its own, about which the operator is asked.
    pub(crate) fn leaves_table(&mut self, made: &Move) -> bool {
        if self.stack.running.is_none() {
            return false;
        }
        let alone = std::slice::from_ref(made);
        if self.lists_limits() {
            self.list_violations(alone);
            return false;
        }
        self.world.machine.first_outside(alone).is_some()
    }

    /// Nothing is asked about what is only drawn.
    fn lists_limits(&self) -> bool {
        self.limits == LimitPolicy::List || self.world.machine.draws()
    }

    fn list_violations(&mut self, moves: &[Move]) {
        for made in moves {
            let alone = std::slice::from_ref(made);
            if let Some(violation) = self.world.machine.first_outside(alone) {
                let message = self.limit_message(&violation);
                let place = Place::line(self.world.file(made.at), made.at.line);
                let diagnostic = Diagnostic::new(Code::OutsideLimits, place, message);
                self.world.tell_diagnostic(diagnostic);
            }
        }
    }

    fn ask_about_limit(&mut self, moves: &[Move], violation: &Violation) -> Result<(), Over> {
        let at = moves.get(violation.move_index).map_or(At::default(), |m| m.at);
        let message = self.limit_message(violation);
        let question = limit_question(message.clone());
        if self.ask(&question, at)? == Answer::Button(Button::Continue) {
            self.world.machine.override_limits();
            return Ok(());
        }
        Err(self.over(Status::Limit, Code::OutsideLimits, at, message))
    }

    fn limit_message(&self, violation: &Violation) -> String {
        let scale = self.world.scale(violation.axis);
        let [reached, limit] =
            [violation.reached, violation.limit].map(|v| kerf_sbp::format_number(v / scale));
        let letter = violation.axis.letter();
        if violation.soft {
            return format!(
                "Out of bounds: {letter} would reach {reached}, it ends at {limit} (from home)"
            );
        }
        format!(
            "{letter} would reach {reached}, the table limit is {limit} (table base coordinates)"
        )
    }

    /// Ends the run when a spindle would start in an open enclosure.
    pub(crate) fn spindle_refused(&self, sourced: &Sourced) -> Option<Over> {
        let starts = matches!(sourced.command, Command::Output { number: 1 | 2, on: true });
        let open = starts && self.world.machine.open_enclosure().is_some();
        let message = ENCLOSURE_OPEN.into();
        open.then(|| self.over(Status::Stopped, Code::InputStop, sourced.at, message))
    }

    fn over(&self, status: Status, code: Code, at: At, message: String) -> Over {
        let place = Place::line(self.world.file(at), at.line);
        let diagnostic = Diagnostic::new(code, place, message);
        Over { status, diagnostic: Some(Box::new(diagnostic)) }
    }

    /// A limit input stopped the machine: the operator says whether it goes on.
    pub(crate) fn limit_input(&mut self, n: u8) -> Result<(), Over> {
        let at = self.last_move;
        let message = format!("stopped by limit input {n}");
        let question = limit_question(message.clone());
        if self.ask(&question, at)? == Answer::Button(Button::Continue) {
            self.world.machine.override_limits();
            return Ok(());
        }
        Err(self.over(Status::Limit, Code::InputStop, at, message))
    }
}

fn limit_question(text: String) -> Question {
    Question {
        kind: QuestionKind::Limit,
        text,
        title: "Limits".into(),
        buttons: vec![Button::Continue, Button::End],
        default: 1,
        prefill: String::new(),
        icon: 48,
        until: None,
    }
}
