//! Jobs on the machine SIM (readings, SIM), and what their traces tell.

use kerf_control::answers::Answers;
use kerf_control::{OperatorRequest, RunContext, Script, Session};
use kerf_drawing::{Editor, script};
use kerf_files::MemoryDisk;
use kerf_geom::{Point2, Polyarc};
use kerf_journal::{RunOptions, Work};
use kerf_machine::lines::Input;
use kerf_machine::profile::profile;
use kerf_machine::{Configuration, Errand, file};
use kerf_model::Change;
use kerf_program::job::{Job, JobShape};
use kerf_program::{Axes, AxisSet, MoveKind, rounded};
use kerf_sim::Sheet;
use kerf_trace::{Event, Sink, Summary, event::MoveEvent, vcd::VcdSink};
use kerf_workspace::Workspace;
use std::sync::Arc;

/// The standard simulated machine (readings, SIM): the profile `sim`.
pub fn sim() -> Configuration {
    let sim = profile("sim").expect("the profile");
    file::read(&"sim".into(), sim.text).expect("a profile without mistakes")
}

/// An open line that is cut through.
pub fn line(number: u32, from: (f64, f64), to: (f64, f64)) -> JobShape {
    let places = [from, to].map(|(x, y)| Point2::new(x, y));
    JobShape::through(number, Polyarc::lines(places, false))
}

/// A closed square that is cut through, counter-clockwise from its lower left corner.
pub fn square(number: u32, (x, y): (f64, f64), side: f64) -> JobShape {
    let corners = [(x, y), (x + side, y), (x + side, y + side), (x, y + side)];
    JobShape::through(number, Polyarc::lines(corners.map(|(x, y)| Point2::new(x, y)), true))
}

/// A job of shapes.
pub fn job(shapes: impl IntoIterator<Item = JobShape>) -> Job {
    Job { name: "job.rsm".into(), shapes: shapes.into_iter().collect(), ..Job::default() }
}

/// JOB-T1: one open line (0,0)-(100,0).
pub fn t1() -> Job {
    job([line(1, (0.0, 0.0), (100.0, 0.0))])
}

/// JOB-T2: and a second one, (100,50)-(0,50).
pub fn t2() -> Job {
    job([line(1, (0.0, 0.0), (100.0, 0.0)), line(2, (100.0, 50.0), (0.0, 50.0))])
}

/// The job of a drawing made by a script, as `kerf toolpath` makes it.
pub fn drawn(clauses: &str) -> Job {
    let mut editor = Editor::default();
    for (number, operation) in script(clauses).expect("a script") {
        editor.apply(&operation).unwrap_or_else(|error| panic!("clause {number}: {error}"));
    }
    let (job, warnings) = kerf_toolpath::job(&editor.drawing).expect("a job");
    assert_eq!(warnings, []);
    // By way of its file, as it is run.
    let (read, _) = kerf_toolpath::read(kerf_toolpath::write(&job).as_bytes());
    read.machine_job("job.rsm".into())
}

/// A job to be run, or a move by hand.
pub struct JobRun {
    job: Job,
    errand: Option<Errand>,
    homed: AxisSet,
    /// Session that stays of what was run before.
    session: Option<Session>,
    machine: Configuration,
    requests: Vec<(f64, OperatorRequest)>,
    answers: String,
    inputs: Vec<Change>,
    sheet: Option<Sheet>,
    at: Axes,
}

/// A job that was run.
pub struct JobTrace {
    /// Everything that was told.
    pub events: Vec<Event>,
    /// Summary of the run.
    pub summary: Summary,
    /// Session that stays.
    pub session: Session,
}

impl JobRun {
    /// A job on SIM, which was homed and stands at its home.
    pub fn new(job: Job) -> Self {
        Self {
            job,
            errand: None,
            homed: AxisSet::first(3),
            session: None,
            machine: sim(),
            requests: Vec::new(),
            answers: String::new(),
            inputs: Vec::new(),
            sheet: None,
            at: Axes::default(),
        }
    }

    /// A move by hand on SIM.
    pub fn hand(errand: Errand) -> Self {
        Self { errand: Some(errand), ..Self::new(Job::default()) }
    }

    /// Nothing was homed.
    #[must_use]
    pub const fn unhomed(mut self) -> Self {
        self.homed = AxisSet::EMPTY;
        self
    }

    /// On the machine as another run left it.
    #[must_use]
    pub fn after(mut self, before: &JobTrace) -> Self {
        self.session = Some(before.session.clone());
        self
    }

    /// A key is let go at a time.
    #[must_use]
    pub fn let_go(mut self, at_s: f64) -> Self {
        self.requests.push((at_s, OperatorRequest::End));
        self
    }

    /// Changes settings.
    #[must_use]
    pub fn with(mut self, change: impl FnOnce(&mut Configuration)) -> Self {
        change(&mut self.machine);
        self
    }

    /// Changes the job.
    #[must_use]
    pub fn job(mut self, change: impl FnOnce(&mut Job)) -> Self {
        change(&mut self.job);
        self
    }

