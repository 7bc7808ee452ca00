//! Runs that end before their time, and how they are taken up.

#![allow(dead_code)]

use kerf_control::answers::{Answers, Operator};
use kerf_control::{AtRest, OperatorRequest, Requests, RunContext, Session};
use kerf_files::{Folders, MemoryDisk};
use kerf_geom::{Point2, Polyarc};
use kerf_journal::{Journal, Press, RunOptions, Started, Work};
use kerf_machine::Configuration;
use kerf_machine::profile::profile;
use kerf_part::Program;
use kerf_program::job::{Job, JobShape};
use kerf_program::{Axes, Question, QuestionKind};
use kerf_sbp::Status;
use kerf_sim::{Clock, Opened, Simulated};
use kerf_trace::{
    Event, Sink,
    event::{Location, MoveEvent},
};
use kerf_workspace::{Workspace, stored::Stored};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use tempfile::{TempDir, tempdir};

/// A line, an arc, a slope down and a way back, with the spindle on.
pub const PART: &str =
    "SO,1,1\nSA\nJZ,.5\nMZ,-.2\nM3,4,0,-.2\nCG,,4,2,0,1,T,1\nM3,0,2,-.6\nMX,3\nJZ,.5\n";

/// A machine whose time passes at once and counts as that of the world: every move is on record before it begins.
pub fn on_record() -> Opened {
    Simulated::opened(AtOnce)
}

struct AtOnce;

impl Clock for AtOnce {
    fn pass(&mut self, _: f64, until_s: f64) -> f64 {
        until_s
    }

    fn in_real_time(&self) -> bool {
        true
    }
}

/// The power fails at a machine time.
pub struct PowerCut(pub f64);

impl Requests for PowerCut {
    fn take(&mut self, _: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        if to_s >= self.0 {
            resume_unwind(Box::new("the power fails"));
        }
        None
    }
}

/// The operator holds the machine at a machine time, and the power fails before it goes on.
pub struct PowerCutHeld(pub f64);

impl Requests for PowerCutHeld {
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        let held = (to_s > from_s && to_s >= self.0)
            .then_some((self.0.max(from_s), OperatorRequest::Hold));
        if held.is_some() {
            self.0 = f64::INFINITY;
        }
        held
    }

    fn resumes(&mut self, _: f64) -> Option<f64> {
        resume_unwind(Box::new("the power fails"))
    }
}

