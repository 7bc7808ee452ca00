//! How files and runs begin and end.

use super::core::Level;
use super::{Context, Core, FileParameters, Status, Step, Stop};
use crate::Program;
use crate::tree::Span;
use kerf_diag::{Code, Diagnostic};
use kerf_program::{At, Axis, Command, FileOp, Host, MoveKind, Sourced};
use std::sync::Arc;

/// Files open within each other at most (programming handbook: eight levels, the first included).
pub(crate) const MOST_LEVELS: usize = 8;

/// GOSUBs within each other at most, in one file.
pub(crate) const MOST_GOSUBS: usize = 10_000;

/// Turns the outcome of a line into a step.
pub(super) fn after(
    core: &mut Core,
    host: &mut dyn Host,
    out: &mut Vec<Sourced>,
    outcome: Result<(), Stop>,
) -> Step {
    match outcome {
        Ok(()) => Step::Ran,
        Err(Stop::Waiting) => Step::Waiting,
        Err(Stop::Failed(diagnostic)) => {
            drop_tabs(core);
            finish(core, host, out, Status::Failed);
            Step::Done(Status::Failed, Some(diagnostic))
        }
        Err(Stop::Finished(status)) => {
            finish(core, host, out, status);
            Step::Done(status, None)
        }
    }
}

/// The bound of executed lines was reached.
pub(super) fn too_many_lines(
    core: &mut Core,
    host: &mut dyn Host,
    out: &mut Vec<Sourced>,
    at: At,
) -> Step {
    let bound = core.options.max_lines;
    let context = Context { core, host, out, at, span: Span::default() };
    let diagnostic = context
        .diagnostic(Span::default(), Code::LineLimit, format!("stopped after {bound} lines"))
        .hint("is there a loop that never ends? --max-lines raises the bound");
    finish(core, host, out, Status::Limit);
    Step::Done(Status::Limit, Some(Box::new(diagnostic)))
}

/// Opens the file the operator started, with the parameters of FP.
pub(super) fn start(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    core.started = true;
    let Some(program) = core.programs.first().cloned() else { return end(core, host, out) };
    let parameters = core.options.file;
    let mut context =
        Context { core, host, out, at: At { file: 0, line: 0 }, span: Span::default() };
    let outcome = context.open_level(program, parameters);
    after(core, host, out, outcome)
}

/// The last line of the innermost file was executed, or END.
pub(super) fn end_of_file(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    let Some(level) = core.levels.last() else { return end(core, host, out) };
    let at = At { file: level.file, line: level.next };
    let mut context = Context { core, host, out, at, span: Span::default() };
    match context.repetition_over() {
        Ok(()) => Step::Ran,
        Err(Stop::Waiting) => Step::Waiting,
        Err(_) => end(core, host, out),
    }
}

/// The run is over without an error.
pub(super) fn end(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    finish(core, host, out, Status::Ok);
    Step::Done(Status::Ok, None)
}

/// What was buffered for tabs never moves after an error.
fn drop_tabs(core: &mut Core) {
    if let Some(mut tabs) = core.tabs.take() {
        tabs.drop_buffered();
    }
}

/// Ends the run: closes files, disarms handlers, gives temporary values back.
pub(super) fn finish(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>, status: Status) {
    let at = core.levels.last().map_or(At::default(), |l| At { file: l.file, line: l.next });
    let mut context = Context { core, host, out, at, span: Span::default() };
    if status == Status::Ok || status == Status::Ended {
        context.end_tabs();
    } else {
        drop_tabs(context.core);
    }
    context.close_user_files();
    context.core.watches.clear();
    context.core.fired.clear();
    context.core.levels.clear();
    context.restore_temporary();
    context.host.store(CLEARED_VALUE, None);
}

/// Key of the value of SetUsrValClrd.
pub(crate) const CLEARED_VALUE: &str = "uValueClrd";

