//! The statements of FabMo's dialect alone: probes, dialogs, FAIL, data for programs beside the machine.

use super::watch::Handler;
use super::{Context, Stop, fields};
use crate::tree::Dialog;
use crate::{Expr, Value};
use kerf_diag::Code;
use kerf_program::{Axes, AxisSet, Button, Command, Feed, MoveKind, Question, QuestionKind, Watch};

impl Context<'_> {
    /// Moves until an input goes on. What follows waits until the move is over; that the target was
    /// reached without a touch is for the program to find out.
    pub(crate) fn probe(&mut self, to: Axes, speed_mm_s: f64, input: u8) {
        if self.host.input(input) {
            let message = format!("input {input} is on already, the probe does not move");
            return self.warn(Code::Unusual, message, "back off before probing again");
        }
        let watch = Watch::change(input, true, false);
        let level = self.core.flow.levels.len();
        // First in the list: an ON INPUT of the same input does not fire for a probe.
        self.core.handlers.watches.insert(0, Handler { watch, at: self.at, level, probe: true });
        self.line_at(MoveKind::Cut, to, Feed::Path(speed_mm_s));
        self.core.handlers.pausing = true;
    }

    /// DIALOG, and PAUSE with a text: OK goes on, Cancel ends the run.
    pub(super) fn dialog(&mut self, dialog: &Dialog) -> Result<(), Stop> {
        let text = self.dialog_words(dialog)?;
        if let Some(seconds) = &dialog.seconds {
            self.eval_number(seconds)?;
            self.emit(Command::Message { text: text.into() });
            return self.pause_for(seconds);
        }
        let title = match &dialog.title {
            Some(title) => self.eval_text(title)?,
            None => self.program.name.to_string(),
        };
        let buttons = [Button::OK, Button::Cancel];
        let Some(name) = dialog.variable else {
            let question = Question { title, ..self.question(QuestionKind::Pause, text, &buttons) };
            return self.confirm(&question);
        };
        let prefill = self.variable(name).map(Value::display).unwrap_or_default();
        let question = Question { title, ..self.entry(text, prefill) };
        let typed = self.values_typed(&question, 1)?;
        self.set_variable(name, fields::value(&typed).typed());
        Ok(())
    }

    /// The text, the details, and what the buttons mean where the program names them.
    fn dialog_words(&mut self, dialog: &Dialog) -> Result<String, Stop> {
        let mut text = self.eval_text(&dialog.text)?;
        if let Some(detail) = &dialog.detail {
            text.push('\n');
            text.push_str(&self.eval_text(detail)?);
        }
        for (button, meaning) in [("OK", &dialog.ok), ("Cancel", &dialog.cancel)] {
            if let Some(meaning) = meaning {
                let meaning = self.eval_text(meaning)?;
                text.push_str(&format!("\n{button}: {meaning}"));
            }
        }
        Ok(text)
    }

    /// SC,0: locations are those of the table base until SC,1 or the end of the run. What is set meanwhile as a working
    /// location is one of the working locations that come back.
    pub(crate) fn use_table_base(&mut self) {
        let frame = &mut self.core.place.frame;
        self.core.place.working_aside.get_or_insert(frame.working_zero);
        frame.working_zero = frame.base_zero;
        self.location_changed(AxisSet::first(6), AxisSet::EMPTY);
    }

    /// SC,1: locations are the working ones again.
    pub(crate) fn use_working_locations(&mut self) {
        let Some(zero) = self.core.place.working_aside.take() else { return };
        self.core.place.frame.working_zero = zero;
        self.location_changed(AxisSet::first(6), AxisSet::EMPTY);
    }

    /// FAIL: the program gives up.
    pub(super) fn give_up(&mut self, text: Option<&Expr>) -> Result<(), Stop> {
        let text = text.map_or(Ok("the program gives up".into()), |t| self.eval_text(t))?;
        self.settle()?;
        Err(self.fail(Code::ProgramFailed, text))
    }

    /// DATA_SEND and DATA_REQUEST: there is no program beside the machine, so what would be sent is
    /// shown, and a request is a question to the operator.
    pub(super) fn data(&mut self, request: bool, items: &[Expr]) -> Result<(), Stop> {
        let mut words = Vec::new();
        for item in items {
            words.push(self.eval_text(item)?);
        }
        let text = words.join(" ");
        if !request {
            self.emit(Command::Message { text: text.into() });
            return Ok(());
        }
        let buttons = [Button::OK, Button::Cancel];
        let question = self.question(QuestionKind::Pause, text, &buttons);
        self.confirm(&question)
    }
}