/// The power fails when the operator has said all of it to whoever stopped.
pub struct PowerCutBehind<'a>(pub &'a [&'a str]);

/// The program is answered; the power fails when whoever stopped it is asked.
pub struct PowerCutSaid(pub &'static str);

impl Operator for PowerCutSaid {
    fn answer(&mut self, question: &Question, _: u32) -> Option<String> {
        if question.kind == QuestionKind::Hold {
            resume_unwind(Box::new("the power fails"));
        }
        Some(self.0.into())
    }
}

impl Operator for PowerCutBehind<'_> {
    fn answer(&mut self, question: &Question, _: u32) -> Option<String> {
        if question.kind != QuestionKind::Hold {
            return None;
        }
        let (word, rest) =
            self.0.split_first().unwrap_or_else(|| resume_unwind(Box::new("the power fails")));
        self.0 = rest;
        Some((*word).into())
    }
}

/// The power fails when it is told that the operator has answered.
pub struct PowerCutTold(pub &'static str);

impl Sink for PowerCutTold {
    fn event(&mut self, event: &Event) {
        if let Event::Ask(asked) = event
            && asked.answer == self.0
        {
            resume_unwind(Box::new("the power fails"));
        }
    }
}

/// The power fails when it is told that the machine is in this state.
pub struct PowerCutIn(pub &'static str);

impl Sink for PowerCutIn {
    fn event(&mut self, event: &Event) {
        if matches!(event, Event::State { state, .. } if **state == *self.0) {
            resume_unwind(Box::new("the power fails"));
        }
    }
}

/// Whoever stops the run instead of answering.
pub struct GivesUp;

impl Operator for GivesUp {
    fn answer(&mut self, _: &Question, _: u32) -> Option<String> {
        None
    }

    fn gives_up(&self) -> bool {
        true
    }
}

pub fn workspace(journal: &Journal, folder: &TempDir) -> Workspace {
    let disk = MemoryDisk::new([("a.sbp", PART.as_bytes())]);
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    let stored = Stored::of(journal.clone()).unwrap();
    Workspace::new(Box::new(disk), folders, stored, folder.path().into())
}

/// Runs the part file on record; nothing when the power fails.
pub fn run(
    folder: &TempDir,
    pace: &mut dyn Requests,
    answers: &str,
) -> (Vec<Event>, Option<Status>) {
    run_work(folder, part(), pace, &mut Answers::read(answers))
}

pub fn part() -> Program {
    kerf_part::read("a.sbp".into(), PART.as_bytes())
}

pub fn run_work(
    folder: &TempDir,
    work: impl Into<Work>,
    pace: &mut dyn Requests,
    operator: &mut dyn Operator,
) -> (Vec<Event>, Option<Status>) {
    let mut events = Vec::new();
    let status = run_in(
        folder,
        work,
        RunContext { sink: &mut events, operator, requests: pace, machine: on_record() },
    );
    (events, status)
}

pub fn run_in(folder: &TempDir, work: impl Into<Work>, context: RunContext<'_>) -> Option<Status> {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let mut workspace = workspace(&journal, folder);
    let (mut session, _) = Session::recall(&journal, &mut workspace).unwrap();
    // Logs are written at its end, also when it was given up.
    let started = Started { time: "14:03:05".into(), date: "2026-11-21".into() };
    let options = RunOptions { started: Some(started), ..RunOptions::default() };
    let went = catch_unwind(AssertUnwindSafe(|| {
        session.run_on_record(work, options, None, &mut workspace, context).unwrap()
    }));
    went.ok().map(|summary| summary.status)
}

pub fn resume(folder: &TempDir, answers: &str) -> (Vec<Event>, Status) {
    let (events, status) = resume_with(folder, &mut (), &mut Answers::read(answers));
    (events, status.unwrap())
}

pub fn resume_with(
    folder: &TempDir,
    pace: &mut dyn Requests,
    operator: &mut dyn Operator,
) -> (Vec<Event>, Option<Status>) {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let cut = journal.runs.cut_short().unwrap().expect("a run to take up");
    let mut workspace = workspace(&journal, folder);
    let (mut session, _) = Session::recall(&journal, &mut workspace).unwrap();
    let mut events = Vec::new();
    let context = RunContext { sink: &mut events, operator, requests: pace, machine: on_record() };
    let went =
        catch_unwind(AssertUnwindSafe(|| session.resume(&cut, &mut workspace, context).unwrap()));
    (events, went.ok().map(|summary| summary.status))
}

pub fn motion(event: &Event) -> Option<&MoveEvent> {
    match event {
        Event::Move(made) => Some(made),
        Event::Arc(arc) => Some(&arc.made),
        _ => None,
    }
}

/// A motion as text, its start left out: kind, line, where to, and the circle that it is part of.
pub fn told(event: &Event) -> Option<String> {
    let made = motion(event)?;
    let circle = match event {
        Event::Arc(arc) => format!(" about {:.6},{:.6} {}", arc.centre.x, arc.centre.y, arc.dir),
        _ => String::new(),
    };
    let Location { x, y, z, .. } = made.to;
    Some(format!("{:?} {} {x:.6},{y:.6},{z:.6}{circle}", made.kind, made.line))
}

pub fn near(a: &Location, b: &Location) -> bool {
    (a.x - b.x).abs() + (a.y - b.y).abs() + (a.z - b.z).abs() < 1e-9
}

/// Events that follow the point at which the run was taken up.
pub fn behind(events: &[Event]) -> &[Event] {
    let at = events.iter().rposition(|e| matches!(e, Event::Resume { .. })).expect("a resume");
    &events[at..]
}

/// The rest of the cut begins where it is said to, and is the rest of the uninterrupted run.
pub fn same_rest(whole: &[Event], rest: &[Event], line: u32) -> MoveEvent {
    let whole: Vec<String> = whole.iter().filter_map(told).collect();
    let after: Vec<String> = behind(rest).iter().filter_map(told).collect();
    assert_eq!(after[..], whole[whole.len() - after.len()..]);
    let first = behind(rest).iter().find_map(motion).unwrap().clone();
    assert_eq!(first.line, line);
    first
}

/// Time at which a line of the uninterrupted run is half made, s.
pub fn middle(whole: &[Event], line: u32) -> f64 {
    let made = whole.iter().filter_map(motion).find(|made| made.line == line).unwrap();
    0.5 * (made.t0 + made.t1)
}

pub fn uninterrupted() -> Vec<Event> {
    let (whole, status) = run(&tempdir().unwrap(), &mut (), "");
    assert_eq!(status, Some(Status::Ok));
    whole
}

/// A line through the sheet, on the simulated machine.
pub fn job(machine: impl FnOnce(&mut Configuration)) -> Work {
    let mut configuration = profile("sim").unwrap().configuration().unwrap();
    machine(&mut configuration);
    let path = [(0.0, 0.0), (100.0, 0.0)].map(|(x, y)| Point2::new(x, y));
    let shapes = [JobShape::through(1, Polyarc::lines(path, false))].into();
    let job = Job { name: "a.rsm".into(), shapes, ..Job::default() };
    Work::Job(Arc::new(job), Arc::new(configuration))
}

/// Takes up a job that was cut short at a time: the question to the operator, and the outputs that come on then.
pub fn asked_and_switched(at_s: f64) -> (String, Vec<String>) {
    let folder = tempdir().unwrap();
    let (_, status) = run_work(&folder, job(|_| ()), &mut PowerCut(at_s), &mut ());
    assert_eq!(status, None, "the power failed");
    let (rest, status) = resume(&folder, "");
    assert_eq!(status, Status::Ok);
    let asked = rest.iter().position(|e| matches!(e, Event::Ask(_))).expect("a question");
    let Event::Ask(question) = &rest[asked] else { unreachable!() };
    let switched = rest[asked..].iter().filter_map(|event| match event {
        Event::Output { name: Some(name), on: true, .. } => Some((*name).to_owned()),
        _ => None,
    });
    (question.text.clone(), switched.collect())
}

/// Questions that were asked.
pub fn asked(events: &[Event]) -> Vec<&str> {
    events
        .iter()
        .filter_map(|event| match event {
            Event::Ask(question) => Some(&*question.text),
            _ => None,
        })
        .collect()
}

/// Somebody moves a switch while nothing runs.
pub fn press(folder: &TempDir, number: u8, on: bool) {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let mut workspace = workspace(&journal, folder);
    let (mut session, _) = Session::recall(&journal, &mut workspace).unwrap();
    AtRest(&mut session).press(Press { number, on }, &mut workspace);
}

/// Location at which the machine stands.
pub fn stands(folder: &TempDir) -> Axes {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let (session, _) = Session::recall(&journal, &mut workspace(&journal, folder)).unwrap();
    session.memory.position
}

/// Question to the operator whether all is ready.
pub const READY: &str =
    "Output 1 comes on, the tool goes back to where the cut ended. Is everything ready?";

/// Before, when a stop input is active.
pub const RELEASE: &str =
    "stopped by stop input 4. When it is released, Resume: the tool rises, and goes on";
