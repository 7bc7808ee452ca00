//! The whole state of a running program.

use super::asking::Asking;
use super::calls::Calls;
use super::coordinates::Coordinates;
use super::curve::Nurbs;
use super::hole::Cycle;
use super::parameters::{Parameters, Scheme};
use super::place::PathPosition;
use super::progress::Progress;
use super::session::{Options, Session};
use super::state::{Modal, State};
use super::under_way::UnderWay;
use crate::syntax::tree::Program;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Axis, Frame, Settings, SpindleTurn};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The state: what is saved, cloned and restored.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Core {
    pub(super) options: Options,
    pub(super) settings: Arc<Settings>,
    pub(super) frame: Frame,
    /// Modes, offsets, parameters and tools.
    pub(super) state: State,
    pub(super) coordinates: Coordinates,
    pub(super) place: PathPosition,
    pub(super) calls: Calls,
    pub(super) progress: Progress,
    pub(super) sequels: Sequels,
    pub(super) under_way: UnderWay,
    pub(super) asking: Asking,
    /// Marks of messages that are told only once.
    pub(super) told: ToldOnce,
}

/// Things that one motion leaves to the next of its kind.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Sequels {
    /// The canned cycle in force.
    pub(super) cycle: Option<Cycle>,
    /// The curve of G5.2 that is being given.
    pub(super) nurbs: Option<Nurbs>,
    /// The second control point of the last G5, as an offset from its end.
    pub(super) spline_end: Option<[f64; 2]>,
}

/// Marks of messages that are told only once: `true` once told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct ToldOnce {
    pub(super) units: bool,
    pub(super) feed: bool,
    pub(super) console: bool,
    pub(super) behind_cycle: bool,
    pub(super) fan: bool,
    /// A line with a mistake was passed: which motion is in force is not known until one is named.
    pub(super) motion_lost: bool,
}

impl Core {
    pub(super) fn new(program: Arc<Program>, session: Session, options: Options) -> Self {
        let progress = Progress::new(options.lines_before, options.stepped);
        let mut core = Self {
            options,
            settings: Arc::new(session.settings),
            frame: session.frame,
            state: session.state,
            coordinates: Coordinates::default(),
            place: PathPosition::at(session.position),
            calls: Calls::new(program),
            progress,
            sequels: Sequels::default(),
            under_way: UnderWay::default(),
            asking: Asking::default(),
            told: ToldOnce::default(),
        };
        core.begin_modes();
        core.adopt_frame();
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
    fn adopt_frame(&mut self) {
        self.refresh();
        let there = self.frame.working_zero;
        let here = self.coordinates.working_zero;
        if here.0.iter().zip(there.0).any(|(a, b)| (a - b).abs() > 1e-9) {
            let (way, present) = (there.minus(here), self.state.modal.system.min(8));
            for (index, system) in self.state.systems.iter_mut().enumerate() {
                if index == present {
                    system.offset = system.offset.plus(way);
                } else if self.under_way.due_tool.is_some() {
                    // Another tool is longer or shorter, wherever a program has its zero.
                    system.offset[Axis::Z] += way[Axis::Z];
                }
            }
            self.refresh();
        }
    }

    /// Works out scale and zero again after unit or offsets changed.
    pub(super) fn refresh(&mut self) {
        self.coordinates = Coordinates::new(&self.state, &self.settings, &self.options);
    }

    /// Makes ready for one line, from 1.
    pub(super) fn enter_line(&mut self, line: u32) {
        let index = line.saturating_sub(1);
        self.calls.enter_line(index);
        self.progress.enter_line(index);
    }

    /// Returns `true` if the only line to execute has been executed.
    pub(super) fn only_is_done(&self) -> bool {
        let at = |index| matches!(&*self.calls.open, [main] if main.next != index);
        self.progress.only.is_some_and(at) && self.under_way.probing.is_none()
    }

    /// Returns `true` if the operator is asked before the spindle turns so.
    pub(super) fn would_ask_spindle(&self, turn: SpindleTurn) -> bool {
        let starts = turn != SpindleTurn::Off && self.state.modal.turn == SpindleTurn::Off;
        let options = &self.options;
        starts && options.ask_spindle && options.spindle_output > 0 && !options.preview
    }

    /// Takes over the machine as another language left it.
    pub(super) fn adopt(&mut self, settings: &Arc<Settings>, frame: &Frame, position: Axes) {
        if self.place.tool() != position {
            self.place = PathPosition::at(position);
        }
        self.settings = settings.clone();
        self.frame = *frame;
        self.asking.settled = false;
        self.adopt_frame();
    }

    /// The workpiece lies elsewhere by so much, machine frame: every place follows it.
    pub(super) fn nudge(&mut self, by: Axes) {
        self.frame.working_zero = self.frame.working_zero.plus(by);
        self.adopt_frame();
        self.place.nudge(by);
    }

    /// The run is over, whatever was under way.
    pub(super) fn abandon(&mut self) {
        self.place.abandon();
        self.under_way.abandon();
        self.progress.over = true;
    }

    /// The state as parameters tell it.
    pub(super) fn parameters(&self) -> Parameters<'_> {
        Parameters {
            state: &self.state,
            calls: &self.calls,
            coordinates: &self.coordinates,
            position: self.place.programmed,
            scheme: self.scheme(),
            preview: self.options.preview,
        }
    }

    /// How numbers of parameters count.
    pub(super) fn scheme(&self) -> Scheme {
        let unit_mm = self.settings.linear_unit.mm();
        Scheme { unit_mm, mirrored: self.options.mirrors() }
    }

    pub(super) fn into_session(self) -> Session {
        Session {
            position: self.place.tool(),
            frame: self.frame,
            settings: Arc::unwrap_or_clone(self.settings),
            state: self.state,
        }
    }
}
