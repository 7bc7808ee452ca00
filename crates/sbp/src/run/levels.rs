//! Part files within part files: FP, custom cuts, repetitions, plunges.
//!
//! ```text
//!  call_file ──► open_level ──► lines … ──► file_over ──► repetitions left: plunge, first line
//!                  │ plunge                     └──────► none left: Z back, caller goes on
//! ```

use super::flow::{Level, Purpose};
use super::registry::PART_FILE;
use super::{Context, FileParameters, Stop};
use crate::{Language, Program};
use kerf_diag::{Code, Place};
use kerf_program::settings::PlungeSign;
use kerf_program::{Axis, Command, FileRequest, Folder, HostError, MoveKind, SourceFile};
use std::sync::Arc;

/// Files open within each other at most (programming handbook: eight levels, the first included).
pub(crate) const MOST_LEVELS: usize = 8;

impl Context<'_> {
    /// Reads a part file and opens it; its first line runs next. A file with errors does not start.
    pub(crate) fn call_file(
        &mut self,
        request: FileRequest,
        parameters: FileParameters,
    ) -> Result<(), Stop> {
        self.settle()?;
        if self.core.flow.levels.len() >= MOST_LEVELS {
            let message = format!("nested deeper than {MOST_LEVELS} files");
            return Err(self.fail(Code::NestedTooDeep, message));
        }
        let source = self.source(&request)?;
        let program = self.read_cached(&source)?;
        if request.folder == Folder::Parts {
            let path = self.host.full_path(&source.name);
            self.host.store(PART_FILE, Some(&path));
        }
        self.doubt_plunge(&program, &parameters);
        self.open_level(program, parameters);
        Ok(())
    }

    /// The file itself, or the one with `.sbp` (`.sbd` of settings) added when the name has no
    /// extension.
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, Stop> {
        let found = match self.host.source(request) {
            Err(HostError::NotFound(_)) if extension(&request.name).is_none() => {
                let usual = if request.folder == Folder::Settings { "sbd" } else { "sbp" };
                let name = format!("{}.{usual}", request.name);
                self.host.source(&FileRequest { folder: request.folder, name })
            }
            found => found,
        };
        let source = found.map_err(|e| self.refused(e))?;
        Ok(source)
    }

    /// The program of a file; what is doubtful in it is told when it is first read.
    fn read_cached(&mut self, source: &SourceFile) -> Result<Arc<Program>, Stop> {
        let same = |p: &&Arc<Program>| p.name == source.name && p.text.as_bytes() == &*source.bytes;
        if let Some(known) = self.core.files.programs.iter().find(same).cloned() {
            return Ok(known);
        }
        let program =
            crate::read_part_as(source.name.clone(), &*source.bytes, self.core.options.dialect);
        if program.language == Language::Gcode {
            self.need_gcode(&format!("{}: G-code files cannot be run here", source.name))?;
        }
        let fatal = !self.core.options.allow_errors;
        let mut first = None;
        for mut diagnostic in program.diagnostics.iter().cloned() {
            diagnostic.callers = self.callers_of_called();
            if fatal && first.is_none() && diagnostic.is_error() {
                first = Some(diagnostic);
            } else {
                self.emit(Command::Diagnostic(Box::new(diagnostic)));
            }
        }
        match first {
            Some(error) => Err(Stop::Failed(Box::new(error))),
            None => Ok(Arc::new(program)),
        }
    }

    /// The present line and those that led to it: the callers of a file that is about to be opened.
    fn callers_of_called(&self) -> Vec<Place> {
        let mut callers = self.callers();
        callers.insert(0, self.program.place(self.at.line, self.span));
        callers
    }

    /// Opens a file that was read; its first line runs next.
    pub(crate) fn open_level(&mut self, program: Arc<Program>, mut parameters: FileParameters) {
        let (proportion, offset, tabs, stepped) = match self.core.flow.level() {
            Some(l) => (l.proportion, l.offset, l.tabs_hold(), l.stepped),
            None => ([1.0; 3], [0.0; 3], false, false),
        };
        // The plunge is a distance of the file that calls, so its proportion holds.
        parameters.plunge_mm *= proportion[2];
        let place = self.core.place.working().minus(self.core.place.offset_applied).first3();
        let offset = match parameters.offset {
            1 => place,
            2 => [place[0], place[1], offset[2]],
            _ => offset,
        };
        if self.core.flow.levels.len() == self.files_begin_at()
            && self.core.place.before_preview.is_some()
        {
            self.core.values.looked_at = Some(self.core.values.settings.clone());
        }
        let start_z = self.plunge_start(&parameters);
        let file = self.core.load(program);
        self.core.flow.calls.insert(file, parameters.call());
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
            tabs: tabs || parameters.tabs,
            purpose: Purpose::Run,
        };
        // G-code is taken up by whoever runs it.
        if let Some(to) = parameters.from.filter(|_| !self.core.files.is_gcode(&level)) {
            level.go_to(to);
        }
        self.core.flow.levels.push(level);
        self.core.refresh_scale();
        self.plunge();
        self.refresh_tabs();
    }

    /// Z before the first plunge when the file is to be plunged; moves to Z 0 when asked to.
    fn plunge_start(&mut self, parameters: &FileParameters) -> Option<f64> {
        if parameters.plunge_mm == 0.0 && !parameters.plunge_from_zero {
            return None;
        }
        let start = self.core.place.position[Axis::Z];
        if parameters.plunge_from_zero {
            let zero = self.core.file_zero(Axis::Z);
            self.move_z(zero);
        }
        Some(start)
    }

    /// One plunge of the innermost file, at Z move speed.
    fn plunge(&mut self) {
        let Some(level) = self.core.flow.level() else { return };
        let rise = level.parameters.plunge_mm;
        if rise != 0.0 {
            let z = self.core.place.position[Axis::Z] + rise;
            self.move_z(z);
        }
    }

    fn move_z(&mut self, machine_z: f64) {
        let mut to = self.core.place.position;
        to[Axis::Z] = machine_z;
        self.line(MoveKind::Cut, to);
    }

    /// Tells of a plunge that lifts. The sign of VC says which way is down; it turns nothing round.
    pub(crate) fn doubt_lift(&mut self, plunge_mm: f64) {
        let lifts = match self.settings().cutter.plunge {
            PlungeSign::Minus => plunge_mm > 0.0,
            PlungeSign::Plus => plunge_mm < 0.0,
        };
        if lifts {
            let hint = "plunges are negative unless VC says that Z counts downwards";
            self.warn(Code::Lifts, "this plunge lifts the tool", hint);
        }
    }

    /// Tells of a plunge that lifts, and of one into a file that moves Z itself.
    pub(crate) fn doubt_plunge(&mut self, program: &Program, parameters: &FileParameters) {
        if parameters.plunge_mm == 0.0 {
            return;
        }
        self.doubt_lift(parameters.plunge_mm);
        if super::z_moves::moves_z(program) {
            let message =
                format!("{} has Z moves; plunge passes will not be correct", program.name);
            self.warn(Code::Unusual, message, "call it several times with growing Z proportions");
        }
    }

    /// The innermost file came to its end: repeat it, or go back to its caller.
    pub(crate) fn file_over(&mut self) {
        let Some(level) = self.core.flow.levels.last_mut() else { return };
        level.gosubs.clear();
        if let Purpose::Handler(home) = level.purpose {
            self.leave_levels(home);
            self.end_file();
        } else if level.repetitions_left > 0 {
            level.repetitions_left -= 1;
            level.next = 0;
            self.plunge();
            self.refresh_tabs();
        } else {
            let start_z = level.start_z;
            self.leave_levels(self.core.flow.levels.len() - 1);
            if let Some(z) = start_z {
                self.move_z(z);
            }
        }
    }

    /// END: the innermost file is over.
    pub(crate) fn end_file(&mut self) {
        let Some(level) = self.core.flow.levels.last_mut() else { return };
        let lines = self.core.files.programs.get(level.file as usize).map_or(0, |p| p.lines.len());
        level.next = lines as u32;
    }

    /// Closes files until only so many are open.
    pub(crate) fn leave_levels(&mut self, depth: usize) {
        while self.core.flow.levels.len() > depth {
            let left = self.core.flow.levels.pop();
            if left.is_some_and(|l| l.purpose == Purpose::ToolChange) {
                self.emit(Command::ToolChange { begin: false });
            }
        }
        if depth <= self.files_begin_at() {
            self.end_look();
        }
        self.core.refresh_scale();
        self.refresh_tabs();
    }

    /// Returns the number of levels that are open before a file is: that of what was typed.
    fn files_begin_at(&self) -> usize {
        usize::from(self.core.options.typed)
    }

    /// Starts or ends tabs after VB, a file or a repetition changed whether they hold.
    pub(crate) fn refresh_tabs(&mut self) {
        let by_file = self.core.flow.level().is_some_and(Level::tabs_hold);
        let wanted = self.core.values.settings.tabs.on || by_file;
        if wanted == self.core.cutting.tabs.is_some() {
            return;
        }
        if !wanted {
            self.end_tabs();
            return;
        }
        let mut tabs = self.core.values.settings.tabs;
        if !tabs.on {
            tabs.count = None;
            tabs.start_mm = None;
        }
        self.core.cutting.tabs =
            Some(kerf_cut::Tabber::new(&tabs, self.core.values.settings.cutter.safe_z_mm));
    }
}

/// Returns the text behind the last point of a file name, unless a folder's name holds it.
fn extension(name: &str) -> Option<&str> {
    let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
    file.rsplit_once('.').map(|(_, extension)| extension)
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