    /// Key Stop at a time.
    #[must_use]
    pub fn stop(mut self, at_s: f64) -> Self {
        self.requests.push((at_s, OperatorRequest::Stop));
        self
    }

    /// Adds a request of the operator at a time.
    #[must_use]
    pub fn request(mut self, at_s: f64, request: OperatorRequest) -> Self {
        self.requests.push((at_s, request));
        self
    }

    /// Sets the words of the operator, one order a line.
    #[must_use]
    pub fn say(mut self, answers: &str) -> Self {
        self.answers = answers.replace(" ⏎ ", "\n");
        self
    }

    /// An input changes.
    #[must_use]
    pub fn input(self, input: Input, at_s: f64, on: bool) -> Self {
        self.raw_input(input.number(), at_s, on)
    }

    /// An input without a name changes, by the number of its line.
    #[must_use]
    pub fn raw_input(mut self, input: u8, at_s: f64, on: bool) -> Self {
        self.inputs.push(Change { input, at_s, on });
        self
    }

    /// The machine stands somewhere else at the beginning.
    #[must_use]
    pub fn at(mut self, x: f64, y: f64, z: f64) -> Self {
        self.at = Axes::xyz(x, y, z);
        self
    }

    /// A sheet lies on the table.
    #[must_use]
    pub fn sheet(mut self, sheet: Sheet) -> Self {
        self.sheet = Some(sheet);
        self
    }

    /// Runs it.
    pub fn run(self) -> JobTrace {
        let mut events = Vec::new();
        let (summary, session) = self.run_into(&mut events);
        JobTrace { events, summary, session }
    }

    /// Runs it and traces its signals.
    pub fn signals(self) -> Signals {
        let mut text = Vec::new();
        let mut sink = VcdSink::new(&mut text, self.machine.clone());
        self.run_into(&mut sink);
        sink.finish().expect("memory takes everything");
        Signals(String::from_utf8(text).expect("a trace is text"))
    }

    /// Runs it for a sink that looks at more than events.
    pub fn run_for(self, sink: &mut dyn Sink) -> Summary {
        self.run_into(sink).0
    }

    fn run_into(self, sink: &mut dyn Sink) -> (Summary, Session) {
        let mut session = self.session.unwrap_or_else(|| {
            let mut session = Session::default();
            session.homed = self.homed;
            session.memory.position = self.at;
            session
        });
        let mut workspace = Workspace::in_memory(MemoryDisk::new(std::iter::empty()));
        let mut operator = Answers::read(&self.answers);
        let mut pace = Script::new(self.requests, Vec::new());
        let context = RunContext {
            sink,
            operator: &mut operator,
            requests: &mut pace,
            machine: kerf_control::simulated(),
        };
        let options =
            RunOptions { inputs: self.inputs, sheet: self.sheet, ..RunOptions::default() };
        let machine = Arc::new(self.machine);
        session.machine_is = machine.clone();
        let work = match self.errand {
            Some(errand) => Work::Hand(errand, machine),
            None => Work::Job(Arc::new(self.job), machine),
        };
        let summary = session.run(work, options, &mut workspace, context);
        (summary, session)
    }
}

/// The signals of a run, as a file that viewers of signals read.
pub struct Signals(pub String);

impl Signals {
    /// Returns when a signal changed and to what, milliseconds.
    pub fn changes(&self, name: &str) -> Vec<(u64, String)> {
        let found = self.of(&[name]).into_iter();
        found.map(|(t_ns, _, value)| (t_ns / 1_000_000, value)).collect()
    }

    /// Changes of some signals in the order of the file: when, nanoseconds; which; to what.
    fn of(&self, names: &[&str]) -> Vec<(u64, usize, String)> {
        let code = |name: &&str| {
            let end = format!(" {name} $end");
            let declares = |line: &&str| line.starts_with("$var") && line.ends_with(&end);
            let declared = self.0.lines().find(declares);
            declared.and_then(|line| line.split(' ').nth(3)).expect("the signal")
        };
        let codes: Vec<&str> = names.iter().map(code).collect();
        let (_, body) = self.0.split_once("$dumpvars").expect("a body");
        let mut now = 0;
        let mut found = Vec::new();
        for line in body.lines().skip_while(|line| *line != "$end") {
            if let Some(time) = line.strip_prefix('#') {
                now = time.parse().expect("a time");
                continue;
            }
            // A bit stands right before its code, another value with a space between.
            let change = line.split_once(' ').or_else(|| line.split_at_checked(1));
            let which = change.and_then(|(_, code)| codes.iter().position(|it| *it == code));
            if let Some((which, (value, _))) = which.zip(change) {
                found.push((now, which, value.to_owned()));
            }
        }
        found
    }

    /// The place to which the pulses of an axis lead from its home, steps.
    pub fn driven(&self, axis: char) -> i64 {
        let [direction, step] = ["dir", "step"].map(|what| format!("{axis}{what}"));
        let (mut forward, mut steps) = (false, 0);
        for (_, which, value) in self.of(&[&direction, &step]) {
            match (which, value == "1") {
                (0, high) => forward = high,
                (_, true) => steps += if forward { 1 } else { -1 },
                _ => {}
            }
        }
        steps
    }

