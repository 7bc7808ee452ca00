//! The loop of a run: interpreter, planner and machine, one after the other.
//!
//! ```text
//!  Interpreter::run ──► commands ──► Mover ──► stack ──► planner ──► plan ──► machine, events
//!        ▲                  │ (not motion)                            │
//!        └── World: answers ┴──────────► carried out                  └─ input: interrupt
//! ```

use crate::bound::Bound;
use crate::drive::Drive;
use crate::execute::Halted;
use crate::stack::{READ_AHEAD, Stack};
use crate::stopping::Kept;
use crate::trail::Trail;
use crate::world::World;
use crate::{OperatorRequest, Requests};
use kerf_diag::{Code, Diagnostic, Place, Severity};
use kerf_journal::{LimitPolicy, Placed};
use kerf_machine::State;
use kerf_machine::state::{Event as Stopped, StopSettings};
use kerf_motion::{Move, Mover};
use kerf_program::{
    At, Axes, Axis, Command, Feed, Interpreter, Line, MoveKind, Sourced, Status, Step, StoppedBy,
    Watch,
};
use kerf_sbp::LAST_ERROR;
use kerf_sim::Watched;
use kerf_trace::flag;
use std::collections::VecDeque;

/// Lines that are executed before their commands are looked at.
pub(crate) const LINES: u64 = 4096;

/// Function that saves a state and gives back what comes of it, or tells why nothing does.
pub(crate) type Restore<I> = fn(&I) -> Result<I, String>;

/// One run.
pub(crate) struct Runner<'a, I> {
    pub interpreter: I,
    pub world: World<'a>,
    pub drive: Drive<'a>,
    pub mover: Mover,
    pub stack: Stack,
    /// The operator's override: share of the speed asked for at which cuts run.
    pub feed: f32,
    /// Requests of the operator that he has not got yet.
    pub requests: VecDeque<(f64, OperatorRequest)>,
    /// Distance by which the workpiece was nudged since the commands at hand were given.
    pub nudged: Option<Axes>,
    out: Vec<Sourced>,
    lines: u64,
    /// An input may interrupt: moves need their numbers.
    watching: bool,
    /// Moment at which the watched input changed that stopped the machine last, seconds of machine time.
    pub(crate) changed_s: f64,
    /// Saves and restores the program's state before each look.
    pub restore: Option<Restore<I>>,
    pub limits: LimitPolicy,
    /// The line of the move made last.
    pub last_move: At,
    /// Place of the program, for the log.
    pub trail: Trail,
    /// State of the machine. A job, or a move by hand, knows more of it.
    pub state: State,
    /// Place to which a run that was stopped comes back.
    pub kept: Kept,
    /// The operator took the tool out of the cut while the program waits.
    pub away: bool,
    /// A job has switched off what it leaves.
    settled: bool,
    /// End of the run that came while the machine moved beside the program.
    pub ends: Option<Over>,
    /// The run is taken up: where the machine stands meanwhile.
    pub reentry: Option<Placed>,
    /// Up to here it is on record how far a move has come, machine time.
    pub recorded_s: f64,
    /// The bound on what is carried out.
    pub bound: Bound,
}

/// Decision whether a run goes on.
#[derive(Debug)]
pub(crate) enum Flow {
    /// On to the next.
    On,
    /// An input interrupted: commands given so far are dropped, the interpreter knows.
    Interrupted,
    /// The machine ends the run.
    Over(Over),
}

/// The end of a run that the interpreter did not decide.
#[derive(Debug)]
pub(crate) struct Over {
    pub status: Status,
    pub diagnostic: Option<Box<Diagnostic>>,
}

impl<'a, I: Interpreter> Runner<'a, I> {
    /// Ready to run; looks at commands after so many lines.
    pub fn new(
        interpreter: I,
        world: World<'a>,
        requests: &'a mut dyn Requests,
        limits: LimitPolicy,
        lines: u64,
    ) -> Self {
        let mover = Mover::new(world.machine.position(), interpreter.settings());
        let (stack, out) = (Stack::default(), Vec::new());
        let drive = Drive::new(world.driven.clone(), requests, world.now());
        Self {
            interpreter,
            world,
            drive,
            mover,
            stack,
            feed: 1.0,
            requests: VecDeque::new(),
            out,
            lines,
            limits,
            watching: false,
            changed_s: 0.0,
            nudged: None,
            restore: None,
            last_move: At::default(),
            trail: Trail::default(),
            state: State::Idle,
            kept: Kept::default(),
            away: false,
            settled: false,
            ends: None,
            reentry: None,
            recorded_s: 0.0,
            bound: Bound::default(),
        }
    }

