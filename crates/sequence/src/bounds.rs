//! Places that a job reaches: all are known before the first move, and none of them may lie where an
//! axis cannot go.

use crate::cut::Cut;
use crate::halt::Halt;
use crate::head::Head;
use crate::path::Follower;
use crate::place::{Along, Here, Progress, Spot, passes};
use crate::schedule::Schedule;
use crate::setup::Setup;
use crate::start::Start;
use crate::step::Step;
use crate::values::Values;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_geom::{Bounds2, Point2};
use kerf_machine::settings::axes::Z2;
use kerf_machine::settings::job::Heads;
use kerf_program::job::{Depths, JobShape};
use kerf_program::{Axis, Command, Sourced};

/// Slack for rounding, mm or degrees.
const SLACK: f64 = 1e-6;

/// A place that is reached.
struct Reached {
    /// The shape; 0 for what belongs to none.
    shape: u32,
    what: String,
    axis: Axis,
    value: f64,
}

impl Reached {
    fn by(shape: &JobShape, axis: Axis, value: f64) -> Self {
        Self { shape: shape.number, what: format!("shape {}", shape.number), axis, value }
    }

    fn by_job(what: &str, axis: Axis, value: f64) -> Self {
        Self { shape: 0, what: what.into(), axis, value }
    }
}

/// The job before it begins, from a shape on.
pub(crate) struct Extent<'a> {
    pub setup: &'a Setup,
    pub values: &'a Values,
    pub head: &'a Head,
    /// The shape with which it begins, counted from 0.
    pub nth: usize,
}

impl Extent<'_> {
    /// The first place of the job that no axis can go to.
    pub fn outside(&self) -> Option<Diagnostic> {
        let shapes = self.setup.job.shapes.iter();
        let mut places = shapes
            .flat_map(|shape| self.reached_by(shape))
            .chain(self.reached_beside())
            .filter(|reached| self.is_outside(reached));
        let reached = places.next().or_else(|| self.turned_too_far())?;
        let Reached { shape, what, axis, value } = reached;
        let letter = axis.letter();
        let place = SourcePlace::line(self.setup.job.name.clone(), shape);
        let message = format!("Out of bounds: {what} reaches {letter} {value:.3}");
        let told = Diagnostic::new(Code::OutsideLimits, place, message);
        let Some([low, high]) = self.setup.reach(axis) else { return Some(told) };
        let mut hint = format!("{letter} goes from {low:.3} to {high:.3}");
        if axis == Axis::C && self.setup.machine.misc.tangential {
            hint += "; misc.tangential_endless tells that the tangential axis has no end";
        }
        Some(told.hint(hint))
    }

    fn is_outside(&self, reached: &Reached) -> bool {
        let reach = self.setup.reach(reached.axis);
        reach.is_some_and(|[low, high]| !(low - SLACK..=high + SLACK).contains(&reached.value))
    }

    /// Returns the places that a shape reaches: its path, the way down beside it, its heights.
    fn reached_by(&self, shape: &JobShape) -> Vec<Reached> {
        let cut = Cut { setup: self.setup, values: self.values, shape };
        let mut bounds = shape.path.bounds();
        let mut heights = Vec::new();
        match shape.depths(&self.values.heights) {
            Ok(Depths::Level(levels)) => {
                bounds.merge(&self.beside(shape, &levels));
                heights.extend(levels.first().into_iter().chain(levels.last()).copied());
            }
            Ok(Depths::Along(base)) => heights.extend(shape.z_mm.iter().map(|z| base + z)),
            Err(_) => {}
        }
        if cut.pierces() && cut.height_law().is_none() {
            heights
                .push(self.values.heights.surface_mm + self.setup.machine.laser.pierce.height_mm);
        }
        let corners = [bounds.min, bounds.max].map(|corner| self.setup.job.on_table(corner));
        let corners = corners.iter().filter(|_| !bounds.is_empty());
        let plane = corners.flat_map(|at| [(Axis::X, at.x), (Axis::Y, at.y)]);
        let heights = heights.into_iter().flat_map(|z| self.heads().map(move |axis| (axis, z)));
        let places = plane.chain(heights);
        places.map(|(axis, value)| Reached::by(shape, axis, value)).collect()
    }

    /// The axes that go up and down.
    fn heads(&self) -> impl Iterator<Item = Axis> + use<> {
        let both = self.setup.machine.job.heads == Heads::Both;
        [Some(Axis::Z), both.then_some(Z2)].into_iter().flatten()
    }

    /// The room of the way down to the first and the last of some heights.
    fn beside(&self, shape: &JobShape, levels: &[f64]) -> Bounds2 {
        let cut = Cut { setup: self.setup, values: self.values, shape };
        let mut bounds = shape.path.bounds();
        let stays = self.setup.machine.plasma.use_sequence || cut.pierces();
        if stays || shape.traversal || cut.height_law().is_some() {
            return bounds;
        }
        let from = |index: usize| match index.checked_sub(1) {
            Some(before) => levels[before],
            None => self.values.heights.surface_mm,
        };
        for index in [0, levels.len().saturating_sub(1)] {
            let Some(level) = levels.get(index) else { continue };
            for slope in shape.plunge.slopes(&shape.path, from(index), *level) {
                bounds.merge(&slope.segment.bounds());
            }
        }
        bounds
    }

    /// Returns the places that the job reaches beside its shapes: the finish position, the height of travel.
    fn reached_beside(&self) -> Vec<Reached> {
        let Point2 { x, y } = self.setup.job.on_table(self.setup.job.finish.unwrap_or_default());
        let finish = [(Axis::X, x), (Axis::Y, y)];
        let finish = finish.map(|(axis, at)| Reached::by_job("the finish position", axis, at));
        let travel_mm = self.values.travel_mm(&self.setup.machine);
        let tops = self.heads().map(|axis| Reached::by_job("ZTop", axis, travel_mm));
        finish.into_iter().chain(tops).collect()
    }

    /// The first turn that a tangential axis with an end cannot make. It turns as it will in the job.
    fn turned_too_far(&self) -> Option<Reached> {
        let bounded = self.setup.machine.misc.tangential && self.setup.reach(Axis::C).is_some();
        let mut dry = bounded.then(|| self.dry())?;
        let job = &self.setup.job;
        let mut first = self.nth;
        for _ in 0..job.repeats.max(1) {
            let begins = dry.head.position[Axis::C];
            for (nth, shape) in job.shapes.iter().enumerate().skip(first) {
                dry.progress.here = Here { nth, ..Here::default() };
                dry.progress.refresh_depths(job, &self.values.heights);
                for pass in 0..passes(&dry.progress.depths) {
                    let turns = dry.turns_of(shape, pass).into_iter();
                    let mut turns = turns.map(|degrees| Reached::by(shape, Axis::C, degrees));
                    if let Some(outside) = turns.find(|it| self.is_outside(it)) {
                        return Some(outside);
                    }
                }
            }
            first = 0;
            // Once more is the same again, unless it begins further round.
            if (dry.head.position[Axis::C] - begins).abs() < SLACK {
                break;
            }
        }
        None
    }

    fn dry(&self) -> Dry<'_> {
        let progress = Progress::new(&self.setup.job, &self.values.heights);
        let (halt, start) = (Halt::default(), Start::default());
        let (values, head) = (self.values.clone(), self.head.clone());
        Dry { setup: self.setup, values, head, progress, halt, start }
    }
}

