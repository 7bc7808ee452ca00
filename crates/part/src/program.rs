//! A part file that was read.

use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_sbp::{Dialect, Language};
use std::borrow::Cow;
use std::sync::Arc;

/// A part file: OpenSBP, G-code, or lines of both.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The file as OpenSBP sees it.
    pub sbp: kerf_sbp::Program,
    /// The G-code in it, each line at its own place; `None` where there is none.
    pub gcode: Option<Arc<kerf_gcode::Program>>,
    /// Everything wrong or doubtful, in order of lines.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a part file; its ending and its lines say in which language.
pub fn read<'a>(name: Arc<str>, bytes: impl Into<Cow<'a, [u8]>>) -> Program {
    told_empty(kerf_sbp::read_part(name, bytes).into())
}

/// The same, OpenSBP written in a dialect.
pub fn read_as<'a>(name: Arc<str>, bytes: impl Into<Cow<'a, [u8]>>, dialect: Dialect) -> Program {
    told_empty(kerf_sbp::read_part_as(name, bytes, dialect).into())
}

/// A file in which nothing stands is hardly what was meant.
fn told_empty(mut program: Program) -> Program {
    if program.diagnostics.is_empty() && program.sbp.text.trim().is_empty() {
        let place = SourcePlace::line(program.name().clone(), 1);
        let empty = Diagnostic::new(Code::EmptyFile, place, "the file is empty");
        program.diagnostics.push(empty.hint("save it again where it was made"));
    }
    program
}

impl From<kerf_sbp::Program> for Program {
    fn from(sbp: kerf_sbp::Program) -> Self {
        let gcode = gcode_of(&sbp);
        let mut diagnostics = sbp.diagnostics.clone();
        if let Some(gcode) = &gcode {
            diagnostics.extend(gcode.diagnostics.iter().cloned());
            diagnostics.sort_by_key(|d| d.place.line);
        }
        Self { sbp, gcode: gcode.map(Arc::new), diagnostics }
    }
}

/// The G-code of a file, read.
pub(crate) fn gcode_of(sbp: &kerf_sbp::Program) -> Option<kerf_gcode::Program> {
    if sbp.language == Language::Gcode {
        return Some(kerf_gcode::read_text(sbp.name.clone(), sbp.text.clone()));
    }
    sbp.has_gcode().then(|| kerf_gcode::read_text(sbp.name.clone(), sbp.gcode_text().into()))
}

impl Program {
    /// Name shown to people.
    pub const fn name(&self) -> &Arc<str> {
        &self.sbp.name
    }

    /// Returns the language of its lines.
    pub const fn language(&self) -> Language {
        self.sbp.language
    }

    /// Returns the number of its lines.
    pub fn line_count(&self) -> usize {
        let gcode = self.gcode.as_ref().map_or(0, |g| g.line_count() as usize);
        gcode.max(self.sbp.lines.len())
    }

    /// True when something is wrong with the file.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}
