//! Modes where ways meet: behind a branch, in a loop, in a subroutine.
//!
//! OpenSBP has no modes for a line to fall back on, so what a line means has to be known where it is
//! written. Where that depends on the way the run takes, the line cannot be kept.

/// A mode, as far as it is known without running the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Known<T> {
    /// It is this on every way.
    Is(T),
    /// It depends on the way taken.
    Depends,
}

impl<T: PartialEq> Known<T> {
    /// Joins what is known on two ways where they meet.
    fn or(self, other: Self) -> Self {
        if self == other { self } else { Self::Depends }
    }
}

/// The modes that a part file has no words for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Modes {
    /// G0 … G3; nothing behind G80.
    pub(super) motion: Known<Option<u8>>,
    /// The tool of the last T.
    pub(super) tool: Known<Option<String>>,
}

impl Modes {
    /// At the start of a program.
    pub(super) const START: Self = Self { motion: Known::Is(None), tool: Known::Is(None) };
    /// In a subroutine that anybody may call.
    pub(super) const ANY: Self = Self { motion: Known::Depends, tool: Known::Depends };

    fn or(self, other: Self) -> Self {
        Self { motion: self.motion.or(other.motion), tool: self.tool.or(other.tool) }
    }

    /// Returns the modes that hold where a stretch of lines may have run any number of times.
    pub(super) fn around(mut self, changes: &Changes) -> Self {
        for motion in &changes.motions {
            self.motion = self.motion.or(Known::Is(*motion));
        }
        for tool in &changes.tools {
            self.tool = self.tool.or(Known::Is(Some(tool.clone())));
        }
        self
    }
}

/// Modes that a stretch of lines sets, in any order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Changes {
    pub(super) motions: Vec<Option<u8>>,
    pub(super) tools: Vec<String>,
}

/// Modes at a place; nothing where no way leads.
pub(super) type Here = Option<Modes>;

/// Joins the modes of two ways where they meet.
pub(super) fn meet(a: Here, b: Here) -> Here {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.or(b)),
        (one, other) => one.or(other),
    }
}

/// Modes while a program is written from its first line to its last.
#[derive(Debug)]
pub(super) struct Ways {
    pub(super) here: Here,
    /// Branches around: before the first of them, and behind those that ended.
    branches: Vec<(Here, Here)>,
    /// Loops around: the label, whether their first line may be left at once, at their first line, and at
    /// each `break`.
    loops: Vec<(String, bool, Here, Here)>,
    /// The program around a subroutine.
    outside: Here,
}

impl Ways {
    pub(super) const fn new() -> Self {
        Self { here: Some(Modes::START), branches: Vec::new(), loops: Vec::new(), outside: None }
    }

    pub(super) fn begin_branch(&mut self) {
        self.branches.push((self.here.clone(), None));
    }

    pub(super) fn next_branch(&mut self) {
        let here = self.here.take();
        if let Some((before, ended)) = self.branches.last_mut() {
            *ended = meet(ended.take(), here);
            self.here = before.clone();
        }
    }

    /// Behind the branches; without an `else` all of them may be passed.
    pub(super) fn end_branches(&mut self, has_else: bool) {
        let Some((before, ended)) = self.branches.pop() else { return };
        self.here = meet(self.here.take(), ended);
        if !has_else {
            self.here = meet(self.here.take(), before);
        }
    }

    pub(super) fn begin_loop(&mut self, label: String, may_pass: bool, changes: &Changes) {
        self.here = self.here.take().map(|modes| modes.around(changes));
        self.loops.push((label, may_pass, self.here.clone(), None));
    }

    pub(super) fn leave_loop(&mut self, label: &str) {
        let here = self.here.take();
        if let Some((.., left)) = self.loops.iter_mut().rfind(|(name, ..)| name == label) {
            *left = meet(left.take(), here);
        }
    }

    pub(super) fn end_loop(&mut self) {
        let Some((_, may_pass, begin, left)) = self.loops.pop() else { return };
        let end = if may_pass { begin } else { self.here.take() };
        self.here = meet(end, left);
    }

    pub(super) fn begin_sub(&mut self) {
        self.outside = self.here.replace(Modes::ANY);
    }

    pub(super) fn end_sub(&mut self) {
        self.here = self.outside.take();
    }

    /// Nothing goes on from here.
    pub(super) fn stop(&mut self) {
        self.here = None;
    }

    /// Behind a call: what the subroutine sets is not looked at in order, so it may be any of it.
    pub(super) fn call(&mut self, changes: &Changes) {
        let Some(modes) = &mut self.here else { return };
        *modes = modes.clone().around(changes);
    }

    /// The modes to write with; none where no way leads, which nobody misses.
    pub(super) fn modes(&mut self) -> &mut Modes {
        self.here.get_or_insert(Modes::ANY)
    }
}