/// A job of which only the turns of the knife are looked at.
struct Dry<'a> {
    setup: &'a Setup,
    values: Values,
    head: Head,
    progress: Progress,
    halt: Halt,
    start: Start,
}

impl Dry<'_> {
    const fn schedule(&self) -> Schedule<'_> {
        let Self { setup, values, head, progress, halt, start } = self;
        Schedule { setup, values, head, progress, halt, start }
    }

    const fn follower<'a>(&'a mut self, out: &'a mut Vec<Sourced>) -> Follower<'a> {
        let Self { setup, values, head, progress, .. } = self;
        Follower { setup, values, head, progress, out }
    }

    /// Returns the angles of the knife in a pass, one turn after the other.
    fn turns_of(&mut self, shape: &JobShape, pass: usize) -> Vec<f64> {
        self.progress.here = Here { pass, along: Along::Before, ..self.progress.here };
        let mut turns = Vec::new();
        let spot = Spot::start_of(shape);
        if let Some(Step::Turn(degrees)) = self.schedule().turn_before_plunge(shape, &spot) {
            self.head.position[Axis::C] = degrees;
            turns.push(degrees);
        }
        let mut out: Vec<Sourced> = Vec::new();
        if let Some(from_mm) = self.schedule().cut(shape).slopes_from(&self.progress, &spot) {
            self.head.position[Axis::Z] = from_mm;
            self.follower(&mut out).slope();
        }
        self.follower(&mut out).follow();
        turns.extend(out.iter().filter_map(|sourced| match &sourced.command {
            Command::Line(line) => Some(line.to[Axis::C]),
            Command::Arc(arc) => Some(arc.to[Axis::C]),
            _ => None,
        }));
        if let Some(Step::Turn(degrees)) = self.schedule().turn_back(shape) {
            self.head.position[Axis::C] = degrees;
        }
        turns
    }
}
