//! Stops of a run: the table of states says what follows, here its effects are
//! carried out.
//!
//! Jobs and moves by hand know what they do when they are stopped, and ask the same table; the run of a
//! part file is stopped here. Whatever it is that runs, a cut power and a lost link end it here.

use crate::OperatorRequest;
use crate::hold::Said;
use crate::runner::{Over, Runner};
use crate::turning::Turning;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_machine::Fault;
use kerf_machine::lines::Input;
use kerf_machine::state::{Effect, Event as Stopped, RELEASE_S, StopSettings};
use kerf_program::{
    Answer, At, Axes, Axis, Button, Interpreter, OutputReason, Question, QuestionKind, Status,
};
use kerf_sbp::SPINDLE_STATUS;
use kerf_trace::{Event, flag};

/// A machine that cuts the power of its motors does it so long after the emergency stop, seconds
/// (command reference, alpha tools).
const POWER_S: f64 = 5.0;

/// A place that is come back to, and what was on there.
#[derive(Clone, Debug, Default)]
pub(crate) struct Kept {
    /// Place where the machine stood.
    stood: Axes,
    /// Place that the commands that were read lead to.
    ahead: Axes,
    /// To where the tool was lifted.
    pub lifted_mm: f64,
    /// Distance by which the workpiece was nudged since.
    pub nudged: Axes,
    /// Spindles and axes that turned or moved by themselves.
    pub turned: Turning,
}

