//! Sample answers: what a program asks while it is previewed, and what was answered.

use kerf_control::answers::{self, Answers, Operator};
use kerf_program::{Question, QuestionKind};
use kerf_wire::SampleAnswer;

/// The most questions that are listed.
const MOST: usize = 50;

/// Answers a preview as a script says, and remembers what the program asked.
#[derive(Debug, Default)]
pub struct Samples {
    script: Answers,
    /// The questions, in the order in which they were asked.
    pub asked: Vec<SampleAnswer>,
}

impl Samples {
    /// Answers by a script.
    pub fn of(script: Answers) -> Self {
        Self { script, asked: Vec::new() }
    }

    fn note(&mut self, question: &Question, line: u32, given: Option<&String>) {
        let buttons: Vec<String> = question.buttons.iter().map(|b| b.word().to_owned()).collect();
        let chooses = question.kind == QuestionKind::Msgbox && buttons.len() > 1;
        if self.asked.len() == MOST || !(chooses || question.kind == QuestionKind::Input) {
            return;
        }
        let entry = question.kind.takes_text();
        let unasked = || match entry {
            true => question.prefill.clone(),
            false => answers::words(&answers::previewed_answer(question)),
        };
        self.asked.push(SampleAnswer {
            line,
            text: question.text.clone(),
            buttons: if entry { Vec::new() } else { buttons },
            answer: given.cloned().unwrap_or_else(unasked),
            given: given.is_some(),
        });
    }
}

impl Operator for Samples {
    fn answer(&mut self, question: &Question, line: u32) -> Option<String> {
        let given = self.script.answer(question, line);
        self.note(question, line, given.as_ref());
        given
    }

    fn script_line(&self) -> Option<usize> {
        self.script.script_line()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::Button;

    fn check(kind: QuestionKind, buttons: &[Button], script: &str, told: Option<(&str, bool)>) {
        let mut samples = Samples::of(Answers::read(script));
        let question = Question {
            kind,
            text: "How deep?".into(),
            title: String::new(),
            buttons: buttons.to_vec(),
            default: 0,
            prefill: "1/4".into(),
            icon: 0,
            until: None,
        };
        samples.answer(&question, 7);
        let asked: Vec<_> =
            samples.asked.iter().map(|asked| (asked.answer.as_str(), asked.given)).collect();
        assert_eq!(asked, told.into_iter().collect::<Vec<_>>(), "{kind:?} {script}");
    }

    #[test]
    fn what_is_asked_is_told_with_its_answer() {
        let boxes = [Button::Yes, Button::No];
        check(QuestionKind::Input, &[Button::OK], "", Some(("1/4", false)));
        check(QuestionKind::Input, &[Button::OK], "7:0.5", Some(("0.5", true)));
        check(QuestionKind::Msgbox, &boxes, "", Some(("Yes", false)));
        check(QuestionKind::Msgbox, &boxes, "7:No", Some(("No", true)));
        check(QuestionKind::Msgbox, &[Button::OK], "", None);
        check(QuestionKind::Pause, &boxes, "", None);
    }
}
