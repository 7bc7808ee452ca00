//! A program's files and answers without a machine.
//!
//! Whoever follows a program on paper, to convert it, has no machine that takes time: everything given
//! counts as done, inputs are off. Files and questions are as in a run.

use crate::answers::{self, Operator};
use kerf_program::{AXES, Answer, Host, Question};
use kerf_workspace::Workspace;
use std::task::Poll;

/// Files and answers.
pub struct Desk<'a> {
    workspace: &'a mut Workspace,
    operator: &'a mut dyn Operator,
}

impl<'a> Desk<'a> {
    /// A desk with these; the workspace has to be one for previews.
    pub fn new(workspace: &'a mut Workspace, operator: &'a mut dyn Operator) -> Self {
        Self { workspace, operator }
    }
}

impl Host for Desk<'_> {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }

    fn input(&mut self, _: u8) -> bool {
        false
    }

    fn output(&mut self, _: u8) -> bool {
        false
    }

    /// An answer that the box does not have counts as none.
    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        let given = self.operator.answer(question, 0);
        let meant = given.and_then(|words| answers::meaning(question, &words));
        Poll::Ready(meant.unwrap_or_else(|| answers::default_answer(question)))
    }

    crate::workspace_host::answered_by_the_workspace!();

    fn machine_position(&mut self) -> [f64; AXES] {
        [0.0; AXES]
    }

    fn firmware(&mut self) -> i32 {
        0
    }
}
