//! Files that were read, and where in them the program stands.

use super::state::Modal;
use crate::syntax::tree::{Program, Span};
use kerf_diag::SourcePlace;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Numbered parameters that belong to a subroutine.
pub(super) const LOCALS: usize = 30;

/// Callers that a diagnostic names.
const MOST_CALLERS: usize = 8;

/// The files of a run and the subroutines that are open.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Calls {
    /// Files read so far; [`At::file`](kerf_program::At) indexes them. Saved apart.
    #[serde(skip)]
    pub(super) programs: Vec<Arc<Program>>,
    /// Open files and subroutines, outermost first.
    pub(super) open: Vec<Call>,
    /// Modes kept by M70 outside subroutines.
    kept: Option<Box<Modal>>,
}

/// An open file or subroutine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Call {
    /// Index of its program.
    pub(super) file: u32,
    /// Index of the line that runs next.
    pub(super) next: u32,
    pub(super) kind: CallKind,
    /// `#1` … `#30` of the file or subroutine; a call by M98 shares those of its caller.
    pub(super) locals: Vec<f64>,
    /// Named parameters of its own.
    pub(super) named: BTreeMap<Arc<str>, f64>,
    /// Counted loops: the line of `repeat` and how many turns are left.
    pub(super) loops: Vec<(u32, u64)>,
    /// Modes kept by M70 or M73.
    pub(super) kept: Option<Box<Modal>>,
    /// M73: the modes come back at the end.
    pub(super) restore: bool,
}

/// Kind of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum CallKind {
    /// The file that the operator started.
    Main,
    /// By an O-word.
    Sub,
    /// By M98: how often it runs again, and its first line (index).
    Fanuc {
        /// Runs left after this one.
        again: u64,
        /// Index of its first line.
        first: u32,
    },
}

impl Calls {
    pub(super) fn new(program: Arc<Program>) -> Self {
        Self { programs: vec![program], open: Vec::new(), kept: None }
    }

    /// The program of a file.
    pub(super) fn program(&self, file: u32) -> Arc<Program> {
        self.programs.get(file as usize).cloned().unwrap_or_default()
    }

    /// Adds a program, or finds the same one read before.
    pub(super) fn load(&mut self, program: Program) -> u32 {
        let known = |p: &Arc<Program>| p.name == program.name && p.text == program.text;
        if let Some(index) = self.programs.iter().position(known) {
            return index as u32;
        }
        self.programs.push(Arc::new(program));
        self.programs.len() as u32 - 1
    }

    /// The file that runs and the index of its next line.
    pub(super) fn next(&self) -> (u32, u32) {
        self.open.last().map_or((0, 0), |call| (call.file, call.next))
    }

    /// Chooses the line (by index) that the innermost call goes on at.
    pub(super) fn go_on_at(&mut self, index: u32) {
        if let Some(call) = self.open.last_mut() {
            call.next = index;
        }
    }

    /// Leaves all subroutines and goes to a line of the file that was started, by index.
    pub(super) fn enter_line(&mut self, index: u32) {
        self.open.truncate(1);
        match self.open.first_mut() {
            Some(call) => call.next = index,
            None => self.open.push(Call::new(0, index, CallKind::Main)),
        }
    }

    /// Returns `true` if a subroutine or a called file runs.
    pub(super) fn is_inside(&self) -> bool {
        self.open.len() > 1
    }

    /// The lines that called the innermost subroutine, innermost first.
    pub(super) fn callers(&self) -> Vec<SourcePlace> {
        let outer = self.open.iter().rev().skip(1).take(MOST_CALLERS);
        let place = |c: &Call| {
            let program = self.programs.get(c.file as usize)?;
            Some(program.place(c.next, Span::default()))
        };
        outer.filter_map(place).collect()
    }

    /// The file or subroutine whose `#1` … `#30` and names hold.
    pub(super) fn scope(&self) -> Option<&Call> {
        self.open.iter().rev().find(|call| !call.locals.is_empty())
    }

    /// The same, to set them.
    pub(super) fn scope_mut(&mut self) -> Option<&mut Call> {
        self.open.iter_mut().rev().find(|call| !call.locals.is_empty())
    }

    /// The place of the modes that M70 keeps here.
    pub(super) fn kept_modes(&mut self) -> &mut Option<Box<Modal>> {
        match self.open.last_mut() {
            Some(call) => &mut call.kept,
            None => &mut self.kept,
        }
    }
}

impl Call {
    pub(super) fn new(file: u32, next: u32, kind: CallKind) -> Self {
        let locals =
            if matches!(kind, CallKind::Fanuc { .. }) { Vec::new() } else { vec![0.0; LOCALS] };
        Self {
            file,
            next,
            kind,
            locals,
            named: BTreeMap::new(),
            loops: Vec::new(),
            kept: None,
            restore: false,
        }
    }
}
