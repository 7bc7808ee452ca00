//! The program and the machine that makes it, as a run has them: how a move is made and told, what stops motion, where a
//! run that is taken up stands. Nothing here decides what follows on a stop.

use crate::asking::Unanswered;
use crate::drive::Drive;
use crate::interruption::Interruption;
use crate::run_end::RunEnd;
use crate::stack::Stack;
use crate::trail::Trail;
use crate::world::World;
use crate::{OperatorRequest, Requests};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_journal::Placed;
use kerf_machine::Lift;
use kerf_machine::lines::Input;
use kerf_model::Watched;
use kerf_motion::{Move, Mover, Path, Plan, Span};
use kerf_program::{At, Axes, Axis, Halted, Interpreter, Sourced, Status};
use kerf_trace::ExecutedMove;
use kerf_trace::event::{ArcEvent, Centre, Event, MoveEvent};
use std::collections::VecDeque;

/// Message when the interlock forbids motion or a spindle.
const ENCLOSURE_OPEN: &str = "enclosure open";

/// A program, the machine that makes it, and what lies between them.
pub(crate) struct Station<'a, I> {
    pub interpreter: I,
    pub world: World<'a>,
    pub drive: Drive<'a>,
    pub mover: Mover,
    pub stack: Stack,
    /// The operator's override: share of the speed asked for at which cuts run.
    pub feed: f32,
    /// The override that waits until no input is watched.
    pub waiting_feed: Option<f32>,
    /// Requests of the operator that he has not got yet.
    pub requests: VecDeque<(f64, OperatorRequest)>,
    /// Distance by which the workpiece was nudged since the commands at hand were given.
    pub nudged: Option<Axes>,
    /// The line of the move made last.
    pub last_move: At,
    /// Place of the program, for the log.
    pub trail: Trail,
    /// The run is taken up: where the machine stands meanwhile.
    pub reentry: Option<Placed>,
    /// Up to here it is on record how far a move has come, machine time.
    pub recorded_s: f64,
}

impl<'a, I: Interpreter> Station<'a, I> {
    /// A program that has not begun, at a machine that stands.
    pub fn new(interpreter: I, world: World<'a>, requests: &'a mut dyn Requests) -> Self {
        let mover = Mover::new(world.model.position(), interpreter.settings());
        let drive = Drive::new(world.driven.clone(), requests, world.now());
        Self {
            interpreter,
            world,
            drive,
            mover,
            stack: Stack::default(),
            feed: 1.0,
            waiting_feed: None,
            requests: VecDeque::new(),
            nudged: None,
            last_move: At::default(),
            trail: Trail::default(),
            reentry: None,
            recorded_s: 0.0,
        }
    }
}

