//! Waits of a run: for time, answers, inputs, the operator.

use crate::OperatorRequest;
use crate::answers;
use crate::away::Aside;
use crate::by_hand::Jog;
use crate::drive::Heard;
use crate::execute::Turn as Halts;
use crate::pendant::KEY;
use crate::runner::{Flow, Over, Runner};
use crate::world::Unanswered;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_journal::{Kind, Placed, Turn};
use kerf_machine::Going;
use kerf_machine::Word;
use kerf_machine::state::{Event as Stopped, StopSettings};
use kerf_motion::Move;
use kerf_program::{
    Answer, At, Button, Halted, Interpreter, Question, QuestionKind, Status, StoppedBy,
};
use kerf_sim::{Halt, HaltCause};
use kerf_trace::{Event, flag};

/// Interval at which it is written down how far a move has come, seconds.
const RECORDED_EVERY_S: f64 = 0.02;

/// Kind of a wait.
#[derive(Clone, Copy)]
enum Waits {
    /// So much time: a stop makes it longer.
    Time,
    /// A moment at which an input changes, whatever happens before.
    Input,
}

impl Waits {
    /// Until when it waits when it was stopped for so long.
    fn after_stop(self, until_s: f64, stopped_s: f64) -> f64 {
        match self {
            Self::Time => until_s + stopped_s,
            Self::Input => until_s,
        }
    }
}

