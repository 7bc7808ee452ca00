//! Part files within part files: FP, custom cuts, repetitions, plunges.
//!
//! ```text
//!  call_file ──► open_level ──► lines … ──► file_over ──► repetitions left: plunge, first line
//!                  │ plunge                     └──────► none left: Z back, caller goes on
//! ```

use super::registry::PART_FILE;
use super::state::{Level, Purpose};
use super::{Context, FileParameters, Stop, cutting, preview, tool_changes};
use crate::{Language, Program};
use kerf_diag::{Code, SourcePlace};
use kerf_program::settings::PlungeSign;
use kerf_program::{Axis, Command, FileRequest, Folder, HostError, MoveKind, SourceFile};
use std::sync::Arc;

/// Files open within each other at most (programming handbook: eight levels, the first included).
pub(crate) const MOST_LEVELS: usize = 8;

/// Reads a part file and opens it; its first line runs next. A file with errors does not start.
pub(crate) fn call_file(
    c: &mut Context<'_>,
    request: FileRequest,
    parameters: FileParameters,
) -> Result<(), Stop> {
    c.settle()?;
    if c.core.flow.levels.len() >= MOST_LEVELS {
        let message = format!("nested deeper than {MOST_LEVELS} files");
        return Err(c.fail(Code::NestedTooDeep, message));
    }
    let source = source(c, &request)?;
    let program = read_cached(c, &source)?;
    if request.folder == Folder::Parts {
        let path = c.host.full_path(&source.name);
        c.host.store(PART_FILE, Some(&path));
    }
    doubt_plunge(c, &program, &parameters);
    open_level(c, program, parameters);
    Ok(())
}

/// The file itself, or the one with `.sbp` (`.sbd` of settings) added when the name has no
/// extension.
fn source(c: &mut Context<'_>, request: &FileRequest) -> Result<SourceFile, Stop> {
    let found = match c.host.source(request) {
        Err(HostError::NotFound(_)) if extension(&request.name).is_none() => {
            let usual = if request.folder == Folder::Settings { "sbd" } else { "sbp" };
            let name = format!("{}.{usual}", request.name);
            c.host.source(&FileRequest { folder: request.folder, name })
        }
        found => found,
    };
    let source = found.map_err(|e| c.refused(e))?;
    Ok(source)
}

/// The program of a file; what is doubtful in it is told when it is first read.
fn read_cached(c: &mut Context<'_>, source: &SourceFile) -> Result<Arc<Program>, Stop> {
    let same = |p: &&Arc<Program>| p.name == source.name && p.text.as_bytes() == &*source.bytes;
    if let Some(known) = c.core.files.programs.iter().find(same).cloned() {
        return Ok(known);
    }
    let program = crate::read_part_as(source.name.clone(), &*source.bytes, c.core.options.dialect);
    if program.language == Language::Gcode {
        need_gcode(c, &format!("{}: G-code files cannot be run here", source.name))?;
    }
    let fatal = !c.core.options.allow_errors;
    let mut first = None;
    for mut diagnostic in program.diagnostics.iter().cloned() {
        diagnostic.callers = callers_of_called(c);
        if fatal && first.is_none() && diagnostic.is_error() {
            first = Some(diagnostic);
        } else {
            c.emit(Command::Diagnostic(Box::new(diagnostic)));
        }
    }
    match first {
        Some(error) => Err(Stop::Failed(Box::new(error))),
        None => Ok(Arc::new(program)),
    }
}

/// The present line and those that led to it: the callers of a file that is about to be opened.
fn callers_of_called(c: &Context<'_>) -> Vec<SourcePlace> {
    let mut callers = c.callers();
    callers.insert(0, c.program.place(c.at.line, c.span));
    callers
}

/// Opens a file that was read; its first line runs next.
pub(crate) fn open_level(
    c: &mut Context<'_>,
    program: Arc<Program>,
    mut parameters: FileParameters,
) {
    let (proportion, offset, tabs, stepped) = match c.core.flow.level() {
        Some(l) => (l.proportion, l.offset, l.tabs_hold(), l.stepped),
        None => ([1.0; 3], [0.0; 3], false, false),
    };
    // The plunge is a distance of the file that calls, so its proportion holds.
    parameters.plunge_mm *= proportion[2];
    let place = c.core.place.working().minus(c.core.place.offset_applied).first3();
    let offset = match parameters.offset {
        1 => place,
        2 => [place[0], place[1], offset[2]],
        _ => offset,
    };
    if c.core.flow.levels.len() == files_begin_at(c) && c.core.place.before_preview.is_some() {
        c.core.values.looked_at = Some(c.core.values.settings.clone());
    }
    let start_z = plunge_start(c, &parameters);
    let file = c.core.load(program);
    c.core.flow.calls.insert(file, parameters.call());
    let mut level = Level {
        file,
        next: 0,
        gosubs: Vec::new(),
        gosub_left: false,
        proportion: std::array::from_fn(|i| proportion[i] * parameters.proportion[i]),
        offset,
        parameters,
        repetitions_left: parameters.repetitions.saturating_sub(1),
        start_z,
        stepped: stepped || parameters.stepped,
        skip_to: None,
        goes_on: None,
        tabs: tabs || parameters.tabs,
        purpose: Purpose::Run,
    };
    // G-code is taken up by whoever runs it.
    if let Some(to) = parameters.from.filter(|_| !c.core.files.is_gcode(&level)) {
        level.go_to(to);
    }
    c.core.flow.levels.push(level);
    c.core.refresh_scale();
    plunge(c);
    refresh_tabs(c);
}

