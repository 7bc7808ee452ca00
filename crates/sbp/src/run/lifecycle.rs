//! Beginning and end of a run.

use super::registry::{CLEARED_VALUE, PART_FILE};
use super::{Context, Core, Stop, cutting, levels, locate, user_files};
use crate::syntax::Dialect;
use crate::tree::Span;
use kerf_diag::Code;
use kerf_program::{At, Command, Host, Sourced};
use kerf_program::{Status, Step};

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
            finish(core, host, out);
            Step::Done(Status::Failed, Some(diagnostic))
        }
        Err(Stop::Finished(status)) => {
            finish(core, host, out);
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
    let program = &core.files.program(at.file);
    let context = Context { core, program, host, out, at, span: Span::default() };
    let diagnostic = context
        .diagnostic(Span::default(), Code::LineLimit, format!("stopped after {bound} lines"))
        .hint("is there a loop that never ends? --max-lines raises the bound");
    finish(core, host, out);
    Step::Done(Status::Limit, Some(Box::new(diagnostic)))
}

/// A loop was found in which nothing changes.
pub(super) fn endless(
    core: &mut Core,
    host: &mut dyn Host,
    out: &mut Vec<Sourced>,
    at: At,
) -> Step {
    let program = &core.files.program(at.file);
    let context = Context { core, program, host, out, at, span: Span::default() };
    let message = "endless loop: this line comes again and again, and nothing has changed since";
    let diagnostic = context.diagnostic(Span::default(), Code::LineLimit, message).hint(
        "let the loop move, wait with PAUSE, change a variable, or leave it with IF ... THEN GOTO",
    );
    finish(core, host, out);
    Step::Done(Status::Limit, Some(Box::new(diagnostic)))
}

/// A file of G-code was started where nobody runs it.
pub(super) fn no_gcode(
    core: &mut Core,
    host: &mut dyn Host,
    out: &mut Vec<Sourced>,
    at: At,
) -> Step {
    let program = &core.files.program(at.file);
    let context = Context { core, program, host, out, at, span: Span::default() };
    let failed = context.fail(Code::NotSupported, "G-code files cannot be run here");
    after(core, host, out, Err(failed))
}

/// Opens the file the operator started, with the parameters of FP.
pub(super) fn start(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    core.flow.started = true;
    let Some(first) = core.files.programs.first().cloned() else { return end(core, host, out) };
    host.store(CLEARED_VALUE, None);
    if !core.options.typed {
        let path = host.full_path(&first.name);
        host.store(PART_FILE, Some(&path));
    }
    let parameters = core.options.file;
    let at = At { file: 0, line: 0 };
    let mut context = Context { core, program: &first, host, out, at, span: Span::default() };
    levels::doubt_plunge(&mut context, &first, &parameters);
    levels::open_level(&mut context, first.clone(), parameters);
    Step::Ran
}

/// The last line of the innermost file was executed, or END.
pub(super) fn end_of_file(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    let Some(level) = core.flow.levels.last() else { return end(core, host, out) };
    let at = At { file: level.file, line: level.next };
    let empty = level.next == 0 || core.files.is_gcode(level);
    if empty && level.repetitions_left > 0 {
        // Without lines in the file nothing else would bound the repetitions.
        core.given.lines += 1;
        if core.options.max_lines > 0 && core.given.lines >= core.options.max_lines {
            return too_many_lines(core, host, out, At { line: 1, ..at });
        }
    }
    let program = &core.files.program(at.file);
    let mut context = Context { core, program, host, out, at, span: Span::default() };
    levels::file_over(&mut context);
    Step::Ran
}

/// The outermost file is over: once all motion is made, so is the run. Until then handlers live.
pub(super) fn end(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
    let at = At::default();
    let program = &core.files.program(at.file);
    let mut context = Context { core, program, host, out, at, span: Span::default() };
    let outcome = end_run(&mut context, Status::Ok);
    after(core, host, out, Err(outcome))
}

/// Ends the run: closes files, disarms handlers, gives temporary values back.
pub(super) fn finish(core: &mut Core, host: &mut dyn Host, out: &mut Vec<Sourced>) {
    let at = core.flow.levels.last().map_or(At::default(), |l| At { file: l.file, line: l.next });
    let program = &core.files.program(at.file);
    let mut context = Context { core, program, host, out, at, span: Span::default() };
    // What is still buffered for tabs never moves: after an error, a stop or a limit.
    context.core.cutting.tabs = None;
    user_files::close_user_files(&mut context);
    context.core.handlers.disarm();
    locate::use_working_locations(&mut context);
    if !context.core.options.typed {
        restore_temporary(&mut context);
    }
    levels::leave_levels(&mut context, 0);
    context.host.store(CLEARED_VALUE, None);
}

/// Waits until all motion is made, then ends the run.
pub(super) fn end_run(c: &mut Context<'_>, status: Status) -> Stop {
    cutting::end_tabs(c);
    c.settle().err().unwrap_or(Stop::Finished(status))
}

/// EXIT SHOPBOT: as the end of everything, and whoever looks is told why Kerf closes.
pub(super) fn exit(c: &mut Context<'_>) -> Stop {
    let over = end_run(c, Status::Ended);
    if matches!(over, Stop::Finished(_)) {
        c.core.flow.closes = true;
        c.emit(Command::Message { text: "closed by part file".into() });
    }
    over
}

/// VS, VI, VU and limits go back to what they were; VO and the VC trigger end (readings, A-91).
fn restore_temporary(c: &mut Context<'_>) {
    let kept = c.core.values.kept.clone();
    let unit = (c.core.options.dialect == Dialect::Fabmo).then_some(kept.linear_unit);
    c.change_settings(|s| {
        // SU holds for the run.
        if let Some(unit) = unit {
            s.use_linear_unit(unit);
        }
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
    c.core.place.offset_applied = Default::default();
}
