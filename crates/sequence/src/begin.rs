//! The beginning and the end of a job, and the way from one path to the next.

use crate::Sequence;
use crate::place::{Along, Here, Stage, passes};
use crate::small::Small;
use crate::start::Door;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_geom::Point2;
use kerf_machine::lines::Output;
use kerf_machine::settings::Configuration;
use kerf_machine::state::{Event, State};
use kerf_program::job::{Depths, Job};
use kerf_program::{At, Axes, Axis, AxisSet, Command, Sourced, Status, Step, ToolPathStart};
use std::sync::Arc;

/// The job where it is cut, and how often: Start may take the present position as origin.
pub(crate) fn placed(job: Arc<Job>, machine: &Configuration, position: Axes) -> Arc<Job> {
    let mut placed = (*job).clone();
    [placed.origin, placed.finish] = lies(&job, machine).map(Some);
    if machine.job.change_origin_at_start {
        placed.origin = Some(Point2::new(position[Axis::X], position[Axis::Y]));
    }
    placed.repeats = placed.repeats.max(machine.job.repeats);
    Arc::new(placed)
}

/// Returns the origin of a job on the table and its finish position: those of the machine, where
/// the job says nothing of them.
pub fn lies(job: &Job, machine: &Configuration) -> [Point2; 2] {
    let set = [machine.job.origin_mm, machine.job.finish_mm].map(|[x, y]| Point2::new(x, y));
    [job.origin.unwrap_or(set[0]), job.finish.unwrap_or(set[1])]
}

impl Sequence {
    /// No step is left: what comes next.
    pub(crate) fn advance(&mut self, out: &mut Vec<Sourced>) -> Step {
        match self.stage {
            Stage::Begin => return self.begin(out),
            Stage::Waiting if self.door == Door::Only => return self.end(Status::Ok),
            Stage::Waiting => self.start_now(),
            Stage::Approach => {
                self.stage = Stage::Shapes;
                self.enter_pass(out);
            }
            Stage::Shapes => self.after_pass(out),
            Stage::Finish => return self.end(Status::Ok),
        }
        Step::Ran
    }

    /// The run is over.
    pub(crate) fn end(&mut self, status: Status) -> Step {
        self.over = Some((status, None));
        Step::Done(status, None)
    }

    fn begin(&mut self, out: &mut Vec<Sourced>) -> Step {
        if let Some(diagnostic) = self.refusal() {
            let diagnostic = Some(Box::new(diagnostic));
            self.over = Some((Status::Failed, diagnostic.clone()));
            return Step::Done(Status::Failed, diagnostic);
        }
        self.give(Command::Settings(self.settings.clone()), out);
        let working = AxisSet::first(2);
        self.give(Command::Location { frame: self.frame, working, base: AxisSet::EMPTY }, out);
        self.state =
            self.state.on(Event::Start, self.stop_settings()).map_or(self.state, |n| n.state);
        self.stage = Stage::Waiting;
        if self.door != Door::Only {
            self.tell_heights(out);
            self.tell_straddling(out);
            self.tell_entries(out);
        }
        self.steps = self.before_start().into();
        Step::Ran
    }

    /// At z = 0 to the first shape, down, the router and its delay; after a pause at the height the
    /// head has, at the lowest that of travel.
    pub(crate) fn approach(&self, again: bool) -> Vec<Small> {
        let mut steps = Vec::new();
        if let Some(shape) = self.here.shape(&self.job) {
            steps.push(if again { self.up() } else { Small::RaiseTo(0.0) });
            steps.push(Small::Travel(shape.start()));
        }
        steps.push(Small::Rapid(self.travel_mm()));
        // A first shape with a pause mark: the router waits for the operator.
        if !self.here.shape(&self.job).is_some_and(|shape| self.is_marked(shape)) {
            steps.extend(self.router_on());
        }
        steps
    }

    pub(crate) fn router_on(&self) -> [Small; 2] {
        [Small::Switch(Output::Router, true), Small::Wait(self.machine.delays.router_start_s)]
    }

