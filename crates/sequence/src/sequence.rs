//! A job being cut: its state.

use crate::beam::no_pulse;
use crate::bounds::Extent;
use crate::cut::Cut;
use crate::entry;
use crate::halt::Halt;
use crate::head::Head;
use crate::path::Follower;
use crate::place::{Along, Here, Progress, Stage};
use crate::queue::Queue;
use crate::schedule::Schedule;
use crate::setup::Setup;
use crate::sheet::Sheet;
use crate::start::{Door, Jig, Start, straddling};
use crate::step::Step;
use crate::values::Values;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_machine::lines::{Input, Output};
use kerf_machine::state::Event;
use kerf_machine::{Configuration, State};
use kerf_program::job::{Heights, Job, JobShape};
use kerf_program::{
    Axes, Axis, AxisSet, Command, HeightLaw, Sourced, Status, Step as Stepped, ToolPathStart,
};
use std::sync::Arc;

/// A job being cut.
#[derive(Clone, Debug)]
pub struct Sequence {
    pub(crate) setup: Setup,
    pub(crate) values: Values,
    pub(crate) head: Head,
    pub(crate) progress: Progress,
    pub(crate) halt: Halt,
    pub(crate) sheet: Sheet,
    pub(crate) start: Start,
    pub(crate) queue: Queue,
    pub(crate) over: Option<(Status, Option<Box<Diagnostic>>)>,
}

impl Sequence {
    /// A job on a machine that stands at a position, machine frame.
    pub fn new(job: Arc<Job>, machine: Arc<Configuration>, position: Axes) -> Self {
        let setup = Setup::new(job, machine, position);
        let values = Values::of(&setup.machine, &setup.settings);
        Self {
            progress: Progress::new(&setup.job, &values.heights),
            sheet: Sheet::at(values.heights.surface_mm),
            head: Head::at(position),
            halt: Halt::default(),
            start: Start { door: Door::Waits, jig: None },
            queue: Queue::default(),
            over: None,
            setup,
            values,
        }
    }

    /// Only waits until the door is shut: something has to be done then, before the job.
    #[must_use]
    pub const fn only_waits_for_door(mut self) -> Self {
        self.start.door = Door::Only;
        self
    }

    /// The job once the door was waited for.
    #[must_use]
    pub const fn behind_door(mut self) -> Self {
        self.start.door = Door::Shut;
        self
    }

    /// Returns the state of the machine.
    pub const fn state(&self) -> State {
        self.halt.state
    }

    /// The job where it is cut, and how often.
    pub fn job(&self) -> &Job {
        &self.setup.job
    }

    /// Highest cutting speed, mm/s.
    pub const fn cut_mm_s(&self) -> f64 {
        self.values.cut_mm_s
    }

    /// The heights in force.
    pub const fn heights(&self) -> Heights {
        self.values.heights
    }

    /// Returns the range of an axis, machine frame; `None` when it has no bounds.
    pub fn reach(&self, axis: Axis) -> Option<[f64; 2]> {
        self.setup.reach(axis)
    }

    /// Returns the law by which Z follows the sheet in the first shape in which it does.
    pub fn follows_sheet(&self) -> Option<HeightLaw> {
        let cut = |shape| self.cut(shape).height_law();
        self.setup.job.shapes.iter().find_map(cut)
    }

