//! Motion commands out of moves and cuts, through the tab filter where tabs hold.

use super::Context;
use kerf_cut::{Cut, Step, Tabber};
use kerf_geom::Vec2;
use kerf_program::settings::Tabs;
use kerf_program::{Arc, At, Axes, Axis, Command, Feed, Line, MoveKind};
use serde::{Deserialize, Serialize};

/// Origin of a move in the tab filter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Origin {
    /// Its line.
    at: At,
    /// The step of the run that executed the line.
    step: u64,
}

/// State of the path that is being cut.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Cutting {
    /// Tabs being cut; `None` outside tabbed paths.
    pub(crate) tabs: Option<Tabber<Origin>>,
    /// Clock angle of the last XY motion, degrees.
    pub(crate) heading: Option<f64>,
    /// I and J of the last CG, mm.
    pub(crate) last_ij: Option<[f64; 2]>,
}

impl Cutting {
    pub(super) const fn new(heading: Option<f64>) -> Self {
        Self { tabs: None, heading, last_ij: None }
    }
}

impl Context<'_> {
    /// Returns the context that the geometry of a cut needs; places are working millimetres.
    pub(crate) fn cut_context(&self) -> kerf_cut::Context {
        let level = self.core.flow.level();
        kerf_cut::Context {
            zero_z: level.map_or(0.0, |l| l.offset[2]),
            scale: level.map_or([1.0; 3], |l| l.proportion),
            ..kerf_cut::Context::new(self.core.place.working().first3(), self.settings())
        }
    }

    /// Carries a cut out. Its last pass gets tabs when asked to, or when tabs hold for the file.
    pub(crate) fn carry_out(&mut self, cut: Cut, feature_tab: bool) {
        let Some(pass) =
            cut.last_pass.clone().filter(|_| feature_tab || self.core.cutting.tabs.is_some())
        else {
            self.without_tabs(&cut.steps);
            self.core.cutting.heading = Some(cut.heading_deg);
            return;
        };
        self.without_tabs(&cut.steps[..pass.start]);
        let own = self.core.cutting.tabs.is_none();
        if own {
            let tabs = Tabs { count: None, start_mm: None, ..self.settings().tabs };
            self.core.cutting.tabs = Some(Tabber::new(&tabs, self.settings().cutter.safe_z_mm));
        }
        self.steps(&cut.steps[pass.clone()]);
        if own {
            self.end_tabs();
        }
        self.without_tabs(&cut.steps[pass.end..]);
        self.core.cutting.heading = Some(cut.heading_deg);
    }

    /// Steps that never get tabs; a tabbed path around them is over.
    fn without_tabs(&mut self, steps: &[Step]) {
        if steps.is_empty() {
            return;
        }
        self.path_over();
        let held = self.core.cutting.tabs.take();
        self.steps(steps);
        self.core.cutting.tabs = held;
    }

    fn steps(&mut self, steps: &[Step]) {
        for step in steps {
            self.step(*step);
        }
    }

    fn step(&mut self, step: Step) {
        if self.core.cutting.tabs.is_some() {
            self.through_tabs(step);
            self.core.place.position = self.machine_of(step.to());
        } else {
            self.plain_step(self.origin(), step);
        }
    }

    /// A straight move to a machine position.
    pub(crate) fn line(&mut self, kind: MoveKind, to: Axes) {
        self.line_at(kind, to, Feed::Axis);
    }

    /// A straight move at a speed.
    pub(super) fn line_at(&mut self, kind: MoveKind, to: Axes, feed: Feed) {
        let from = self.core.place.position;
        if to.same_place(&from) {
            return;
        }
        let delta = Vec2::new(to[Axis::X] - from[Axis::X], to[Axis::Y] - from[Axis::Y]);
        if delta != Vec2::default() {
            self.core.cutting.heading = Some(kerf_geom::vec_to_clock(delta));
        }
        if self.core.cutting.tabs.is_some() {
            if to.0[3..] == from.0[3..] {
                self.through_tabs(Step::Line {
                    kind,
                    to: self.core.place.frame.working(to).first3(),
                });
                self.core.place.position = to;
                return;
            }
            self.interrupt_tabs();
        }
        self.core.place.position = to;
        self.motion(self.origin(), Command::Line(Line { kind, to, feed }));
    }

    fn origin(&self) -> Origin {
        Origin { at: self.at, step: self.core.given.steps }
    }

    /// Machine position of working X, Y, Z, the other axes where they are.
    fn machine_of(&self, working: [f64; 3]) -> Axes {
        let mut to = self.core.place.position;
        for (axis, value) in Axis::ALL.into_iter().zip(working) {
            to[axis] = value + self.core.place.frame.working_zero[axis];
        }
        to
    }

    /// Gives one step as a motion command of the line it comes from.
    fn plain_step(&mut self, origin: Origin, step: Step) {
        let to = self.machine_of(step.to());
        let command = match step {
            Step::Line { kind, .. } => Command::Line(Line { kind, to, feed: Feed::Axis }),
            Step::Arc { centre, sweep_rad, chords, small, .. } => {
                let zero = self.core.place.frame.working_zero;
                let centre = [centre[0] + zero[Axis::X], centre[1] + zero[Axis::Y]];
                Command::Arc(Arc {
                    kind: MoveKind::Cut,
                    centre,
                    sweep_rad,
                    to,
                    feed: Feed::Axis,
                    chords,
                    small,
                })
            }
        };
        self.core.place.position = to;
        self.motion(origin, command);
    }

    fn motion(&mut self, origin: Origin, command: Command) {
        self.core.given.motions += 1;
        if !self.core.handlers.watches.is_empty() {
            self.core.given.given_by.push(origin.step);
        }
        let here = std::mem::replace(&mut self.at, origin.at);
        self.emit(command);
        self.at = here;
    }

    fn through_tabs(&mut self, step: Step) {
        let from = self.core.place.working().first3();
        let origin = self.origin();
        // Whatever the filter holds back has still to be carried out.
        self.core.given.settled = false;
        self.let_go(|tabs, out| tabs.push(from, step, origin, out));
    }

    /// The path is interrupted but not over: what is buffered goes out.
    pub(crate) fn interrupt_tabs(&mut self) {
        self.let_go(|tabs, out| tabs.flush(out));
    }

    /// The tabbed path is over, tabs hold on.
    fn path_over(&mut self) {
        self.let_go(|tabs, out| tabs.path_end(out));
    }

    /// Tabs end.
    pub(crate) fn end_tabs(&mut self) {
        self.path_over();
        self.core.cutting.tabs = None;
    }

    /// Gives the moves that the tab filter lets go; the planned position stays what it is.
    fn let_go(&mut self, act: impl FnOnce(&mut Tabber<Origin>, &mut Vec<(Origin, Step)>)) {
        let Some(mut tabs) = self.core.cutting.tabs.take() else { return };
        let mut cut = Vec::new();
        act(&mut tabs, &mut cut);
        let planned = self.core.place.position;
        for (origin, step) in cut {
            self.plain_step(origin, step);
        }
        self.core.place.position = planned;
        self.core.cutting.tabs = Some(tabs);
    }
}