impl<I: Interpreter> Runner<'_, I> {
    /// Asks the table what follows on an event and does it. What is not in the table does not happen.
    pub(crate) fn on(&mut self, event: Stopped, settings: StopSettings, why: &str) {
        let Some(next) = self.state.on(event, settings) else { return };
        self.state = next.state;
        // What a run leaves on is settled before anybody is told that it is over.
        let (settled, others): (Vec<_>, Vec<_>) =
            next.effects.into_iter().partition(|effect| *effect == Effect::LeaveOutputs);
        settled.into_iter().for_each(|effect| self.carry_out(effect));
        if !matches!(event, Stopped::Start | Stopped::Ready | Stopped::End | Stopped::Stop) {
            let (state, t) = (next.state.name().into(), self.world.now());
            self.world.tell(&Event::State { state, why: why.into(), t });
        }
        others.into_iter().for_each(|effect| self.carry_out(effect));
        self.world.tell_log();
    }

    pub(crate) fn carry_out(&mut self, effect: Effect) {
        match effect {
            // The planner has done the slowing down.
            Effect::SlowDown | Effect::Halt => self.world.machine.stopped(),
            Effect::KeepPlace => self.keep_place(),
            Effect::SpindleOff => self.stop_spindles(),
            Effect::Raise => {
                self.lift();
                // The way back is as high although something ended the lift early.
                let lifted_mm = self.lift_mm().unwrap_or(f64::NEG_INFINITY);
                self.kept.lifted_mm = lifted_mm.max(self.world.machine.position()[Axis::Z]);
            }
            Effect::AllOff => self.world.machine.outputs_off(),
            Effect::MotorsOff => self.cut_power(),
            Effect::Doubt => self.doubt(),
            Effect::ComeBack => self.come_back(),
            // A job knows what it leaves on: nothing.
            Effect::LeaveOutputs if self.interpreter.takes_stops() => {
                let last = self.last_commands(Status::Stopped);
                last.into_iter().for_each(|sourced| self.world.perform(sourced.command));
                self.world.tell_log();
            }
            // Of part files outputs follow their modes, at the end of the file too; their heights stay.
            Effect::LeaveOutputs
            | Effect::CutOff
            | Effect::CutOffAtOnce
            | Effect::RouterOff
            | Effect::ToolOff
            | Effect::RestoreHeights => {}
        }
    }

    fn keep_place(&mut self) {
        self.tell_standing(flag::STOPPED);
        self.world.tracked().land();
        let stood = self.world.machine.position();
        let ahead = self.mover.position();
        self.kept = Kept { stood, ahead, lifted_mm: stood[Axis::Z], ..Kept::default() };
    }

    /// Stops what turns; it comes on again with what was stopped before.
    pub(crate) fn stop_spindles(&mut self) {
        self.world.stop_turning();
        self.keep_turning();
    }

    /// Keeps what a stop input stopped meanwhile, which comes on again when the run goes on.
    pub(crate) fn keep_turning(&mut self) {
        let Turning { spindles, alone } = std::mem::take(&mut self.world.stopped);
        self.kept.turned.add(spindles, alone);
    }

    /// The motors keep the axes for a moment, then nothing does.
    fn cut_power(&mut self) {
        let t = self.world.now();
        self.world.tell_log();
        self.pass_learning(t, t + POWER_S, None).into_iter().for_each(drop);
        self.stand_until(t + POWER_S);
        self.world.machine.motors_off();
    }

    /// Puts the machine in doubt: whoever cuts next is asked whether it is where it is believed to be.
    fn doubt(&mut self) {
        let doubted = self.world.machine.doubt();
        self.world.workspace.doubts_location(doubted);
    }

    /// Goes on where the machine stood, from wherever the operator moved it: what a stop switched off
    /// comes on again, then over the place at the height to which the tool was lifted, or higher, and
    /// down. What was planned follows the workpiece.
    fn come_back(&mut self) {
        let Kept { stood, ahead, lifted_mm, nudged, turned } = std::mem::take(&mut self.kept);
        let moved = self.world.machine.position() != stood.plus(nudged);
        self.world.machine.resumed();
        if moved {
            let until_s = self.world.machine.warn();
            self.world.tell_log();
            self.ends = self.stand_heeding(until_s).err();
        }
        self.world.tell_log();
        self.world.tell(&Event::Resume { t: self.world.now() });
        // What somebody nudges when it is stopped on the way back moves what is ahead too.
        let before = self.nudged.unwrap_or_default();
        if self.ends.is_none() {
            self.turn_again(turned);
        }
        if moved {
            let nudged = nudged.plus(self.nudged.unwrap_or_default().minus(before));
            self.go_back_to(stood.plus(nudged), lifted_mm + nudged[Axis::Z]);
        }
        let on_the_way = self.nudged.unwrap_or_default().minus(before);
        self.shift(nudged);
        self.mover.set_position(ahead.plus(nudged).plus(on_the_way));
        self.tell_standing(0);
    }

    /// Spindles turn again, and have the time that the machine gives them to come to speed.
    fn turn_again(&mut self, Turning { spindles, alone }: Turning) {
        for (axis, motion) in alone {
            self.world.machine.independent(axis, motion);
        }
        for number in &spindles {
            self.world.machine.output(*number, true, OutputReason::Mode);
        }
        if !spindles.is_empty() {
            self.world.workspace.set_value(SPINDLE_STATUS, Some("1"));
            self.come_to_speed();
        }
    }

    /// A question of the program is answered. Where a stop input stopped what turned meanwhile, that comes on
    /// again when the input is released and somebody says so.
    pub(crate) fn goes_on_after_question(&mut self) -> Result<(), Over> {
        self.heed_emergency()?;
        if self.world.stopped.is_empty() {
            return Ok(());
        }
        self.keep_turning();
        if self.world.is_pressed() && self.interpreter.takes_stops() {
            // A job says itself what comes on again.
            self.kept.turned = Turning::default();
        }
        self.released_after_question()?;
        let turned = std::mem::take(&mut self.kept.turned);
        self.turn_again(turned);
        self.heeded()
    }

    /// A stop input that was pressed while somebody was asked has to be released before anything goes on. Who gives
    /// the run up instead can take it up.
    fn released_after_question(&mut self) -> Result<(), Over> {
        let Some(n) = self.world.machine.stop_input() else { return Ok(()) };
        if self.cuts_power(n) {
            return Err(self.power_is_cut());
        }
        let message = self.stop_input_message(format!("stopped by stop input {n}"));
        self.world.workspace.tape.stood(1.0);
        self.world.workspace.tape.stops_at_input(n);
        if let Err(over) = self.until_released(&message, false) {
            self.world.workspace.tape.given_up(self.world.placed());
            return Err(over);
        }
        self.world.workspace.tape.goes_on();
        Ok(())
    }

    /// Waits as long as the machine gives a spindle to come to speed.
    pub(crate) fn come_to_speed(&mut self) {
        self.world.tell_log();
        let seconds = self.world.machine_is.delays.router_start_s;
        if seconds > 0.0 && !self.world.machine.draws() && self.ends.is_none() {
            let t = self.world.now();
            self.world.tell(&Event::Wait { seconds, t });
            self.ends = self.stand_heeding(t + seconds).err();
        }
    }

    /// A stop input stopped the machine, or forbids it to move on: nothing moves before it is released
    /// and the operator says so.
    pub(crate) fn blocked(&mut self, n: u8) -> Result<(), Over> {
        let settings = StopSettings::OPENSBP;
        let message = self.stop_input_message(format!("stopped by stop input {n}"));
        self.world.workspace.tape.stops_at_input(n);
        self.on(Stopped::StopInput, settings, &message);
        if let Err(over) = self.until_released(&message, true) {
            self.on(Stopped::Abort, settings, "");
            self.world.workspace.tape.given_up(self.world.placed());
            return Err(over);
        }
        self.world.workspace.tape.goes_on();
        self.on(Stopped::Released, settings, "");
        self.heeded()?;
        self.on(Stopped::Continue, settings, "");
        self.heeded()
    }

    /// Asks until the input is released and somebody says so.
    pub(crate) fn until_released(&mut self, message: &str, rises: bool) -> Result<(), Over> {
        let question = blocked_question(message, &self.kept.turned.spindles, rises);
        loop {
            match self.ask_whoever_stopped(&question)? {
                Said::Resume => return Ok(()),
                // Nothing is moved by hand before the input is released.
                Said::Words(_) => {}
                Said::Quit => break,
            }
        }
        Err(self.over(Status::Stopped, Code::InputStop, self.last_move, message.to_owned()))
    }

    /// Tells whether a stop input forbids what the operator wants; he is told, and asked again in a moment.
    pub(crate) fn is_forbidden(&mut self) -> bool {
        let Some(active) = self.world.machine.stop_input() else { return false };
        let t = self.world.now();
        let text = format!("stop input {active} is active: nothing moves before it is released");
        self.world.tell(&Event::Message { text: text.into(), t });
        match self.pass_learning(t, t + RELEASE_S, None) {
            Some((_, OperatorRequest::Stop | OperatorRequest::Hold)) => self.forgo(),
            request => request.into_iter().for_each(|request| self.put_off(request)),
        }
        self.stand_until(t + RELEASE_S);
        true
    }

    /// A limit stopped the machine, or a move would leave the table: the operator says whether it goes
    /// on regardless.
    pub(crate) fn limited(&mut self, at: At, code: Code, message: String) -> Result<(), Over> {
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
        Err(self.over(Status::Limit, code, at, message))
    }

    /// The emergency stop of a machine that cuts its power: spindles at once, motors later. Nothing goes
    /// on from there.
    pub(crate) fn power_is_cut(&mut self) -> Over {
        let message = "emergency stop";
        self.on(Stopped::PowerCut, StopSettings::OPENSBP, message);
        self.world.workspace.set_value(SPINDLE_STATUS, Some("0"));
        let mut over =
            self.over(Status::Stopped, Code::InputStop, self.last_move, message.to_owned());
        let hint = "home the machine, or set its locations, before anything is cut";
        over.diagnostic = over.diagnostic.map(|why| Box::new((*why).hint(hint)));
        over
    }

    /// The emergency stop ends a part file as soon as it is pressed; where the power went then, it is what it
    /// is when the tool goes back.
    pub(crate) fn heed_emergency(&mut self) -> Result<(), Over> {
        match self.world.machine.stop_input() {
            Some(n) if self.cuts_power(n) && !self.is_open_for_take_up() => {
                Err(self.power_is_cut())
            }
            _ if self.is_ended_by_press() => self.heed_press(),
            _ => Ok(()),
        }
    }

    /// The same where it is known to be pressed, or was for a moment.
    pub(crate) fn heed_press(&mut self) -> Result<(), Over> {
        if self.is_open_for_take_up() { Ok(()) } else { Err(self.emergency()) }
    }

    /// The emergency stop that jobs have: a part file ends there, with everything off.
    pub(crate) fn emergency(&mut self) -> Over {
        // Whoever pressed it wants nothing to move.
        let settings = StopSettings { raise: false, ..StopSettings::OPENSBP };
        let why = "emergency stop";
        self.world.workspace.tape.stops_at_input(Input::EmergencyStop.number());
        self.on(Stopped::EmergencyStop, settings, why);
        self.stop_spindles();
        self.on(Stopped::Stands, settings, why);
        self.on(Stopped::Abort, settings, why);
        self.world.workspace.tape.given_up(self.world.placed());
        let mut over = self.over(Status::Stopped, Code::InputStop, self.last_move, why.to_owned());
        let hint = "release it; the location is known, and the run can be taken up";
        over.diagnostic = over.diagnostic.map(|why| Box::new((*why).hint(hint)));
        over
    }

    /// A motor has stalled: nobody knows how many steps are lost.
    pub(crate) fn has_stalled(&mut self) -> Over {
        let message = "a motor has stalled";
        self.world.machine.stalled();
        self.on(Stopped::Stall, StopSettings::OPENSBP, message);
        self.over(Status::Failed, Code::InputStop, self.last_move, message.to_owned())
    }

    /// The controller does not answer any more.
    pub(crate) fn link_is_lost(&mut self) -> Over {
        if let Some(failure) = self.drive.fault().cloned() {
            return self.fails(&failure);
        }
        self.on(Stopped::LinkLost, StopSettings::OPENSBP, "not connected");
        self.not_connected(self.last_move)
    }

    /// The controller does not follow any more: where it stands is what it told last.
    pub(crate) fn fails(&mut self, failure: &Fault) -> Over {
        self.drive.stands();
        if let Some(stands) = failure.stands {
            self.world.machine.put(stands);
            self.mover.set_position(stands);
        }
        self.on(Stopped::LinkLost, StopSettings::OPENSBP, &failure.message);
        let at = failure.at.unwrap_or(self.last_move);
        let code = if failure.silent { Code::NotConnected } else { Code::Controller };
        let mut over = self.over(Status::Failed, code, at, failure.message.clone());
        over.diagnostic = over.diagnostic.map(|why| Box::new((*why).hint(failure.hint)));
        over
    }

    /// Nothing moves without a controller.
    pub(crate) fn not_connected(&self, at: At) -> Over {
        let settings = self.world.machine.settings();
        let connection = settings.driver.connection(&settings.controller);
        let message = format!("the machine is not connected ({connection}): nothing moves");
        let place = Place::line(self.world.file(at), at.line);
        let why = Diagnostic::new(Code::NotConnected, place, message)
            .hint("look at its cable, its power and its port (VI); SP shows the file in preview meanwhile");
        Over { status: Status::Failed, diagnostic: Some(Box::new(why)) }
    }

    pub(crate) fn over(&self, status: Status, code: Code, at: At, message: String) -> Over {
        let place = Place::line(self.world.file(at), at.line);
        let diagnostic = Diagnostic::new(code, place, message);
        Over { status, diagnostic: Some(Box::new(diagnostic)) }
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