impl Context<'_> {
    /// Opens a file that was read; its first line runs next.
    pub(crate) fn open_level(
        &mut self,
        program: Arc<Program>,
        parameters: FileParameters,
    ) -> Result<(), Stop> {
        if self.core.levels.len() >= MOST_LEVELS {
            let message = format!("nested deeper than {MOST_LEVELS} files");
            return Err(self.fail(Code::NestedTooDeep, message));
        }
        let working = self.core.working();
        let (proportion, offset, tabs) = match self.core.level() {
            Some(l) => (l.proportion, l.offset, l.tabs),
            None => ([1.0; 3], [0.0; 3], false),
        };
        let place = working.first3();
        let offset = match parameters.offset {
            1 => place,
            2 => [place[0], place[1], offset[2]],
            _ => offset,
        };
        let start_z = self.plunge_start(&parameters);
        let file = self.core.load(program);
        self.core.levels.push(Level {
            file,
            next: 0,
            gosubs: Vec::new(),
            proportion: std::array::from_fn(|i| proportion[i] * parameters.proportion[i]),
            offset,
            parameters,
            repetitions_left: parameters.repetitions.saturating_sub(1),
            start_z,
            tabs: tabs || parameters.tabs,
        });
        self.core.refresh_scale();
        self.plunge();
        self.refresh_tabs();
        Ok(())
    }

    /// Z before the first plunge when the file is to be plunged; moves to Z 0 when asked to.
    fn plunge_start(&mut self, parameters: &FileParameters) -> Option<f64> {
        if parameters.plunge_mm == 0.0 && !parameters.plunge_from_zero {
            return None;
        }
        let start = self.core.position[Axis::Z];
        if parameters.plunge_from_zero {
            let zero = self.core.file_zero(Axis::Z);
            self.move_z(zero);
        }
        Some(start)
    }

    /// One plunge of the innermost file, at Z move speed.
    fn plunge(&mut self) {
        let Some(level) = self.core.level() else { return };
        let depth = level.parameters.plunge_mm;
        if depth != 0.0 {
            let z = self.core.position[Axis::Z] + depth;
            self.move_z(z);
        }
    }

    fn move_z(&mut self, machine_z: f64) {
        let mut to = self.core.position;
        to[Axis::Z] = machine_z;
        self.line(MoveKind::Cut, to);
    }

    /// The innermost file came to its end: repeat it, or go back to its caller.
    fn repetition_over(&mut self) -> Result<(), Stop> {
        let Some(level) = self.core.levels.last_mut() else { return Ok(()) };
        level.gosubs.clear();
        if level.repetitions_left > 0 {
            level.repetitions_left -= 1;
            level.next = 0;
            self.plunge();
            self.refresh_tabs();
            return Ok(());
        }
        if let Some(z) = level.start_z.take() {
            self.move_z(z);
        }
        self.core.levels.pop();
        self.core.refresh_scale();
        self.refresh_tabs();
        Ok(())
    }

    /// END: the innermost file is over.
    pub(crate) fn end_file(&mut self) {
        if let Some(level) = self.core.levels.last_mut() {
            level.next = u32::MAX;
        }
    }

    /// Starts or ends tabs after VB, a file or a repetition changed whether they hold.
    pub(crate) fn refresh_tabs(&mut self) {
        let by_file = self.core.level().is_some_and(|l| l.tabs && l.repetitions_left == 0);
        let wanted = self.core.settings.tabs.on || by_file;
        if wanted == self.core.tabs.is_some() {
            return;
        }
        if wanted {
            let mut tabs = self.core.settings.tabs;
            if !self.core.settings.tabs.on {
                tabs.count = None;
                tabs.start_mm = None;
            }
            self.core.tabs =
                Some(kerf_cut::Tabber::new(&tabs, self.core.settings.cutter.safe_z_mm));
        } else {
            self.end_tabs();
        }
    }

    fn close_user_files(&mut self) {
        for number in 1..=9u8 {
            if let Some(file) = self.core.files[usize::from(number) - 1].take() {
                // Nothing can be done about a file that does not close; the host has told.
                let _ = self.host.close(number);
                self.emit(Command::File { op: FileOp::Close, path: file.path });
            }
        }
    }

    /// VS, VI, VU and limits go back to what they were; VO and the VC trigger end.
    fn restore_temporary(&mut self) {
        let kept = self.core.kept.clone();
        self.change_settings(|s| {
            s.speeds = kept.speeds;
            s.driver = kept.driver;
            s.resolution = kept.resolution;
            s.limits = kept.limits;
            s.io.limits_active = kept.io.limits_active;
            s.tool_offset.on = false;
            s.cutter.trigger.active = false;
            s.tabs.on = false;
            s.tabs.count = None;
            s.tabs.start_mm = None;
        });
        self.core.offset_applied = Default::default();
    }

    /// Reads a part file and opens it; a file with errors does not start.
    pub(crate) fn call_file(
        &mut self,
        request: &kerf_program::FileRequest,
        parameters: FileParameters,
    ) -> Result<(), Stop> {
        self.settle()?;
        let source = self.host.source(request).map_err(|e| self.refused(e))?;
        let program = self.read_cached(&source);
        if program.has_errors() && !self.core.options.allow_errors {
            return Err(self.faulty(&program));
        }
        self.open_level(program, parameters)
    }

    fn read_cached(&self, source: &kerf_program::SourceFile) -> Arc<Program> {
        let same = |p: &&Arc<Program>| p.name == source.name && p.text.as_bytes() == &*source.bytes;
        match self.core.programs.iter().find(same) {
            Some(known) => known.clone(),
            None => Arc::new(crate::read(source.name.clone(), &source.bytes)),
        }
    }

    fn faulty(&mut self, program: &Program) -> Stop {
        for d in program.diagnostics.iter().filter(|d| d.is_error()).skip(1) {
            self.emit(Command::Diagnostic(Box::new(d.clone())));
        }
        let first = program.diagnostics.iter().find(|d| d.is_error()).cloned();
        let mut diagnostic: Diagnostic = first
            .unwrap_or_else(|| self.diagnostic(self.span, Code::Syntax, "the file has errors"));
        let here = self.program().place(self.at.line, self.span);
        diagnostic.callers.insert(0, here);
        Stop::Failed(Box::new(diagnostic))
    }
}
