//! Questions to the operator that both languages ask, and their answers while a step is repeated.

use crate::{Answer, Button, GoTo, Question, QuestionKind};
use serde::{Deserialize, Serialize};
use std::task::Poll;

/// Answers to a step that is repeated from its beginning until it has every one.
///
/// ```
/// use kerf_program::{Answer, Answers, Button};
/// use std::task::Poll;
/// let mut answers = Answers::default();
/// let ok = Answer::Button(Button::OK);
/// assert_eq!(answers.next(|| Poll::Ready(ok.clone())), Poll::Ready(ok.clone()));
/// answers.begin_again();
/// assert_eq!(answers.next(|| Poll::Pending), Poll::Ready(ok), "it is not asked twice");
/// assert_eq!(answers.next(|| Poll::Pending), Poll::Pending);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Answers {
    heard: Vec<Answer>,
    /// Number of these that the present attempt has taken.
    taken: usize,
}

impl Answers {
    /// Begins another attempt, which hears the same answers first.
    pub const fn begin_again(&mut self) {
        self.taken = 0;
    }

    /// Forgets the answers: the step is over.
    pub fn forget(&mut self) {
        self.heard.clear();
    }

    /// The next answer: one heard in an earlier attempt, or the one that `ask` gets.
    pub fn next(&mut self, ask: impl FnOnce() -> Poll<Answer>) -> Poll<Answer> {
        if self.taken == self.heard.len() {
            match ask() {
                Poll::Ready(answer) => self.heard.push(answer),
                Poll::Pending => return Poll::Pending,
            }
        }
        let answer = self.heard[self.taken].clone();
        self.taken += 1;
        Poll::Ready(answer)
    }
}

impl Question {
    /// A question whose first button is the default.
    pub fn new(
        kind: QuestionKind,
        title: impl Into<String>,
        text: impl Into<String>,
        buttons: &[Button],
    ) -> Self {
        Self {
            kind,
            text: text.into(),
            title: title.into(),
            buttons: buttons.to_vec(),
            default: 0,
            prefill: String::new(),
            icon: 0,
            until: None,
        }
    }

    /// Asks about the line that is next in a file which is gone through line by line; `last` is the line at which a run
    /// of it ended.
    pub fn of_step(file: &str, line: &str, last: Option<u32>) -> Self {
        let buttons = [Button::Step, Button::Run, Button::Quit];
        let question = Self::new(QuestionKind::Step, file, line.trim(), &buttons);
        Self { prefill: last.map_or_else(String::new, |line| line.to_string()), ..question }
    }
}

/// Choice of the operator about the line that is next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepChoice {
    /// It runs, and the one behind it is asked for.
    Once,
    /// The file runs on without questions.
    RunOn,
    /// The run ends.
    Quit,
    /// The file goes on at another line.
    GoTo(GoTo),
    /// What was typed names no line: the question is asked again.
    Again,
}

impl StepChoice {
    /// Reads the answer to [`Question::of_step`].
    pub fn of(answer: &Answer, last: Option<u32>) -> Self {
        match answer {
            Answer::Button(Button::Step) => Self::Once,
            Answer::Button(Button::Run) => Self::RunOn,
            Answer::Button(_) => Self::Quit,
            Answer::Text(words) => GoTo::read(words, last).map_or(Self::Again, Self::GoTo),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_is_taken_once_in_each_attempt_and_forgotten_with_the_step() {
        let (yes, no) = (Answer::Button(Button::Yes), Answer::Button(Button::No));
        let mut answers = Answers::default();
        let ready = |answer: &Answer| Poll::Ready(answer.clone());
        assert_eq!(answers.next(|| ready(&yes)), ready(&yes));
        assert_eq!(answers.next(|| ready(&no)), ready(&no));
        answers.begin_again();
        assert_eq!(answers.next(|| Poll::Pending), ready(&yes));
        assert_eq!(answers.next(|| Poll::Pending), ready(&no));
        answers.begin_again();
        answers.forget();
        assert_eq!(answers.next(|| Poll::Pending), Poll::Pending);
    }

    #[test]
    fn answers_to_a_step() {
        let typed = |words: &str| StepChoice::of(&Answer::Text(words.into()), Some(7));
        assert_eq!(StepChoice::of(&Answer::Button(Button::Step), None), StepChoice::Once);
        assert_eq!(StepChoice::of(&Answer::Button(Button::Run), None), StepChoice::RunOn);
        assert_eq!(StepChoice::of(&Answer::Button(Button::Cancel), None), StepChoice::Quit);
        assert!(matches!(typed("12"), StepChoice::GoTo(GoTo { line: 12, .. })));
        assert_eq!(typed("what"), StepChoice::Again);
    }
}
