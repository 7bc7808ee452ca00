//! PAUSE in its three forms, and WARNING OFF.

use super::{Context, Stop};
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::{Button, Command, Question, QuestionKind};

/// No pause is longer, about three years: beyond, a clock loses its milliseconds.
const LONGEST_S: f64 = 1e8;

impl Context<'_> {
    /// PAUSE n: waits so many seconds. The comment above was told when its own line ran.
    pub(super) fn pause_for(&mut self, seconds: &Expr) -> Result<(), Stop> {
        let n = self.eval_number(seconds)?;
        if !(0.0..=LONGEST_S).contains(&n) {
            let message = format!(
                "a pause lasts 0 or more seconds, at most 100000000, not {}",
                Value::Number(n).display()
            );
            return Err(self.fail_at(seconds.span, Code::OutOfRange, message, ""));
        }
        self.settle()?;
        self.emit(Command::Wait { seconds: n });
        self.core.handlers.pausing = !self.core.handlers.watches.is_empty();
        Ok(())
    }

    /// PAUSE: waits for the operator.
    pub(super) fn pause(&mut self) -> Result<(), Stop> {
        let question = self.pause_question();
        self.confirm(&question)
    }

    /// PAUSE UNTIL: waits for the operator or for an input; goes on at once when the input is
    /// already in the state (readings, A-29).
    pub(super) fn pause_until(&mut self, switch: &Expr, state: &Expr) -> Result<(), Stop> {
        let input = self.switch_number(switch)?;
        let on = self.switch_state(state)?;
        self.settle()?;
        if self.host.input(input) == on {
            return Ok(());
        }
        let question = Question { until: Some((input, on)), ..self.pause_question() };
        self.confirm(&question)
    }

    fn pause_question(&self) -> Question {
        let text = self.comment_above().unwrap_or_else(|| "Continue?".into());
        self.question(QuestionKind::Pause, text, &[Button::OK, Button::Cancel])
    }

    fn switch_state(&mut self, state: &Expr) -> Result<bool, Stop> {
        let n = self.eval_number(state)?;
        if n == 0.0 || n == 1.0 {
            return Ok(n == 1.0);
        }
        let message = format!("a switch is 1 or 0, not {}", Value::Number(n).display());
        Err(self.fail_at(state.span, Code::OutOfRange, message, "1 closed, 0 open"))
    }

    /// WARNING OFF: no flashing until the next motion.
    pub(super) fn warning_off(&mut self) -> Result<(), Stop> {
        self.settle()?;
        self.emit(Command::WarningOff);
        Ok(())
    }
}
