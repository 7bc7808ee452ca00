//! What a stop, a pause mark and a way back come to, as steps.

use crate::place::{Along, Stage};
use crate::schedule::Schedule;
use crate::start::{Door, PATIENCE_S};
use crate::step::{Awaited, Step};
use kerf_machine::State;
use kerf_machine::lines::{Input, Output};
use kerf_machine::state::Effect;
use kerf_program::Beam;
use kerf_program::job::JobShape;

/// Cut outputs.
const CUTS: [Output; 3] = [Output::Cut1, Output::Cut2, Output::Cut3];

/// Tool outputs.
const TOOLS: [Output; 3] = [Output::Tool1, Output::Tool2, Output::Tool3];

impl Schedule<'_> {
    /// Returns `true` if the machine halts by itself before a shape that is about to begin.
    pub fn is_marked(&self, shape: &JobShape) -> bool {
        shape.pause && self.progress.here.pass == 0 && !self.halt.halted_before
    }

    /// A pause mark: the head waits over the shape, whatever cuts is off.
    pub fn mark(&self) -> Vec<Step> {
        let off = [Effect::CutOff, Effect::RouterOff, Effect::ToolOff];
        let mut steps: Vec<Step> = off.into_iter().flat_map(|it| self.effect(it)).collect();
        steps.extend([Step::Mark, Step::Ask]);
        steps
    }

    /// The steps of an effect; what slows motion down has happened when they are asked for.
    pub fn effect(&self, effect: Effect) -> Vec<Step> {
        // Whether an output is on is asked when its step is carried out: steps before it may switch it on.
        let off = |outputs: &[Output]| -> Vec<Step> {
            outputs.iter().map(|output| Step::Switch(*output, false)).collect()
        };
        match effect {
            Effect::CutOff => {
                let mut steps = vec![Step::Height(None)];
                steps.extend(off(&CUTS));
                steps.push(Step::Beam(Beam::Off));
                steps
            }
            Effect::RouterOff | Effect::SpindleOff => off(&[Output::Router]),
            Effect::AllOff | Effect::LeaveOutputs => {
                off(Output::ALL).into_iter().chain([Step::Beam(Beam::Off)]).collect()
            }
            Effect::Raise => vec![Step::RaiseTo(self.travel_mm())],
            Effect::ToolOff => off(&TOOLS),
            Effect::ComeBack => self.come_back(),
            Effect::RestoreHeights => vec![Step::RestoreHeights],
            Effect::CutOffAtOnce
            | Effect::SlowDown
            | Effect::Halt
            | Effect::KeepPlace
            | Effect::MotorsOff
            | Effect::Doubt => Vec::new(),
        }
    }

    /// Back to where the job was left: router, tool, plunge, cut, each with its delay.
    pub fn come_back(&self) -> Vec<Step> {
        if self.progress.stage == Stage::Waiting {
            return self.before_start();
        }
        if matches!(self.progress.stage, Stage::Begin | Stage::Approach) {
            return self.approach(true);
        }
        if self.progress.stage == Stage::Finish {
            return self.finish();
        }
        let back = self
            .progress
            .here
            .shape(&self.setup.job)
            .and_then(|shape| self.progress.here.spot(shape));
        let mut steps = back.map_or(Vec::new(), |spot| self.way_to(spot.at));
        steps.extend(self.router_on());
        if self.progress.here.along == Along::After || self.progress.here.along == Along::Clear {
            return steps;
        }
        steps.extend(self.pass_steps());
        steps
    }

    /// Returns the steps before the job begins; often none.
    pub fn before_start(&self) -> Vec<Step> {
        let mut steps = Vec::new();
        if self.setup.machine.job.external_start && self.start.door != Door::Shut {
            let (input, timeout_s) = (Input::WHome, PATIENCE_S);
            let missing = "close the door";
            steps.push(Step::SayUnless(input, missing));
            steps.push(Step::Await(Awaited { input, timeout_s, missing: Some(missing) }));
        }
        if self.start.door == Door::Only {
            steps.insert(0, Step::Enter(State::Waiting));
            return steps;
        }
        if self.setup.machine.misc.double_start {
            steps.push(Step::Ask);
        }
        if self.setup.machine.job.two_jigs {
            steps.extend([Step::Switch(Output::JobRunning, true), Step::AwaitJig]);
        }
        if !steps.is_empty() {
            steps.insert(0, Step::Enter(State::Waiting));
        }
        steps
    }

    /// The output of the jig that is being cut.
    pub fn jig_on(&self) -> Option<Step> {
        let jig = self.start.jig.filter(|_| self.progress.stage != Stage::Waiting)?;
        Some(Step::Switch(jig.output(), true))
    }
}
