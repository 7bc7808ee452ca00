//! The stepped interpreter of both languages.

use crate::Program;
use crate::files::Files;
use crate::guest::Guest;
use crate::library::Library;
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_program::settings::Mode;
use kerf_program::{At, Axes, FileCall, Frame, Host, Settings, Sourced, Status, Step, Watch};
use kerf_sbp::{GcodeDone, GcodeDue, Variables};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Options for running a program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Options {
    /// Options of OpenSBP. Bounds, file parameters and preview hold for both languages.
    pub sbp: kerf_sbp::Options,
    /// Options of G-code, as far as `sbp` does not say.
    pub gcode: kerf_gcode::Options,
}

/// State that a run begins with and leaves behind.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Session {
    /// The machine, and what OpenSBP remembers.
    pub sbp: kerf_sbp::Session,
    /// State that G-code remembers.
    pub gcode: kerf_gcode::State,
}

/// A program being run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Interpreter {
    sbp: kerf_sbp::Interpreter,
    gcode: kerf_gcode::Options,
    options: kerf_sbp::Options,
    /// State that G-code remembers while none runs.
    state: kerf_gcode::State,
    /// The parameters of the G-code that ran last, with those of its own.
    parameters: Vec<(String, f64)>,
    /// G-code under way, outermost first: a handler of ON INPUT may run G-code while other G-code
    /// stands still.
    guests: Vec<Guest>,
    /// Runs the single lines of a file, by the number of the file, so that modes and cycles last.
    lines: Option<(u32, kerf_gcode::Interpreter)>,
    files: Files,
    /// Files whose faults in G-code were told: those of the first are told before the start.
    told: BTreeSet<u32>,
    #[serde(skip)]
    library: Library,
}

impl Interpreter {
    /// Prepares to run a program from the state of a session.
    pub fn new(program: Program, session: Session, options: Options) -> Self {
        let Program { sbp, gcode, .. } = program;
        let Options { sbp: mut options, gcode: gcode_options } = options;
        options.gcode = true;
        let mut sbp = kerf_sbp::Interpreter::new(sbp, session.sbp, options.clone());
        let mut files = Files::default();
        files.learn_sbp(&sbp);
        sbp.use_tools(session.gcode.tool_table());
        Self {
            sbp,
            gcode: gcode_options,
            options,
            state: session.gcode,
            parameters: Vec::new(),
            guests: Vec::new(),
            lines: None,
            files,
            told: BTreeSet::from([0]),
            library: Library::new(gcode),
        }
    }

    /// The user's variables of OpenSBP.
    pub fn sbp_variables(&self) -> &Variables {
        self.sbp.variables()
    }

    /// Parameters of G-code that are not zero, by name as people write them.
    pub fn gcode_parameters(&self) -> Vec<(String, f64)> {
        match self.guests.last() {
            Some(guest) => guest.interpreter.variables(),
            None => self.parameters.clone(),
        }
    }

    /// Returns `true` if the program ended with EXIT SHOPBOT: what runs it is to close, too.
    pub const fn closes(&self) -> bool {
        self.sbp.closes()
    }

    /// Returns the state that stays after the run.
    pub fn into_session(mut self) -> Session {
        self.retire();
        self.state.use_tools(self.sbp.tools());
        Session { sbp: self.sbp.into_session(), gcode: self.state }
    }

    fn go(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        self.drop_left();
        let Some(due) = self.sbp.gcode_due() else {
            return self.go_sbp(host, out, lines);
        };
        let fits = |g: &Guest| g.due == due && g.depth == self.sbp.depth();
        if !self.guests.last().is_some_and(fits)
            && let Err(error) = self.begin(due, out)
        {
            return self.failed(host, out, Status::Failed, Some(error));
        }
        self.go_gcode(host, out, lines)
    }

