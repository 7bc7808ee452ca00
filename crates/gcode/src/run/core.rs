//! The whole state of a running program.

use super::compensation::Compensator;
use super::probe::Probe;
use super::state::Modal;
use super::stepping::Stepping;
use super::{Options, Session, State};
use crate::syntax::tree::Program;
use kerf_program::settings::{AxisUnit, LinearUnit};
use kerf_program::{AXES, Answer, Axes, Axis, Frame, Settings, Turn};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The state: what is saved, cloned and restored.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Core {
    pub(super) options: Options,
    /// Files read so far; [`At::file`](kerf_program::At) indexes them. Saved apart.
    #[serde(skip)]
    pub(super) programs: Vec<Arc<Program>>,
    /// Open files and subroutines, outermost first.
    pub(super) calls: Vec<Call>,
    pub(super) started: bool,
    /// M2, M30 or the end of the file was reached: only what is under way is left to do.
    pub(super) over: bool,
    pub(super) settings: Arc<Settings>,
    pub(super) frame: Frame,
    /// Place to which the program has sent the machine, machine frame; with compensation the place on
    /// the programmed path.
    pub(super) position: Axes,
    pub(super) state: State,
    /// Modes kept by M70 outside subroutines.
    pub(super) kept: Option<Box<Modal>>,
    /// Millimetres or degrees of one unit in the file, per axis: unit times proportion.
    pub(super) scale: [f64; AXES],
    /// Machine position of a place that reads zero in the file, while nothing is turned.
    pub(super) zero: Axes,
    /// Sine and cosine of the coordinate system's turn.
    pub(super) turned: Option<[f64; 2]>,
    /// The canned cycle in force.
    pub(super) cycle: Option<super::cycles::Cycle>,
    /// The curve of G5.2 that is being given.
    pub(super) nurbs: Option<super::spline::Nurbs>,
    /// The second control point of the last G5, as an offset from its end.
    pub(super) spline_end: Option<[f64; 2]>,
    pub(super) compensator: Option<Compensator>,
    /// Place at which G40 left the tool, until the next move brings it to the path.
    pub(super) beside: Option<Axes>,
    /// A probe move that is under way.
    pub(super) probing: Option<Probe>,
    /// A tool change has begun: the spindle was stopped, the operator is asked next.
    #[serde(default)]
    pub(super) changing: bool,
    /// The block at hand was carried out, and holds the program with these words.
    #[serde(default)]
    pub(super) holding: Option<String>,
    /// The hole of G88 whose retract comes when somebody has answered, and how the spindle turns then.
    #[serde(default)]
    pub(super) retracting: Option<(super::cycles::Hole, Turn)>,
    /// Answers given in the present block, which begins again for each question; how many of them the
    /// present attempt has taken.
    #[serde(default)]
    pub(super) asked: Vec<Answer>,
    #[serde(default)]
    pub(super) taken: usize,
    /// Motion commands given so far.
    pub(super) motions: u64,
    /// Everything given so far has been carried out.
    pub(super) settled: bool,
    /// All that came before the present block has been carried out. What the block itself gives before
    /// it asks goes with it: it is given anew with each attempt, so nobody could wait for it.
    #[serde(default)]
    pub(super) at_rest: bool,
    /// Lines executed.
    pub(super) lines: u64,
    /// Only the line of this index is executed.
    #[serde(default)]
    pub(super) only: Option<u32>,
    /// Marks of messages that are told only once.
    pub(super) told: Told,
    /// Way in which the lines are gone through.
    #[serde(default)]
    pub(super) stepping: Stepping,
}

/// Marks of messages that are told only once: `true` once told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Told {
    pub(super) units: bool,
    pub(super) feed: bool,
    pub(super) console: bool,
    #[serde(default)]
    pub(super) behind_cycle: bool,
    #[serde(default)]
    pub(super) fan: bool,
    /// A line with a mistake was passed: which motion is in force is not known until one is named.
    pub(super) motion_lost: bool,
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

/// Numbered parameters that belong to a subroutine.
pub(super) const LOCALS: usize = 30;

impl Core {
    pub(super) fn new(program: Arc<Program>, session: Session, options: Options) -> Self {
        let (lines, stepping) = (options.lines_before, Stepping::new(options.stepped));
        let mut core = Self {
            options,
            programs: vec![program],
            calls: Vec::new(),
            started: false,
            over: false,
            settings: Arc::new(session.settings),
            frame: session.frame,
            position: session.position,
            state: session.state,
            kept: None,
            scale: [1.0; AXES],
            zero: Axes::default(),
            turned: None,
            cycle: None,
            nurbs: None,
            spline_end: None,
            compensator: None,
            beside: None,
            probing: None,
            changing: false,
            holding: None,
            retracting: None,
            asked: Vec::new(),
            taken: 0,
            motions: 0,
            settled: true,
            at_rest: false,
            lines,
            only: None,
            told: Told::default(),
            stepping,
        };
        core.begin_modes();
        core.adopt_frame();
        core.refresh();
        core
    }

