//! The steps of one pass of one shape.
//!
//! ```text
//!  travel ─► tool on ─► down ─► start ─► follow ─► cut off, end delay ─► up ─► tool off
//!                                 │
//!            router: cut on, bottom delay          (Profiler reference, "Special Delay Times")
//!            laser:  pierce, purge, gas            ("Laser Operation")
//!            plasma: feel the sheet, arc           ("Plasma Startup Sequence")
//! ```
//!
//! Every kind of machine is this one list with other steps for the start.

use crate::cut::Cut;
use crate::halt::Halt;
use crate::head::Head;
use crate::path::nearest_turn;
use crate::place::{Along, Progress, Spot, passes};
use crate::plasma;
use crate::setup::Setup;
use crate::sheet;
use crate::start::Start;
use crate::step::Step;
use crate::values::Values;
use kerf_geom::Point2;
use kerf_machine::State;
use kerf_machine::lines::Output;
use kerf_program::job::{Depths, JobShape};
use kerf_program::{Axis, HeightLaw};
use std::sync::Arc;

/// The steps that come next, from how far the job is and what holds now. It reads, and changes nothing.
pub(crate) struct Schedule<'a> {
    pub setup: &'a Setup,
    pub values: &'a Values,
    pub head: &'a Head,
    pub progress: &'a Progress,
    pub halt: &'a Halt,
    pub start: &'a Start,
}