impl<I: Interpreter> Runner<'_, I> {
    /// Lets time pass until a moment, unless something stops the program before.
    fn pass_until(&mut self, mut until_s: f64, waits: Waits) -> Flow {
        loop {
            match self.pass_some(until_s) {
                None => return Flow::On,
                Some((stood_s, Flow::On)) => {
                    until_s = waits.after_stop(until_s, self.world.now() - stood_s);
                }
                Some((_, flow)) => return flow,
            }
        }
    }

    /// The same until something happens: when that was, and what follows on it. Nothing when the moment has come.
    fn pass_some(&mut self, until_s: f64) -> Option<(f64, Flow)> {
        self.wake();
        let watches = self.watched(self.world.now());
        let turn = self.meet(until_s, &watches, None, Self::ask_pace);
        if self.drive.fault().is_some() {
            return Some((self.world.now(), Flow::Over(self.link_is_lost())));
        }
        self.stand_until(turn.map_or(until_s, |(t_s, _)| t_s));
        let stood_s = self.world.now();
        self.world.workspace.tape.stood(1.0);
        let flow = match turn?.1 {
            Halts::Operator(request) if self.is_taken(request) => {
                self.taken(StoppedBy::Operator, &self.stood())
            }
            Halts::Operator(request) if self.is_passed_over(request) => Flow::On,
            Halts::Operator(request) => self.stands(request).map_or_else(Flow::Over, |()| Flow::On),
            Halts::Input(halt) => self.input_halts(halt),
        };
        Some((stood_s, flow))
    }

    /// An input changed while time passed and nothing moved.
    fn input_halts(&mut self, halt: Halt) -> Flow {
        match halt.cause {
            HaltCause::Watch(index) if self.is_emergency(index) => {
                self.heed_press().map_or_else(Flow::Over, |()| Flow::On)
            }
            HaltCause::Watch(index) => {
                self.drop_outputs(self.world.now(), index);
                self.world.tell_log();
                self.changed_s = halt.t_s;
                self.interrupt(index, &self.stood())
            }
            cause => match self.halted_by(cause, self.stood()) {
                Ok(()) => Flow::On,
                Err(halted) => self.halted(halted),
            },
        }
    }

    /// Tells whether the program says what follows on a request.
    fn is_taken(&self, request: OperatorRequest) -> bool {
        self.interpreter.takes_stops()
            && matches!(request, OperatorRequest::Stop | OperatorRequest::Hold)
    }

    /// Tells whether the power went when a machine that stood was about to be stopped. It is elsewhere now, and
    /// is brought back before the next move.
    fn is_passed_over(&mut self, request: OperatorRequest) -> bool {
        matches!(request, OperatorRequest::Stop | OperatorRequest::Hold) && self.is_overtaken()
    }

    /// Returns where the machine stands, with nothing left to make.
    pub(crate) fn stood(&self) -> Halted {
        let position = self.world.machine.position();
        Halted { motion: None, began: position, stands: position }
    }

    /// Time passes and nothing moves.
    pub(crate) fn stand_until(&mut self, end_s: f64) {
        let begin_s = self.world.now();
        let end_s = end_s.max(begin_s);
        self.world.tracked().advance(end_s);
        self.world.tally.waited(end_s - begin_s);
        self.world.tell_log();
    }

    pub(crate) fn wait(&mut self, seconds: f64) -> Flow {
        if self.world.machine.draws() {
            return Flow::On;
        }
        let t = self.world.now();
        self.tell_standing(flag::PAUSED);
        self.world.tell(&Event::Wait { seconds, t });
        self.pass_until(t + seconds.max(0.0), Waits::Time)
    }

    /// Returns what comes before a moment: a request of the operator, one that was postponed first, or an input.
    pub(crate) fn ask_pace(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<Going<'_>>,
    ) -> Option<(f64, Heard)> {
        let Some((t_s, request)) = self.requests.pop_front() else {
            return self.pass(from_s, to_s, going);
        };
        let postponed = (t_s.clamp(from_s, to_s.max(from_s)), Heard::Operator(request));
        let heard = self.hear(to_s, |_, _| Some(postponed));
        if !matches!(heard, Some((_, Heard::Operator(_)))) {
            // Not yet, where this has happened before.
            self.requests.push_front((t_s, request));
        }
        heard
    }

    /// Lets machine time pass. What was made before it is on record; while the machine moves, soon. A switch that the
    /// operator moves is told by the machine.
    pub(crate) fn pass(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<Going<'_>>,
    ) -> Option<(f64, Heard)> {
        if to_s > from_s && self.drive.is_real() {
            self.world.workspace.tape.write();
            // What moves waits for no disk.
            if going.is_none() {
                self.world.workspace.tape.settle();
            }
        }
        loop {
            let heard = self.hear(to_s, |run, is_kept| {
                if is_kept {
                    run.watch_writing(from_s, to_s, going)
                } else {
                    run.watch(from_s, to_s, going)
                }
            });
            let (t_s, Heard::Operator(OperatorRequest::Input { number, on })) = heard? else {
                return heard;
            };
            if !self.press(number, on, t_s) {
                return Some((t_s, Heard::Input { number, on }));
            }
        }
    }

    /// The same; inputs that change meanwhile are noted, and only the operator ends it.
    pub(crate) fn pass_learning(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<Going<'_>>,
    ) -> Option<(f64, OperatorRequest)> {
        loop {
            match self.pass(from_s, to_s, going)? {
                (t_s, Heard::Input { number, on }) => self.world.tracked().learn(number, on, t_s),
                (t_s, Heard::Operator(request)) => return Some((t_s, request)),
            }
        }
    }

    /// Returns what the tape tells, else what the world does; that is kept where there is a tape.
    fn hear(
        &mut self,
        to_s: f64,
        world: impl FnOnce(&mut Self, bool) -> Option<(f64, Heard)>,
    ) -> Option<(f64, Heard)> {
        match self.world.workspace.tape.turn(Kind::Request) {
            Turn::Told(Some((t_s, request))) => {
                self.world.workspace.tape.write();
                Some((t_s, Heard::Operator(request)))
            }
            Turn::Told(None) if self.world.machine.draws() => None,
            Turn::Told(None) => self.drive.repeat(to_s, &self.world.machine.settings().io),
            Turn::Live => world(self, false),
            Turn::Open(call) => {
                let heard = world(self, true);
                self.keep(call, heard);
                heard
            }
        }
    }

    /// Keeps what was heard on the tape. A machine that repeats what it does tells its inputs once more instead.
    fn keep(&mut self, call: u64, heard: Option<(f64, Heard)>) {
        let request = heard.and_then(|(t_s, heard)| match heard {
            Heard::Operator(request) => Some((t_s, request)),
            Heard::Input { .. } if self.drive.repeats() => None,
            Heard::Input { number, on } => Some((t_s, OperatorRequest::Input { number, on })),
        });
        let tape = &mut self.world.workspace.tape;
        tape.heard(Kind::Request, call, request.as_ref());
        match request {
            Some((_, OperatorRequest::Stop | OperatorRequest::Hold)) => tape.stops(),
            Some((_, OperatorRequest::Input { number, .. })) => tape.presses(number),
            _ => {}
        }
        if request.is_some() {
            tape.write();
        }
    }

    fn watch(&mut self, from_s: f64, to_s: f64, going: Option<Going<'_>>) -> Option<(f64, Heard)> {
        self.world.pass(&mut self.drive, from_s, to_s, going, self.feed)
    }

    /// While time passes as it does in the world, how far a move has come is on record: what is made
    /// of it when the power fails is not cut again.
    fn watch_writing(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<Going<'_>>,
    ) -> Option<(f64, Heard)> {
        let Some(under_way) = going.filter(|_| self.drive.is_real()) else {
            return self.watch(from_s, to_s, going);
        };
        let slices = ((to_s - from_s) / RECORDED_EVERY_S).ceil().max(1.0) as u64;
        let moment = |n: u64| from_s + (to_s - from_s) * n as f64 / slices as f64;
        for slice in 1..=slices {
            let (begin_s, end_s) = (moment(slice - 1), moment(slice));
            let request = self.watch(begin_s, end_s, going);
            if request.is_some() || slice == slices {
                return request;
            }
            // A way that is looked through again after something happened is on record already.
            if end_s <= self.recorded_s {
                continue;
            }
            self.recorded_s = end_s;
            let state = under_way.at(end_s);
            if state.move_index == under_way.index {
                let place = Placed { position: state.position, ..self.world.placed() };
                self.world.workspace.tape.makes(state.share * under_way.part, place);
            }
        }
        None
    }

    /// Keeps a request of which nothing comes now, as if it had not been told: it is when it is fulfilled. Whoever asks
    /// once more because of it postpones it instead.
    pub(crate) fn put_off(&mut self, request: (f64, OperatorRequest)) {
        self.world.workspace.tape.unhear_request();
        self.postpone(request);
    }

    /// Nothing comes of a stop that was told just now: an input has stopped the machine already, or it slows down for one,
    /// and asks when it stands.
    pub(crate) fn forgo(&mut self) {
        self.world.workspace.tape.unhear_request();
        self.drive.heard();
    }

    /// Keeps a request that cannot be fulfilled now.
    pub(crate) fn postpone(&mut self, request: (f64, OperatorRequest)) {
        if !self.requests.iter().any(|(_, other)| *other == request.1) {
            self.requests.push_back(request);
        }
    }

    /// The operator may want something of a program that computes and does not move.
    pub(crate) fn heed_operator(&mut self) -> Flow {
        let now = self.world.now();
        if self.stack.running.is_some() {
            return self.heed_while_moving();
        }
        let Some((t_s, heard)) = self.ask_pace(now, now, None) else { return Flow::On };
        let request = match heard {
            Heard::Operator(request) => request,
            Heard::Input { number, on } => {
                self.world.tracked().learn(number, on, t_s);
                return Flow::On;
            }
        };
        if self.is_taken(request) {
            return self.taken(StoppedBy::Operator, &self.stood());
        }
        self.world.workspace.tape.stood(1.0);
        if self.is_passed_over(request) {
            return Flow::On;
        }
        self.stands(request).map_or_else(Flow::Over, |()| Flow::On)
    }

    /// Lets what moves heed a request on the way. A program that only computes would not get there, and must not keep
    /// another from being heard.
    fn heed_while_moving(&mut self) -> Flow {
        let now = self.world.now();
        match self.pass(now, now, None) {
            Some((t_s, Heard::Operator(request))) => self.postpone((t_s, request)),
            Some((t_s, Heard::Input { number, on })) => {
                self.world.tracked().learn(number, on, t_s);
                return self.flush();
            }
            None => {}
        }
        let stops = |request: &OperatorRequest| !matches!(request, OperatorRequest::Feed(_));
        if self.requests.iter().any(|(_, request)| stops(request)) {
            self.flush()
        } else {
            Flow::On
        }
    }

    /// Does what follows on a request when the machine stands.
    pub(crate) fn stands(&mut self, request: OperatorRequest) -> Result<(), Over> {
        match request {
            OperatorRequest::Stop => self.hold(),
            OperatorRequest::Hold => self.pause(),
            OperatorRequest::Feed(share) => {
                self.override_feed(share);
                Ok(())
            }
            OperatorRequest::End => Err(Over { status: Status::Ended, diagnostic: None }),
            OperatorRequest::Input { number, on } => {
                self.press(number, on, self.world.now());
                Ok(())
            }
        }
    }

    /// The switch of an input is moved at a moment that is still to come, or in the next: the machine tells that it
    /// changes. Returns `false` where nobody moves switches but the machine.
    fn press(&mut self, input: u8, on: bool, at_s: f64) -> bool {
        let at_s = at_s.max(self.world.now().next_up());
        self.drive.press(input, on, at_s)
    }

    /// From here on cuts run at this share of the speed asked for.
    pub(crate) fn override_feed(&mut self, share: f32) {
        let (least, most) = Move::FEEDS;
        let share = if share.is_nan() { 1.0 } else { share.clamp(least, most) };
        if self.drive.overrides() {
            self.drive.feed(share);
        } else {
            self.feed = share;
        }
        let percent = (f64::from(share) * 1e3).round() / 10.0;
        self.world.tell(&Event::Override { percent, t: self.world.now() });
    }

    /// The machine stands where it is, and stays so until the operator resumes.
    fn pause(&mut self) -> Result<(), Over> {
        // The tool stays where it is.
        let settings = StopSettings { raise: false, ..StopSettings::OPENSBP };
        self.heed_emergency()?;
        self.on(Stopped::Stop, settings, "");
        self.on(Stopped::Stands, settings, "");
        self.keep_turning();
        self.stopped_meanwhile()?;
        let t = self.world.now();
        self.world.tell(&Event::Hold { t });
        self.tell_standing(flag::PAUSED);
        let resumed = if self.is_open_for_take_up() {
            Some(t)
        } else {
            let drive = &mut self.drive;
            self.world.workspace.tape.change(Kind::Resume, || drive.resumes(t))
        };
        // The power went before the run was given up.
        let resumed = resumed.or_else(|| self.is_open_for_take_up().then_some(t));
        let Some(resumed_s) = resumed else {
            self.on(Stopped::Abort, settings, "");
            self.world.workspace.tape.given_up(self.world.placed());
            return Err(Over { status: Status::Stopped, diagnostic: None });
        };
        if let Err(over) = self.stand_held(resumed_s) {
            self.on(Stopped::Abort, settings, "");
            self.world.workspace.tape.given_up(self.world.placed());
            return Err(over);
        }
        self.world.workspace.tape.goes_on();
        self.on(Stopped::Continue, settings, "");
        self.heeded()
    }

    /// The machine is held until a moment. A stop input that came or comes meanwhile stops what turns, and has to be
    /// released; the emergency stop ends the run.
    fn stand_held(&mut self, until_s: f64) -> Result<(), Over> {
        let Some((t_s, cause)) = self.stops_held(until_s) else {
            self.stand_until(until_s);
            return Ok(());
        };
        self.stand_until(t_s);
        let HaltCause::Stop(n) = cause else { return self.heed_press() };
        if self.cuts_power(n) {
            return Err(self.power_is_cut());
        }
        self.stop_spindles();
        self.stand_until(until_s);
        let message = self.stop_input_message(format!("stopped by stop input {n}"));
        self.until_released(&message, false)
    }

    /// The first stop of a machine that is held until a moment, and when it came.
    fn stops_held(&mut self, until_s: f64) -> Option<(f64, HaltCause)> {
        let active = self.world.machine.stop_input();
        let active = active.map(|n| (self.world.now(), HaltCause::Stop(n)));
        active.or_else(|| {
            let watched = self.watched_at_rest();
            self.world.tracked().learn_until(until_s);
            let halt = self.world.machine.halted_at_rest(until_s, watched.as_slice())?;
            matches!(halt.cause, HaltCause::Stop(_) | HaltCause::Watch(_))
                .then_some((halt.t_s, halt.cause))
        })
    }

    /// Answers the question that is open: an input does, or the operator.
    pub(crate) fn answer(&mut self) -> Flow {
        self.wake();
        let asked = self.world.question.as_ref().map(|question| question.kind);
        let keypad = asked == Some(QuestionKind::Keypad);
        self.tell_standing(if keypad { flag::KEYPAD } else { flag::PAUSED });
        self.trail.asks(self.interpreter.call_stack());
        let at = self.asking_line();
        let until = self.world.question.as_ref().and_then(|q| q.until);
        let tracked = self.world.tracked();
        let moment = until.and_then(|(n, on)| match asked {
            // A key: what is pressed already was meant for something else.
            Some(QuestionKind::Paused) => tracked.when_pressed(n, on),
            _ => tracked.when(n, on),
        });
        if let Some(moment) = moment {
            let (begin_s, flow) = (self.world.now(), self.pass_until(moment, Waits::Input));
            if matches!(flow, Flow::On) {
                let seconds = self.world.now() - begin_s;
                self.world.tell(&Event::Wait { seconds, t: begin_s });
                self.world.answered_by_input(Answer::Button(Button::OK), at);
            }
            return flow;
        }
        if let Some(moment) = asked.and_then(|kind| self.world.next_key_s(kind)) {
            let flow = self.pass_until(moment, Waits::Input);
            if matches!(flow, Flow::On) {
                self.use_pendant(at);
            }
            return flow;
        }
        match self.answer_or_give_up(at) {
            Ok(answer) => {
                self.world.answer = answer;
                let goes_on = self
                    .heeded()
                    .and_then(|()| self.goes_on_after_question())
                    .and_then(|()| self.goes_back_after());
                goes_on.map_or_else(Flow::Over, |()| Flow::On)
            }
            Err(why) => Flow::Over(self.unanswered(at, why)),
        }
    }

    /// Returns the answer of the operator to the question that is open. A run that he gives up instead can be taken up
    /// as if he had not answered, unless it has not moved yet.
    fn answer_or_give_up(&mut self, at: At) -> Result<Option<Answer>, Unanswered> {
        loop {
            let question = self.world.question.clone();
            let answer = self.answer_of_operator(at);
            let pauses = question.as_ref().is_some_and(|it| it.kind == QuestionKind::Paused);
            if !gives_up(&answer, pauses) {
                return answer;
            }
            if self.world.workspace.tape.is_last_told() {
                // The power went before the run was given up.
                self.world.workspace.tape.take_back_answer();
                self.world.question = question;
                self.wake();
                continue;
            }
            if self.world.silent || !self.world.workspace.tape.has_moved() {
                return answer;
            }
            let stands = self.stands_at();
            self.world.workspace.tape.given_up_by_answer(stands);
            // Nothing is brought back only to be given up.
            let is_back = self.reentry.is_none();
            return if is_back { answer } else { Err(Unanswered::Stopped) };
        }
    }

    /// Returns the answer of the operator to the question that is open; at a keypad he moves the tool before.
    fn answer_of_operator(&mut self, at: At) -> Result<Option<Answer>, Unanswered> {
        let Some(question) = self.world.question.take() else { return Ok(None) };
        let hands = [QuestionKind::Keypad, QuestionKind::Paused].contains(&question.kind);
        loop {
            let answer = self.world.ask_now(&question, at)?;
            match &answer {
                Answer::Text(words) if Aside::is_for(question.kind) => match Aside::read(words) {
                    Some(aside) => {
                        self.set_aside(aside);
                        if self.ends.is_some() {
                            return Ok(None);
                        }
                    }
                    None => return Ok(Some(answer)),
                },
                Answer::Text(words) if words == KEY && question.kind == QuestionKind::Keypad => {
                    if self.follow_pendant() {
                        self.world.answered();
                        return Ok(Some(Answer::Button(Button::OK)));
                    }
                }
                Answer::Text(words) if hands => match Jog::read(words) {
                    Some(jog) => {
                        self.jog(jog);
                        self.interpreter.moved(self.world.machine.position());
                    }
                    None if question.kind == QuestionKind::Keypad => {}
                    None => return Ok(Some(answer)),
                },
                _ => return Ok(Some(answer)),
            }
        }
    }

    /// A question of the machine, not of the program.
    pub(crate) fn ask(&mut self, question: &Question, at: At) -> Result<Answer, Over> {
        self.wake();
        let answer = self.world.ask_now(question, at);
        self.keep_turning();
        answer.map_err(|why| self.unanswered(at, why))
    }

    fn unanswered(&self, at: At, why: Unanswered) -> Over {
        let message = match why {
            Unanswered::Stopped => return Over { status: Status::Stopped, diagnostic: None },
            Unanswered::NoButton(message) => message,
        };
        let place = Place::line(self.world.file(at), at.line);
        let diagnostic = Diagnostic::new(Code::Terminated, place, message)
            .hint("the script of answers has to fit what is asked");
        Over { status: Status::Failed, diagnostic: Some(Box::new(diagnostic)) }
    }

    /// The line that asks; it runs again when the answer is there.
    pub(crate) fn asking_line(&self) -> At {
        self.interpreter.call_stack().last().copied().unwrap_or_default()
    }
}

/// Tells whether the operator gives up a run that waits: a job in a pause by what he tells it.
fn gives_up(answer: &Result<Option<Answer>, Unanswered>, pauses: bool) -> bool {
    match answer {
        Ok(Some(answer)) if pauses => Word::read(&answers::words(answer)) == Some(Word::Abort),
        Ok(_) | Err(Unanswered::NoButton(_)) => false,
        Err(Unanswered::Stopped) => true,
    }
}
