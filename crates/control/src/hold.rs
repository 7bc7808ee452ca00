//! A run that the operator stopped in the middle: what may be done until it goes on or is given up.
//!
//! ```text
//!  stop: ramp down ─► lift to Safe-Z ─► ask ─► Resume: back over it and down, on along the path
//!                                        │ ▲
//!                             nudge, jog └─┘    Quit: the run is over
//! ```
//!
//! A nudge moves the tool and the working zero alike: whatever is cut next is shifted, and what the
//! display calls the place stays (command reference, MN).

use crate::OperatorRequest;
use crate::hand_words::Jog;
use crate::nudge::Nudge;
use crate::run_end::RunEnd;
use crate::stopped_spindles::StoppedSpindles;
use crate::stopping::RunStops;
use kerf_diag::Code;
use kerf_machine::state::{Event as Stopped, StopSettings};
use kerf_model::HaltCause;
use kerf_program::{
    Answer, At, Axes, AxisSet, Button, Interpreter, MoveKind, Question, QuestionKind, Status,
};
use kerf_trace::{Event, flag};

/// A hold leaves the tool where it is.
const HELD: StopSettings = StopSettings { raise: false, ..StopSettings::OPENSBP };

/// The most refused answers in a hold: a script that only says Resume must not hold a run for ever.
const MOST_REFUSALS: u32 = 1000;

/// Answer of the operator about a run that is stopped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Said {
    Resume,
    Quit,
    /// A nudge or a jog, when it is one.
    Words(String),
}