    fn go_sbp(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        let given = out.len();
        if let Some(guest) = self.guests.last().filter(|g| !g.stale) {
            self.sbp.use_tools(guest.interpreter.state().tool_table());
        }
        self.guests.iter_mut().for_each(|g| g.stale = true);
        let step = match lines {
            1 => self.sbp.step(host, out),
            _ => self.sbp.run(host, out, lines),
        };
        self.files.learn_sbp(&self.sbp);
        self.files.translate_sbp(&mut out[given..]);
        match self.moved_beside_path(&out[given..]) {
            Some((first, error)) => {
                out.truncate(given + first);
                self.failed(host, out, Status::Failed, Some(error))
            }
            None => step,
        }
    }

    /// The first move of OpenSBP while cutter compensation of G-code is on, which knows nothing of it and of the
    /// moves that are held back.
    fn moved_beside_path(&self, given: &[Sourced]) -> Option<(usize, Box<Diagnostic>)> {
        self.lines.as_ref().filter(|(_, lines)| lines.compensates())?;
        let first = given.iter().position(|it| it.command.is_motion())?;
        let at = given[first].at;
        let name = self.files.name(at.file).unwrap_or_else(|| Arc::from(""));
        let message = "OpenSBP moves while cutter compensation is on";
        let error = Diagnostic::new(Code::Compensation, SourcePlace::line(name, at.line), message);
        Some((first, Box::new(error.hint("write G40 before it, or the move in G-code"))))
    }

    fn go_gcode(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        let watched = self.sbp.watches().next().is_some();
        let Some(guest) = self.guests.last_mut() else { return Step::Ran };
        guest.catch_up(&self.sbp);
        let given = out.len();
        if let Some(step) = guest.changes_tool(&mut self.sbp, host, out) {
            return self.opens_tool_change(step, host, out, given);
        }
        match guest.run(host, out, lines, watched, &mut self.files) {
            Step::Done(Status::Ok, _) => {
                self.end_guest();
                Step::Ran
            }
            Step::Done(status, error) => self.failed(host, out, status, error),
            step => step,
        }
    }

    /// The file that changes the tool is open, or could not be opened.
    fn opens_tool_change(
        &mut self,
        step: Step,
        host: &mut dyn Host,
        out: &mut Vec<Sourced>,
        given: usize,
    ) -> Step {
        self.files.learn_sbp(&self.sbp);
        self.files.translate_sbp(&mut out[given..]);
        match step {
            Step::Done(status, error) => self.failed(host, out, status, error),
            step => step,
        }
    }

    /// Opens the G-code that is due. A file with errors does not start.
    fn begin(&mut self, due: GcodeDue, out: &mut Vec<Sourced>) -> Result<(), Box<Diagnostic>> {
        let (file, at) = match due {
            GcodeDue::File(file) => (file, At { file, line: 1 }),
            GcodeDue::Line(at) => (at.file, at),
        };
        let program = self.library.of(file, &self.sbp);
        let here = self.files.of_sbp(file);
        if self.told.insert(file) {
            self.tell_faults(&program, due, At { file: here, ..at }, out)?;
        }
        self.tell_of_tabs(due, here, out);
        let interpreter = match due {
            GcodeDue::File(_) => self.file_interpreter(program),
            GcodeDue::Line(at) => self.line_interpreter(program, at),
        };
        self.guests.push(Guest::new(interpreter, due, self.sbp.depth(), here));
        Ok(())
    }

    /// Tabs are left in OpenSBP only: nobody shall find that out at the machine.
    fn tell_of_tabs(&self, due: GcodeDue, file: u32, out: &mut Vec<Sourced>) {
        if !matches!(due, GcodeDue::File(_)) || !self.sbp.file_place().tabs {
            return;
        }
        let name = self.files.name(file).unwrap_or_default();
        let message = "tabs are not left in G-code: this file is cut through";
        let diagnostic = Diagnostic::new(Code::NotSupported, SourcePlace::line(name, 1), message)
            .hint("kerf convert makes a part file of it, which FP runs with tabs")
            .severity(Severity::Warning);
        let command = kerf_program::Command::Diagnostic(Box::new(diagnostic));
        out.push(Sourced { at: At { file, line: 1 }, command });
    }