    /// A pass begins: its heights are those of now.
    pub(crate) fn enter_pass(&mut self, out: &mut Vec<Sourced>) {
        let job = self.job.clone();
        let Some(shape) = self.here.shape(&job) else { return self.leave() };
        if let Err(low) = Depths::of(shape.depth, &shape.z_mm, &self.heights) {
            // A pause lifted ZBottom above it.
            return self.fault(&format!("shape {}: {low}", shape.number));
        }
        self.refresh_depths();
        if self.group.as_ref() != Some(&shape.group) {
            self.group = Some(shape.group.clone());
            let tool = shape.tool.to_string();
            let (name, tool) = (Some(shape.group.clone()), Some(tool.as_str().into()));
            self.give(Command::ToolPath(ToolPathStart { name, tool }), out);
        }
        let steps = self.pass_steps();
        self.steps.extend(steps);
    }

    /// The heights of the path at hand are those of now.
    pub(crate) fn refresh_depths(&mut self) {
        let depths = self
            .here
            .shape(&self.job)
            .map(|shape| Depths::of(shape.depth, &shape.z_mm, &self.heights));
        if let Some(Ok(depths)) = depths {
            self.depths = depths;
        }
    }

    /// A pass is made, or the tool is clear of it.
    fn after_pass(&mut self, out: &mut Vec<Sourced>) {
        if self.here.along != Along::Clear {
            self.steps = self.end_of_pass().into();
            return;
        }
        self.here = self.next();
        self.halted_before &= self.here.pass > 0;
        self.cut += u64::from(self.here.pass == 0);
        self.enter_pass(out);
    }

    /// The path that follows; beyond the last shape when there is none.
    fn next(&mut self) -> Here {
        let Here { repeat, nth, pass, .. } = self.here;
        if pass + 1 < passes(&self.depths) {
            return Here { pass: pass + 1, along: Along::Before, ..self.here };
        }
        let repeats = self.job.repeats.max(1);
        if nth + 1 >= self.job.shapes.len() && repeat + 1 < repeats {
            let text = format!("{} of {repeats}", repeat + 2).into();
            self.steps.push_back(Small::Say(text));
            return Here { repeat: repeat + 1, ..Here::default() };
        }
        Here { nth: nth + 1, pass: 0, along: Along::Before, repeat }
    }

    /// All shapes are cut: the router goes off, the head goes to the finish position.
    fn leave(&mut self) {
        if self.next_jig() {
            return;
        }
        self.stage = Stage::Finish;
        self.steps = self.finish().into();
    }

    pub(crate) fn finish(&self) -> Vec<Small> {
        vec![
            self.up(),
            Small::Switch(Output::Router, false),
            Small::Travel(self.job.finish.unwrap_or_default()),
            Small::Switch(Output::JobRunning, false),
            Small::RestoreHeights,
            Small::Enter(State::Idle),
        ]
    }

    /// Returns the reason if the job cannot begin.
    fn refusal(&self) -> Option<Diagnostic> {
        let problem = self.no_pulse().map(|why| (0, why.to_owned()));
        let problem = problem.map(|(line, message)| self.outside_limits(line, message));
        problem.or_else(|| self.too_low_to_cut()).or_else(|| self.outside())
    }

    /// The first shape that would be cut below ZBottom.
    pub(crate) fn too_low_to_cut(&self) -> Option<Diagnostic> {
        self.job.shapes.iter().find_map(|shape| {
            let low = Depths::of(shape.depth, &shape.z_mm, &self.heights).err()?;
            Some(self.outside_limits(shape.number, format!("shape {}: {low}", shape.number)))
        })
    }

    fn outside_limits(&self, line: u32, message: String) -> Diagnostic {
        let place = Place::line(self.job.name.clone(), line);
        Diagnostic::new(Code::OutsideLimits, place, message)
    }

    /// Returns the place of the job in its file: the number of the shape.
    pub(crate) fn at(&self) -> At {
        At { file: 0, line: self.here.shape(&self.job).map_or(0, |shape| shape.number) }
    }
}