    /// Runs the program to its end.
    pub fn run(&mut self) -> Over {
        let (typed, now_s) = (self.world.typed_files > 0, self.world.now());
        self.world.tracked().learn_until(now_s);
        let may_begin = if typed { Ok(()) } else { self.may_begin() };
        if typed {
            self.world.machine.begin_lines();
        } else if may_begin.is_ok() {
            self.world.machine.begin_file();
        }
        self.world.tell_log();
        self.on(Stopped::Start, StopSettings::OPENSBP, "");
        self.on(Stopped::Ready, StopSettings::OPENSBP, "");
        let over = match may_begin {
            Ok(()) => self.turns(),
            Err(over) => self.ended(over),
        };
        self.world.driven.borrow_mut().land();
        // Typed lines are no file, unless they ran one.
        if typed && self.world.files_known() <= self.world.typed_files {
            self.world.machine.end_lines();
        } else {
            self.world.machine.end_file();
        }
        self.world.tell_log();
        self.world.spindle_rests();
        self.on(Stopped::End, StopSettings::OPENSBP, "");
        self.world.flush_print();
        self.world.file_runs = false;
        let stopped = if over.status == Status::Stopped { flag::STOPPED } else { 0 };
        let interpreter = &self.interpreter;
        self.world.tell_standing(stopped, &Vec::new, &|| interpreter.variables());
        over
    }

    fn turns(&mut self) -> Over {
        loop {
            if let Some(over) = self.turn() {
                return over;
            }
        }
    }

    /// Some lines, and what they ask for.
    fn turn(&mut self) -> Option<Over> {
        if let Some(restore) = self.restore {
            match restore(&self.interpreter) {
                Ok(restored) => self.interpreter = restored,
                Err(why) => return Some(self.lost(&why)),
            }
        }
        self.nudged = None;
        self.wake();
        if let Some(over) = self.take_up_at_rest() {
            return Some(self.ended(over));
        }
        let step = self.interpreter.run(&mut self.world, &mut self.out, self.lines);
        self.learn_files();
        self.trail.goes_on(self.interpreter.call_stack());
        self.tell_standing(0);
        let flow = match self.feed() {
            Flow::On => self.follow(step),
            flow => flow,
        };
        let flow = match flow {
            Flow::On | Flow::Interrupted => self.heed_operator(),
            flow => flow,
        };
        if let Some(over) = self.keeps_record() {
            return Some(self.ended(over));
        }
        match flow {
            Flow::On | Flow::Interrupted => None,
            Flow::Over(over) => Some(self.ended(over)),
        }
    }

    /// Tells when the journal cannot be written; ends a run that is not the one on the tape.
    fn keeps_record(&mut self) -> Option<Over> {
        if let Some(trouble) = self.world.workspace.new_trouble() {
            let place = Place::line(self.world.file(self.last_move), self.last_move.line);
            let message = format!("the run goes on, but is not on record: {trouble}");
            let diagnostic = Diagnostic::new(Code::Journal, place, message);
            self.world.tell_diagnostic(diagnostic.severity(Severity::Warning));
        }
        let unfit = self.world.workspace.tape.unfit()?.to_owned();
        Some(self.lost(&unfit))
    }

    pub(crate) fn tell_standing(&mut self, flags: u8) {
        let moves = |s: &Sourced| s.command.is_motion() && self.is_of_file(s.at);
        self.world.file_moves = self.stack.moves_file() || self.out.iter().any(moves);
        let interpreter = &self.interpreter;
        let called = |at: At| (at, interpreter.file_call(at.file));
        let files = || interpreter.call_stack().into_iter().map(called).collect();
        self.world.tell_standing(flags, &files, &|| interpreter.variables());
    }

    fn lost(&self, why: &str) -> Over {
        let at = self.asking_line();
        let place = Place::line(self.world.file(at), at.line);
        let message = format!("the state of the program cannot be saved: {why}");
        let diagnostic = Diagnostic::new(Code::Terminated, place, message);
        Over { status: Status::Failed, diagnostic: Some(Box::new(diagnostic)) }
    }

