//! Waits of a run: for time, answers, inputs, the operator.

use crate::asking::Unanswered;
use crate::drive::Heard;
use crate::hand_words::{Aside, Jog, KEY};
use crate::interruption::Interruption;
use crate::run_end::Break;
use crate::runner::Runner;
use crate::station::Station;
use crate::{OperatorRequest, answers, lift_aside, pendant, reentry};
use kerf_machine::PauseOrder;
use kerf_model::{Halt, HaltCause};
use kerf_program::{Answer, At, Button, Interpreter, QuestionKind, StoppedBy};
use kerf_trace::{Event, flag};

/// Kind of a wait.
#[derive(Clone, Copy)]
enum Waits {
    /// For a time, which a stop extends.
    Time,
    /// A moment at which an input changes, whatever happens before.
    Input,
}

impl Waits {
    /// Returns the end of the wait after a stop of so many seconds.
    fn after_stop(self, until_s: f64, stopped_s: f64) -> f64 {
        match self {
            Self::Time => until_s + stopped_s,
            Self::Input => until_s,
        }
    }
}

impl<I: Interpreter> Runner<'_, I> {
    /// Lets time pass until a moment, unless something stops the program before.
    fn pass_until(&mut self, mut until_s: f64, waits: Waits) -> Result<(), Break> {
        while let Some(stood_s) = self.pass_some(until_s)? {
            until_s = waits.after_stop(until_s, self.stops.station.world.now() - stood_s);
        }
        Ok(())
    }

    /// The same until something happens: when that was. Nothing when the moment has come.
    fn pass_some(&mut self, until_s: f64) -> Result<Option<f64>, Break> {
        self.stops.station.wake();
        let watches = self.stops.station.watched(self.stops.station.world.now());
        let turn = self.stops.station.meet(until_s, &watches, None, Station::ask_pace);
        if self.stops.station.drive.fault().is_some() {
            return Err(self.stops.link_is_lost().into());
        }
        self.stops.station.stand_until(turn.map_or(until_s, |(t_s, _)| t_s));
        let stood_s = self.stops.station.world.now();
        self.stops.station.world.workspace.tape.stood(1.0);
        match turn {
            Some((_, Interruption::Operator(request))) if self.is_taken(request) => {
                return Err(self.taken_by_operator());
            }
            Some((_, Interruption::Operator(request))) if self.is_passed_over(request) => {}
            Some((_, Interruption::Operator(request))) => self.stops.stands(request)?,
            Some((_, Interruption::Input(halt))) => self.input_halts(halt)?,
            None => return Ok(None),
        }
        Ok(Some(stood_s))
    }

    /// An input changed while time passed and nothing moved.
    fn input_halts(&mut self, halt: Halt) -> Result<(), Break> {
        match halt.cause {
            HaltCause::Watch(index) if self.stops.station.is_emergency(index) => {
                Ok(self.stops.heed_press()?)
            }
            HaltCause::Watch(index) => {
                self.stops.station.drop_outputs(self.stops.station.world.now(), index);
                self.stops.station.world.tell_log();
                self.changed_s = halt.t_s;
                self.interrupt(index, &self.stops.station.stood())
            }
            cause => self.halted_by(cause, self.stops.station.stood()),
        }
    }

    /// The operator has stopped the machine, and the program says what follows.
    fn taken_by_operator(&mut self) -> Break {
        let stood = self.stops.station.stood();
        reentry::taken(&mut self.stops, StoppedBy::Operator, &stood)
    }

    /// Tells whether the program says what follows on a request.
    fn is_taken(&self, request: OperatorRequest) -> bool {
        self.stops.station.interpreter.takes_stops()
            && matches!(request, OperatorRequest::Stop | OperatorRequest::Hold)
    }

    /// Tells whether the power went when a machine that stood was about to be stopped. It is elsewhere now, and
    /// is brought back before the next move.
    fn is_passed_over(&mut self, request: OperatorRequest) -> bool {
        matches!(request, OperatorRequest::Stop | OperatorRequest::Hold)
            && self.stops.station.is_overtaken()
    }

    pub(crate) fn wait(&mut self, seconds: f64) -> Result<(), Break> {
        if self.stops.station.world.model.draws() {
            return Ok(());
        }
        let t = self.stops.station.world.now();
        self.stops.station.tell_standing(flag::PAUSED);
        self.stops.station.world.tell(&Event::Wait { seconds, t });
        self.pass_until(t + seconds.max(0.0), Waits::Time)
    }

    /// The operator may want something of a program that computes and does not move.
    pub(crate) fn heed_operator(&mut self) -> Result<(), Break> {
        let now = self.stops.station.world.now();
        if self.stops.station.stack.running.is_some() {
            return self.heed_while_moving();
        }
        let request = match self.stops.station.ask_pace(now, now, None) {
            Some((_, Heard::Operator(request))) => request,
            Some((t_s, Heard::Input { number, on })) => {
                self.stops.station.world.tracked().learn(number, on, t_s);
                return Ok(());
            }
            None => return Ok(()),
        };
        if self.is_taken(request) {
            return Err(self.taken_by_operator());
        }
        self.stops.station.world.workspace.tape.stood(1.0);
        if self.is_passed_over(request) {
            return Ok(());
        }
        Ok(self.stops.stands(request)?)
    }

    /// Lets what moves heed a request on the way. A program that only computes would not get there, and must not keep
    /// another from being heard.
    fn heed_while_moving(&mut self) -> Result<(), Break> {
        let now = self.stops.station.world.now();
        match self.stops.station.pass(now, now, None) {
            Some((t_s, Heard::Operator(request))) => self.stops.station.postpone((t_s, request)),
            Some((t_s, Heard::Input { number, on })) => {
                self.stops.station.world.tracked().learn(number, on, t_s);
                return self.flush();
            }
            None => {}
        }
        let stops = |request: &OperatorRequest| !matches!(request, OperatorRequest::Feed(_));
        if self.stops.station.requests.iter().any(|(_, request)| stops(request)) {
            self.flush()
        } else {
            Ok(())
        }
    }

    /// Answers the question that is open: an input does, or the operator.
    pub(crate) fn answer(&mut self) -> Result<(), Break> {
        self.stops.station.wake();
        let asked = self.stops.station.world.question.as_ref().map(|question| question.kind);
        let keypad = asked == Some(QuestionKind::Keypad);
        self.stops.station.tell_standing(if keypad { flag::KEYPAD } else { flag::PAUSED });
        self.stops.station.trail.asks(self.stops.station.interpreter.call_stack());
        let at = self.stops.station.asking_line();
        let until = self.stops.station.world.question.as_ref().and_then(|q| q.until);
        let tracked = self.stops.station.world.tracked();
        let moment = until.and_then(|(n, on)| match asked {
            // A key: what is pressed already was meant for something else.
            Some(QuestionKind::Paused) => tracked.when_pressed(n, on),
            _ => tracked.when(n, on),
        });
        if let Some(moment) = moment {
            let begin_s = self.stops.station.world.now();
            self.pass_until(moment, Waits::Input)?;
            let world = &mut self.stops.station.world;
            let seconds = world.now() - begin_s;
            world.tell(&Event::Wait { seconds, t: begin_s });
            world.answered_by_input(Answer::Button(Button::OK), at);
            return Ok(());
        }
        if let Some(moment) = asked.and_then(|kind| self.stops.station.world.next_key_s(kind)) {
            self.pass_until(moment, Waits::Input)?;
            pendant::use_pendant(&mut self.stops.station, at);
            return Ok(());
        }
        match self.answer_or_give_up(at) {
            Ok(answer) => {
                self.stops.station.world.answer = answer;
                self.stops.heeded()?;
                self.stops.goes_on_after_question()?;
                Ok(lift_aside::goes_back_after(&mut self.stops)?)
            }
            Err(why) => Err(self.stops.station.unanswered(at, why).into()),
        }
    }

    /// Returns the answer of the operator to the question that is open. A run that he gives up instead can be taken up
    /// as if he had not answered, unless it has not moved yet.
    fn answer_or_give_up(&mut self, at: At) -> Result<Option<Answer>, Unanswered> {
        loop {
            let question = self.stops.station.world.question.clone();
            let answer = self.answer_of_operator(at);
            let pauses = question.as_ref().is_some_and(|it| it.kind == QuestionKind::Paused);
            if !gives_up(&answer, pauses) {
                return answer;
            }
            if self.stops.station.world.workspace.tape.is_last_told() {
                // The power went before the run was given up.
                self.stops.station.world.workspace.tape.take_back_answer();
                self.stops.station.world.question = question;
                self.stops.station.wake();
                continue;
            }
            if self.stops.station.world.silent
                || !self.stops.station.world.workspace.tape.has_moved()
            {
                return answer;
            }
            let stands = self.stops.station.stands_at();
            self.stops.station.world.workspace.tape.given_up_by_answer(stands);
            // Nothing is brought back only to be given up.
            let is_back = self.stops.station.reentry.is_none();
            return if is_back { answer } else { Err(Unanswered::Stopped) };
        }
    }

    /// Returns the answer of the operator to the question that is open; at a keypad he moves the tool before.
    fn answer_of_operator(&mut self, at: At) -> Result<Option<Answer>, Unanswered> {
        let Some(question) = self.stops.station.world.question.take() else { return Ok(None) };
        let hands = [QuestionKind::Keypad, QuestionKind::Paused].contains(&question.kind);
        loop {
            let answer = self.stops.station.world.ask_now(&question, at)?;
            match &answer {
                Answer::Text(words) if Aside::is_for(question.kind) => match Aside::read(words) {
                    Some(aside) => {
                        lift_aside::set_aside(&mut self.stops, aside);
                        if self.stops.ends.is_some() {
                            return Ok(None);
                        }
                    }
                    None => return Ok(Some(answer)),
                },
                Answer::Text(words) if words == KEY && question.kind == QuestionKind::Keypad => {
                    if pendant::follow_pendant(&mut self.stops.station) {
                        self.stops.station.world.answered();
                        return Ok(Some(Answer::Button(Button::OK)));
                    }
                }
                Answer::Text(words) if hands => match Jog::read(words) {
                    Some(jog) => {
                        self.stops.station.jog(jog);
                        self.stops
                            .station
                            .interpreter
                            .moved(self.stops.station.world.model.position());
                    }
                    None if question.kind == QuestionKind::Keypad => {}
                    None => return Ok(Some(answer)),
                },
                _ => return Ok(Some(answer)),
            }
        }
    }
}

/// Tells whether the operator gives up a run that waits: a job in a pause by what he tells it.
fn gives_up(answer: &Result<Option<Answer>, Unanswered>, pauses: bool) -> bool {
    match answer {
        Ok(Some(answer)) if pauses => {
            PauseOrder::read(&answers::words(answer)) == Some(PauseOrder::Abort)
        }
        Ok(_) | Err(Unanswered::NoButton(_)) => false,
        Err(Unanswered::Stopped) => true,
    }
}