    /// The counted place of an axis, steps, and the moment since which it is there, milliseconds.
    pub fn positions(&self, axis: char) -> Vec<(u64, i64)> {
        let steps = |value: &str| {
            let bits = u32::from_str_radix(value.trim_start_matches('b'), 2).expect("a number");
            i64::from(bits as i32)
        };
        let changes = self.changes(&format!("{axis}_pos")).into_iter();
        changes.map(|(t_ms, value)| (t_ms, steps(&value))).collect()
    }

    /// Returns when a bit was on, milliseconds.
    pub fn on(&self, name: &str) -> Vec<(u64, u64)> {
        let changes = self.changes(name);
        let pairs = changes.chunks(2);
        pairs.map(|pair| (pair[0].0, pair.get(1).map_or(u64::MAX, |(off, _)| *off))).collect()
    }
}

impl JobTrace {
    /// Changes of outputs, states and intensity-free signals as `0.300 router+`, in order.
    pub fn edges(&self) -> Vec<String> {
        let edge = |event: &Event| match event {
            Event::Output { name: Some(name), on, t, .. } => {
                Some(format!("{t:.3} {name}{}", if *on { '+' } else { '-' }))
            }
            Event::LaserHz { hz, t } => Some(format!("{t:.3} hz {hz}")),
            _ => None,
        };
        self.events.iter().filter_map(edge).collect()
    }

    /// Returns the messages of all diagnostics of the run.
    pub fn warnings(&self) -> Vec<String> {
        let told = |event: &Event| match event {
            Event::Diag(told) => Some(told.message.clone()),
            _ => None,
        };
        self.events.iter().filter_map(told).collect()
    }

    /// Moves as `0.000-0.300 z-10`: when, and where the axes end that moved.
    pub fn moves(&self) -> Vec<String> {
        let shown = |made: &MoveEvent| {
            let pairs = [
                ('x', made.from.x, made.to.x),
                ('y', made.from.y, made.to.y),
                ('z', made.from.z, made.to.z),
                ('c', made.from.c, made.to.c),
            ];
            let moved = pairs.into_iter().filter(|(_, from, to)| (from - to).abs() > 1e-9);
            let ends: String =
                moved.map(|(axis, _, to)| format!(" {axis}{}", rounded(to, 3))).collect();
            format!("{:.3}-{:.3}{ends}", made.t0, made.t1)
        };
        self.events.iter().filter_map(motion).map(shown).collect()
    }

    /// Returns what people are told.
    pub fn messages(&self) -> Vec<String> {
        let told = |event: &Event| match event {
            Event::Message { text, .. } => Some(text.to_string()),
            _ => None,
        };
        self.events.iter().filter_map(told).collect()
    }

    /// Axes that were homed, and how many steps the last home was off: `x 3 steps`.
    pub fn homed(&self) -> Vec<String> {
        let told = |event: &Event| match event {
            Event::Homed { axis, steps, .. } => Some(format!("{axis} {steps} steps")),
            _ => None,
        };
        self.events.iter().filter_map(told).collect()
    }

    /// States as `5.940 paused`, with why.
    pub fn states(&self) -> Vec<String> {
        let told = |event: &Event| match event {
            Event::State { state, why, t } if why.is_empty() => Some(format!("{t:.3} {state}")),
            Event::State { state, why, t } => Some(format!("{t:.3} {state}: {why}")),
            _ => None,
        };
        self.events.iter().filter_map(told).collect()
    }

    /// Intensity as `4.842 2`, in order.
    pub fn intensities(&self) -> Vec<(f64, u8, u8)> {
        let told = |event: &Event| match event {
            Event::Intensity { value, byte, t, .. } => Some((*t, *value, *byte)),
            _ => None,
        };
        self.events.iter().filter_map(told).collect()
    }

    /// Speeds asked for of the cuts in the plane, mm/s.
    pub fn cutting_speeds(&self) -> Vec<f64> {
        let cuts = self.events.iter().filter_map(motion).filter(|made| {
            let flat = (made.from.x, made.from.y) != (made.to.x, made.to.y);
            flat && made.kind == MoveKind::Cut
        });
        cuts.map(|made| rounded(made.speed, 3)).collect()
    }

    /// Returns the reason why the job was refused.
    pub fn refused(&self) -> String {
        self.summary.error.as_ref().map_or(String::new(), |error| error.message.clone())
    }

    /// Returns the place where the machine stands at the end, machine frame.
    pub fn rests(&self) -> [f64; 3] {
        self.session.memory.position.first3()
    }
}

/// Returns the move that an event tells of: a straight one, or that of an arc.
fn motion(event: &Event) -> Option<&MoveEvent> {
    match event {
        Event::Move(made) => Some(made),
        Event::Arc(arc) => Some(&arc.made),
        _ => None,
    }
}