    /// The steps that may come next.
    pub(crate) const fn schedule(&self) -> Schedule<'_> {
        let Self { setup, values, head, progress, halt, start, .. } = self;
        Schedule { setup, values, head, progress, halt, start }
    }

    /// Whoever gives motions.
    pub(crate) const fn follower<'a>(&'a mut self, out: &'a mut Vec<Sourced>) -> Follower<'a> {
        let Self { setup, values, head, progress, .. } = self;
        Follower { setup, values, head, progress, out }
    }

    fn extent(&self) -> Extent<'_> {
        let Self { setup, values, head, .. } = self;
        Extent { setup, values, head, nth: self.progress.here.nth }
    }

    fn cut<'a>(&'a self, shape: &'a JobShape) -> Cut<'a> {
        Cut { setup: &self.setup, values: &self.values, shape }
    }

    pub(crate) fn give(&self, command: Command, out: &mut Vec<Sourced>) {
        out.push(Sourced { at: self.progress.at(&self.setup.job), command });
    }

    /// No step is left: what comes next.
    pub(crate) fn advance(&mut self, out: &mut Vec<Sourced>) -> Stepped {
        match self.progress.stage {
            Stage::Begin => return self.begin(out),
            Stage::Waiting if self.start.door == Door::Only => return self.end(Status::Ok),
            Stage::Waiting => self.start_now(),
            Stage::Approach => {
                self.progress.stage = Stage::Shapes;
                self.enter_pass(out);
            }
            Stage::Shapes => self.after_pass(out),
            Stage::Finish => return self.end(Status::Ok),
        }
        Stepped::Ran
    }

    /// The run is over.
    pub(crate) fn end(&mut self, status: Status) -> Stepped {
        self.over = Some((status, None));
        Stepped::Done(status, None)
    }

    fn begin(&mut self, out: &mut Vec<Sourced>) -> Stepped {
        if let Some(diagnostic) = self.refusal() {
            let diagnostic = Some(Box::new(diagnostic));
            self.over = Some((Status::Failed, diagnostic.clone()));
            return Stepped::Done(Status::Failed, diagnostic);
        }
        self.give(Command::Settings(self.setup.settings.clone()), out);
        let working = AxisSet::first(2);
        self.give(
            Command::Location { frame: self.setup.frame, working, base: AxisSet::EMPTY },
            out,
        );
        self.halt.state = self
            .halt
            .state
            .on(Event::Start, self.values.stop_settings())
            .map_or(self.halt.state, |n| n.state);
        self.progress.stage = Stage::Waiting;
        if self.start.door != Door::Only {
            self.tell_heights(out);
            let across = straddling(&self.setup.job, &self.setup.machine);
            across
                .into_iter()
                .for_each(|text| self.give(Command::Message { text: text.into() }, out));
            let told = entry::mistakes(&self.setup, &self.values);
            told.into_iter().for_each(|told| self.give(Command::Diagnostic(Box::new(told)), out));
        }
        self.queue.steps = self.schedule().before_start().into();
        Stepped::Ran
    }

    /// A pass begins: its heights are those of now.
    pub(crate) fn enter_pass(&mut self, out: &mut Vec<Sourced>) {
        let job = self.setup.job.clone();
        let Some(shape) = self.progress.here.shape(&job) else { return self.leave() };
        if let Err(low) = shape.depths(&self.values.heights) {
            // A pause lifted ZBottom above it.
            return self.fault(&format!("shape {}: {low}", shape.number));
        }
        self.progress.refresh_depths(&self.setup.job, &self.values.heights);
        if self.progress.group.as_ref() != Some(&shape.group) {
            self.progress.group = Some(shape.group.clone());
            let tool = shape.tool.to_string();
            let (name, tool) = (Some(shape.group.clone()), Some(tool.as_str().into()));
            self.give(Command::ToolPath(ToolPathStart { name, tool }), out);
        }
        let steps = self.schedule().pass_steps();
        self.queue.steps.extend(steps);
    }

    /// A pass is made, or the tool is clear of it.
    fn after_pass(&mut self, out: &mut Vec<Sourced>) {
        if self.progress.here.along != Along::Clear {
            self.queue.steps = self.schedule().end_of_pass().into();
            return;
        }
        let next = self.progress.next(&self.setup.job);
        if next.repeat != self.progress.here.repeat {
            let text = format!("{} of {}", next.repeat + 1, self.setup.job.repeats).into();
            self.queue.steps.push_back(Step::Say(text));
        }
        self.progress.here = next;
        self.halt.halted_before &= self.progress.here.pass > 0;
        self.progress.cut += u64::from(self.progress.here.pass == 0);
        self.enter_pass(out);
    }

    /// All shapes are cut: the router goes off, the head goes to the finish position.
    fn leave(&mut self) {
        if self.next_jig() {
            return;
        }
        self.progress.stage = Stage::Finish;
        self.queue.steps = self.schedule().finish().into();
    }

    /// Returns the reason if the job cannot begin.
    fn refusal(&self) -> Option<Diagnostic> {
        let problem = no_pulse(&self.setup.machine).map(|why| (0, why.to_owned()));
        let problem = problem.map(|(line, message)| self.outside_limits(line, message));
        problem.or_else(|| self.too_low_to_cut()).or_else(|| self.extent().outside())
    }

    /// The first shape that would be cut below ZBottom.
    pub(crate) fn too_low_to_cut(&self) -> Option<Diagnostic> {
        self.setup.job.shapes.iter().find_map(|shape| {
            let low = shape.depths(&self.values.heights).err()?;
            Some(self.outside_limits(shape.number, format!("shape {}: {low}", shape.number)))
        })
    }

    fn outside_limits(&self, line: u32, message: String) -> Diagnostic {
        let place = SourcePlace::line(self.setup.job.name.clone(), line);
        Diagnostic::new(Code::OutsideLimits, place, message)
    }

    /// Everything that was waited for is there.
    pub(crate) fn start_now(&mut self) {
        self.progress.stage = Stage::Approach;
        self.queue
            .steps
            .extend([Step::Enter(State::Running), Step::Switch(Output::JobRunning, true)]);
        self.queue.steps.extend(self.schedule().jig_on());
        self.queue.steps.extend(self.schedule().approach(false));
    }

    /// A jig is ready: its shapes are the job until it is done; the first time from the start shape on.
    pub(crate) fn take_jig(&mut self, input: Input) {
        let jig = if input == Input::Jig2 { Jig::Two } else { Jig::One };
        let skipped =
            if self.start.jig.is_none() { self.setup.whole.start.saturating_sub(1) } else { 0 };
        let shapes = self.setup.whole.shapes.iter().skip(skipped);
        let mine = shapes
            .filter(|shape| Jig::of(shape, &self.setup.whole, &self.setup.machine) == Some(jig))
            .cloned()
            .collect();
        self.setup.job = Arc::new(Job { shapes: mine, start: 1, ..(*self.setup.whole).clone() });
        (self.start.jig, self.progress.here) = (Some(jig), Here::default());
    }

    /// The jig is done: the head goes to the finish position, and waits for the next.
    pub(crate) fn next_jig(&mut self) -> bool {
        let Some(jig) = self.start.jig else { return false };
        self.progress.stage = Stage::Waiting;
        self.queue.steps = [
            self.schedule().up(),
            Step::Switch(jig.output(), false),
            Step::Switch(Output::Router, false),
            Step::Travel(self.setup.job.finish.unwrap_or_default()),
            Step::Enter(State::Waiting),
            Step::AwaitJig,
        ]
        .into();
        true
    }
}