    /// Tells what is wrong with G-code that was just read; an error ends the run, unless a single
    /// line has it, which fails when it is reached.
    fn tell_faults(
        &mut self,
        program: &kerf_gcode::Program,
        due: GcodeDue,
        at: At,
        out: &mut Vec<Sourced>,
    ) -> Result<(), Box<Diagnostic>> {
        let fatal = matches!(due, GcodeDue::File(_)) && !self.options.allow_errors;
        for diagnostic in &program.diagnostics {
            if fatal && diagnostic.is_error() {
                return Err(Box::new(diagnostic.clone()));
            }
            let command = kerf_program::Command::Diagnostic(Box::new(diagnostic.clone()));
            out.push(Sourced { at, command });
        }
        Ok(())
    }

    fn file_interpreter(&self, program: Arc<kerf_gcode::Program>) -> kerf_gcode::Interpreter {
        kerf_gcode::Interpreter::new(program, self.gcode_session(), self.gcode_options())
    }

    /// The interpreter of the lines of a file, made ready for one of them.
    fn line_interpreter(
        &mut self,
        program: Arc<kerf_gcode::Program>,
        at: At,
    ) -> kerf_gcode::Interpreter {
        let known = self.lines.take().filter(|(file, _)| *file == at.file);
        let mut interpreter = known.map_or_else(
            || {
                let options = kerf_gcode::Options {
                    unit_known: true,
                    speeds_known: true,
                    keep_modes: self.options.typed,
                    stepped: false,
                    from: None,
                    ..self.gcode_options()
                };
                kerf_gcode::Interpreter::new(program, self.gcode_session(), options)
            },
            |(_, interpreter)| interpreter,
        );
        interpreter.adopt(self.sbp.settings(), self.sbp.frame(), self.sbp.position());
        interpreter.use_tools(self.sbp.tools());
        interpreter.enter_line(at.line);
        interpreter
    }

    fn gcode_session(&self) -> kerf_gcode::Session {
        let mut state = self.state.clone();
        state.use_tools(self.sbp.tools());
        kerf_gcode::Session {
            settings: (**self.sbp.settings()).clone(),
            frame: *self.sbp.frame(),
            position: self.sbp.position(),
            state,
        }
    }

    fn gcode_options(&self) -> kerf_gcode::Options {
        let place = self.sbp.file_place();
        let preview = self.options.preview || self.sbp.settings().mode == Mode::Preview;
        kerf_gcode::Options {
            max_lines: self.options.max_lines,
            lines_before: self.sbp.lines(),
            preview,
            ask_spindle: self.sbp.settings().ask_spindle,
            changes_elsewhere: self.sbp.settings().m6_runs_c9,
            proportion: place.proportion,
            temporary_zero_mm: place.zero_mm,
            stepped: place.stepped,
            from: place.from,
            ..self.gcode.clone()
        }
    }

    /// The innermost G-code is done: OpenSBP goes on from where it left the machine.
    fn end_guest(&mut self) {
        let Some(guest) = self.guests.pop() else { return };
        self.sbp.gcode_done(&guest.done());
        self.keep(guest);
    }

    fn keep(&mut self, guest: Guest) {
        self.state = guest.interpreter.state().clone();
        match guest.stale {
            true => self.state.use_tools(self.sbp.tools()),
            false => self.sbp.use_tools(self.state.tool_table()),
        }
        self.parameters = guest.interpreter.variables();
        if let GcodeDue::Line(at) = guest.due {
            self.lines = Some((at.file, guest.interpreter));
        }
    }

    /// G-code whose file a handler of ON INPUT has left does not go on.
    fn drop_left(&mut self) {
        while self.guests.last().is_some_and(|g| g.depth > self.sbp.depth()) {
            if let Some(guest) = self.guests.pop() {
                self.keep(guest);
            }
        }
    }