    /// Does what a step asks for, after its commands were taken over.
    fn follow(&mut self, step: Step) -> Flow {
        match step {
            Step::Ran => Flow::On,
            Step::Waiting if self.world.question.is_some() => self.answer(),
            Step::Waiting => {
                let flow = self.flush();
                if matches!(flow, Flow::On) {
                    self.world.settled = true;
                }
                flow
            }
            Step::Done(Status::Failed, diagnostic) => {
                Flow::Over(Over { status: Status::Failed, diagnostic })
            }
            Step::Done(status, diagnostic) => match self.flush() {
                Flow::On => Flow::Over(Over { status, diagnostic }),
                flow => flow,
            },
        }
    }

    /// The run is over: what was read and not made is dropped, what ended it is told.
    fn ended(&mut self, over: Over) -> Over {
        let failed = over.diagnostic.is_none().then(|| self.drive.fault().cloned()).flatten();
        let over = failed.map_or(over, |failure| self.fails(&failure));
        if self.stack.running.is_some() {
            // What moves cannot be dropped: it comes to rest behind the last move that was read.
            drop(self.flush());
        }
        // A run that is taken up and has nothing to make says so.
        self.hear_world();
        self.trail.goes_on(self.interpreter.call_stack());
        let last = self.last_commands(over.status);
        if let Some(diagnostic) = &over.diagnostic {
            self.world.tell_diagnostic((**diagnostic).clone());
            if !self.world.previews {
                let Place { file, line, .. } = &diagnostic.place;
                let told = format!("{file}:{line}: {}", diagnostic.message);
                self.world.workspace.set_value(LAST_ERROR, Some(&told));
            }
        }
        self.drop_motion(over.status);
        last.into_iter().for_each(|sourced| self.world.perform(sourced.command));
        over
    }

    /// Returns the commands of the program for the end of its run. A job leaves nothing on, however it ends; that is
    /// settled once.
    pub(crate) fn last_commands(&mut self, status: Status) -> Vec<Sourced> {
        let mut last = Vec::new();
        let is_job = self.interpreter.takes_stops();
        if is_job && std::mem::replace(&mut self.settled, true) {
            return last;
        }
        match status {
            Status::Limit => drop(self.interpreter.limit(&mut self.world, &mut last)),
            Status::Stopped => drop(self.interpreter.stop(&mut self.world, &mut last)),
            _ if is_job => drop(self.interpreter.stop(&mut self.world, &mut last)),
            Status::Ok | Status::Ended | Status::Failed => {}
        }
        last
    }

    /// Forgets moves that were not made. What does not belong to them is carried out: files that
    /// were closed, settings given back, what a person should know.
    fn drop_motion(&mut self, status: Status) {
        let waiting = std::mem::take(&mut self.stack.waiting);
        if let (Status::Failed, Some(first)) = (status, waiting.front()) {
            self.note_dropped(first.at, waiting.len());
        }
        for sourced in self.stack.clear().chain(std::mem::take(&mut self.out)) {
            if outlives_motion(&sourced.command) {
                self.world.perform(sourced.command);
            }
        }
    }

    fn note_dropped(&mut self, at: At, count: usize) {
        let moves = if count == 1 { "1 move was".into() } else { format!("{count} moves were") };
        let message = format!("{moves} read but not made, because of the error in the same stack");
        let place = Place::line(self.world.file(at), at.line);
        let hint = "nothing of a stack moves when it cannot be read to its end";
        self.world.tell_diagnostic(Diagnostic::new(Code::StackDropped, place, message).hint(hint));
    }

    fn learn_files(&mut self) {
        while let Some(name) = self.interpreter.file_name(self.world.files_known() as u32) {
            self.world.name_file(name);
            self.world.file_runs |= self.world.files_known() > self.world.typed_files;
        }
    }

    /// Takes over the commands given: motion goes onto the stack, the rest is carried out.
    fn feed(&mut self) -> Flow {
        self.watching = self.interpreter.takes_stops() || !self.interpreter.watches().is_empty();
        let mut out = std::mem::take(&mut self.out);
        let motions = out.iter().filter(|s| s.command.is_motion()).count() as u64;
        let mut number = self.interpreter.motions() - motions;
        let mut flow = Flow::On;
        for sourced in out.drain(..) {
            number += u64::from(sourced.command.is_motion());
            flow = self.take(sourced, number);
            if !matches!(flow, Flow::On) {
                break;
            }
        }
        self.out = out;
        self.out.clear();
        flow
    }

