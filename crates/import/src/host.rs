//! A program's files and answers without a machine.
//!
//! Whoever follows a program on paper, to convert it, has no machine that takes time: everything given
//! counts as done, inputs are off. Files and questions are as in a run.

use kerf_program::{AXES, Answer, Host, Question};
use kerf_workspace::Workspace;
use std::task::Poll;

/// Answer to a question; `None` leaves it to the default.
pub type Answers<'a> = &'a mut dyn FnMut(&Question) -> Option<Answer>;

/// Files and answers.
pub struct ConversionHost<'a> {
    workspace: &'a mut Workspace,
    answers: Answers<'a>,
}

impl<'a> ConversionHost<'a> {
    /// A host with these; the workspace has to be one for previews.
    pub fn new(workspace: &'a mut Workspace, answers: Answers<'a>) -> Self {
        Self { workspace, answers }
    }
}

impl Host for ConversionHost<'_> {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }

    fn input(&mut self, _: u8) -> bool {
        false
    }

    fn output(&mut self, _: u8) -> bool {
        false
    }

    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        Poll::Ready((self.answers)(question).unwrap_or_else(|| question.default_answer()))
    }

    kerf_workspace::answered_by_the_workspace!();

    fn machine_position(&mut self) -> [f64; AXES] {
        [0.0; AXES]
    }

    fn firmware(&mut self) -> i32 {
        0
    }
}
