//! What a run waits for: time, answers, inputs, the operator.

use crate::runner::{Flow, Over, Runner};
use crate::{Event, flag};
use kerf_diag::{Code, Diagnostic, Place};
use kerf_program::{Answer, At, Button, Interpreter, Question, Status};
use kerf_sim::HaltCause;

impl<I: Interpreter> Runner<'_, I> {
    /// Lets time pass until a moment, unless something stops the program before.
    pub(crate) fn pass_until(&mut self, until_s: f64) -> Flow {
        let watches = self.watched();
        let halt = self.world.machine.first_halt(until_s, &watches);
        // Nothing moves: limit and stop inputs have nothing to stop.
        let halt = halt.and_then(|h| match h.cause {
            HaltCause::Watch(index) => Some((h.t_s, index)),
            _ => None,
        });
        let end_s = halt.map_or(until_s, |(t_s, _)| t_s);
        let begin_s = self.world.now();
        let stopped = self.pace.pass(begin_s, end_s);
        let end_s = stopped.unwrap_or(end_s).max(begin_s);
        self.world.machine.advance(end_s);
        self.world.tally.waited(end_s - begin_s);
        self.world.tell_log();
        match (stopped, halt) {
            (Some(_), _) => match self.hold() {
                Ok(_) => self.pass_until(self.world.now() + until_s - end_s),
                Err(over) => Flow::Over(over),
            },
            (None, Some((_, index))) => self.interrupt(index, None),
            (None, None) => Flow::On,
        }
    }

    pub(crate) fn wait(&mut self, seconds: f64) -> Flow {
        if self.world.machine.draws() {
            return Flow::On;
        }
        let t = self.world.now();
        self.tell_standing(flag::PAUSED);
        self.world.tell(&Event::Wait { seconds, t });
        self.pass_until(t + seconds.max(0.0))
    }

    /// The operator may stop a program that computes and does not move.
    pub(crate) fn heed_operator(&mut self) -> Flow {
        let now = self.world.now();
        match self.pace.pass(now, now) {
            Some(_) => self.hold().map_or_else(Flow::Over, |_| Flow::On),
            None => Flow::On,
        }
    }

    /// Answers the question that is open: an input does, or the operator.
    pub(crate) fn answer(&mut self) -> Flow {
        self.tell_standing(flag::PAUSED);
        self.trail.asks(self.interpreter.call_stack());
        let at = self.asking_line();
        let until = self.world.question.as_ref().and_then(|q| q.until);
        let moment = until.and_then(|(n, on)| self.world.machine.when_input(n, on));
        if let Some(moment) = moment {
            let (begin_s, flow) = (self.world.now(), self.pass_until(moment));
            if matches!(flow, Flow::On) {
                let seconds = self.world.now() - begin_s;
                self.world.tell(&Event::Wait { seconds, t: begin_s });
                self.world.answered_by_input(Answer::Button(Button::OK), at);
            }
            return flow;
        }
        match self.world.answer_open_question(at) {
            Ok(()) => Flow::On,
            Err(message) => Flow::Over(self.unanswered(at, message)),
        }
    }

    /// A question of the machine, not of the program.
    pub(crate) fn ask(&mut self, question: &Question, at: At) -> Result<Answer, Over> {
        self.world.ask_now(question, at).map_err(|message| self.unanswered(at, message))
    }

    fn unanswered(&self, at: At, message: String) -> Over {
        let place = Place::line(self.world.file(at), at.line);
        let diagnostic = Diagnostic::new(Code::Terminated, place, message)
            .hint("the script of answers has to name a button of the box");
        Over { status: Status::Failed, diagnostic: Some(Box::new(diagnostic)) }
    }

    /// The line that asks; it runs again when the answer is there.
    pub(crate) fn asking_line(&self) -> At {
        self.interpreter.call_stack().last().copied().unwrap_or_default()
    }
}