/// Z before the first plunge when the file is to be plunged; moves to Z 0 when asked to.
fn plunge_start(c: &mut Context<'_>, parameters: &FileParameters) -> Option<f64> {
    if parameters.plunge_mm == 0.0 && !parameters.plunge_from_zero {
        return None;
    }
    let start = c.core.place.position[Axis::Z];
    if parameters.plunge_from_zero {
        let zero = c.core.file_zero(Axis::Z);
        move_z(c, zero);
    }
    Some(start)
}

/// One plunge of the innermost file, at Z move speed.
fn plunge(c: &mut Context<'_>) {
    let Some(level) = c.core.flow.level() else { return };
    let rise = level.parameters.plunge_mm;
    if rise != 0.0 {
        let z = c.core.place.position[Axis::Z] + rise;
        move_z(c, z);
    }
}

fn move_z(c: &mut Context<'_>, machine_z: f64) {
    let mut to = c.core.place.position;
    to[Axis::Z] = machine_z;
    cutting::line(c, MoveKind::Cut, to);
}

/// Tells of a plunge that lifts. The sign of VC says which way is down; it turns nothing round.
pub(crate) fn doubt_lift(c: &mut Context<'_>, plunge_mm: f64) {
    let lifts = match c.settings().cutter.plunge {
        PlungeSign::Minus => plunge_mm > 0.0,
        PlungeSign::Plus => plunge_mm < 0.0,
    };
    if lifts {
        let hint = "plunges are negative unless VC says that Z counts downwards";
        c.warn(Code::Lifts, "this plunge lifts the tool", hint);
    }
}

/// Tells of a plunge that lifts, and of one into a file that moves Z itself.
pub(crate) fn doubt_plunge(c: &mut Context<'_>, program: &Program, parameters: &FileParameters) {
    if parameters.plunge_mm == 0.0 {
        return;
    }
    doubt_lift(c, parameters.plunge_mm);
    if super::z_moves::moves_z(program) {
        let message = format!("{} has Z moves; plunge passes will not be correct", program.name);
        c.warn(Code::Unusual, message, "call it several times with growing Z proportions");
    }
}

/// The innermost file came to its end: repeat it, or go back to its caller.
pub(crate) fn file_over(c: &mut Context<'_>) {
    let Some(level) = c.core.flow.levels.last_mut() else { return };
    level.gosubs.clear();
    if let Purpose::Handler(home) = level.purpose {
        leave_levels(c, home);
        end_file(c);
    } else if level.repetitions_left > 0 {
        level.repetitions_left -= 1;
        level.next = 0;
        plunge(c);
        refresh_tabs(c);
    } else {
        let (start_z, goes_on) = (level.start_z, level.goes_on);
        if level.purpose == Purpose::ToolChange {
            tool_changes::end(c);
        }
        leave_levels(c, c.core.flow.levels.len() - 1);
        c.core.flow.gcode_line = goes_on;
        if let Some(z) = start_z {
            move_z(c, z);
        }
    }
}

/// END: the innermost file is over.
pub(crate) fn end_file(c: &mut Context<'_>) {
    let Some(level) = c.core.flow.levels.last_mut() else { return };
    let lines = c.core.files.programs.get(level.file as usize).map_or(0, |p| p.lines.len());
    level.next = lines as u32;
}

/// Closes files until only so many are open.
pub(crate) fn leave_levels(c: &mut Context<'_>, depth: usize) {
    while c.core.flow.levels.len() > depth {
        let left = c.core.flow.levels.pop();
        if left.is_some_and(|l| l.purpose == Purpose::ToolChange) {
            c.emit(Command::ToolChange { begin: false });
        }
    }
    if depth <= files_begin_at(c) {
        preview::end_look(c);
    }
    c.core.refresh_scale();
    refresh_tabs(c);
}

/// Returns the number of levels that are open before a file is: that of what was typed.
fn files_begin_at(c: &Context<'_>) -> usize {
    usize::from(c.core.options.typed)
}

/// Starts or ends tabs after VB, a file or a repetition changed whether they hold.
pub(crate) fn refresh_tabs(c: &mut Context<'_>) {
    let by_file = c.core.flow.level().is_some_and(Level::tabs_hold);
    let wanted = c.core.values.settings.tabs.on || by_file;
    if wanted == c.core.cutting.tabs.is_some() {
        return;
    }
    if !wanted {
        cutting::end_tabs(c);
        return;
    }
    let mut tabs = c.core.values.settings.tabs;
    if !tabs.on {
        tabs.count = None;
        tabs.start_mm = None;
    }
    c.core.cutting.tabs =
        Some(kerf_cut::Tabber::new(&tabs, c.core.values.settings.cutter.safe_z_mm));
}

/// Returns the text behind the last point of a file name, unless a folder's name holds it.
fn extension(name: &str) -> Option<&str> {
    let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
    file.rsplit_once('.').map(|(_, extension)| extension)
}

/// Fails where nobody runs G-code.
pub(super) fn need_gcode(c: &Context<'_>, message: &str) -> Result<(), Stop> {
    let runs = c.core.options.gcode;
    if runs { Ok(()) } else { Err(c.fail(Code::NotSupported, message)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_extension_belongs_to_the_file_not_to_its_folder() {
        let cases =
            [("a.sbp", Some("sbp")), ("x.y\\a", None), ("x.y/a", None), ("a.b.nc", Some("nc"))];
        for (name, expected) in cases {
            assert_eq!(extension(name), expected, "{name}");
        }
    }
}
