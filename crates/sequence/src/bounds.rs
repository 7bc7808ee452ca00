//! Places that a job reaches: all are known before the first move, and none of them may lie where an
//! axis cannot go.

use crate::Sequence;
use crate::place::{Along, Here, Spot, passes};
use crate::small::Small;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_geom::{Bounds2, Point2};
use kerf_machine::homing::{soft_bounds, table_bounds};
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

impl Sequence {
    /// Returns the range of an axis, machine frame; `None` when it has no bounds.
    pub fn reach(&self, axis: Axis) -> Option<[f64; 2]> {
        let (soft, table) = (soft_bounds(&self.machine, axis), table_bounds(&self.machine, axis));
        match (soft, table) {
            (Some(soft), Some(table)) => Some([soft.0.max(table.0), soft.1.min(table.1)]),
            (soft, table) => soft.or(table).map(Into::into),
        }
    }

    /// The first place of the job that no axis can go to.
    pub(crate) fn outside(&self) -> Option<Diagnostic> {
        let shapes = self.job.shapes.iter();
        let mut places = shapes
            .flat_map(|shape| self.reached_by(shape))
            .chain(self.reached_beside())
            .filter(|reached| self.is_outside(reached));
        let reached = places.next().or_else(|| self.turned_too_far())?;
        let Reached { shape, what, axis, value } = reached;
        let letter = axis.letter();
        let place = Place::line(self.job.name.clone(), shape);
        let message = format!("Out of bounds: {what} reaches {letter} {value:.3}");
        let told = Diagnostic::new(Code::OutsideLimits, place, message);
        let Some([low, high]) = self.reach(axis) else { return Some(told) };
        let mut hint = format!("{letter} goes from {low:.3} to {high:.3}");
        if axis == Axis::C && self.machine.misc.tangential {
            hint += "; misc.tangential_endless tells that the tangential axis has no end";
        }
        Some(told.hint(hint))
    }

    fn is_outside(&self, reached: &Reached) -> bool {
        let reach = self.reach(reached.axis);
        reach.is_some_and(|[low, high]| !(low - SLACK..=high + SLACK).contains(&reached.value))
    }

    /// Returns the places that a shape reaches: its path, the way down beside it, its heights.
    fn reached_by(&self, shape: &JobShape) -> Vec<Reached> {
        let mut bounds = shape.path.bounds();
        let mut heights = Vec::new();
        match Depths::of(shape.depth, &shape.z_mm, &self.heights) {
            Ok(Depths::Level(levels)) => {
                bounds.merge(&self.beside(shape, &levels));
                heights.extend(levels.first().into_iter().chain(levels.last()).copied());
            }
            Ok(Depths::Along(base)) => heights.extend(shape.z_mm.iter().map(|z| base + z)),
            Err(_) => {}
        }
        if self.pierces(shape) && self.height_law(shape).is_none() {
            heights.push(self.heights.surface_mm + self.machine.laser.pierce.height_mm);
        }
        let corners = [bounds.min, bounds.max].map(|corner| self.job.on_table(corner));
        let corners = corners.iter().filter(|_| !bounds.is_empty());
        let plane = corners.flat_map(|at| [(Axis::X, at.x), (Axis::Y, at.y)]);
        let heights = heights.into_iter().flat_map(|z| self.heads().map(move |axis| (axis, z)));
        let places = plane.chain(heights);
        places.map(|(axis, value)| Reached::by(shape, axis, value)).collect()
    }

    /// The axes that go up and down.
    fn heads(&self) -> impl Iterator<Item = Axis> + use<> {
        let both = self.machine.job.heads == Heads::Both;
        [Some(Axis::Z), both.then_some(Z2)].into_iter().flatten()
    }

    /// The room of the way down to the first and the last of some heights.
    fn beside(&self, shape: &JobShape, levels: &[f64]) -> Bounds2 {
        let mut bounds = shape.path.bounds();
        let stays = self.machine.plasma.use_sequence || self.pierces(shape);
        if stays || shape.traversal || self.height_law(shape).is_some() {
            return bounds;
        }
        let from = |index: usize| match index.checked_sub(1) {
            Some(before) => levels[before],
            None => self.heights.surface_mm,
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
        let Point2 { x, y } = self.job.on_table(self.job.finish.unwrap_or_default());
        let finish = [(Axis::X, x), (Axis::Y, y)];
        let finish = finish.map(|(axis, at)| Reached::by_job("the finish position", axis, at));
        let travel_mm = self.travel_mm();
        let tops = self.heads().map(|axis| Reached::by_job("ZTop", axis, travel_mm));
        finish.into_iter().chain(tops).collect()
    }

    /// The first turn that a tangential axis with an end cannot make. It turns as it will in the job.
    fn turned_too_far(&self) -> Option<Reached> {
        let bounded = self.machine.misc.tangential && self.reach(Axis::C).is_some();
        let mut dry = bounded.then(|| self.clone())?;
        let job = self.job.clone();
        let mut first = self.here.nth;
        for _ in 0..job.repeats.max(1) {
            let begins = dry.position[Axis::C];
            for (nth, shape) in job.shapes.iter().enumerate().skip(first) {
                dry.here = Here { nth, ..Here::default() };
                dry.refresh_depths();
                for pass in 0..passes(&dry.depths) {
                    let turns = dry.turns_of(shape, pass).into_iter();
                    let mut turns = turns.map(|degrees| Reached::by(shape, Axis::C, degrees));
                    if let Some(outside) = turns.find(|it| self.is_outside(it)) {
                        return Some(outside);
                    }
                }
            }
            first = 0;
            // Once more is the same again, unless it begins further round.
            if (dry.position[Axis::C] - begins).abs() < SLACK {
                break;
            }
        }
        None
    }

    /// Returns the angles of the knife in a pass, one turn after the other.
    fn turns_of(&mut self, shape: &JobShape, pass: usize) -> Vec<f64> {
        self.here = Here { pass, along: Along::Before, ..self.here };
        let mut turns = Vec::new();
        let spot = Spot::start_of(shape);
        if let Some(Small::Turn(degrees)) = self.turn_before_plunge(shape, &spot) {
            self.position[Axis::C] = degrees;
            turns.push(degrees);
        }
        let mut out: Vec<Sourced> = Vec::new();
        if let Some(from_mm) = self.slopes_from(shape, &spot) {
            self.position[Axis::Z] = from_mm;
            self.slope(&mut out);
        }
        self.follow(&mut out);
        turns.extend(out.iter().filter_map(|sourced| match &sourced.command {
            Command::Line(line) => Some(line.to[Axis::C]),
            Command::Arc(arc) => Some(arc.to[Axis::C]),
            _ => None,
        }));
        if let Some(Small::Turn(degrees)) = self.turn_back(shape) {
            self.position[Axis::C] = degrees;
        }
        turns
    }
}
