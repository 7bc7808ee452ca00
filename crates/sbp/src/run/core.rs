//! The whole state of a running program.

use super::cutting::Origin;
use super::watch::Handler;
use super::{BeforePreview, FileParameters, Options, Session, Variables};
use crate::tree::Span;
use crate::{Program, Value};
use kerf_cut::Tabber;
use kerf_diag::Place;
use kerf_program::{AXES, Answer, At, Axes, Axis, AxisSet, FileCall, Frame, GoTo, Settings};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The state: what is saved, cloned and restored.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Core {
    pub(crate) options: Options,
    /// Files read so far; [`At::file`] indexes them. Saved once for all states, see `saving`.
    #[serde(skip)]
    pub(crate) programs: Vec<Arc<Program>>,
    /// For each file, the variable slot of each of its names. Made again after restoring.
    #[serde(skip)]
    pub(crate) links: Vec<Arc<[u32]>>,
    /// Open files, outermost first.
    pub(crate) levels: Vec<Level>,
    /// Last call of each file.
    #[serde(default)]
    pub(crate) calls: BTreeMap<u32, FileCall>,
    /// The operator let the line that is next run, of a file that is stepped through.
    #[serde(default)]
    pub(crate) granted: bool,
    /// The first file has been opened.
    pub(crate) started: bool,
    pub(crate) settings: Arc<Settings>,
    /// Settings to which temporary values return when the run ends (SV replaces them).
    pub(crate) kept: Arc<Settings>,
    pub(crate) frame: Frame,
    /// Place to which the machine has been sent, machine frame.
    pub(crate) position: Axes,
    /// The part of `position` that the tool offset of VO contributes.
    pub(crate) offset_applied: Axes,
    pub(crate) variables: Variables,
    pub(crate) watches: Vec<Handler>,
    /// Handlers that fired and whose actions have not run yet.
    pub(crate) fired: Vec<Handler>,
    /// A timed pause was given while handlers are armed: nothing is read until it is over.
    pub(crate) pausing: bool,
    /// EXIT SHOPBOT was reached.
    #[serde(default)]
    pub(crate) closes: bool,
    /// Steps that had an effect so far.
    pub(crate) steps: u64,
    /// The step behind each motion command given in this one, while handlers are armed.
    pub(crate) given_by: Vec<u64>,
    /// Motion commands given so far.
    pub(crate) motions: u64,
    /// Answers so far to the step that waits: it is repeated until it has every answer.
    #[serde(default)]
    pub(crate) heard: Vec<Answer>,
    /// Number of these that it has taken.
    #[serde(skip)]
    pub(crate) taken: usize,
    /// Everything given so far has been carried out.
    pub(crate) settled: bool,
    /// Lines executed.
    pub(crate) lines: u64,
    /// Lines executed one after the other that left everything as it was.
    #[serde(default)]
    pub(crate) idle: u64,
    /// The present line changes something, or looks at what may change by itself.
    #[serde(skip)]
    pub(crate) changes: bool,
    /// Clock angle of the last XY motion, degrees.
    pub(crate) heading: Option<f64>,
    /// I and J of the last CG, mm.
    pub(crate) last_ij: Option<[f64; 2]>,
    /// User files by number − 1.
    pub(crate) files: [Option<UserFile>; 9],
    /// Tabs being cut; `None` outside tabbed paths.
    pub(crate) tabs: Option<Tabber<Origin>>,
    /// Axes that MI keeps moving.
    pub(crate) independent: AxisSet,
    /// Axes that moved by themselves: where they are only the machine knows.
    pub(crate) adrift: AxisSet,
    /// SC,0 of FabMo's dialect: the zero of the working locations, which SC,1 brings back.
    pub(crate) working_aside: Option<Axes>,
    /// In preview mode: what SM returns to.
    pub(crate) before_preview: Option<Box<BeforePreview>>,
    /// In preview mode, while a file runs: the settings that it began with.
    pub(crate) looked_at: Option<Arc<Settings>>,
    /// State of the random sequence.
    pub(crate) random: u64,
    /// Variables made beyond the hundredth were told of.
    pub(crate) told_many_variables: bool,
    /// A line of G-code that has to run before the next step.
    #[serde(default)]
    pub(crate) gcode_line: Option<At>,
    /// Internal units (mm, degrees) of one unit in the file, per axis: unit times proportion.
    pub(crate) scale: [f64; AXES],
}

/// An open part file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Level {
    /// Index of its program.
    pub(crate) file: u32,
    /// Index of the line that runs next.
    pub(crate) next: u32,
    /// Lines to return to, innermost last.
    pub(crate) gosubs: Vec<u32>,
    /// A GOTO was carried out while a GOSUB was open: it may have left it for good.
    #[serde(default)]
    pub(crate) gosub_left: bool,
    /// Proportions of this file and of all that called it.
    pub(crate) proportion: [f64; 3],
    /// Temporary zero, working location in mm.
    pub(crate) offset: [f64; 3],
    /// Its plunge is already multiplied by the caller's Z proportion.
    pub(crate) parameters: FileParameters,
    /// Repetitions still to come after this one.
    pub(crate) repetitions_left: u32,
    /// Z to return to after plunges, machine frame.
    pub(crate) start_z: Option<f64>,
    /// The operator is asked before each line (FG), also in files that it calls.
    #[serde(default)]
    pub(crate) stepped: bool,
    /// Lines before this index are passed over, but for settings and assignments.
    #[serde(default)]
    pub(crate) skip_to: Option<u32>,
    /// Tabs hold here (own or inherited), on the last repetition.
    pub(crate) tabs: bool,
    pub(crate) purpose: Purpose,
}

