//! Surroundings of a program: machine, operator, files, and the events that tell of it.
//!
//! The world answers what the interpreter asks ([`Host`]) and carries out its commands, except
//! motion, which the [`Runner`](crate::runner) plans first.

use crate::answers::Operator;
use crate::drive::{Drive, Heard};
use crate::stopped_spindles::StoppedSpindles;
use crate::told_heights::{self, ToldHeights};
use crate::tracked::Tracked;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_journal::Placed;
use kerf_machine::{Actuator, Configuration, Driven, Going};
use kerf_model::Model;
use kerf_program::job::InForce;
use kerf_program::{
    Answer, At, Axes, Axis, AxisSet, Command, FileCall, Frame, OutputReason, Question,
    SPINDLE_OUTPUT, SPINDLE_STATUS, Settings,
};
use kerf_sim::{Hands, Opened, Simulation};
use kerf_trace::event::{Event, Location, Partial};
use kerf_trace::{Doing, ExecutedMove, OpenFile, RunStatus, Sink, Tally, flag};
use kerf_workspace::{Workspace, confirm, unconfirmed};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A line of the print window that grows beyond this is told in parts, bytes: a loop that prints
/// without end must not eat the memory.
const LONGEST_LINE: usize = 1_000_000;

pub(crate) struct World<'a> {
    /// Beliefs about the machine.
    pub model: Model,
    /// The machine that makes what is planned.
    pub driven: Driven,
    /// The hands at it.
    pub hands: Hands,
    pub tally: Tally,
    pub workspace: &'a mut Workspace,
    sink: &'a mut dyn Sink,
    pub operator: &'a mut dyn Operator,
    /// The settings whose units events are told in.
    settings: Arc<Settings>,
    /// Names of the files that places speak of.
    files: Vec<Arc<str>>,
    /// A line of the print window that has no end yet.
    printed: String,
    /// Everything given so far was carried out; holds for one question.
    pub settled: bool,
    pub question: Option<Question>,
    pub answer: Option<Answer>,
    /// Diagnostics that were told already: a line in a loop finds the same again and again.
    told: BTreeSet<(Code, SourcePlace, String)>,
    /// The run is a preview.
    pub previews: bool,
    /// A part file runs, for those who look from outside.
    pub file_runs: bool,
    /// Moves of a part file are still to be made, or being made.
    pub file_moves: bool,
    /// Files that are open and are none: one, where lines were typed.
    pub typed_files: usize,
    /// Tells nothing: the run repeats what has happened before.
    pub silent: bool,
    /// The zero points that stay: a job has its own only while it runs.
    pub stays: Option<Frame>,
    /// Configuration of the machine.
    pub machine_is: Arc<Configuration>,
    /// Axes that were homed when the run began.
    pub homed: AxisSet,
    /// Axes that can be homed.
    pub homes: AxisSet,
    /// The heights of a job.
    pub heights: ToldHeights,
    /// The pulse frequency of a laser, where one was set.
    pub laser_hz: Option<f64>,
    /// The spindle was switched in this run.
    pub spindle_switched: bool,
    /// Spindles and axes that a stop input stopped while somebody was asked.
    pub stopped: StoppedSpindles,
    /// The limit switch that the next question about limits is about; without one it is about the table.
    pub limit: Option<u8>,
}

impl<'a> World<'a> {
    pub fn new(
        simulation: Simulation,
        workspace: &'a mut Workspace,
        sink: &'a mut dyn Sink,
        operator: &'a mut dyn Operator,
        opened: Opened,
    ) -> Self {
        let Simulation { mut model, physics } = simulation;
        let Opened { machine: driven, hands } = opened;
        hands.put(physics);
        let settings = model.settings().clone();
        model.leaves_torch(driven.borrow().facts().follows_torch);
        driven.borrow_mut().use_settings(&settings);
        Self {
            model,
            driven,
            hands,
            tally: Tally::default(),
            workspace,
            sink,
            operator,
            settings,
            files: Vec::new(),
            printed: String::new(),
            settled: false,
            question: None,
            answer: None,
            told: BTreeSet::new(),
            previews: false,
            file_runs: false,
            file_moves: false,
            typed_files: 0,
            silent: false,
            stays: None,
            machine_is: Arc::default(),
            homed: AxisSet::EMPTY,
            homes: AxisSet::EMPTY,
            heights: ToldHeights::default(),
            laser_hz: None,
            spindle_switched: false,
            stopped: StoppedSpindles::default(),
            limit: None,
        }
    }