    /// Everything of G-code ends here.
    fn retire(&mut self) {
        while let Some(guest) = self.guests.last() {
            let done = GcodeDone { ended: false, ..guest.done() };
            if !guest.stale {
                self.sbp.gcode_done(&done);
            }
            if let Some(guest) = self.guests.pop() {
                self.keep(guest);
            }
        }
    }

    /// G-code ended the run.
    fn failed(
        &mut self,
        host: &mut dyn Host,
        out: &mut Vec<Sourced>,
        status: Status,
        mut error: Option<Box<Diagnostic>>,
    ) -> Step {
        if let Some(error) = &mut error {
            error.callers.extend(self.sbp.callers());
        }
        self.retire();
        let given = out.len();
        self.sbp.abandon(host, out);
        self.files.translate_sbp(&mut out[given..]);
        Step::Done(status, error)
    }
}

impl kerf_program::Interpreter for Interpreter {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        self.go(host, out, 1)
    }

    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        self.go(host, out, lines)
    }

    fn interrupt(&mut self, watch: &Watch, motion: Option<u64>, position: Axes) {
        let Some(guest) = self.guests.last_mut().filter(|g| !g.stale) else {
            return self.sbp.interrupt(watch, motion, position);
        };
        if guest.interpreter.watches().any(|w| w == watch) {
            return guest.interpreter.interrupt(watch, motion, position);
        }
        guest.interrupted(position);
        self.sbp.interrupt(watch, None, position);
    }

    fn nudge(&mut self, by: Axes) {
        self.sbp.nudge(by);
        self.guests.iter_mut().for_each(|g| g.interpreter.nudge(by));
    }

    fn carried_out(&mut self, motion: u64) {
        self.sbp.carried_out(motion);
    }

    fn stop(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        self.retire();
        self.sbp.stop(host, out)
    }

    fn limit(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        self.retire();
        self.sbp.limit(host, out)
    }

    fn watches(&self) -> Vec<Watch> {
        let probe = self.guests.last().into_iter().flat_map(|g| g.interpreter.watches());
        probe.chain(self.sbp.watches()).cloned().collect()
    }

    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        self.files.name(file)
    }

    fn file_call(&self, file: u32) -> Option<FileCall> {
        self.sbp.file_call(self.files.to_sbp(file)?)
    }

    fn call_stack(&self) -> Vec<At> {
        let here = |at: At| At { file: self.files.of_sbp(at.file), ..at };
        let mut open: Vec<At> = self.sbp.call_stack().map(here).collect();
        for guest in &self.guests {
            if let GcodeDue::File(_) = guest.due {
                let inner = open.split_off(guest.depth.min(open.len()));
                open.pop();
                open.extend(guest.call_stack());
                open.extend(inner);
            }
        }
        open
    }

    fn motions(&self) -> u64 {
        self.sbp.motions() + self.guests.iter().map(Guest::motions).sum::<u64>()
    }

    fn lines(&self) -> u64 {
        let file = |g: &&Guest| matches!(g.due, GcodeDue::File(_));
        self.sbp.lines() + self.guests.iter().filter(file).map(Guest::lines).sum::<u64>()
    }

    fn settings(&self) -> &Arc<Settings> {
        self.sbp.settings()
    }

    fn frame(&self) -> &Frame {
        match self.guests.last() {
            Some(guest) if !guest.stale => guest.interpreter.frame(),
            _ => self.sbp.frame(),
        }
    }

    fn position(&self) -> Axes {
        match self.guests.last() {
            Some(guest) if !guest.stale => guest.interpreter.position(),
            _ => self.sbp.position(),
        }
    }

    fn variables(&self) -> Vec<(String, String)> {
        let named = self.sbp.variables().list().into_iter().map(|(n, v)| (n, v.display()));
        let parameters = self.gcode_parameters();
        named.chain(parameters.into_iter().map(|(n, v)| (n, v.to_string()))).collect()
    }
}
