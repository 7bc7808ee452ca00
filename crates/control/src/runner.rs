//! The loop of a run: interpreter, planner and machine, one after the other.
//!
//! ```text
//!  Interpreter::run ──► commands ──► Mover ──► stack ──► planner ──► plan ──► machine, events
//!        ▲                  │ (not motion)                            │
//!        └── World: answers ┴──────────► carried out                  └─ input: interrupt
//! ```

use crate::command_limit::CommandLimit;
use crate::run_end::{Break, RunEnd};
use crate::stack::READ_AHEAD;
use crate::station::Station;
use crate::stopping::RunStops;
use crate::world::World;
use crate::{Requests, lift_aside, reentry, table_limits};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_journal::LimitPolicy;
use kerf_machine::state::{Event as Stopped, StopSettings};
use kerf_motion::{Move, Mover};
use kerf_program::{
    At, Axes, Axis, Command, Feed, Interpreter, Line, MoveKind, Sourced, Status, Step, Watch,
};
use kerf_sbp::LAST_ERROR;
use kerf_trace::flag;

/// Lines that are executed before their commands are looked at.
pub(crate) const LINES: u64 = 4096;

/// Function that saves a state and gives back what comes of it, or tells why nothing does.
pub(crate) type Restore<I> = fn(&I) -> Result<I, String>;