/// Purpose for which a file was opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Purpose {
    /// To be run, by the operator, FP or a custom cut.
    Run,
    /// To change the tool (C9).
    ToolChange,
    /// Only for a subroutine that a handler of ON INPUT called from within a nested file. The
    /// number is the depth at which the file itself is open.
    Handler(usize),
}

impl Level {
    /// Returns `true` if its cuts get tabs now, and those of files it calls.
    pub(crate) fn tabs_hold(&self) -> bool {
        self.tabs && self.repetitions_left == 0
    }

    /// Goes on at another line. Settings on the way are those behind the present line, or from the
    /// beginning when that is further down.
    pub(crate) fn go_to(&mut self, to: GoTo) {
        let index = to.line.saturating_sub(1);
        self.skip_to = to.settings.then_some(index);
        if !to.settings {
            self.next = index;
        } else if index < self.next {
            self.next = 0;
        }
    }

    /// Returns `true` if its lines have to be looked at one by one.
    pub(crate) const fn watched(&self) -> bool {
        self.stepped || self.skip_to.is_some()
    }
}

/// A file of the user that is open.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct UserFile {
    pub(crate) path: Arc<str>,
    pub(crate) mode: crate::tree::FileMode,
    /// Fields of the last line read that were not taken yet.
    pub(crate) fields: Vec<Value>,
}

impl Core {
    pub(super) fn new(program: Arc<Program>, session: Session, options: Options) -> Self {
        let settings = Arc::new(session.settings);
        let typed = options.typed;
        let mut core = Self {
            random: options.seed,
            options,
            programs: Vec::new(),
            links: Vec::new(),
            levels: Vec::new(),
            calls: BTreeMap::new(),
            granted: false,
            started: false,
            kept: settings.clone(),
            settings,
            frame: session.frame,
            position: session.position,
            offset_applied: session.offset_applied,
            variables: session.variables,
            watches: Vec::new(),
            fired: Vec::new(),
            pausing: false,
            closes: false,
            steps: 0,
            given_by: Vec::new(),
            motions: 0,
            heard: Vec::new(),
            taken: 0,
            settled: true,
            lines: 0,
            heading: session.heading.filter(|_| typed),
            last_ij: None,
            files: Default::default(),
            tabs: None,
            independent: session.independent,
            adrift: AxisSet::EMPTY,
            before_preview: session.before_preview,
            idle: 0,
            changes: false,
            looked_at: None,
            working_aside: None,
            told_many_variables: false,
            gcode_line: None,
            scale: [1.0; AXES],
        };
        core.load(program);
        core
    }

    /// Adds a program, or finds the same one read before.
    pub(crate) fn load(&mut self, program: Arc<Program>) -> u32 {
        let known = |p: &Arc<Program>| {
            Arc::ptr_eq(p, &program) || p.name == program.name && p.text == program.text
        };
        if let Some(index) = self.programs.iter().position(known) {
            return index as u32;
        }
        self.programs.push(program);
        self.relink();
        self.programs.len() as u32 - 1
    }

    /// Finds the slots of the names of all programs that have none yet.
    pub(crate) fn relink(&mut self) {
        for index in self.links.len()..self.programs.len() {
            let program = self.programs[index].clone();
            self.links.push(program.names.iter().map(|n| self.variables.slot(n)).collect());
        }
    }

    /// A file of [`At`](kerf_program::At); an empty one for a number that none has.
    pub(crate) fn program(&self, file: u32) -> Arc<Program> {
        self.programs.get(file as usize).cloned().unwrap_or_default()
    }

    /// The innermost open file.
    pub(crate) fn level(&self) -> Option<&Level> {
        self.levels.last()
    }

    /// The lines that called the innermost file, innermost first.
    pub(crate) fn callers(&self) -> Vec<Place> {
        let place = |level: &Level| {
            let program = self.programs.get(level.file as usize)?;
            Some(program.place(level.next, Span::default()))
        };
        self.levels.iter().rev().skip(1).filter_map(place).collect()
    }

    /// Working location, mm.
    pub(crate) fn working(&self) -> Axes {
        self.frame.working(self.position)
    }

    /// Internal units of one unit in the file, after settings or the level changed.
    pub(crate) fn refresh_scale(&mut self) {
        let proportion = self.level().map_or([1.0; 3], |l| l.proportion);
        self.scale = std::array::from_fn(|i| {
            self.settings.axis_scale(Axis::ALL[i]) * proportion.get(i).copied().unwrap_or(1.0)
        });
    }

    /// The workpiece lies elsewhere by so much: what the program knows in the machine frame follows.
    pub(super) fn nudge(&mut self, by: Axes) {
        self.frame.working_zero = self.frame.working_zero.plus(by);
        self.position = self.position.plus(by);
        for level in &mut self.levels {
            level.start_z = level.start_z.map(|z| z + by[Axis::Z]);
        }
    }

    /// Returns `true` if an axis may be elsewhere than the program sent it: MI or torch height moves it.
    pub(crate) fn wanders(&self, axis: Axis) -> bool {
        self.independent.contains(axis) || axis == Axis::Z && self.settings.torch_on()
    }

    pub(super) fn into_session(self) -> Session {
        Session {
            settings: Arc::unwrap_or_clone(self.settings),
            frame: self.frame,
            position: self.position,
            variables: self.variables,
            independent: self.independent,
            offset_applied: self.offset_applied,
            heading: self.heading,
            before_preview: self.before_preview,
        }
    }
}