impl<I: Interpreter> RunStops<'_, I> {
    /// The operator stopped the machine, which stands; unless the run goes on.
    pub(crate) fn hold(&mut self) -> Result<(), RunEnd> {
        let settings = StopSettings::OPENSBP;
        self.station.drive.heard();
        self.station.world.tell(&Event::Stop { by: "operator", n: 0, t: self.station.world.now() });
        self.heed_emergency()?;
        self.on(Stopped::Stop, settings, "");
        self.on(Stopped::Stands, settings, "");
        self.heeded()?;
        self.stopped_meanwhile()?;
        let (resumed, nudged) = self.until_resumed(&hold_question());
        self.kept.nudged = nudged;
        if resumed.is_err() {
            self.on(Stopped::Abort, settings, "");
            // Whatever is run next is cut where the workpiece is now.
            self.station.shift(nudged);
            self.station.world.workspace.tape.given_up(self.station.world.placed());
        }
        resumed?;
        self.station.world.workspace.tape.goes_on();
        self.on(Stopped::Continue, settings, "");
        self.heeded()
    }

    /// A run is given up that is held.
    fn gives_up_held(&mut self) -> RunEnd {
        self.on(Stopped::Abort, HELD, "");
        self.station.world.workspace.tape.given_up(self.station.world.placed());
        RunEnd::of(Status::Stopped)
    }

    /// The machine stands where it is, and stays so until the operator resumes.
    fn pause(&mut self) -> Result<(), RunEnd> {
        self.heed_emergency()?;
        self.on(Stopped::Stop, HELD, "");
        self.on(Stopped::Stands, HELD, "");
        self.keep_turning();
        self.stopped_meanwhile()?;
        let t = self.station.world.now();
        self.station.world.tell(&Event::Hold { t });
        self.station.tell_standing(flag::PAUSED);
        let Some(resumed_s) = self.station.resumes(t) else { return Err(self.gives_up_held()) };
        if let Err(end) = self.stand_held(resumed_s) {
            drop(self.gives_up_held());
            return Err(end);
        }
        self.station.world.workspace.tape.goes_on();
        self.on(Stopped::Continue, HELD, "");
        self.heeded()
    }

    /// Does what follows on a request when the machine stands.
    pub(crate) fn stands(&mut self, request: OperatorRequest) -> Result<(), RunEnd> {
        match request {
            OperatorRequest::Stop => self.hold(),
            OperatorRequest::Hold => self.pause(),
            OperatorRequest::Feed(share) => {
                self.station.override_feed(share);
                Ok(())
            }
            OperatorRequest::End => Err(RunEnd::of(Status::Ended)),
            OperatorRequest::GiveUp => {
                self.on(Stopped::Stop, HELD, "");
                self.on(Stopped::Stands, HELD, "");
                self.keep_turning();
                Err(self.gives_up_held())
            }
            OperatorRequest::Input { number, on } => {
                self.station.press(number, on, self.station.world.now());
                Ok(())
            }
        }
    }

    /// The machine is held until a moment. A stop input that came or comes meanwhile stops what turns, and has to be
    /// released; the emergency stop ends the run.
    fn stand_held(&mut self, until_s: f64) -> Result<(), RunEnd> {
        let Some((t_s, cause)) = self.station.stops_held(until_s) else {
            self.station.stand_until(until_s);
            return Ok(());
        };
        self.station.stand_until(t_s);
        let HaltCause::Stop(n) = cause else { return self.heed_press() };
        if self.station.cuts_power(n) {
            return Err(self.power_is_cut());
        }
        self.stop_spindles();
        self.station.stand_until(until_s);
        let message = self.station.stop_input_message(format!("stopped by stop input {n}"));
        self.until_released(&message, false)
    }

    /// A stop input that came while the machine slowed down stops what turns as well.
    fn stopped_meanwhile(&mut self) -> Result<(), RunEnd> {
        match self.station.world.model.stop_input() {
            Some(n) if self.station.cuts_power(n) => Err(self.power_is_cut()),
            Some(_) if self.station.world.model.turns() => {
                self.stop_spindles();
                self.station.world.tell_log();
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Does what the operator says until the run goes on, or is given up. With it goes the sum of all
    /// nudges.
    pub(crate) fn until_resumed(&mut self, question: &Question) -> (Result<(), RunEnd>, Axes) {
        let mut nudged = Axes::default();
        loop {
            match self.ask_whoever_stopped(question) {
                Err(over) => return (Err(over), nudged),
                Ok(Said::Resume) => return (Ok(()), nudged),
                Ok(Said::Quit) => {
                    return (Err(RunEnd::of(Status::Stopped)), nudged);
                }
                Ok(Said::Words(words)) => {
                    if let Some(nudge) = Nudge::read(&words) {
                        nudged = nudged.plus(self.nudge(nudge));
                        if let Err(over) = self.heeded() {
                            return (Err(over), nudged);
                        }
                    } else if let Some(jog) = Jog::read(&words) {
                        self.station.jog(jog);
                    }
                }
            }
        }
    }

    /// Asks what follows on a stop: nothing goes on as long as a stop input is active. Where the power went
    /// before the answer, it is asked when the machine goes back, whether all is ready.
    fn ask_whoever_stopped(&mut self, question: &Question) -> Result<Said, RunEnd> {
        for _ in 0..MOST_REFUSALS {
            if self.station.is_open_for_take_up() {
                return Ok(Said::Resume);
            }
            self.heed_emergency()?;
            let answer = self.ask(question, self.station.last_move)?;
            self.heed_emergency()?;
            match answer {
                Answer::Text(words) => return Ok(Said::Words(words)),
                Answer::Button(Button::Resume) if self.station.is_forbidden() => {}
                Answer::Button(Button::Resume) => return Ok(Said::Resume),
                // The power went before the run was given up.
                Answer::Button(_) if self.station.is_open_for_take_up() => return Ok(Said::Resume),
                Answer::Button(_) => break,
            }
        }
        Ok(Said::Quit)
    }

    /// Nudges as the operator says it, in his units. Tells how far, machine frame; nowhere when
    /// something forbids it.
    pub(crate) fn nudge(&mut self, nudge: Nudge) -> Axes {
        let Nudge { axis, distance } = nudge;
        let nudge = Nudge { axis, distance: distance * self.station.world.scale(axis) };
        let position = self.station.world.model.position();
        let (settings, mut frame) =
            (self.station.world.model.settings(), *self.station.world.model.frame());
        let refused = if self.station.interpreter.takes_stops() {
            Some((Code::NotSupported, "a job is not nudged: move its origin".to_owned()))
        } else if self.station.world.model.draws() {
            Some((Code::NotSupported, "nothing is nudged while commands are only drawn".to_owned()))
        } else {
            let within = nudge.check(settings, &frame, position);
            let within =
                within.and_then(|()| nudge.within(self.station.room_by_hand(axis), position));
            within.err().map(|outside| (Code::OutsideLimits, outside.to_string()))
        };
        if let Some((code, why)) = refused {
            self.station.tell_refused(code, why);
            return Axes::default();
        }
        frame.working_zero = frame.working_zero.plus(nudge.way());
        self.station.world.model.use_frame(frame, AxisSet::EMPTY);
        self.station.world.tracked().begin_motion();
        self.station.world.tell_log();
        self.go(MoveKind::Jog, position.plus(nudge.way()));
        self.station.world.tell_base(AxisSet::EMPTY.with(axis));
        nudge.way()
    }

    /// A question of the machine, not of the program.
    pub(crate) fn ask(&mut self, question: &Question, at: At) -> Result<Answer, RunEnd> {
        self.station.wake();
        let answer = self.station.world.ask_now(question, at);
        self.keep_turning();
        answer.map_err(|why| self.station.unanswered(at, why))
    }

    /// A stop input stopped the machine, or forbids it to move on: nothing moves before it is released
    /// and the operator says so.
    pub(crate) fn blocked(&mut self, n: u8) -> Result<(), RunEnd> {
        let settings = StopSettings::OPENSBP;
        let message = self.station.stop_input_message(format!("stopped by stop input {n}"));
        self.station.world.workspace.tape.stops_at_input(n);
        self.on(Stopped::StopInput, settings, &message);
        if let Err(over) = self.until_released(&message, true) {
            self.on(Stopped::Abort, settings, "");
            self.station.world.workspace.tape.given_up(self.station.world.placed());
            return Err(over);
        }
        self.station.world.workspace.tape.goes_on();
        self.on(Stopped::Released, settings, "");
        self.heeded()?;
        self.on(Stopped::Continue, settings, "");
        self.heeded()
    }

    /// Asks until the input is released and somebody says so.
    pub(crate) fn until_released(&mut self, message: &str, rises: bool) -> Result<(), RunEnd> {
        let question = blocked_question(message, &self.kept.turned.spindles, rises);
        loop {
            match self.ask_whoever_stopped(&question)? {
                Said::Resume => return Ok(()),
                // Nothing is moved by hand before the input is released.
                Said::Words(_) => {}
                Said::Quit => break,
            }
        }
        Err(self.station.over(
            Status::Stopped,
            Code::InputStop,
            self.station.last_move,
            message.to_owned(),
        ))
    }

    /// A limit stopped the machine, or a move would leave the table: the operator says whether it goes
    /// on regardless.
    pub(crate) fn limited(&mut self, at: At, code: Code, message: String) -> Result<(), RunEnd> {
        self.on(Stopped::Limit, StopSettings::OPENSBP, &message);
        let answer = self.ask(&limit_question(message.clone()), at);
        if matches!(answer, Ok(Answer::Button(Button::Continue))) {
            self.heed_emergency()?;
            self.released_after_question()?;
            self.on(Stopped::Override, StopSettings::OPENSBP, "");
            return self.heeded();
        }
        self.on(Stopped::Abort, StopSettings::OPENSBP, &message);
        answer?;
        Err(self.station.over(Status::Limit, code, at, message))
    }

    /// A question of the program is answered. Where a stop input stopped what turned meanwhile, that comes on
    /// again when the input is released and somebody says so.
    pub(crate) fn goes_on_after_question(&mut self) -> Result<(), RunEnd> {
        self.heed_emergency()?;
        if self.station.world.stopped.is_empty() {
            return Ok(());
        }
        self.keep_turning();
        if self.station.world.is_pressed() && self.station.interpreter.takes_stops() {
            // A job says itself what comes on again.
            self.kept.turned = StoppedSpindles::default();
        }
        self.released_after_question()?;
        let turned = std::mem::take(&mut self.kept.turned);
        self.turn_again(turned);
        self.heeded()
    }

    /// A stop input that was pressed while somebody was asked has to be released before anything goes on. Who gives
    /// the run up instead can take it up.
    fn released_after_question(&mut self) -> Result<(), RunEnd> {
        let Some(n) = self.station.world.model.stop_input() else { return Ok(()) };
        if self.station.cuts_power(n) {
            return Err(self.power_is_cut());
        }
        let message = self.station.stop_input_message(format!("stopped by stop input {n}"));
        self.station.world.workspace.tape.stood(1.0);
        self.station.world.workspace.tape.stops_at_input(n);
        if let Err(over) = self.until_released(&message, false) {
            self.station.world.workspace.tape.given_up(self.station.world.placed());
            return Err(over);
        }
        self.station.world.workspace.tape.goes_on();
        Ok(())
    }
}

fn hold_question() -> Question {
    Question {
        kind: QuestionKind::Hold,
        text: "Stopped. Resume, Quit, or nudge the workpiece (nudge y .05)".into(),
        title: "Stopped".into(),
        buttons: vec![Button::Resume, Button::Quit],
        default: 1,
        prefill: String::new(),
        icon: 0,
        until: None,
    }
}

fn limit_question(text: String) -> Question {
    Question {
        kind: QuestionKind::Limit,
        text,
        title: "Limits".into(),
        buttons: vec![Button::Continue, Button::End],
        default: 1,
        prefill: String::new(),
        icon: 48,
        until: None,
    }
}

fn blocked_question(why: &str, spindles: &[u8], rises: bool) -> Question {
    let on: Vec<String> = spindles.iter().map(u8::to_string).collect();
    let again = match on.as_slice() {
        [] => String::new(),
        [one] => format!(", output {one} comes on again"),
        all => format!(", outputs {} come on again", all.join(" and ")),
    };
    let what = if rises { "the tool rises" } else { "the program waits no longer" };
    Question {
        kind: QuestionKind::Hold,
        text: format!("{why}. When it is released, Resume: {what}{again}, and goes on"),
        title: "Stopped".into(),
        buttons: vec![Button::Resume, Button::Quit],
        default: 1,
        prefill: String::new(),
        icon: 48,
        until: None,
    }
}
