//! Taking up a run that was cut short: up to where it was it runs in silence, the world's part
//! played from the [tape](kerf_journal); then the machine goes back to where the cut ended.
//!
//! ```text
//!           lift ┌─ ask ───── approach ──────┐
//!                │   spindle, outputs        │ plunge
//!   stands here ─┘                           └─► on along the path
//! ```
//!
//! Of the move that was under way the rest is made, along the same path: an arc is still part of the
//! same circle. A job knows its own way back, that from a pause, lift and all: it is asked first, and
//! told where it was.

use crate::OperatorRequest;
use crate::execute::Halted;
use crate::runner::{Flow, Over, Runner};
use kerf_journal::Placed;
use kerf_machine::lines::Output;
use kerf_motion::Move;
use kerf_program::{
    Axes, Axis, Button, Interpreter, MoveKind, OutputReason, Question, QuestionKind, StoppedBy,
};
use kerf_sim::WasOn;
use kerf_trace::Event;
use std::sync::Arc;

/// Of a move that was as good as made this much counts as made: the rest has a length.
const LAST_SHARE: f64 = 1.0 - 1e-9;

impl<I: Interpreter> Runner<'_, I> {
    /// The world is heard again when all has happened that happened before.
    pub(crate) fn wake(&mut self) {
        // What was made of a move is left out of it when it is read: until then nothing is new.
        if !self.world.workspace.tape.is_within() {
            self.hear_world();
        }
    }

    pub(crate) fn hear_world(&mut self) {
        if self.world.silent && !self.world.workspace.tape.plays() {
            self.world.silent = false;
            self.world.workspace.goes_live();
            let stands = self.stands_at();
            self.world.workspace.tape.wake(stands);
        }
    }

    /// Returns `true` if the next move is the first one that was not made before.
    pub(crate) fn is_taken_up(&mut self) -> bool {
        self.hear_world();
        self.reentry.is_some() && (!self.world.silent || self.world.workspace.tape.is_reentered())
    }

    /// Tells whether the power went when the machine was about to do what the operator wants: then or now.
    pub(crate) fn is_overtaken(&mut self) -> bool {
        if self.world.workspace.tape.was_overtaken() {
            return true;
        }
        let overtaken = self.is_taken_up();
        if overtaken && !self.world.silent {
            self.world.workspace.tape.overtakes();
        }
        overtaken
    }

    /// The moves that are left are planned anew, from a stand.
    pub(crate) fn stand_back(&mut self, piece: &[Move]) {
        let mut left = piece.to_vec();
        if let Some(running) = self.stack.running.take() {
            left.extend(running.withdraw());
        }
        if let Some(first) = left.first_mut() {
            first.from = self.world.machine.position();
        }
        self.stack.waiting = left.into_iter().collect();
        self.stand();
    }

    /// Heeds a request that the operator had just before the power went, and did not see happen: a run that is taken
    /// up is not stopped for it.
    pub(crate) fn overtaken(&mut self, request: OperatorRequest) {
        match request {
            OperatorRequest::Feed(share) => self.override_feed(share),
            OperatorRequest::End => self.postpone((self.world.now(), request)),
            // An input is what it is now.
            OperatorRequest::Stop | OperatorRequest::Hold | OperatorRequest::Input { .. } => {}
        }
    }

    /// Brings the machine back to where the run was, before the rest that was not made; or lets the
    /// program do it.
    pub(crate) fn take_up(&mut self) -> Result<(), Halted> {
        if !self.is_taken_up() {
            return Ok(());
        }
        // It may have been taken up here before, and cut short again.
        let told = self.world.workspace.tape.reentered().unwrap_or_else(|| {
            let stands = self.stands_at();
            self.reentry = None;
            self.world.workspace.tape.reenter(stands)
        });
        self.skip(told.within);
        for (input, on) in told.moved {
            self.world.tracked().press(input, on);
        }
        if self.interpreter.takes_stops() {
            let halted = self.hand_over(told.place.position);
            return Err(halted.unwrap_or_else(Halted::Over));
        }
        self.go_back(told.place.position).map_err(Halted::Over)
    }

    /// A program that finds its own way back does so at once: nothing goes on before the tool is clear.
    pub(crate) fn take_up_at_rest(&mut self) -> Option<Over> {
        let rests = self.stack.is_empty() && !self.world.workspace.tape.reenters_within();
        if !(self.interpreter.takes_stops() && rests) {
            return None;
        }
        let halted = self.take_up().err()?;
        match self.halted(halted) {
            Flow::Over(over) => Some(over),
            Flow::On | Flow::Interrupted => None,
        }
    }

    /// The program finds its way back from where the machine stands.
    fn hand_over(&mut self, from: Axes) -> Result<Halted, Over> {
        let began = self.world.machine.position();
        let motion = self.stack.next_number();
        // What was on comes on by the program's own way back.
        drop(self.world.tracked().restart(from));
        self.tell_taken_up();
        let at = kerf_program::Halted { motion, began, stands: from };
        let outputs = self.interpreter.comes_on(&at);
        self.whether_ready(&WasOn { outputs, pwm_percent: 0.0 }).0?;
        let stands = self.world.machine.position();
        self.world.tell(&Event::Resume { t: self.world.now() });
        let at = kerf_program::Halted { stands, ..at };
        Ok(Halted::Taken { by: StoppedBy::PowerCut, at })
    }

    /// Nothing goes back and nothing turns before the operator says so. With it goes how far he has nudged
    /// the workpiece.
    fn whether_ready(&mut self, was_on: &WasOn) -> (Result<(), Over>, Axes) {
        let (ready, nudged) = self.until_resumed(&ready_question(was_on));
        match ready {
            Ok(()) => self.world.workspace.tape.goes_back(),
            Err(_) => {
                self.shift(nudged);
                self.world.workspace.tape.given_up(self.world.placed());
            }
        }
        (ready, nudged)
    }

    /// Tells whether the power went here, where the machine was stopped, or goes back after a stop: the rest of that
    /// is settled by the question whether all is ready, when the next move is about to be made.
    pub(crate) fn is_open_for_take_up(&mut self) -> bool {
        self.reentry.is_some() && self.world.workspace.tape.is_open()
    }

    /// Leaves out what was made of the first move that waits.
    fn skip(&mut self, share: f64) {
        let waiting = &mut self.stack.waiting;
        let Some(first) = (share > 0.0).then(|| waiting.pop_front()).flatten() else { return };
        let (made, rest) = first.split(share.min(LAST_SHARE));
        self.world.tally.made(&made, 0.0, self.world.machine.frame());
        waiting.push_front(rest);
        self.world.machine.put(rest.from);
    }

    /// Returns the place where the machine stands, in the frames of the run.
    pub(crate) fn stands_at(&self) -> Placed {
        let Placed { position: here, frame } = self.world.placed();
        let position = self.reentry.map_or(here, |stands| stands.seen_from(&frame));
        Placed { position, frame }
    }

    /// A run that was taken up and is over without a move leaves the machine where it stood.
    pub(crate) fn stay_where_it_stands(&mut self) {
        if self.reentry.is_some() {
            let stands = self.stands_at();
            self.world.tracked().restart(stands.position);
        }
    }

    fn go_back(&mut self, from: Axes) -> Result<(), Over> {
        let ahead = self.mover.position();
        let to = self.world.machine.position();
        let was_on = self.world.tracked().restart(from);
        self.tell_taken_up();
        self.may_go_back()?;
        self.world.tracked().begin_motion();
        self.lift();
        self.heeded()?;
        let (ready, nudged) = self.whether_ready(&was_on);
        ready?;
        let before = self.nudged.unwrap_or_default();
        self.switch_on(&was_on);
        let meanwhile = self.nudged.unwrap_or_default().minus(before);
        self.approach(to.plus(nudged).plus(meanwhile));
        let on_the_way = self.nudged.unwrap_or_default().minus(before);
        self.go(MoveKind::Cut, to.plus(nudged).plus(on_the_way));
        self.heeded()?;
        let on_the_way = self.nudged.unwrap_or_default().minus(before);
        self.mover.set_position(ahead.plus(nudged).plus(on_the_way));
        self.shift(nudged);
        self.world.tell(&Event::Resume { t: self.world.now() });
        Ok(())
    }

    /// Nothing moves before every stop is released.
    fn may_go_back(&mut self) -> Result<(), Over> {
        self.heed_emergency()?;
        let released = match self.world.machine.stop_input() {
            Some(n) if self.cuts_power(n) => Err(self.power_is_cut()),
            Some(n) => self.stopped_again(n),
            None => Ok(()),
        };
        if released.is_err() {
            self.world.workspace.tape.given_up(self.world.placed());
        }
        released
    }

    /// Outputs come on again, and have the time that the machine gives a spindle to come to speed.
    fn switch_on(&mut self, was_on: &WasOn) {
        for number in &was_on.outputs {
            self.world.machine.output(*number, true, OutputReason::Program);
        }
        if was_on.pwm_percent > 0.0 {
            self.world.machine.pwm(1, was_on.pwm_percent);
        }
        self.world.tell_log();
        if was_on.turns() {
            self.come_to_speed();
        }
    }

    fn tell_taken_up(&mut self) {
        let (file, line) = (self.world.file(self.last_move), self.last_move.line);
        let text = match line {
            0 => "taken up before the first move".to_owned(),
            line => format!("taken up behind line {line} of {file}"),
        };
        self.world.tell(&Event::Message { text: Arc::from(text), t: self.world.now() });
        self.world.tell_log();
    }

    /// Over the place, no lower than the tool is now.
    fn approach(&mut self, to: Axes) {
        let mut over = to;
        over[Axis::Z] = to[Axis::Z].max(self.world.machine.position()[Axis::Z]);
        self.go(MoveKind::Jog, over);
    }
}

/// Builds the question to the operator when the tool is up, before anything turns.
fn ready_question(was_on: &WasOn) -> Question {
    let name = |n: &u8| Output::of_number(*n).map_or(n.to_string(), |line| line.name().to_owned());
    let on: Vec<String> = was_on.outputs.iter().map(name).collect();
    let outputs = match on.as_slice() {
        [] => "No output comes on".to_owned(),
        [one] => format!("Output {one} comes on"),
        all => format!("Outputs {} come on", all.join(", ")),
    };
    Question {
        kind: QuestionKind::Hold,
        text: format!("{outputs}, the tool goes back to where the cut ended. Is everything ready?"),
        title: "Resume".into(),
        buttons: vec![Button::Resume, Button::Quit],
        default: 0,
        prefill: String::new(),
        icon: 0,
        until: None,
    }
}
