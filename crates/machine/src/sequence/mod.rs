//! Jobs on a machine: the order in which outputs switch, delays pass and the tool moves, and what a
//! stop in the middle does to it (Profiler reference, "Machining the Job", "Special Delay Times
//! During Cutting", "Pausing the Machine").
//!
//! A [`Sequence`] is an [`Interpreter`](kerf_program::Interpreter): it is stepped, never blocks, and
//! gives the same commands as a part file does. So preview, time, trace and a real run treat a job and
//! a program alike, and the time of a job is that of the plan.
//!
//! ```text
//!  Job ──► pass by pass ──► small steps ──► commands
//!             ▲  shape.rs, beam.rs, plasma.rs   carry.rs, path.rs
//!             └── stop, arc lost, estop: pause.rs ──► State (one table for all machines)
//!                 power cut: taken_up.rs
//! ```
//!
//! What a pass is made of is decided when it begins, from what then holds: a pause may have changed
//! speeds, ZBottom or the height of the sheet. A router, a laser, a plasma torch and a knife differ
//! in a few small steps only.

mod beam;
mod begin;
mod bounds;
mod carry;
mod entry;
mod forbidden;
mod height;
mod limited;
mod path;
mod pause;
mod place;
mod plasma;
mod program;
mod shape;
mod small;
mod start;
mod taken_up;
mod words;

pub use begin::{lies, settings as planner_settings};
pub(crate) use carry::rapid_mm_s;
pub(crate) use forbidden::stop_input;
pub(crate) use path::CHORDS;
pub use start::straddling;
pub use words::Word;

use crate::lines::Output;
use crate::settings::Configuration;
use crate::state::{State, StopSettings};
use kerf_diag::Diagnostic;
use kerf_geom::Point2;
use kerf_program::job::{Depths, Heights, InForce, Job};
use kerf_program::{Axes, Axis, Frame, Halted, HeightLaw, Settings, Status};
use path::Followed;
use place::{Here, Stage};
use small::Small;
use start::{Door, Jig};
use std::collections::VecDeque;
use std::sync::Arc;

/// Places closer than this are the same, mm.
const SAME_MM: f64 = 1e-9;

/// A job being cut.
#[derive(Clone, Debug)]
pub struct Sequence {
    job: Arc<Job>,
    /// The job that was given, where the one at hand is a part of it.
    whole: Arc<Job>,
    /// State of the wait for the door.
    door: Door,
    /// The jig being cut, or cut last.
    jig: Option<Jig>,
    machine: Arc<Configuration>,
    /// Settings of the planner.
    settings: Arc<Settings>,
    frame: Frame,
    /// The heights in force: a pause or height control moves them.
    heights: Heights,
    cut_mm_s: f64,
    plunge_mm_s: f64,
    raise: bool,
    state: State,
    /// Reason for which it is not running.
    why: Arc<str>,
    stage: Stage,
    here: Here,
    /// Heights of the path at hand.
    depths: Depths,
    /// Steps still to do.
    steps: VecDeque<Small>,
    /// The commands of the first of them were given.
    given: bool,
    position: Axes,
    motions: u64,
    followed: Followed,
    /// Outputs that are on, a bit each.
    on: u32,
    /// Place where the last input fired.
    began: Halted,
    /// Place where the sheet was felt, Z of the machine frame.
    felt_mm: f64,
    /// The height from which height control carried Z, machine frame.
    begun_mm: f64,
    /// Law by which Z follows the sheet, or followed it last.
    law: Option<Arc<HeightLaw>>,
    /// Height control is on.
    controlled: bool,
    /// The machine stands at the pause mark of a shape.
    marked: bool,
    /// It halted at the pause mark of this shape already.
    halted_before: bool,
    cut: u64,
    /// The group told last.
    group: Option<Arc<str>>,
    /// Groups that were told to be slower than they ask for.
    limited: Vec<Arc<str>>,
    over: Option<(Status, Option<Box<Diagnostic>>)>,
}

impl Sequence {
    /// A job on a machine that stands at a position, machine frame.
    pub fn new(job: Arc<Job>, machine: Arc<Configuration>, position: Axes) -> Self {
        let job = begin::placed(job, &machine, position);
        let zpos = machine.zpos;
        let heights =
            Heights { top_mm: zpos.top_mm, surface_mm: zpos.surface_mm, bottom_mm: zpos.bottom_mm };
        let settings = begin::settings(&machine);
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
    const fn in_force(&self) -> InForce {
        InForce { cut_mm_s: self.cut_mm_s, plunge_mm_s: self.plunge_mm_s, raise: self.raise }
    }

    /// The heights in force.
    pub const fn heights(&self) -> Heights {
        self.heights
    }

    const fn stop_settings(&self) -> StopSettings {
        StopSettings::profiler(self.raise)
    }

    fn is_on(&self, output: Output) -> bool {
        self.on & bit(output) != 0
    }

    fn is_at(&self, place: Point2) -> bool {
        let to = self.job.on_table(place);
        let (dx, dy) = (to.x - self.position[Axis::X], to.y - self.position[Axis::Y]);
        dx.abs() <= SAME_MM && dy.abs() <= SAME_MM
    }
}

/// The bit of an output.
const fn bit(output: Output) -> u32 {
    1 << output.number()
}