    /// The modes a program begins with.
    fn begin_modes(&mut self) {
        if self.options.keep_modes {
            return;
        }
        let grbl = self.options.dialect.is_of_grbl();
        let unit = match grbl {
            true => LinearUnit::Mm,
            false => self.settings.linear_unit,
        };
        let turn = self.state.modal.turn;
        // grbl wakes up with G21 and G0.
        let (unit_said, motion) = (grbl, grbl.then_some(0));
        self.state.modal = Modal { unit, unit_said, turn, motion, ..Modal::default() };
    }

    /// Another language may have moved the working zero: the system in force follows.
    pub(super) fn adopt_frame(&mut self) {
        self.refresh();
        let there = self.frame.working_zero;
        let here = self.working_zero();
        if here.0.iter().zip(there.0).any(|(a, b)| (a - b).abs() > 1e-9) {
            let system = &mut self.state.systems[self.state.modal.system.min(8)];
            system.offset = system.offset.plus(there.minus(here));
        }
    }

    /// Makes ready for one line, from 1.
    pub(super) fn enter_line(&mut self, line: u32) {
        let index = line.saturating_sub(1);
        self.calls.truncate(1);
        match self.calls.first_mut() {
            Some(call) => call.next = index,
            None => self.calls.push(Call::new(0, index, CallKind::Main)),
        }
        (self.started, self.over, self.only) = (true, false, Some(index));
    }

    /// Returns `true` if the only line to execute has been executed.
    pub(super) fn only_is_done(&self) -> bool {
        let at = |index| matches!(&*self.calls, [main] if main.next != index);
        self.only.is_some_and(at) && self.probing.is_none()
    }

    /// Returns `true` if the operator is asked before the spindle turns so.
    pub(super) fn would_ask_spindle(&self, turn: Turn) -> bool {
        let starts = turn != Turn::Off && self.state.modal.turn == Turn::Off;
        let options = &self.options;
        starts && options.ask_spindle && options.spindle_output > 0 && !options.preview
    }

    /// Takes over the machine as another language left it.
    pub(super) fn adopt(&mut self, settings: &Arc<Settings>, frame: &Frame, position: Axes) {
        if self.tool_position() != position {
            (self.compensator, self.beside) = (None, None);
            self.position = position;
        }
        self.settings = settings.clone();
        self.frame = *frame;
        self.settled = false;
        self.adopt_frame();
        self.refresh();
    }

    /// Machine position of the zero of the coordinates in force.
    pub(super) fn working_zero(&self) -> Axes {
        let system = &self.state.systems[self.state.modal.system.min(8)];
        system.offset.plus(self.state.tool_offset).plus(self.turn(self.state.shift))
    }

    /// An angle of the file as one of the machine, and back: a file that FP mirrors turns the other way.
    pub(super) fn turn_of(&self, degrees: f64) -> f64 {
        if self.options.mirrors() { -degrees } else { degrees }
    }

    /// A displacement in the coordinate system as one in the machine frame.
    pub(super) fn turn(&self, mut place: Axes) -> Axes {
        if let Some([sin, cos]) = self.turned {
            let [x, y, ..] = place.0;
            place.0[0] = x * cos - y * sin;
            place.0[1] = x * sin + y * cos;
        }
        place
    }

    /// A displacement in the machine frame as one in the coordinate system.
    pub(super) fn unturn(&self, mut place: Axes) -> Axes {
        if let Some([sin, cos]) = self.turned {
            let [x, y, ..] = place.0;
            place.0[0] = x * cos + y * sin;
            place.0[1] = y * cos - x * sin;
        }
        place
    }

    /// Works out scale and zero again after unit or offsets changed.
    pub(super) fn refresh(&mut self) {
        let system = self.state.systems[self.state.modal.system.min(8)];
        self.turned = (system.rotation_deg != 0.0).then(|| {
            let (sin, cos) = system.rotation_deg.to_radians().sin_cos();
            [sin, cos]
        });
        self.scale = Axis::ALL.map(|axis| self.unit_of(axis));
        self.zero = self.working_zero();
        for i in 0..3 {
            self.scale[i] *= self.options.proportion[i];
            self.zero.0[i] += self.options.temporary_zero_mm[i];
        }
    }

    /// Millimetres or degrees of one unit in the file, without the proportions of FP. A, B and C that the
    /// machine has as linear axes are measured like X.
    pub(super) fn unit_of(&self, axis: Axis) -> f64 {
        match self.settings.axis_unit(axis) {
            AxisUnit::Linear(_) => self.state.modal.unit.mm(),
            AxisUnit::Degrees => 1.0,
        }
    }

    /// Machine position of a place in the coordinate system, mm.
    pub(super) fn machine_of(&self, place: Axes) -> Axes {
        self.turn(place).plus(self.zero)
    }

    /// Place in the coordinate system of a machine position, mm.
    pub(super) fn place_of(&self, machine: Axes) -> Axes {
        self.unturn(machine.minus(self.zero))
    }

    /// Returns the place of the program, in the units of the file.
    pub(super) fn user_position(&self) -> Axes {
        self.to_user(self.place_of(self.position))
    }

    pub(super) fn to_user(&self, place: Axes) -> Axes {
        Axes(std::array::from_fn(|i| kerf_program::settings::to_user(place.0[i], self.scale[i])))
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

    pub(super) fn into_session(self) -> Session {
        Session {
            position: self.tool_position(),
            frame: self.frame,
            settings: Arc::unwrap_or_clone(self.settings),
            state: self.state,
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