    /// Returns the machine as the run leaves it.
    pub fn into_simulation(self) -> Simulation {
        Simulation { model: self.model, physics: self.hands.take() }
    }

    /// The machine, and what is believed of it.
    pub fn tracked(&mut self) -> Tracked<'_> {
        Tracked { model: &mut self.model, driven: &self.driven, hands: &self.hands }
    }

    /// Has the machine set something, in its place between two moves. What is told again was set before, and what is
    /// only drawn sets nothing.
    pub fn set(&self, actuator: &Actuator) {
        if !self.silent && !self.model.draws() {
            self.driven.borrow_mut().set(actuator);
        }
    }

    /// Tells an event.
    pub fn tell(&mut self, event: &Event) {
        if !self.silent {
            self.sink.event(event);
        }
    }

    /// Lets machine time go on from one moment to another, as [`Drive::pass`] does.
    pub fn pass(
        &mut self,
        drive: &mut Drive<'_>,
        from_s: f64,
        to_s: f64,
        going: Option<&Going<'_>>,
        feed: f32,
    ) -> Option<(f64, Heard)> {
        if !self.silent && !self.model.draws() {
            self.driven.borrow_mut().beam(self.model.shines());
        }
        let doing = Doing { machine: &self.model, going, feed, files: &self.files };
        drive.pass(from_s, to_s, &doing, self.sink)
    }

    /// Shows the machine where it stands on its way.
    pub fn shows(&mut self, going: &Going<'_>, at_s: f64, feed: f32) {
        let doing = Doing { machine: &self.model, going: Some(going), feed, files: &self.files };
        self.sink.under_way(&doing, at_s, at_s);
    }

    /// Tells that a move is made, and by which plan.
    pub fn tell_made(&mut self, made: &ExecutedMove<'_>) {
        if self.silent {
            self.sink.made_before(made);
        } else {
            self.sink.made(made);
        }
    }

    /// Tells where the run stands, when anybody looks: its flags besides those of running and
    /// previewing, and the files that are open, each at the line that is read next.
    pub fn tell_standing(
        &mut self,
        flags: u8,
        files: &dyn Fn() -> Vec<(At, Option<FileCall>)>,
        variables: &dyn Fn() -> Vec<(String, String)>,
    ) {
        let preview = if self.previews || self.model.draws() { flag::PREVIEW } else { 0 };
        let files = files();
        // A file that was read to its end still moves.
        if !files.is_empty() {
            self.file_runs = self.file_moves || files.len() > self.typed_files;
        }
        let file = if self.file_runs { flag::FILE_RUNNING } else { 0 };
        self.workspace.tape.stands(flags | preview | file);
        if self.silent || !self.sink.looks_at_status() {
            return;
        }
        let open = |(at, call): (At, Option<FileCall>)| OpenFile {
            file: self.file(at),
            line: at.line,
            call,
        };
        let files: Vec<OpenFile> = files.into_iter().map(open).collect();
        let running = if files.is_empty() { 0 } else { flag::FILE_RUNNING };
        let watched = self.watched(variables);
        self.sink.run_status(&RunStatus { status: flags | running | preview, files, watched });
    }

    /// The variables that somebody wants to see, in the order in which he named them.
    fn watched(&self, variables: &dyn Fn() -> Vec<(String, String)>) -> Vec<(String, String)> {
        let names = self.sink.watches();
        let all = if names.is_empty() { Vec::new() } else { variables() };
        let value = |name: &str| {
            let bare = name.trim_start_matches('&');
            let same = |(known, _): &&(String, String)| known.eq_ignore_ascii_case(bare);
            let kept = || self.workspace.stored.get(name).map(str::to_owned);
            all.iter().find(same).map(|(_, value)| value.clone()).or_else(kept)
        };
        names.into_iter().filter_map(|name| Some((name.clone(), value(&name)?))).collect()
    }

    /// Tells whether anybody looks at moves and arcs.
    pub fn tells_motion(&self) -> bool {
        !self.silent && self.sink.looks_at_motion()
    }

    /// Tells something a person should know.
    pub fn tell_diagnostic(&mut self, diagnostic: Diagnostic) {
        let what = (diagnostic.code, diagnostic.place.clone(), diagnostic.message.clone());
        if self.told.insert(what) {
            self.tell(&Event::Diag(Box::new(diagnostic)));
        }
    }

    /// Returns the place of the machine, and the zero points that stay.
    pub fn placed(&self) -> Placed {
        let frame = self.stays.unwrap_or(*self.model.frame());
        Placed { position: self.model.position(), frame }
    }

    /// Machine time, seconds.
    pub fn now(&self) -> f64 {
        self.model.clock_s()
    }

    /// Returns the number of files that have names.
    pub const fn files_known(&self) -> usize {
        self.files.len()
    }

    /// The name of the next file.
    pub fn name_file(&mut self, name: Arc<str>) {
        self.files.push(name);
    }

    /// The name of a file.
    pub fn file(&self, at: At) -> Arc<str> {
        self.files.get(at.file as usize).cloned().unwrap_or_default()
    }

    /// Internal units in a user unit of an axis.
    pub fn scale(&self, axis: Axis) -> f64 {
        self.settings.axis_scale(axis)
    }

    /// A machine position as a working location in the user's units.
    pub fn place(&self, machine: Axes) -> Location {
        self.settings.to_user(self.model.frame().working(machine)).into()
    }

    /// The user's unit.
    pub fn units(&self) -> &'static str {
        self.settings.linear_unit.symbol()
    }

    /// A spindle that was switched in a run and is off at its end counts as active no longer: whoever
    /// starts it next is asked again.
    pub fn spindle_rests(&mut self) {
        if self.spindle_switched && !self.previews && !self.model.outputs().is_on(SPINDLE_OUTPUT) {
            self.workspace.set_value(SPINDLE_STATUS, Some("0"));
        }
    }

    /// Carries out a command that is no motion and takes no time.
    pub fn perform(&mut self, command: Command) {
        let t = self.now();
        match command {
            Command::Settings(settings) => self.use_settings(settings),
            Command::Location { frame, working, base } => self.locate(frame, working, base),
            Command::Output { number, on } => {
                self.model.output(number, on, OutputReason::Program);
            }
            Command::Pwm { channel, percent } => self.model.pwm(channel, percent),
            Command::Spindle { number, rpm } => self.model.spindle(number, rpm),
            Command::Independent { axis, motion } => self.model.independent(axis, motion),
            Command::MotorsOff => self.model.motors_off(),
            Command::WarningOff => self.model.warning_off(),
            Command::Print { text, newline } => self.print(&text, newline),
            Command::Message { text } => self.tell(&Event::Message { text, t }),
            Command::Diagnostic(diagnostic) => self.tell_diagnostic(*diagnostic),
            Command::File { op, path } => self.tell(&Event::File { op, path, t }),
            Command::Sound { path } => self.tell(&Event::Sound { path, t }),
            Command::ToolPath(start) => {
                self.tally.begins(&start);
                self.tell(&Event::ToolPath { name: start.name, tool: start.tool, t });
            }
            Command::ToolChange { begin } => {
                self.tally.changing(begin);
                self.tell(&Event::ToolChange { begin, t });
            }
            Command::ClearPreview => self.tell(&Event::Clear { t }),
            Command::State { name, why } => self.tell(&Event::State { state: name, why, t }),
            Command::Beam(beam) => self.model.beam(beam),
            Command::LaserFrequency { hz } => self.model.laser_frequency(hz),
            Command::Heights(heights) => {
                self.heights.hold(heights);
                self.tell(&told_heights::event(heights, t));
            }
            Command::InForce(InForce { cut_mm_s, plunge_mm_s, raise }) => {
                self.tell(&Event::InForce { cut_mm_s, plunge_mm_s, raise, t });
            }
            Command::HeightControl(law) => {
                let law = law.as_deref().copied();
                self.heights.follow(law);
                self.tracked().control_height(law);
            }
            // The simulated machine has one direction and no coolant: they are only told.
            Command::SpindleTurn { number, turn } => {
                self.set(&Actuator::Turn(turn));
                self.tell(&Event::Turn { turn, t, n: number });
            }
            Command::Coolant { mist, flood } => {
                self.set(&Actuator::Coolant { mist, flood });
                self.tell(&Event::Coolant { mist, flood, t });
            }
            // It has no overrides; the planner follows the path by its own options.
            Command::PathControl(_) | Command::Overrides { .. } | Command::Chorded(_) => {}
            // The runner carries these out.
            Command::Line(_) | Command::Arc(_) | Command::EndStack | Command::Wait { .. } => {}
        }
        self.tell_log();
    }

    fn use_settings(&mut self, settings: Arc<Settings>) {
        let (before, drew) = (self.units(), self.model.draws());
        // VD tells its values even where they are those that hold.
        if *settings == *self.settings || settings.display != self.settings.display {
            self.sink.displays(settings.display.comments);
        }
        self.settings = settings.clone();
        self.driven.borrow_mut().use_settings(&settings);
        self.model.use_settings(settings);
        self.tell_log();
        let (units, t) = (self.units(), self.now());
        if units != before {
            self.tell(&Event::Units { units, t });
        }
        if self.model.draws() != drew {
            let (settings, draws) = (self.settings.clone(), self.model.draws());
            self.workspace.log_mode(&settings, draws);
            let mode = if drew { "move" } else { "preview" };
            self.tell(&Event::Mode { mode, t });
        }
    }

    fn locate(&mut self, frame: Frame, working: AxisSet, base: AxisSet) {
        let mut set = working;
        base.iter().for_each(|axis| set.insert(axis));
        self.model.use_frame(frame, set);
        if !self.model.draws() && !unconfirmed(self.workspace).is_empty() {
            confirm(self.workspace, set);
        }
        let place = self.model.position();
        let set = self.partial(frame.working(place), working);
        let base = self.partial(frame.base(place), base);
        self.tell(&Event::Location { set, base, t: self.now() });
    }

    /// Tells the table base coordinates of axes after a nudge.
    pub fn tell_base(&mut self, axes: AxisSet) {
        let base = self.model.frame().base(self.model.position());
        let base = self.partial(base, axes);
        self.tell(&Event::Location { set: Partial::new(), base, t: self.now() });
    }

    fn partial(&self, internal: Axes, axes: AxisSet) -> Partial {
        let user = self.settings.to_user(internal);
        axes.iter().map(|axis| (axis.letter().to_ascii_lowercase(), user[axis])).collect()
    }

    fn print(&mut self, text: &str, newline: bool) {
        self.printed.push_str(text);
        if newline || self.printed.len() > LONGEST_LINE {
            self.end_line();
        }
    }

    fn end_line(&mut self) {
        let text = Arc::from(std::mem::take(&mut self.printed));
        self.tell(&Event::Print { text, t: self.now() });
    }

    /// The run is over: what was printed without a line end is told.
    pub fn flush_print(&mut self) {
        if !self.printed.is_empty() {
            self.end_line();
        }
    }
}
