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

use crate::Sequence;
use crate::path::nearest_turn;
use crate::place::Spot;
use crate::small::{Awaited, Small};
use kerf_machine::lines::{Input, Output};
use kerf_machine::settings::delays::{BottomDelayType, TimeoutAction};
use kerf_program::job::JobShape;
use kerf_program::{Axis, Beam};

impl Sequence {
    /// Returns the steps that are left of the pass at hand.
    pub(crate) fn pass_steps(&self) -> Vec<Small> {
        let Some(shape) = self.here.shape(&self.job) else { return Vec::new() };
        let mut steps = Vec::new();
        if let Some(spot) = self.here.spot(shape) {
            let z = self.height_at(shape, &spot);
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
            steps.extend(self.height_law(shape).map(|_| Small::TellHeights));
            steps.extend([Small::Follow, Small::Made]);
            steps.extend(self.end_of_cut(shape));
        }
        steps
    }

    /// To a place of the job at the height of travel, unless the tool is there.
    pub(crate) fn way_to(&self, place: kerf_geom::Point2) -> Vec<Small> {
        if self.is_at(place) { Vec::new() } else { vec![self.up(), Small::Travel(place)] }
    }

    /// To the height of travel; a job that does not raise in pauses moves by hand where it stands.
    pub(crate) fn up(&self) -> Small {
        Small::RaiseTo(self.travel_mm())
    }

    /// The height of travel: where height control carried it above home, that of home.
    pub(crate) fn travel_mm(&self) -> f64 {
        self.heights.top_mm.min(self.machine.zpos.top_mm.max(0.0))
    }

    fn traverse(&self, z: f64) -> Vec<Small> {
        let along = matches!(self.depths, kerf_program::job::Depths::Along(_));
        let down = along.then_some(Small::Plunge(z));
        down.into_iter().chain([Small::Follow, Small::Made]).collect()
    }

    /// From the height of travel to cutting.
    fn start(&self, shape: &JobShape, spot: &Spot, z: f64) -> Vec<Small> {
        if self.machine.plasma.use_sequence {
            return self.plasma_start(shape);
        }
        if self.pierces(shape) {
            return self.laser_start(shape, z);
        }
        let slope = self.slopes_from(shape, spot);
        let mut steps = self.tool_on(self.tool_of(shape));
        steps.extend(self.down(shape, slope.unwrap_or(z)));
        steps.push(Small::Switch(Output::cut(shape.cut), true));
        steps.extend(self.bottom_delay(shape));
        steps.extend(self.beam_follows(shape));
        steps.extend(slope.map(|_| Small::Slope));
        steps
    }

    /// The tool output and its delay; nothing when it is on.
    pub(crate) fn tool_on(&self, tool: Option<Output>) -> Vec<Small> {
        let Some(tool) = tool.filter(|tool| !self.is_on(*tool)) else { return Vec::new() };
        vec![Small::Switch(tool, true), Small::Wait(self.machine.delays.air_tool_s)]
    }

    /// A knife turns into the direction of the path before it plunges.
    pub(crate) fn turn_before_plunge(&self, shape: &JobShape, spot: &Spot) -> Option<Small> {
        if !self.machine.misc.tangential || shape.path.segment_count() == 0 {
            return None;
        }
        let direction = shape.path.segment(spot.segment).direction(spot.share);
        let degrees = direction.y.atan2(direction.x).to_degrees();
        Some(Small::Turn(nearest_turn(self.position[Axis::C], degrees)))
    }

    /// Behind a closed path a knife makes the last turn too: it stands as it began. Where its axis ends before
    /// that, it stays.
    pub(crate) fn turn_back(&self, shape: &JobShape) -> Option<Small> {
        let begins = Spot::start_of(shape);
        let turn = self.turn_before_plunge(shape, &begins).filter(|_| shape.path.closed)?;
        let reach = self.reach(Axis::C);
        let reached = |[low, high]: [f64; 2], degrees| (low..=high).contains(&degrees);
        let there = |turn: &Small| match (turn, reach) {
            (Small::Turn(degrees), Some(reach)) => reached(reach, *degrees),
            _ => true,
        };
        Some(turn).filter(there)
    }

    fn bottom_delay(&self, shape: &JobShape) -> Vec<Small> {
        let delays = &self.machine.delays;
        let mut steps = Vec::from_iter(self.beam_at_bottom(shape));
        if delays.bottom_type == BottomDelayType::Input {
            let pauses = delays.bottom_timeout == TimeoutAction::Pause;
            let missing = pauses.then_some("no end-of-bottom-delay input");
            let (input, timeout_s) = (Input::EndBottomDelay, delays.bottom_timeout_s);
            steps.push(Small::Await(Awaited { input, timeout_s, missing }));
        }
        steps.push(Small::Wait(delays.bottom_s));
        steps
    }

    fn end_of_cut(&self, shape: &JobShape) -> Vec<Small> {
        let mut steps = vec![Small::Height(None), Small::Switch(Output::cut(shape.cut), false)];
        steps.extend(self.beam_at_end());
        steps.push(Small::Wait(self.machine.delays.end_s));
        steps.push(Small::Beam(Beam::Off));
        steps
    }

    /// The path is made: the tool goes up, unless the next pass begins right here.
    pub(crate) fn end_of_pass(&self) -> Vec<Small> {
        let Some(shape) = self.here.shape(&self.job) else { return Vec::new() };
        let more = self.here.pass + 1 < crate::place::passes(&self.depths);
        let mut steps = Vec::new();
        if !shape.traversal && !more {
            steps.push(self.up());
            steps.extend(self.turn_back(shape));
            steps.extend(self.tools_off());
        }
        steps.push(Small::Clear);
        steps
    }

    /// Tool outputs go off, with the delay of each.
    pub(crate) fn tools_off(&self) -> Vec<Small> {
        let tools = [Output::Tool1, Output::Tool2, Output::Tool3];
        let on: Vec<Output> = tools.into_iter().filter(|tool| self.is_on(*tool)).collect();
        let wait = (!on.is_empty()).then_some(Small::Wait(self.machine.delays.air_tool_s));
        on.into_iter().map(|tool| Small::Switch(tool, false)).chain(wait).collect()
    }
}
