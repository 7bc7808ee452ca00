//! A host whose operator takes time to answer.

use kerf_program::testing::Bystander;
use kerf_program::{Answer, Question};
use std::task::Poll;

/// Motion is over at once; nobody answers until an answer is there.
#[derive(Default)]
pub struct Patient {
    /// The answer, when the operator has one.
    pub answer: Option<String>,
    /// Questions that were asked, as often as they were.
    pub asked: Vec<String>,
}

impl Bystander for Patient {
    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        self.asked.push(question.text.clone());
        self.answer.take().map_or(Poll::Pending, |text| Poll::Ready(Answer::Text(text)))
    }
}