    fn take(&mut self, mut sourced: Sourced, number: u64) -> Flow {
        if !self.bound.takes_one() {
            return self.looked_enough(sourced.at);
        }
        if self.leaves_torch(&sourced.command) {
            match self.flush() {
                Flow::On => self.world.tracked().land(),
                flow => return flow,
            }
            self.mover.set_position(self.world.machine.position());
        }
        if let Some(nudged) = self.nudged {
            sourced.command.shift(nudged);
        }
        if let Some((axis, place)) = Mover::beyond(&sourced.command) {
            let far = place / self.world.scale(axis);
            let message = format!("{} would go to {far:e}: nothing is that long", axis.letter());
            return Flow::Over(self.over(Status::Failed, Code::OutOfRange, sourced.at, message));
        }
        let made = match &sourced.command {
            Command::Line(line) => self.mover.line(sourced.at, line),
            Command::Arc(arc) => self.mover.arc(sourced.at, arc),
            _ => return self.take_other(sourced),
        };
        let Some(made) = made else { return Flow::On };
        self.take_move(made, number)
    }

    /// Makes what was read up to here; then the run is over.
    fn looked_enough(&mut self, at: At) -> Flow {
        match self.flush() {
            Flow::On => {
                let (message, hint) = self.bound.told();
                let mut over = self.over(Status::Limit, Code::LineLimit, at, message);
                over.diagnostic = over.diagnostic.map(|told| Box::new(told.hint(hint)));
                Flow::Over(over)
            }
            flow => flow,
        }
    }

    /// A move joins the stack; a jog is a stack of its own.
    fn take_move(&mut self, mut made: Move, number: u64) -> Flow {
        if let Err(over) = self.back_in_the_cut() {
            return Flow::Over(over);
        }
        let jog = made.kind == MoveKind::Jog;
        let apart = jog && !self.stack.is_empty() || self.leaves_table(&made);
        let flow = if apart { self.flush_before(|by| made.shift(by)) } else { Flow::On };
        if !matches!(flow, Flow::On) {
            return flow;
        }
        if !jog && self.is_full() {
            match self.reload(&mut made, number) {
                Flow::On => {}
                flow => return flow,
            }
        }
        self.stack_up(made, number);
        if jog { self.flush() } else { self.run_ahead() }
    }

    /// Makes what is planned for good, once enough was read.
    fn run_ahead(&mut self) -> Flow {
        if self.stack.running.is_none() {
            if self.stack.waiting.len() < READ_AHEAD {
                return Flow::On;
            }
            if let Err(halted) = self.begin() {
                return self.halted(halted);
            }
        }
        match self.run_on(false) {
            None => Flow::On,
            Some(halted) => self.halted(halted),
        }
    }

    fn stack_up(&mut self, made: Move, number: u64) {
        let of_file = self.is_of_file(made.at);
        self.stack.push(made.at_feed(self.feed), self.watching.then_some(number));
        if of_file {
            self.stack.came_from_file();
        }
    }

    /// Returns `true` if a line stands in a file, and was not typed.
    const fn is_of_file(&self, at: At) -> bool {
        at.file as usize >= self.world.typed_files
    }

    /// Returns `true` if the stack takes no more moves.
    fn is_full(&self) -> bool {
        let limit = self.world.machine.settings().stack_limit;
        limit.is_some_and(|limit| self.stack.len() >= u64::from(limit))
    }

    /// Makes a full stack, pulls up to Safe-Z and comes back, so that the next move begins another
    /// (programming handbook, "Movement Blocks").
    fn reload(&mut self, next: &mut Move, number: u64) -> Flow {
        match self.flush_before(|by| next.shift(by)) {
            Flow::On => {}
            flow => return flow,
        }
        let machine = &self.world.machine;
        let Some(safe_mm) = machine.settings().cutter.safe_z_mm else { return Flow::On };
        let mut up = next.from;
        up[Axis::Z] = machine.frame().working_zero[Axis::Z] + safe_mm;
        let after = self.mover.position();
        self.mover.set_position(next.from);
        for (kind, to) in [(MoveKind::Jog, up), (MoveKind::Cut, next.from)] {
            let line = Line { kind, to, feed: Feed::Axis };
            let Some(made) = self.mover.line(next.at, &line) else { continue };
            self.stack_up(made, number);
            match self.flush() {
                Flow::On => {}
                flow => return flow,
            }
        }
        self.mover.set_position(after);
        Flow::On
    }