/// One run.
pub(crate) struct Runner<'a, I> {
    pub stops: RunStops<'a, I>,
    /// Commands that were given and not taken yet.
    out: Vec<Sourced>,
    lines: u64,
    /// An input may interrupt: moves need their numbers.
    watching: bool,
    /// Moment at which the watched input changed that stopped the machine last, seconds of machine time.
    pub changed_s: f64,
    /// Saves and restores the program's state before each look.
    pub restore: Option<Restore<I>>,
    /// The limit of what is carried out.
    pub bound: CommandLimit,
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
        let stops = RunStops::new(Station::new(interpreter, world, requests), limits);
        let (out, bound) = (Vec::new(), CommandLimit::default());
        Self { stops, out, lines, watching: false, changed_s: 0.0, restore: None, bound }
    }

    /// Runs the program to its end.
    pub(crate) fn run(&mut self) -> RunEnd {
        let world = &mut self.stops.station.world;
        let (typed, now_s) = (world.typed_files > 0, world.now());
        world.tracked().learn_until(now_s);
        let may_begin = if typed { Ok(()) } else { table_limits::may_begin(&mut self.stops) };
        if typed {
            self.stops.station.world.model.begin_lines();
        } else if may_begin.is_ok() {
            self.stops.station.world.model.begin_file();
        }
        self.stops.station.world.tell_log();
        self.stops.on(Stopped::Start, StopSettings::OPENSBP, "");
        self.stops.on(Stopped::Ready, StopSettings::OPENSBP, "");
        let over = match may_begin {
            Ok(()) => self.turns(),
            Err(over) => self.ended(over),
        };
        self.stops.station.world.driven.borrow_mut().land();
        // Typed lines are no file, unless they ran one.
        if typed && self.stops.station.world.files_known() <= self.stops.station.world.typed_files {
            self.stops.station.world.model.end_lines();
        } else {
            self.stops.station.world.model.end_file();
        }
        self.stops.station.world.tell_log();
        self.stops.station.world.spindle_rests();
        self.stops.on(Stopped::End, StopSettings::OPENSBP, "");
        self.stops.station.world.flush_print();
        self.stops.station.world.file_runs = false;
        let stopped = if over.status == Status::Stopped { flag::STOPPED } else { 0 };
        let interpreter = &self.stops.station.interpreter;
        self.stops.station.world.tell_standing(stopped, &Vec::new, &|| interpreter.variables());
        over
    }

    fn turns(&mut self) -> RunEnd {
        loop {
            if let Err(end) = self.restore() {
                return end;
            }
            if let Err(end) = self.turn() {
                return self.ended(end);
            }
        }
    }

    /// Goes on with the program as it comes back from a record, where that is tried.
    fn restore(&mut self) -> Result<(), RunEnd> {
        let Some(restore) = self.restore else { return Ok(()) };
        match restore(&self.stops.station.interpreter) {
            Ok(restored) => self.stops.station.interpreter = restored,
            Err(why) => return Err(self.lost(&why)),
        }
        Ok(())
    }

    /// Executes some lines and carries out their commands.
    fn turn(&mut self) -> Result<(), RunEnd> {
        let station = &mut self.stops.station;
        station.nudged = None;
        station.wake();
        self.take_up_at_rest()?;
        let station = &mut self.stops.station;
        let step = station.interpreter.run(&mut station.world, &mut self.out, self.lines);
        self.learn_files();
        let station = &mut self.stops.station;
        station.trail.goes_on(station.interpreter.call_stack());
        station.tell_standing_with(0, &self.out);
        let followed = self.feed().and_then(|()| self.follow(step));
        let heeded =
            Break::unless_ended(followed).map_err(Break::Ended).and_then(|()| self.heed_operator());
        self.keeps_record()?;
        Break::unless_ended(heeded)
    }

    /// Tells when the journal cannot be written; ends a run that is not the one on the tape.
    fn keeps_record(&mut self) -> Result<(), RunEnd> {
        let Station { world, last_move, .. } = &mut self.stops.station;
        if let Some(trouble) = world.workspace.new_trouble() {
            let place = SourcePlace::line(world.file(*last_move), last_move.line);
            let message = format!("the run goes on, but is not on record: {trouble}");
            let diagnostic = Diagnostic::new(Code::Journal, place, message);
            world.tell_diagnostic(diagnostic.severity(Severity::Warning));
        }
        let unfit = world.workspace.tape.unfit().map(str::to_owned);
        unfit.map_or(Ok(()), |unfit| Err(self.lost(&unfit)))
    }

    fn lost(&self, why: &str) -> RunEnd {
        let at = self.stops.station.asking_line();
        let place = SourcePlace::line(self.stops.station.world.file(at), at.line);
        let message = format!("the state of the program cannot be saved: {why}");
        let diagnostic = Diagnostic::new(Code::Terminated, place, message);
        RunEnd { status: Status::Failed, diagnostic: Some(Box::new(diagnostic)) }
    }

    /// Does what a step asks for, after its commands were taken over.
    fn follow(&mut self, step: Step) -> Result<(), Break> {
        match step {
            Step::Ran => Ok(()),
            Step::Waiting if self.stops.station.world.question.is_some() => self.answer(),
            Step::Waiting => {
                self.flush()?;
                self.stops.station.world.settled = true;
                Ok(())
            }
            Step::Done(Status::Failed, diagnostic) => {
                Err(RunEnd { status: Status::Failed, diagnostic }.into())
            }
            Step::Done(status, diagnostic) => {
                self.flush()?;
                Err(RunEnd { status, diagnostic }.into())
            }
        }
    }

    /// The run is over: what was read and not made is dropped, what ended it is told.
    fn ended(&mut self, over: RunEnd) -> RunEnd {
        let failed =
            over.diagnostic.is_none().then(|| self.stops.station.drive.fault().cloned()).flatten();
        let over = failed.map_or(over, |failure| self.stops.fails(&failure));
        if self.stops.station.stack.running.is_some() {
            // What moves cannot be dropped: it comes to rest behind the last move that was read.
            drop(self.flush());
        }
        // A run that is taken up and has nothing to make says so.
        self.stops.station.hear_world();
        self.stops.station.trail.goes_on(self.stops.station.interpreter.call_stack());
        let last = self.stops.last_commands(over.status);
        if let Some(diagnostic) = &over.diagnostic {
            self.stops.station.world.tell_diagnostic((**diagnostic).clone());
            if !self.stops.station.world.previews {
                let SourcePlace { file, line, .. } = &diagnostic.place;
                let told = format!("{file}:{line}: {}", diagnostic.message);
                self.stops.station.world.workspace.set_value(LAST_ERROR, Some(&told));
            }
        }
        self.drop_motion(over.status);
        last.into_iter().for_each(|sourced| self.stops.station.world.perform(sourced.command));
        over
    }

    /// Forgets moves that were not made. What does not belong to them is carried out: files that
    /// were closed, settings given back, what a person should know.
    fn drop_motion(&mut self, status: Status) {
        let waiting = std::mem::take(&mut self.stops.station.stack.waiting);
        if let (Status::Failed, Some(first)) = (status, waiting.front()) {
            self.note_dropped(first.at, waiting.len());
        }
        for sourced in self.stops.station.stack.clear().chain(std::mem::take(&mut self.out)) {
            if outlives_motion(&sourced.command) {
                self.stops.station.world.perform(sourced.command);
            }
        }
    }

    fn note_dropped(&mut self, at: At, count: usize) {
        let moves = if count == 1 { "1 move was".into() } else { format!("{count} moves were") };
        let message = format!("{moves} read but not made, because of the error in the same stack");
        let place = SourcePlace::line(self.stops.station.world.file(at), at.line);
        let hint = "nothing of a stack moves when it cannot be read to its end";
        self.stops
            .station
            .world
            .tell_diagnostic(Diagnostic::new(Code::StackDropped, place, message).hint(hint));
    }

    fn learn_files(&mut self) {
        while let Some(name) =
            self.stops.station.interpreter.file_name(self.stops.station.world.files_known() as u32)
        {
            self.stops.station.world.name_file(name);
            self.stops.station.world.file_runs |=
                self.stops.station.world.files_known() > self.stops.station.world.typed_files;
        }
    }

    /// Takes over the commands given: motion goes onto the stack, the rest is carried out.
    fn feed(&mut self) -> Result<(), Break> {
        let interpreter = &self.stops.station.interpreter;
        self.watching = interpreter.takes_stops() || !interpreter.watches().is_empty();
        let mut out = std::mem::take(&mut self.out);
        let motions = out.iter().filter(|s| s.command.is_motion()).count() as u64;
        let mut number = interpreter.motions() - motions;
        let taken = out.drain(..).try_for_each(|sourced| {
            number += u64::from(sourced.command.is_motion());
            self.take(sourced, number)
        });
        self.out = out;
        taken
    }

    fn take(&mut self, mut sourced: Sourced, number: u64) -> Result<(), Break> {
        if !self.bound.takes_one() {
            return Err(self.looked_enough(sourced.at));
        }
        if self.leaves_torch(&sourced.command) {
            self.flush()?;
            let station = &mut self.stops.station;
            station.world.tracked().land();
            station.mover.set_position(station.world.model.position());
        }
        let station = &mut self.stops.station;
        if let Some(nudged) = station.nudged {
            sourced.command.shift(nudged);
        }
        if let Some((axis, place)) = Mover::beyond(&sourced.command) {
            let far = place / station.world.scale(axis);
            let message = format!("{} would go to {far:e}: nothing is that long", axis.letter());
            let end = station.over(Status::Failed, Code::OutOfRange, sourced.at, message);
            return Err(end.into());
        }
        let made = match &sourced.command {
            Command::Line(line) => station.mover.line(sourced.at, line),
            Command::Arc(arc) => station.mover.arc(sourced.at, arc),
            _ => return self.take_other(sourced),
        };
        made.map_or(Ok(()), |made| self.take_move(made, number))
    }

    /// Makes what was read up to here; then the run is over.
    fn looked_enough(&mut self, at: At) -> Break {
        if let Err(sooner) = self.flush() {
            return sooner;
        }
        let (message, hint) = self.bound.message();
        self.stops.station.over(Status::Limit, Code::LineLimit, at, message).hint(hint).into()
    }

    /// A move joins the stack; a jog is a stack of its own.
    fn take_move(&mut self, mut made: Move, number: u64) -> Result<(), Break> {
        lift_aside::back_in_the_cut(&mut self.stops)?;
        let jog = made.kind == MoveKind::Jog;
        let apart = jog && !self.stops.station.stack.is_empty()
            || table_limits::leaves_table(&mut self.stops, &made);
        if apart {
            self.flush_before(|by| made.shift(by))?;
        }
        if !jog && self.is_full() {
            self.reload(&mut made, number)?;
        }
        self.stack_up(made, number);
        if jog { self.flush() } else { self.run_ahead() }
    }

    /// Makes what is planned for good, once enough was read.
    fn run_ahead(&mut self) -> Result<(), Break> {
        let stack = &self.stops.station.stack;
        if stack.running.is_none() {
            if stack.waiting.len() < READ_AHEAD {
                return Ok(());
            }
            self.begin()?;
        }
        self.run_on(false)
    }

    fn stack_up(&mut self, made: Move, number: u64) {
        let station = &mut self.stops.station;
        station.stack.push(made.at_feed(station.feed), self.watching.then_some(number));
        if station.is_of_file(made.at) {
            station.stack.came_from_file();
        }
    }

    /// Returns `true` if the stack takes no more moves.
    fn is_full(&self) -> bool {
        let limit = self.stops.station.world.model.settings().stack_limit;
        limit.is_some_and(|limit| self.stops.station.stack.len() >= u64::from(limit))
    }

    /// Makes a full stack, pulls up to Safe-Z and comes back, so that the next move begins another
    /// (programming handbook, "Movement Blocks").
    fn reload(&mut self, next: &mut Move, number: u64) -> Result<(), Break> {
        self.flush_before(|by| next.shift(by))?;
        let Station { world, mover, .. } = &mut self.stops.station;
        let Some(safe_mm) = world.model.settings().cutter.safe_z_mm else { return Ok(()) };
        let mut up = next.from;
        up[Axis::Z] = world.model.frame().working_zero[Axis::Z] + safe_mm;
        let after = mover.position();
        mover.set_position(next.from);
        for (kind, to) in [(MoveKind::Jog, up), (MoveKind::Cut, next.from)] {
            let line = Line { kind, to, feed: Feed::Axis };
            let Some(made) = self.stops.station.mover.line(next.at, &line) else { continue };
            self.stack_up(made, number);
            self.flush()?;
        }
        self.stops.station.mover.set_position(after);
        Ok(())
    }

    fn take_other(&mut self, mut sourced: Sourced) -> Result<(), Break> {
        if let Command::Settings(settings) = &sourced.command {
            self.stops.station.mover.settings(settings);
        }
        if self.joins(&sourced.command) {
            let stack = &mut self.stops.station.stack;
            if stack.is_empty() {
                return self.perform(sourced.command, sourced.at);
            }
            stack.mark(sourced);
            return Ok(());
        }
        self.flush_before(|by| sourced.command.shift(by))?;
        match sourced.command {
            Command::Wait { seconds } => self.wait(seconds),
            command => self.perform(command, sourced.at),
        }
    }

    /// Carries out a command at rest, where it may be.
    fn perform(&mut self, command: Command, at: At) -> Result<(), Break> {
        table_limits::may_turn(&mut self.stops, &command, at)?;
        let Station { world, mover, .. } = &mut self.stops.station;
        world.perform(command);
        // A preview begins and ends elsewhere than the last move.
        mover.set_position(world.model.position());
        Ok(())
    }

    /// Returns `true` if a move of Z alone begins where the torch has brought it.
    fn leaves_torch(&self, command: &Command) -> bool {
        let Command::Line(line) = command else { return false };
        let from = self.stops.station.mover.position();
        let stays = |axis: Axis| line.to[axis] == from[axis];
        self.stops.station.world.model.settings().torch_on() && stays(Axis::X) && stays(Axis::Y)
    }

    /// Tells whether motion goes on through a command. It does not when a preview begins or ends.
    fn joins(&self, command: &Command) -> bool {
        match command {
            Command::Settings(new) => new.mode == self.stops.station.world.model.settings().mode,
            other => !other.ends_stack(),
        }
    }

    /// The stack is complete: runs what is left of it.
    pub(crate) fn flush(&mut self) -> Result<(), Break> {
        if self.stops.station.stack.is_empty() {
            return Ok(());
        }
        loop {
            if !self.stops.station.stack.waiting.is_empty() {
                self.begin()?;
            }
            self.run_on(true)?;
            if self.stops.station.stack.waiting.is_empty() {
                self.stops.station.come_to_rest();
                return Ok(());
            }
        }
    }

    /// Runs the stack that was read before something that was taken out of it already: a nudge
    /// meanwhile shifts that too.
    fn flush_before(&mut self, shift: impl FnOnce(Axes)) -> Result<(), Break> {
        let before = self.stops.station.nudged.unwrap_or_default();
        let flushed = self.flush();
        if let Some(nudged) = self.stops.station.nudged {
            shift(nudged.minus(before));
        }
        flushed
    }

    /// A watched input stopped the machine: the program's handler comes next, and those of inputs that changed in the
    /// same moment or until the machine stood.
    pub(crate) fn interrupt(
        &mut self,
        index: usize,
        at: &kerf_program::Halted,
    ) -> Result<(), Break> {
        let Station { interpreter, world, .. } = &mut self.stops.station;
        world.tracked().land();
        let position = world.model.position();
        let Some(watch) = interpreter.watches().get(index).cloned() else { return Ok(()) };
        interpreter.fired(at);
        interpreter.interrupt(&watch, at.motion, position);
        let changed = world.model.changed_since(self.changed_s);
        let fires = |w: &Watch| w.level_after_s.is_none() && changed.contains(&(w.input, w.on));
        for other in interpreter.watches().into_iter().filter(fires) {
            interpreter.interrupt(&other, None, position);
        }
        self.stops.station.begin_anew(position);
        Err(Break::Interrupted)
    }

    /// Lets a program that knows its own way back take it at once, before anything else goes on.
    fn take_up_at_rest(&mut self) -> Result<(), RunEnd> {
        let Station { interpreter, world, stack, .. } = &self.stops.station;
        let rests = stack.is_empty() && !world.workspace.tape.reenters_within();
        if !(interpreter.takes_stops() && rests) {
            return Ok(());
        }
        Break::unless_ended(reentry::take_up(&mut self.stops))
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
