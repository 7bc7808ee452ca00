//! The state in which a job is, and the reason for which it stands.

use kerf_machine::lines::Input;
use kerf_machine::{Configuration, State};
use kerf_program::{Halted, Question, QuestionKind};
use std::sync::Arc;

/// State of a job as stops leave it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Halt {
    pub state: State,
    /// Reason for which it is not running.
    pub why: Arc<str>,
    /// Place where the last input fired.
    pub began: Halted,
    /// The machine stands at the pause mark of a shape.
    pub marked: bool,
    /// It halted at the pause mark of this shape already.
    pub halted_before: bool,
}

impl Halt {
    /// The pause mark of the shape at hand is left behind.
    pub fn leave_mark(&mut self) {
        self.halted_before |= std::mem::take(&mut self.marked);
    }

    /// Returns the question to the operator.
    pub fn question(&self, machine: &Configuration, nth: usize, number: u32) -> Question {
        // A pause mark is where a job is meant to wait: without an operator it goes on.
        let preparing = self.state == State::Waiting && self.why.is_empty();
        let marked = self.marked || preparing;
        let text = match (&*self.why, marked) {
            (_, true) if preparing => format!("Start with shape {}?", nth + 1),
            (_, true) => format!("Shape {}", number),
            ("", false) => "Paused".to_owned(),
            (why, false) => format!("Paused: {why}"),
        };
        let limited = self.state == State::Limited;
        Question {
            kind: if limited { QuestionKind::Limit } else { QuestionKind::Paused },
            text,
            title: "Job".into(),
            buttons: self.state.ways_on().into(),
            default: usize::from(!marked),
            // The shape it begins with, so that whoever shows it need not read the text.
            prefill: if preparing { (nth + 1).to_string() } else { String::new() },
            icon: 0,
            // The external start is a key as any other.
            until: (preparing && machine.job.external_start)
                .then_some((Input::WHome.number(), true)),
        }
    }
}
