//! What the operator is asked, and when the machine has caught up.

use super::stop::Stop;
use kerf_program::{Answer, Answers, Host, Question};
use serde::{Deserialize, Serialize};
use std::task::Poll;

/// Answers of the operator, and how far the machine has come.
///
/// A block that asks begins again for each question. The answers that it was given are kept until it is done,
/// so that nobody is asked twice.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Asking {
    /// Answers given in the present block.
    answers: Answers,
    /// Everything given so far has been carried out.
    pub(super) settled: bool,
    /// All that came before the present block has been carried out. What the block itself gives before
    /// it asks goes with it: it is given anew with each attempt, so nobody could wait for it.
    at_rest: bool,
}

impl Default for Asking {
    fn default() -> Self {
        Self { answers: Answers::default(), settled: true, at_rest: false }
    }
}

impl Asking {
    /// Waits until everything given so far has been carried out.
    pub(super) fn settle(&mut self, host: &mut dyn Host) -> Result<(), Stop> {
        if self.settled || self.at_rest {
            return Ok(());
        }
        match host.settle() {
            Poll::Ready(()) => {
                self.settled = true;
                Ok(())
            }
            Poll::Pending => Err(Stop::Waiting),
        }
    }

    /// Asks the operator, unless an earlier attempt of the block did.
    pub(super) fn ask(&mut self, host: &mut dyn Host, question: &Question) -> Result<Answer, Stop> {
        let mut answers = std::mem::take(&mut self.answers);
        let answer = answers.next(|| match self.ask_at_once(host, question) {
            Ok(answer) => Poll::Ready(answer),
            Err(_) => Poll::Pending,
        });
        self.answers = answers;
        match answer {
            Poll::Ready(answer) => Ok(answer),
            Poll::Pending => Err(Stop::Waiting),
        }
    }

    /// Asks the operator outside a block: the answer is not kept for another attempt.
    pub(super) fn ask_at_once(
        &mut self,
        host: &mut dyn Host,
        question: &Question,
    ) -> Result<Answer, Stop> {
        self.settle(host)?;
        match host.ask(question) {
            Poll::Ready(answer) => Ok(answer),
            Poll::Pending => Err(Stop::Waiting),
        }
    }

    /// A block begins that may ask; the machine stands.
    pub(super) const fn begin(&mut self) {
        self.answers.begin_again();
        self.at_rest = true;
    }

    /// The block ended, or is attempted again later; returns the answers given in it.
    pub(super) fn end(&mut self) -> Answers {
        self.at_rest = false;
        std::mem::take(&mut self.answers)
    }

    /// Keeps the answers for the next attempt of the block.
    pub(super) fn keep(&mut self, answers: Answers) {
        self.answers = answers;
    }
}