impl Schedule<'_> {
    /// A shape, and what it is cut with.
    pub fn cut<'b>(&'b self, shape: &'b JobShape) -> Cut<'b> {
        Cut { setup: self.setup, values: self.values, shape }
    }

    /// Returns the steps that are left of the pass at hand.
    pub fn pass_steps(&self) -> Vec<Step> {
        let Some(shape) = self.progress.here.shape(&self.setup.job) else { return Vec::new() };
        let mut steps = Vec::new();
        if let Some(spot) = self.progress.here.spot(shape) {
            let z = self.progress.height_at(shape, &spot, self.values.heights.bottom_mm);
            steps.extend(self.link(shape, spot.at));
            if self.is_marked(shape) {
                steps.extend(self.mark());
                return steps;
            }
            if shape.traversal {
                steps.extend(self.traverse(z));
                return steps;
            }
            steps.extend(self.turn_before_plunge(shape, &spot));
            steps.extend(self.start(shape, &spot, z));
            steps.extend(self.cut(shape).height_law().map(|_| Step::TellHeights));
            steps.extend([Step::Follow, Step::Made]);
            steps.extend(self.cut(shape).end_of_cut());
        }
        steps
    }

    /// To a place of the job at the height of travel, unless the tool is there.
    pub fn way_to(&self, place: Point2) -> Vec<Step> {
        if self.setup.is_over(self.head.position, place) {
            Vec::new()
        } else {
            vec![self.up(), Step::Travel(place)]
        }
    }

    /// To the height of travel; a job that does not raise in pauses moves by hand where it stands.
    pub fn up(&self) -> Step {
        Step::RaiseTo(self.travel_mm())
    }

    /// The height of travel: where height control carried it above home, that of home.
    pub fn travel_mm(&self) -> f64 {
        self.values.travel_mm(&self.setup.machine)
    }

    fn traverse(&self, z: f64) -> Vec<Step> {
        let along = matches!(self.progress.depths, Depths::Along(_));
        let down = along.then_some(Step::Plunge(z));
        down.into_iter().chain([Step::Follow, Step::Made]).collect()
    }

    /// From the height of travel to cutting.
    fn start(&self, shape: &JobShape, spot: &Spot, z: f64) -> Vec<Step> {
        if self.setup.machine.plasma.use_sequence {
            return plasma::start(&self.cut(shape), self.tool_on(self.cut(shape).tool_of()));
        }
        if self.cut(shape).pierces() {
            return self.cut(shape).laser_start(z);
        }
        let slope = self.cut(shape).slopes_from(self.progress, spot);
        let mut steps = self.tool_on(self.cut(shape).tool_of());
        steps.extend(self.cut(shape).down(slope.unwrap_or(z)));
        steps.push(Step::Switch(Output::cut(shape.cut), true));
        steps.extend(self.cut(shape).bottom_delay());
        steps.extend(self.cut(shape).beam_follows());
        steps.extend(slope.map(|_| Step::Slope));
        steps
    }

    /// The tool output and its delay; nothing when it is on.
    pub fn tool_on(&self, tool: Option<Output>) -> Vec<Step> {
        let Some(tool) = tool.filter(|tool| !self.head.is_on(*tool)) else { return Vec::new() };
        vec![Step::Switch(tool, true), Step::Wait(self.setup.machine.delays.air_tool_s)]
    }

    /// A knife turns into the direction of the path before it plunges.
    pub fn turn_before_plunge(&self, shape: &JobShape, spot: &Spot) -> Option<Step> {
        if !self.setup.machine.misc.tangential || shape.path.segment_count() == 0 {
            return None;
        }
        let direction = shape.path.segment(spot.segment).direction(spot.share);
        let degrees = direction.y.atan2(direction.x).to_degrees();
        Some(Step::Turn(nearest_turn(self.head.position[Axis::C], degrees)))
    }

    /// Behind a closed path a knife makes the last turn too: it stands as it began. Where its axis ends before
    /// that, it stays.
    pub fn turn_back(&self, shape: &JobShape) -> Option<Step> {
        let begins = Spot::start_of(shape);
        let turn = self.turn_before_plunge(shape, &begins).filter(|_| shape.path.closed)?;
        let reach = self.setup.reach(Axis::C);
        let reached = |[low, high]: [f64; 2], degrees| (low..=high).contains(&degrees);
        let there = |turn: &Step| match (turn, reach) {
            (Step::Turn(degrees), Some(reach)) => reached(reach, *degrees),
            _ => true,
        };
        Some(turn).filter(there)
    }

    /// The path is made: the tool goes up, unless the next pass begins right here.
    pub fn end_of_pass(&self) -> Vec<Step> {
        let Some(shape) = self.progress.here.shape(&self.setup.job) else { return Vec::new() };
        let more = self.progress.here.pass + 1 < passes(&self.progress.depths);
        let mut steps = Vec::new();
        if !shape.traversal && !more {
            steps.push(self.up());
            steps.extend(self.turn_back(shape));
            steps.extend(self.tools_off());
        }
        steps.push(Step::Clear);
        steps
    }

    /// Tool outputs go off, with the delay of each.
    pub fn tools_off(&self) -> Vec<Step> {
        let tools = [Output::Tool1, Output::Tool2, Output::Tool3];
        let on: Vec<Output> = tools.into_iter().filter(|tool| self.head.is_on(*tool)).collect();
        let wait = (!on.is_empty()).then_some(Step::Wait(self.setup.machine.delays.air_tool_s));
        on.into_iter().map(|tool| Step::Switch(tool, false)).chain(wait).collect()
    }

    /// At z = 0 to the first shape, down, the router and its delay; after a pause at the height the
    /// head has, at the lowest that of travel.
    pub fn approach(&self, again: bool) -> Vec<Step> {
        let mut steps = Vec::new();
        if let Some(shape) = self.progress.here.shape(&self.setup.job) {
            steps.push(if again { self.up() } else { Step::RaiseTo(0.0) });
            steps.push(Step::Travel(shape.start()));
        }
        steps.push(Step::Rapid(self.travel_mm()));
        // A first shape with a pause mark: the router waits for the operator.
        if !self.progress.here.shape(&self.setup.job).is_some_and(|shape| self.is_marked(shape)) {
            steps.extend(self.router_on());
        }
        steps
    }

    pub fn router_on(&self) -> [Step; 2] {
        [Step::Switch(Output::Router, true), Step::Wait(self.setup.machine.delays.router_start_s)]
    }

    pub fn finish(&self) -> Vec<Step> {
        vec![
            self.up(),
            Step::Switch(Output::Router, false),
            Step::Travel(self.setup.job.finish.unwrap_or_default()),
            Step::Switch(Output::JobRunning, false),
            Step::RestoreHeights,
            Step::Enter(State::Idle),
        ]
    }

    /// In the plane to where a path begins, its height over the sheet kept where that is asked for.
    pub fn link(&self, shape: &JobShape, place: Point2) -> Vec<Step> {
        let mut steps = self.way_to(place);
        let law = self.law_between(shape).filter(|_| self.progress.here.along == Along::Before);
        if let (Some(law), Some(at)) = (law, steps.len().checked_sub(1)) {
            steps.insert(at, Step::Height(Some(Arc::new(law))));
            steps.push(Step::Height(None));
        }
        steps
    }

    /// The same on the way from the path before to a path, at the height of travel, where both are followed.
    fn law_between(&self, shape: &JobShape) -> Option<HeightLaw> {
        let before =
            self.progress.here.nth.checked_sub(1).and_then(|nth| self.setup.job.shapes.get(nth))?;
        let followed = self.setup.machine.height.between && self.cut(before).height_law().is_some();
        let law = self.cut(shape).height_law().filter(|_| followed)?;
        // As far over the sheet as the way begins, whichever set point is that of its direction.
        let over_mm = sheet::gap_mm(&law, sheet::end_of(before))
            - sheet::gap_mm(&law, shape.start() - before.end());
        let raised_mm = self.travel_mm() - self.values.heights.surface_mm + over_mm;
        Some(HeightLaw { raised_mm: Some(raised_mm), ..law })
    }
}