    fn take_other(&mut self, mut sourced: Sourced) -> Flow {
        if let Command::Settings(settings) = &sourced.command {
            self.mover.settings(settings);
        }
        if self.joins(&sourced.command) {
            if self.stack.is_empty() {
                return self.perform(sourced.command, sourced.at);
            }
            self.stack.mark(sourced);
            return Flow::On;
        }
        match (self.flush_before(|by| sourced.command.shift(by)), sourced.command) {
            (Flow::On, Command::Wait { seconds }) => self.wait(seconds),
            (Flow::On, command) => self.perform(command, sourced.at),
            (flow, _) => flow,
        }
    }

    /// Carries out a command at rest, where it may be.
    fn perform(&mut self, command: Command, at: At) -> Flow {
        if let Err(over) = self.may_turn(&command, at) {
            return Flow::Over(over);
        }
        self.world.perform(command);
        // A preview begins and ends elsewhere than the last move.
        self.mover.set_position(self.world.machine.position());
        Flow::On
    }

    /// Returns `true` if a move of Z alone begins where the torch has brought it.
    fn leaves_torch(&self, command: &Command) -> bool {
        let Command::Line(line) = command else { return false };
        let from = self.mover.position();
        let stays = |axis: Axis| line.to[axis] == from[axis];
        self.world.machine.settings().torch_on() && stays(Axis::X) && stays(Axis::Y)
    }

    /// Tells whether motion goes on through a command. It does not when a preview begins or ends.
    fn joins(&self, command: &Command) -> bool {
        match command {
            Command::Settings(new) => new.mode == self.world.machine.settings().mode,
            other => !other.ends_stack(),
        }
    }

    /// The stack is complete: runs what is left of it.
    pub(crate) fn flush(&mut self) -> Flow {
        if self.stack.is_empty() {
            return Flow::On;
        }
        loop {
            if !self.stack.waiting.is_empty()
                && let Err(halted) = self.begin()
            {
                return self.halted(halted);
            }
            if let Some(halted) = self.run_on(true) {
                return self.halted(halted);
            }
            if self.stack.waiting.is_empty() {
                self.come_to_rest();
                return Flow::On;
            }
        }
    }

    /// Runs the stack that was read before something that was taken out of it already: a nudge
    /// meanwhile shifts that too.
    fn flush_before(&mut self, shift: impl FnOnce(Axes)) -> Flow {
        let before = self.nudged.unwrap_or_default();
        let flow = self.flush();
        if let Some(nudged) = self.nudged {
            shift(nudged.minus(before));
        }
        flow
    }

    pub(crate) fn halted(&mut self, halted: Halted) -> Flow {
        match halted {
            Halted::Watch { index, at } => self.interrupt(index, &at),
            Halted::Taken { by, at } => self.taken(by, &at),
            Halted::Over(over) => Flow::Over(over),
        }
    }

    /// A watched input stopped the machine: the program's handler comes next, and those of inputs that changed in the
    /// same moment or until the machine stood.
    pub(crate) fn interrupt(&mut self, index: usize, at: &kerf_program::Halted) -> Flow {
        self.world.tracked().land();
        let position = self.world.machine.position();
        let Some(watch) = self.interpreter.watches().get(index).cloned() else { return Flow::On };
        self.interpreter.fired(at);
        self.interpreter.interrupt(&watch, at.motion, position);
        let changed = self.world.machine.changed_since(self.changed_s);
        let fires = |w: &Watch| w.level_after_s.is_none() && changed.contains(&(w.input, w.on));
        for other in self.interpreter.watches().into_iter().filter(fires) {
            self.interpreter.interrupt(&other, None, position);
        }
        self.begin_anew(position);
        Flow::Interrupted
    }

    /// The machine was stopped, and the program says what follows.
    pub(crate) fn taken(&mut self, by: StoppedBy, at: &kerf_program::Halted) -> Flow {
        self.drive.heard();
        self.world.tracked().land();
        let stands = self.world.machine.position();
        self.world.limit = match by {
            StoppedBy::Limit(input) => Some(input),
            _ => None,
        };
        self.interpreter.stopped(by, &kerf_program::Halted { stands, ..*at });
        self.world.workspace.tape.goes_on();
        self.begin_anew(stands);
        Flow::Interrupted
    }

    /// Commands given so far are dropped.
    fn begin_anew(&mut self, position: Axes) {
        drop(self.stack.clear());
        self.mover.set_position(position);
        self.mover.settings(self.interpreter.settings());
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
}

/// Tells whether a command is carried out although the moves around it are not made.
const fn outlives_motion(command: &Command) -> bool {
    matches!(
        command,
        Command::Settings(_)
            | Command::File { .. }
            | Command::ToolChange { .. }
            | Command::Diagnostic(_)
    )
}
