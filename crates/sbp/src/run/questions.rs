//! The parts that all questions to the operator share.

use super::{Context, Status, Stop};
use crate::tree::{DialogText, TextPart};
use kerf_diag::Code;
use kerf_program::{Answer, Button, Question, QuestionKind};

impl Context<'_> {
    /// A question with the file's name as title and its first button as default.
    pub(crate) fn question(
        &self,
        kind: QuestionKind,
        text: impl Into<String>,
        buttons: &[Button],
    ) -> Question {
        Question {
            kind,
            text: text.into(),
            title: self.program.name.to_string(),
            buttons: buttons.to_vec(),
            default: 0,
            prefill: String::new(),
            icon: 0,
            until: None,
        }
    }

    /// Asks something that OK or Cancel answers; Cancel ends the run.
    pub(crate) fn confirm(&mut self, question: &Question) -> Result<(), Stop> {
        match self.ask(question)? {
            Answer::Button(Button::Cancel) => Err(self.terminated()),
            _ => Ok(()),
        }
    }

    /// A question for text that a person types, with what stands there at first.
    pub(crate) fn entry(&self, text: impl Into<String>, prefill: impl Into<String>) -> Question {
        let question = self.question(QuestionKind::Input, text, &[Button::OK, Button::Cancel]);
        Question { prefill: prefill.into(), ..question }
    }

    /// Asks for text that a person types; Cancel ends the run.
    pub(crate) fn typed(&mut self, question: &Question) -> Result<String, Stop> {
        let answer = self.ask(question)?;
        self.text_of(answer, question)
    }

    fn text_of(&mut self, answer: Answer, question: &Question) -> Result<String, Stop> {
        match answer {
            Answer::Text(typed) => Ok(typed),
            Answer::Button(Button::Cancel) => Err(self.terminated()),
            Answer::Button(_) => Ok(question.prefill.clone()),
        }
    }

    /// The text that a person types for so many values; Cancel ends the run. A preview that nobody answers takes 0 for
    /// each, and says so.
    pub(crate) fn values_typed(
        &mut self,
        question: &Question,
        values: usize,
    ) -> Result<String, Stop> {
        match self.ask(question)? {
            Answer::Button(Button::OK)
                if self.core.options.preview && question.prefill.is_empty() =>
            {
                self.note(
                    Code::SampleAnswer,
                    format!("nobody answers '{}' here: 0 is taken", question.text),
                    "answers for a look at this file: --answers FILE, or a file of its name with .answers behind it",
                );
                Ok(vec!["0"; values.max(1)].join(","))
            }
            answer => self.text_of(answer, question),
        }
    }

    /// The operator ended the run here, as with a stop (readings, A-30).
    pub(crate) fn terminated(&mut self) -> Stop {
        self.note(Code::Terminated, "terminated by the user", "");
        Stop::Finished(Status::Stopped)
    }

    /// The text of a dialog or of a command line.
    pub(crate) fn dialog_text(&mut self, text: &DialogText) -> Result<String, Stop> {
        match text {
            DialogText::Expr(expr) => self.eval_text(expr),
            DialogText::Parts(parts) => Ok(parts.iter().map(|part| self.text_part(part)).collect()),
        }
    }

    fn text_part(&self, part: &TextPart) -> String {
        match part {
            TextPart::Literal(text) => text.to_string(),
            TextPart::Variable(name, written) => {
                self.variable(*name).map_or_else(|| written.to_string(), crate::Value::display)
            }
        }
    }
}