impl<I: Interpreter> Station<'_, I> {
    /// Tells where the run stands, with flags besides those of running and previewing.
    pub(crate) fn tell_standing(&mut self, flags: u8) {
        self.tell_standing_with(flags, &[]);
    }

    /// The same with commands that were given and not taken yet.
    pub(crate) fn tell_standing_with(&mut self, flags: u8, given: &[Sourced]) {
        let moves = |s: &Sourced| s.command.is_motion() && self.is_of_file(s.at);
        self.world.file_moves = self.stack.moves_file() || given.iter().any(moves);
        let interpreter = &self.interpreter;
        let called = |at: At| (at, interpreter.file_call(at.file));
        let files = || interpreter.call_stack().into_iter().map(called).collect();
        self.world.tell_standing(flags, &files, &|| interpreter.variables());
    }

    /// Returns `true` if a line stands in a file, and was not typed.
    pub(crate) const fn is_of_file(&self, at: At) -> bool {
        at.file as usize >= self.world.typed_files
    }

    /// Takes a move of a plan that began at `t0_s` as made: what it brought about is believed, told and counted. A move
    /// beside the program is none of its own.
    pub(crate) fn make_one(&mut self, plan: &Plan, span: &Span<'_>, t0_s: f64, beside: bool) {
        self.last_move = span.made.at;
        self.trail.moves(span.made.at);
        let [begin_s, end_s] = self.moments(t0_s, [span.t0_s, span.t1_s]);
        let alone = self.world.model.alone();
        let lift = self.world.tracked().move_made(t0_s, plan, span);
        let made = carried(span.made, &lift);
        if self.world.tells_motion() {
            let event = self.move_event(&made, begin_s, end_s);
            self.world.tell(&event);
        }
        self.world.tell_made(&ExecutedMove { plan, span, t0_s, alone, lift: &lift, beside });
        let World { tally, model, .. } = &mut self.world;
        tally.made(&made, end_s - begin_s, model.frame());
        tally.carried(&made, &lift, model.frame());
        self.world.tell_log();
        self.world.workspace.tape.comes_to(end_s);
        if self.world.workspace.tape.is_written() {
            let (file, place) = (self.world.file(span.made.at), self.world.placed());
            self.world.workspace.tape.made(&file, span.made.at.line, place);
        }
    }

    fn move_event(&self, made: &Move, t0: f64, t1: f64) -> Event {
        let event = MoveEvent {
            kind: made.kind,
            file: self.world.file(made.at),
            line: made.at.line,
            to: self.world.place(made.to),
            t0,
            t1,
            speed: made.speed_mm_s / self.world.scale(leading_axis(made)),
            from: self.world.place(made.from),
        };
        let Path::Arc { centre, sweep_rad, .. } = made.path else { return Event::Move(event) };
        let mut middle = made.to;
        (middle[Axis::X], middle[Axis::Y]) = (centre[0], centre[1]);
        let centre = self.world.place(middle);
        Event::Arc(ArcEvent {
            made: event,
            centre: Centre { x: centre.x, y: centre.y },
            dir: if sweep_rad < 0.0 { "cw" } else { "ccw" },
            sweep: sweep_rad.abs().to_degrees(),
        })
    }

    /// Returns machine time at begin and end of a part of a plan from `t0_s`. What is only drawn takes no time.
    pub(crate) fn moments(&self, t0_s: f64, span_s: [f64; 2]) -> [f64; 2] {
        if self.world.model.draws() { [self.world.now(); 2] } else { span_s.map(|s| t0_s + s) }
    }

    /// Learns that nothing turns any more after a stop that switches outputs off. It comes on again, with the time to come to
    /// speed, when the run goes on; a job says itself what comes on.
    pub(crate) fn learn_switched_off(&mut self) {
        if self.drive.stop_switches_off() && !self.interpreter.takes_stops() {
            self.world.stop_turning();
            self.world.tell_log();
        }
    }

    /// Outputs that do not wait until the machine stands.
    pub(crate) fn drop_outputs(&mut self, t_s: f64, index: usize) {
        if let Some(watch) = self.interpreter.watches().get(index) {
            self.world.model.drop_outputs(t_s, &watch.drops);
        }
    }

    /// The inputs whose changes stop the machine for the program.
    pub(crate) fn watched(&self, begin_s: f64) -> Vec<Watched> {
        let watched = self.interpreter.watches().into_iter().map(|w| Watched {
            input: w.input,
            on: w.on,
            ramped: w.ramped,
            level_from_s: w.level_after_s.map(|after_s| begin_s + after_s),
        });
        watched.chain(self.watched_for_all()).collect()
    }

    /// Watches for part files, beside what they wait for, the emergency stop of jobs, which see to it themselves.
    fn watched_for_all(&self) -> Option<Watched> {
        let (input, on) = (Input::EmergencyStop.number(), self.world.machine_is.estop.active);
        let watched = Watched { input, on, ramped: true, level_from_s: None };
        (!self.interpreter.takes_stops()).then_some(watched)
    }

    /// The same while the machine stands: whether it is pressed from now on.
    pub(crate) fn watched_at_rest(&self) -> Option<Watched> {
        let level_from_s = Some(self.world.now());
        self.watched_for_all().map(|watched| Watched { level_from_s, ..watched })
    }

    /// Returns `true` if this watch is the emergency stop.
    pub(crate) fn is_emergency(&self, watch: usize) -> bool {
        watch >= self.interpreter.watches().len()
    }

    /// Returns `true` if the emergency stop of jobs is pressed while a part file runs.
    pub(crate) fn is_ended_by_press(&self) -> bool {
        self.world.is_pressed() && !self.interpreter.takes_stops()
    }

    /// Tells whether a stop input is the emergency stop of a machine that cuts its power with it.
    pub(crate) fn cuts_power(&self, input: u8) -> bool {
        input == kerf_model::STOP_INPUT && self.world.machine_is.estop.cuts_power
    }

    /// Returns the message about a stop input; an open enclosure says so itself.
    pub(crate) fn stop_input_message(&self, message: String) -> String {
        let open = self.world.model.open_enclosure().is_some();
        if open { ENCLOSURE_OPEN.into() } else { message }
    }

    pub(crate) fn over(&self, status: Status, code: Code, at: At, message: String) -> RunEnd {
        let place = SourcePlace::line(self.world.file(at), at.line);
        let diagnostic = Diagnostic::new(code, place, message);
        RunEnd { status, diagnostic: Some(Box::new(diagnostic)) }
    }

    pub(crate) fn unanswered(&self, at: At, why: Unanswered) -> RunEnd {
        let message = match why {
            Unanswered::Stopped => return RunEnd::of(Status::Stopped),
            Unanswered::NoButton(message) => message,
        };
        let place = SourcePlace::line(self.world.file(at), at.line);
        let diagnostic = Diagnostic::new(Code::Terminated, place, message)
            .hint("the script of answers has to fit what is asked");
        RunEnd { status: Status::Failed, diagnostic: Some(Box::new(diagnostic)) }
    }

    /// Makes the end of a run that has no controller to move.
    pub(crate) fn not_connected(&self, at: At) -> RunEnd {
        let settings = self.world.model.settings();
        let connection = settings.driver.connection(&settings.controller);
        let message = format!("the machine is not connected ({connection}): nothing moves");
        let place = SourcePlace::line(self.world.file(at), at.line);
        let why = Diagnostic::new(Code::NotConnected, place, message)
            .hint("look at its cable, its power and its port (VI); SP shows the file in preview meanwhile");
        RunEnd { status: Status::Failed, diagnostic: Some(Box::new(why)) }
    }

    /// The line that asks; it runs again when the answer is there.
    pub(crate) fn asking_line(&self) -> At {
        self.interpreter.call_stack().last().copied().unwrap_or_default()
    }

    /// Returns where the machine stands, with nothing left to make.
    pub(crate) fn stood(&self) -> Halted {
        let position = self.world.model.position();
        Halted { motion: None, began: position, stands: position }
    }

    /// Everything that was planned and not made follows the workpiece.
    pub(crate) fn shift(&mut self, by: Axes) {
        if by == Axes::default() {
            return;
        }
        self.stack.stand_back();
        self.stack.shift(by);
        self.interpreter.nudge(by);
        self.nudged = Some(self.nudged.unwrap_or_default().plus(by));
    }

    pub(crate) fn tell_refused(&mut self, code: Code, why: String) {
        let place = SourcePlace::line(self.world.file(self.last_move), self.last_move.line);
        let diagnostic = Diagnostic::new(code, place, why);
        self.world.tell_diagnostic(diagnostic.severity(Severity::Warning));
    }

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

    /// Returns the place where the machine stands, in the frames of the run.
    pub(crate) fn stands_at(&self) -> Placed {
        let Placed { position: here, frame } = self.world.placed();
        let position = self.reentry.map_or(here, |stands| stands.seen_from(&frame));
        Placed { position, frame }
    }

    /// Tells whether the power went here, where the machine was stopped, or goes back after a stop: the rest of that
    /// is settled by the question whether all is ready, when the next move is about to be made.
    pub(crate) fn is_open_for_take_up(&mut self) -> bool {
        self.reentry.is_some() && self.world.workspace.tape.is_open()
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

    /// Heeds a request that the operator had just before the power went, and did not see happen: a run that is taken
    /// up is not stopped for it.
    fn overtaken(&mut self, request: OperatorRequest) {
        match request {
            OperatorRequest::Feed(share) => self.override_feed(share),
            OperatorRequest::End => self.postpone((self.world.now(), request)),
            // An input is what it is now.
            OperatorRequest::Stop
            | OperatorRequest::Hold
            | OperatorRequest::GiveUp
            | OperatorRequest::Input { .. } => {}
        }
    }

    /// Tells whether the power went while the machine was about to do what the operator wants.
    pub(crate) fn overtakes(&mut self, turn: Interruption) -> bool {
        let Interruption::Operator(request) = turn else { return false };
        let overtaken = self.is_overtaken();
        if overtaken {
            self.overtaken(request);
        }
        overtaken
    }

    /// Puts the machine in doubt: whoever cuts next is asked whether it is where it is believed to be.
    pub(crate) fn doubt(&mut self) {
        let doubted = self.world.model.doubt();
        self.world.workspace.doubts_location(doubted);
    }

    /// The moves that are left are planned anew, from a stand.
    pub(crate) fn stand_back(&mut self, piece: &[Move]) {
        let mut left = piece.to_vec();
        if let Some(running) = self.stack.running.take() {
            left.extend(running.withdraw());
        }
        if let Some(first) = left.first_mut() {
            first.from = self.world.model.position();
        }
        self.stack.waiting = left.into_iter().collect();
        self.stand();
    }

    /// Keeps the recorded place of the machine where a run that was taken up ends without a move.
    pub(crate) fn stay_where_it_stands(&mut self) {
        if self.reentry.is_some() {
            let stands = self.stands_at();
            self.world.tracked().restart(stands.position);
        }
    }

    /// Carries out what is marked before the next move.
    pub(crate) fn carry_out_marks(&mut self) {
        while let Some(sourced) = self.stack.due() {
            self.world.perform(sourced.command);
        }
    }

    /// Everything of the stack was made: the machine stands.
    pub(crate) fn come_to_rest(&mut self) {
        if self.stack.running.take().is_some() {
            self.stand();
        }
        for sourced in self.stack.clear() {
            self.world.perform(sourced.command);
        }
    }

    /// Commands given so far are dropped.
    pub(crate) fn begin_anew(&mut self, position: Axes) {
        drop(self.stack.clear());
        self.mover.set_position(position);
        self.mover.settings(self.interpreter.settings());
    }

    /// Returns the height to which the tool is lifted, machine frame.
    pub(crate) fn lift_mm(&self) -> Option<f64> {
        let safe_mm = self.world.model.settings().cutter.safe_z_mm?;
        Some(self.world.model.frame().working_zero[Axis::Z] + safe_mm)
    }
}

/// A move as it is made, between the heights that height control carries its ends to.
fn carried(made: &Move, lift: &Lift) -> Move {
    let [from_mm, to_mm] = lift.ends();
    let mut made = *made;
    made.from[Axis::Z] += from_mm;
    made.to[Axis::Z] += to_mm;
    made
}

/// The axis in whose unit the speed of a move is told.
fn leading_axis(made: &Move) -> Axis {
    let moves = |axis: &Axis| made.from[*axis] != made.to[*axis];
    let arc = matches!(made.path, Path::Arc { .. });
    if arc { Axis::X } else { Axis::ALL.into_iter().find(moves).unwrap_or(Axis::X) }
}
