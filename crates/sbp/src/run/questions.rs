//! The parts that all questions to the operator share.

use super::{Context, Stop, eval};
use crate::tree::{DialogText, TextPart};
use kerf_diag::Code;
use kerf_program::Status;
use kerf_program::{Answer, Button, Question, QuestionKind};

/// A question with the file's name as title and its first button as default.
pub(crate) fn question(
    c: &Context<'_>,
    kind: QuestionKind,
    text: impl Into<String>,
    buttons: &[Button],
) -> Question {
    Question::new(kind, &*c.program.name, text, buttons)
}

/// Asks something that OK or Cancel answers; Cancel ends the run.
pub(crate) fn confirm(c: &mut Context<'_>, question: &Question) -> Result<(), Stop> {
    match c.ask(question)? {
        Answer::Button(Button::Cancel) => Err(terminated(c)),
        _ => Ok(()),
    }
}

/// A question for text that a person types, with what stands there at first.
pub(crate) fn entry(
    c: &Context<'_>,
    text: impl Into<String>,
    prefill: impl Into<String>,
) -> Question {
    let question = question(c, QuestionKind::Input, text, &[Button::OK, Button::Cancel]);
    Question { prefill: prefill.into(), ..question }
}

/// Asks for text that a person types; Cancel ends the run.
pub(crate) fn typed(c: &mut Context<'_>, question: &Question) -> Result<String, Stop> {
    let answer = c.ask(question)?;
    text_of(c, answer, question)
}

fn text_of(c: &mut Context<'_>, answer: Answer, question: &Question) -> Result<String, Stop> {
    match answer {
        Answer::Text(typed) => Ok(typed),
        Answer::Button(Button::Cancel) => Err(terminated(c)),
        Answer::Button(_) => Ok(question.prefill.clone()),
    }
}

/// The text that a person types for so many values; Cancel ends the run. A preview that nobody answers takes 0 for
/// each, and says so.
pub(crate) fn values_typed(
    c: &mut Context<'_>,
    question: &Question,
    values: usize,
) -> Result<String, Stop> {
    match c.ask(question)? {
        Answer::Button(Button::OK) if c.core.options.preview && question.prefill.is_empty() => {
            c.note(
                Code::SampleAnswer,
                format!("nobody answers '{}' here: 0 is taken", question.text),
                "answers for a look at this file: --answers FILE, or a file of its name with .answers behind it",
            );
            Ok(vec!["0"; values.max(1)].join(","))
        }
        answer => text_of(c, answer, question),
    }
}

/// The operator ended the run here, as with a stop (readings, A-30).
pub(crate) fn terminated(c: &mut Context<'_>) -> Stop {
    c.note(Code::Terminated, "terminated by the user", "");
    Stop::Finished(Status::Stopped)
}

/// The text of a dialog or of a command line.
pub(crate) fn dialog_text(c: &mut Context<'_>, text: &DialogText) -> Result<String, Stop> {
    match text {
        DialogText::Expr(expr) => eval::eval_text(c, expr),
        DialogText::Parts(parts) => Ok(parts.iter().map(|part| text_part(c, part)).collect()),
    }
}

fn text_part(c: &Context<'_>, part: &TextPart) -> String {
    match part {
        TextPart::Literal(text) => text.to_string(),
        TextPart::Variable(name, written) => {
            eval::variable(c, *name).map_or_else(|| written.to_string(), crate::Value::display)
        }
    }
}
