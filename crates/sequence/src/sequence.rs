//! A job being cut: its state.

use crate::begin;
use crate::path::Followed;
use crate::place::{Here, Stage};
use crate::small::Small;
use crate::start::{Door, Jig};
use kerf_diag::Diagnostic;
use kerf_geom::Point2;
use kerf_machine::lines::Output;
use kerf_machine::planning::job_settings;
use kerf_machine::settings::Configuration;
use kerf_machine::state::{State, StopSettings};
use kerf_program::job::{Depths, Heights, InForce, Job};
use kerf_program::{Axes, Axis, Frame, Halted, HeightLaw, Settings, Status};
use std::collections::VecDeque;
use std::sync::Arc;

/// Places closer than this are the same, mm.
pub(crate) const SAME_MM: f64 = 1e-9;

/// A job being cut.
#[derive(Clone, Debug)]
pub struct Sequence {
    pub(crate) job: Arc<Job>,
    /// The job that was given, where the one at hand is a part of it.
    pub(crate) whole: Arc<Job>,
    /// State of the wait for the door.
    pub(crate) door: Door,
    /// The jig being cut, or cut last.
    pub(crate) jig: Option<Jig>,
    pub(crate) machine: Arc<Configuration>,
    /// Settings of the planner.
    pub(crate) settings: Arc<Settings>,
    pub(crate) frame: Frame,
    /// The heights in force: a pause or height control moves them.
    pub(crate) heights: Heights,
    pub(crate) cut_mm_s: f64,
    pub(crate) plunge_mm_s: f64,
    pub(crate) raise: bool,
    pub(crate) state: State,
    /// Reason for which it is not running.
    pub(crate) why: Arc<str>,
    pub(crate) stage: Stage,
    pub(crate) here: Here,
    /// Heights of the path at hand.
    pub(crate) depths: Depths,
    /// Steps still to do.
    pub(crate) steps: VecDeque<Small>,
    /// The commands of the first of them were given.
    pub(crate) given: bool,
    pub(crate) position: Axes,
    pub(crate) motions: u64,
    pub(crate) followed: Followed,
    /// Outputs that are on, a bit each.
    pub(crate) on: u32,
    /// Place where the last input fired.
    pub(crate) began: Halted,
    /// Place where the sheet was felt, Z of the machine frame.
    pub(crate) felt_mm: f64,
    /// The height from which height control carried Z, machine frame.
    pub(crate) begun_mm: f64,
    /// Law by which Z follows the sheet, or followed it last.
    pub(crate) law: Option<Arc<HeightLaw>>,
    /// Height control is on.
    pub(crate) controlled: bool,
    /// The machine stands at the pause mark of a shape.
    pub(crate) marked: bool,
    /// It halted at the pause mark of this shape already.
    pub(crate) halted_before: bool,
    pub(crate) cut: u64,
    /// The group told last.
    pub(crate) group: Option<Arc<str>>,
    /// Groups that were told to be slower than they ask for.
    pub(crate) limited: Vec<Arc<str>>,
    pub(crate) over: Option<(Status, Option<Box<Diagnostic>>)>,
}

impl Sequence {
    /// A job on a machine that stands at a position, machine frame.
    pub fn new(job: Arc<Job>, machine: Arc<Configuration>, position: Axes) -> Self {
        let job = begin::placed(job, &machine, position);
        let zpos = machine.zpos;
        let heights =
            Heights { top_mm: zpos.top_mm, surface_mm: zpos.surface_mm, bottom_mm: zpos.bottom_mm };
        let settings = job_settings(&machine);
        let cut_mm_s = settings.smoothing.cut_speed_mm_s.unwrap_or(settings.speeds.cut.xy);
        let mut frame = Frame::default();
        let origin = job.origin.unwrap_or_default();
        (frame.working_zero[Axis::X], frame.working_zero[Axis::Y]) = (origin.x, origin.y);
        Self {
            settings: Arc::new(settings),
            frame,
            heights,
            cut_mm_s,
            plunge_mm_s: machine.speeds.plunge_mm_s,
            raise: machine.pause.raise,
            state: State::Idle,
            why: Arc::default(),
            stage: Stage::Begin,
            here: Here { nth: job.start.saturating_sub(1), ..Here::default() },
            depths: Depths::Along(heights.surface_mm),
            steps: VecDeque::new(),
            given: false,
            position,
            motions: 0,
            followed: Followed::default(),
            on: 0,
            began: Halted::default(),
            felt_mm: heights.surface_mm,
            begun_mm: heights.surface_mm,
            law: None,
            controlled: false,
            marked: false,
            halted_before: false,
            cut: 0,
            group: None,
            limited: Vec::new(),
            over: None,
            whole: job.clone(),
            jig: None,
            door: Door::Waits,
            job,
            machine,
        }
    }

    /// Returns the state of the machine.
    pub const fn state(&self) -> State {
        self.state
    }

    /// The job where it is cut, and how often.
    pub fn job(&self) -> &Job {
        &self.job
    }

    /// Highest cutting speed, mm/s.
    pub const fn cut_mm_s(&self) -> f64 {
        self.cut_mm_s
    }

    /// Returns the values that a pause may have changed.
    pub(crate) const fn in_force(&self) -> InForce {
        InForce { cut_mm_s: self.cut_mm_s, plunge_mm_s: self.plunge_mm_s, raise: self.raise }
    }

    /// The heights in force.
    pub const fn heights(&self) -> Heights {
        self.heights
    }

    pub(crate) const fn stop_settings(&self) -> StopSettings {
        StopSettings::profiler(self.raise)
    }

    pub(crate) fn is_on(&self, output: Output) -> bool {
        self.on & bit(output) != 0
    }

    pub(crate) fn is_at(&self, place: Point2) -> bool {
        let to = self.job.on_table(place);
        let (dx, dy) = (to.x - self.position[Axis::X], to.y - self.position[Axis::Y]);
        dx.abs() <= SAME_MM && dy.abs() <= SAME_MM
    }
}

/// The bit of an output.
pub(crate) const fn bit(output: Output) -> u32 {
    1 << output.number()
}
