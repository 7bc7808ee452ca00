//! The parts of a program as they are gathered while its file is read.

use super::index::CommandIndex;
use super::labels::Labels;
use super::names::Names;
use crate::syntax::Dialect;
use crate::syntax::tree::{NameId, Program};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use std::sync::Arc;

/// Diagnostics that are kept; a file that is no part file would give millions.
pub(super) const MOST_DIAGNOSTICS: usize = 10_000;

/// A file while it is read.
#[derive(Debug)]
pub(super) struct File {
    /// What was read so far; names and labels come at the end.
    pub(super) program: Program,
    pub(super) labels: Labels,
    names: Names,
    pub(super) commands: CommandIndex,
    /// The line of an unconditional END with no label behind it.
    pub(super) last_end: Option<u32>,
    /// The file has the ending of G-code: a line is OpenSBP only where it can be nothing else.
    pub(super) gcode_first: bool,
    /// Number of diagnostics that were told but not kept, and whether errors are among them.
    untold: usize,
    untold_errors: bool,
}

impl File {
    pub(super) fn new(name: Arc<str>, dialect: Dialect) -> Self {
        Self {
            program: Program { name, dialect, ..Program::default() },
            labels: Labels::default(),
            names: Names::default(),
            commands: CommandIndex::new(dialect),
            last_end: None,
            gcode_first: false,
            untold: 0,
            untold_errors: false,
        }
    }

    /// The number of a variable's name, which is the same in any case.
    pub(super) fn name_id(&mut self, name: &str) -> NameId {
        NameId(self.names.id(name))
    }

    /// Drops the diagnostics of a line, from the number `before` on, where enough were kept.
    pub(super) fn bound_diagnostics(&mut self, before: usize) {
        if before >= MOST_DIAGNOSTICS {
            let dropped = self.program.diagnostics.split_off(before);
            self.untold += dropped.len();
            self.untold_errors |= dropped.iter().any(Diagnostic::is_error);
        }
    }

    /// Makes warnings of the findings behind the last END: no run reaches them, so they are no reason not to run.
    ///
    /// Unless a jump misses its label: one of the lines may be that label, misspelt.
    fn soften_unreachable(&mut self) {
        let Some(end) = self.last_end else { return };
        if self.labels.lack_one() {
            return;
        }
        for diagnostic in self.program.diagnostics.iter_mut().filter(|d| d.place.line > end) {
            diagnostic.severity = Severity::Warning;
            diagnostic.hint = format!("never reached: it stands behind line {end}");
        }
    }

    /// In the dialect `strict` old spellings are errors.
    fn refuse_old_spellings(&mut self) {
        if self.program.dialect != Dialect::Strict {
            return;
        }
        let old = [Code::DoubtfulSpelling, Code::RepeatedLabel, Code::TextAfterEnd];
        for diagnostic in self.program.diagnostics.iter_mut().filter(|d| old.contains(&d.code)) {
            diagnostic.severity = Severity::Error;
        }
    }

    /// Everything together; jumps find their labels.
    pub(super) fn finish(mut self, text: String) -> Program {
        if self.untold > 0 {
            let line = self.program.lines.len() as u32;
            let message = format!("{} more findings are not listed", self.untold);
            let place = SourcePlace::line(self.program.name.clone(), line);
            let severity = if self.untold_errors { Severity::Error } else { Severity::Warning };
            let last = Diagnostic::new(Code::Syntax, place, message).severity(severity);
            self.program.diagnostics.push(last);
        }
        self.refuse_old_spellings();
        self.soften_unreachable();
        let (labels, label_names) = self.labels.finish();
        let (text, names) = (Arc::new(text), self.names.into_list());
        Program { text, labels, label_names, names, ..self.program }
    }
}
