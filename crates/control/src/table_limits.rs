//! Refusal of motion: moves that would leave the table, anything while a stop input is active or the
//! enclosure is open.

use crate::execute::Halted;
use crate::runner::{Over, Runner};
use kerf_diag::{Code, Diagnostic, Place};
use kerf_journal::LimitPolicy;
use kerf_machine::lines::{Input, Output};
use kerf_motion::{Move, Queue};
use kerf_program::{At, Command, Independent, Interpreter, Status, StoppedBy, Turn};
use kerf_sim::{Violation, Watched};

/// Message when the interlock forbids motion or a spindle.
const ENCLOSURE_OPEN: &str = "enclosure open";

/// Tells whether an output turns a spindle: those of part files, or that of jobs.
const fn turns(output: u8) -> bool {
    matches!(output, 1 | 2) || output == Output::Router.number()
}

impl<I: Interpreter> Runner<'_, I> {
    /// Nothing moves that would leave the table, or while a stop input is active.
    pub(crate) fn check(&mut self, moves: &Queue) -> Result<(), Over> {
        let Some(first) = moves.front() else { return Ok(()) };
        if self.lists_limits() {
            moves.iter().for_each(|made| self.list_violation(&made));
        } else if let Some((at, violation)) = self.first_outside(moves) {
            self.limited(at, Code::OutsideLimits, self.limit_message(&violation))?;
        }
        let refused = moves.iter().find_map(|made| Some((made.at, self.drive.refuses(&made)?)));
        if let Some((at, why)) = refused {
            return Err(self.over(Status::Failed, Code::Controller, at, why));
        }
        self.may_move(first.at)
    }

    /// A limit switch that is on already when a file begins to move, or whose wire is broken, stops it as one that comes
    /// on the way. By hand the tool may be moved away from it.
    pub(crate) fn heed_limit(&mut self) -> Result<(), Halted> {
        let by_hand = self.world.typed_files > 0 || self.is_open_for_take_up();
        let Some(input) = self.world.machine.limit_input().filter(|_| !by_hand) else {
            return Ok(());
        };
        if self.interpreter.takes_stops() {
            return Err(Halted::Taken { by: StoppedBy::Limit(input), at: self.stood() });
        }
        let message = format!("limit input {input} is active before anything moves");
        self.world.limit = Some(input);
        self.limited(self.last_move, Code::InputStop, message).map_err(Halted::Over)
    }

    /// Nothing moves without a controller, or while a stop input is active. A run that has not moved
    /// yet does not begin; another waits until the input is released.
    pub(crate) fn may_move(&mut self, at: At) -> Result<(), Over> {
        if self.is_open_for_take_up() {
            return Ok(());
        }
        if !self.world.machine.is_connected() {
            return Err(self.not_connected(at));
        }
        if self.is_ended_by_press() {
            return Err(self.ended_by_press(at));
        }
        let Some(input) = self.world.machine.stop_input() else { return Ok(()) };
        if self.world.tally.moves > 0 && self.cuts_power(input) {
            return Err(self.power_is_cut());
        }
        if self.world.tally.moves > 0 && !self.interpreter.takes_stops() {
            self.world.workspace.tape.stood(1.0);
            return self.blocked(input);
        }
        Err(self.forbids(input, at))
    }

    /// The emergency stop is pressed where something is about to move or to turn: a run that has not moved yet
    /// does not begin.
    fn ended_by_press(&mut self, at: At) -> Over {
        if self.world.tally.moves > 0 {
            self.world.workspace.tape.stood(1.0);
            return self.emergency();
        }
        let message = "emergency stop".to_owned();
        let over = self.over(Status::Stopped, Code::InputStop, at, message);
        let hint = "release it: nothing moves and nothing turns before";
        let diagnostic = over.diagnostic.map(|why| Box::new((*why).hint(hint)));
        Over { diagnostic, ..over }
    }

    /// A file whose outputs come on when it starts does not start while a stop is active.
    pub(crate) fn may_begin(&mut self) -> Result<(), Over> {
        self.world.machine.begin_lines();
        if !self.world.machine.switches_on_at_start() || self.interpreter.takes_stops() {
            return Ok(());
        }
        if self.is_ended_by_press() {
            return Err(self.ended_by_press(At::default()));
        }
        let input = self.world.machine.stop_input();
        input.map_or(Ok(()), |input| Err(self.forbids(input, At::default())))
    }

    fn forbids(&self, input: u8, at: At) -> Over {
        let active = format!("stop input {input} is active: stop circuit open, nothing may move");
        let message = self.stop_input_message(active);
        self.over(Status::Stopped, Code::InputStop, at, message)
    }

    /// Returns the message about a stop input; an open enclosure says so itself.
    pub(crate) fn stop_input_message(&self, message: String) -> String {
        let open = self.world.machine.open_enclosure().is_some();
        if open { ENCLOSURE_OPEN.into() } else { message }
    }

    /// Tells whether a move of a stack that moves already would leave the table: whatever comes before it is
    /// made first, and then it is a stack of its own, about which the operator is asked.
    pub(crate) fn leaves_table(&mut self, made: &Move) -> bool {
        if self.stack.running.is_none() {
            return false;
        }
        if self.lists_limits() {
            self.list_violation(made);
            return false;
        }
        self.world.machine.first_outside(std::slice::from_ref(made)).is_some()
    }

    /// Nothing is asked about what is only drawn.
    fn lists_limits(&self) -> bool {
        self.limits == LimitPolicy::List || self.world.machine.draws()
    }

    fn list_violation(&mut self, made: &Move) {
        if let Some(violation) = self.world.machine.first_outside(std::slice::from_ref(made)) {
            let message = self.limit_message(&violation);
            let place = Place::line(self.world.file(made.at), made.at.line);
            let diagnostic = Diagnostic::new(Code::OutsideLimits, place, message);
            self.world.tell_diagnostic(diagnostic);
        }
    }

    fn first_outside(&self, moves: &Queue) -> Option<(At, Violation)> {
        let machine = &self.world.machine;
        moves.iter().find_map(|made| Some((made.at, machine.first_outside(&[made])?)))
    }

    fn limit_message(&self, violation: &Violation) -> String {
        let scale = self.world.scale(violation.axis);
        let [reached, limit] =
            [violation.reached, violation.limit].map(|v| kerf_sbp::format_number(v / scale));
        let letter = violation.axis.letter();
        if violation.soft {
            return format!(
                "Out of bounds: {letter} would reach {reached}, it ends at {limit} (from home)"
            );
        }
        format!(
            "{letter} would reach {reached}, the table limit is {limit} (table base coordinates)"
        )
    }

    /// No spindle and no axis of its own (MI) starts where nothing may move: in an open enclosure, while a stop is
    /// pressed.
    pub(crate) fn may_turn(&mut self, command: &Command, at: At) -> Result<(), Over> {
        let starts = match command {
            Command::Output { number, on } => *on && turns(*number),
            Command::Independent { motion, .. } => *motion != Independent::Off,
            Command::SpindleTurn { turn, .. } => *turn != Turn::Off,
            Command::Pwm { percent, .. } => *percent > 0.0,
            _ => false,
        };
        let stopped = self.world.machine.stop_input().is_some() || self.world.is_pressed();
        if starts && stopped { self.may_move(at) } else { Ok(()) }
    }

    /// Watches for part files, beside what they wait for, the emergency stop of jobs, which see to it themselves.
    pub(crate) fn watched_for_all(&self) -> Option<Watched> {
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
}
