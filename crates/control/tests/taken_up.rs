//! A run that was stopped and given up, or killed in the middle of a move, is taken up at the exact
//! place: nothing is cut twice, nothing is left out, and the path is that of the uninterrupted run.

#![allow(clippy::unwrap_used, clippy::expect_used, non_snake_case)]

use kerf_control::answers::{Answers, Operator};
use kerf_control::event::{MoveEvent, Place};
use kerf_control::files::{Folders, MemoryDisk};
use kerf_control::journal::Journal;
use kerf_control::stored::Stored;
use kerf_control::{
    Company, Event, Pace, Press, RunOptions, Script, Session, Shelf, Sink, Started, StopAt, Wish,
    Work,
};
use kerf_geom::{Point2, Polyarc};
use kerf_machine::Configuration;
use kerf_machine::lines::Input;
use kerf_machine::profile::profile;
use kerf_part::Program;
use kerf_program::job::{Job, JobShape};
use kerf_program::{Axes, Axis, Dynamics, MoveKind, Question, QuestionKind, Settings};
use kerf_sbp::Status;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use tempfile::{TempDir, tempdir};

/// A line, an arc, a slope down and a way back, with the spindle on.
const PART: &str =
    "SO,1,1\nSA\nJZ,.5\nMZ,-.2\nM3,4,0,-.2\nCG,,4,2,0,1,T,1\nM3,0,2,-.6\nMX,3\nJZ,.5\n";

/// The power fails at a machine time.
struct PowerCut(f64);

impl Pace for PowerCut {
    fn pass(&mut self, _: f64, to_s: f64) -> Option<(f64, Wish)> {
        if to_s >= self.0 {
            resume_unwind(Box::new("the power fails"));
        }
        None
    }

    fn is_real(&self) -> bool {
        true
    }
}

/// The operator holds the machine at a machine time, and the power fails before it goes on.
struct PowerCutHeld(f64);

impl Pace for PowerCutHeld {
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        let held = (to_s > from_s && to_s >= self.0).then_some((self.0.max(from_s), Wish::Hold));
        if held.is_some() {
            self.0 = f64::INFINITY;
        }
        held
    }

    fn is_real(&self) -> bool {
        true
    }

    fn resumes(&mut self, _: f64) -> Option<f64> {
        resume_unwind(Box::new("the power fails"))
    }
}

/// The power fails when the operator has said all of it to whoever stopped.
struct PowerCutBehind<'a>(&'a [&'a str]);

/// The program is answered; the power fails when whoever stopped it is asked.
struct PowerCutSaid(&'static str);

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
struct PowerCutTold(&'static str);

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
struct PowerCutIn(&'static str);

impl Sink for PowerCutIn {
    fn event(&mut self, event: &Event) {
        if matches!(event, Event::State { state, .. } if **state == *self.0) {
            resume_unwind(Box::new("the power fails"));
        }
    }
}

/// Whoever stops the run instead of answering.
struct GivesUp;

impl Operator for GivesUp {
    fn answer(&mut self, _: &Question, _: u32) -> Option<String> {
        None
    }

    fn gives_up(&self) -> bool {
        true
    }
}

fn shelf(journal: &Journal, folder: &TempDir) -> Shelf {
    let disk = MemoryDisk::new([("a.sbp", PART.as_bytes())]);
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    let stored = Stored::of(journal.clone()).unwrap();
    Shelf::new(Box::new(disk), folders, stored, folder.path().into())
}

/// Runs the part file on record; nothing when the power fails.
fn run(folder: &TempDir, pace: &mut dyn Pace, answers: &str) -> (Vec<Event>, Option<Status>) {
    run_work(folder, part(), pace, &mut Answers::read(answers))
}

fn part() -> Program {
    kerf_part::read("a.sbp".into(), PART.as_bytes())
}

fn run_work(
    folder: &TempDir,
    work: impl Into<Work>,
    pace: &mut dyn Pace,
    operator: &mut dyn Operator,
) -> (Vec<Event>, Option<Status>) {
    let mut events = Vec::new();
    let status = run_in(folder, work, Company { sink: &mut events, operator, pace });
    (events, status)
}

fn run_in(folder: &TempDir, work: impl Into<Work>, company: Company<'_>) -> Option<Status> {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let mut shelf = shelf(&journal, folder);
    let (mut session, _) = Session::recall(&journal, &mut shelf).unwrap();
    // Logs are written at its end, also when it was given up.
    let started = Started { time: "14:03:05".into(), date: "2026-11-21".into() };
    let options = RunOptions { started: Some(started), ..RunOptions::default() };
    let went = catch_unwind(AssertUnwindSafe(|| {
        session.run_on_record(work, options, None, &mut shelf, company).unwrap()
    }));
    went.ok().map(|summary| summary.status)
}

fn resume(folder: &TempDir, answers: &str) -> (Vec<Event>, Status) {
    let (events, status) = resume_with(folder, &mut (), &mut Answers::read(answers));
    (events, status.unwrap())
}

fn resume_with(
    folder: &TempDir,
    pace: &mut dyn Pace,
    operator: &mut dyn Operator,
) -> (Vec<Event>, Option<Status>) {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let cut = journal.cut_short().unwrap().expect("a run to take up");
    let mut shelf = shelf(&journal, folder);
    let (mut session, _) = Session::recall(&journal, &mut shelf).unwrap();
    let mut events = Vec::new();
    let company = Company { sink: &mut events, operator, pace };
    let went =
        catch_unwind(AssertUnwindSafe(|| session.resume(&cut, &mut shelf, company).unwrap()));
    (events, went.ok().map(|summary| summary.status))
}

fn motion(event: &Event) -> Option<&MoveEvent> {
    match event {
        Event::Move(made) => Some(made),
        Event::Arc(arc) => Some(&arc.made),
        _ => None,
    }
}

/// A motion as text, its start left out: kind, line, where to, and the circle that it is part of.
fn told(event: &Event) -> Option<String> {
    let made = motion(event)?;
    let circle = match event {
        Event::Arc(arc) => format!(" about {:.6},{:.6} {}", arc.centre.x, arc.centre.y, arc.dir),
        _ => String::new(),
    };
    let Place { x, y, z, .. } = made.to;
    Some(format!("{:?} {} {x:.6},{y:.6},{z:.6}{circle}", made.kind, made.line))
}

fn near(a: &Place, b: &Place) -> bool {
    (a.x - b.x).abs() + (a.y - b.y).abs() + (a.z - b.z).abs() < 1e-9
}

/// What follows the point at which the run was taken up.
fn behind(events: &[Event]) -> &[Event] {
    let at = events.iter().rposition(|e| matches!(e, Event::Resume { .. })).expect("a resume");
    &events[at..]
}

/// The rest of the cut begins where it is said to, and is the rest of the uninterrupted run.
fn same_rest(whole: &[Event], rest: &[Event], line: u32) -> MoveEvent {
    let whole: Vec<String> = whole.iter().filter_map(told).collect();
    let after: Vec<String> = behind(rest).iter().filter_map(told).collect();
    assert_eq!(after[..], whole[whole.len() - after.len()..]);
    let first = behind(rest).iter().find_map(motion).unwrap().clone();
    assert_eq!(first.line, line);
    first
}

/// When a line of the uninterrupted run is half made.
fn middle(whole: &[Event], line: u32) -> f64 {
    let made = whole.iter().filter_map(motion).find(|made| made.line == line).unwrap();
    0.5 * (made.t0 + made.t1)
}

fn uninterrupted() -> Vec<Event> {
    let (whole, status) = run(&tempdir().unwrap(), &mut (), "");
    assert_eq!(status, Some(Status::Ok));
    whole
}

#[test]
fn a_run_that_was_given_up_goes_on_where_it_stood() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let (begun, status) = run(&folder, &mut StopAt(middle(&whole, line)), "hold=Quit");
        assert_eq!(status, Some(Status::Stopped), "line {line}");
        let stood = begun.iter().filter_map(motion).rfind(|made| made.kind == MoveKind::Cut);
        let (rest, status) = resume(&folder, "");
        assert_eq!(status, Status::Ok);
        let first = same_rest(&whole, &rest, line);
        assert!(near(&first.from, &stood.unwrap().to), "line {line}: {first:?}");
        let (journal, _) = Journal::open(folder.path()).unwrap();
        assert!(journal.cut_short().unwrap().is_none(), "it is done");
    }
}

#[test]
fn after_a_power_cut_nothing_is_cut_twice() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let at_s = middle(&whole, line);
        let (_, status) = run(&folder, &mut PowerCut(at_s), "");
        assert_eq!(status, None, "the power failed");
        let (rest, status) = resume(&folder, "");
        assert_eq!(status, Status::Ok);
        let first = same_rest(&whole, &rest, line);
        let made = whole.iter().filter_map(motion).find(|made| made.line == line).unwrap();
        let way = |a: &Place, b: &Place| (a.x - b.x).hypot(a.y - b.y);
        let share = way(&made.from, &first.from) / way(&made.from, &made.to);
        assert!((0.3..0.7).contains(&share), "line {line} goes on at {share} of its way");
    }
}

#[test]
fn the_way_back_is_safe() {
    let whole = uninterrupted();
    let folder = tempdir().unwrap();
    run(&folder, &mut PowerCut(middle(&whole, 6)), "");
    let (rest, _) = resume(&folder, "");
    let steps: Vec<String> = rest
        .iter()
        .skip_while(|e| !matches!(e, Event::Message { .. }))
        .take_while(|e| !matches!(e, Event::Resume { .. }))
        .filter_map(|event| match event {
            Event::Ask(asked) => Some(format!("ask {}", asked.text)),
            Event::Output { n: 1, on, .. } => Some(format!("output {on}")),
            _ => motion(event).map(|made| match made.kind {
                MoveKind::Jog => format!("up to {:.1}", made.to.z),
                MoveKind::Cut => format!("down to {:.1}", made.to.z),
            }),
        })
        .collect();
    let ready =
        "ask Output 1 comes on, the tool goes back to where the cut ended. Is everything ready?";
    assert_eq!(steps, ["up to 1.0", ready, "output true", "down to -0.2"]);
}

/// A line through the sheet, on the simulated machine.
fn job(machine: impl FnOnce(&mut Configuration)) -> Work {
    let mut configuration = profile("sim").unwrap().configuration().unwrap();
    machine(&mut configuration);
    let path = [(0.0, 0.0), (100.0, 0.0)].map(|(x, y)| Point2::new(x, y));
    let shapes = [JobShape::through(1, Polyarc::lines(path, false))].into();
    let job = Job { name: "a.rsm".into(), shapes, ..Job::default() };
    Work::Job(Arc::new(job), Arc::new(configuration))
}

/// A job that is given up in a pause goes on from there; one that was not begun is over.
#[test]
fn a_job_that_was_given_up_in_a_pause_is_taken_up() {
    let given_up = |answers, machine: fn(&mut Configuration)| {
        let folder = tempdir().unwrap();
        let mut answers = Answers::read(answers);
        let (_, status) = run_work(&folder, job(machine), &mut StopAt(5.4), &mut answers);
        assert_eq!(status, Some(Status::Stopped));
        let (journal, _) = Journal::open(folder.path()).unwrap();
        (folder, journal.cut_short().unwrap())
    };
    // Also when he has moved the tool before.
    for answers in ["paused=abort", "jog 0,30,0,0,0,0 1\njog 5,30,0,0,0,0 1\nabort"] {
        let (folder, cut) = given_up(answers, |_| ());
        assert!(cut.is_some_and(|cut| cut.stopped()));
        let (rest, status) = resume(&folder, "hold=Resume\npaused=Resume");
        assert_eq!(status, Status::Ok, "{rest:#?}");
        let cuts = rest.iter().filter_map(motion);
        let cuts = cuts.filter(|made| made.from.x < made.to.x && made.to.z < -15.0);
        let along: Vec<_> = cuts.map(|made| (made.from.x, made.to.x)).collect();
        let (from, to) = (along[0].0, along[along.len() - 1].1);
        assert!(from > 5.0 && from < 95.0 && (to - 100.0).abs() < 1e-9, "{along:?}");
    }
    let (_, cut) = given_up("paused=abort", |machine| machine.misc.double_start = true);
    assert!(cut.is_none(), "it has not begun");
}

/// The power fails when he has said so and the job is not given up yet: he is asked again.
#[test]
fn a_job_that_was_about_to_be_given_up_asks_again() {
    let folder = tempdir().unwrap();
    let operator = &mut Answers::read("paused=abort");
    let company = Company { sink: &mut PowerCutTold("abort"), operator, pace: &mut StopAt(5.4) };
    assert_eq!(run_in(&folder, job(|_| ()), company), None, "the power failed");
    let (said, status) = resume(&folder, "paused=abort");
    assert_eq!((asked(&said).len(), status), (1, Status::Stopped), "{said:#?}");
    let (rest, status) = resume(&folder, "hold=Resume\npaused=Resume");
    assert_eq!(status, Status::Ok, "{rest:#?}");
    let to = rest.iter().filter_map(motion).map(|made| made.to.x);
    assert!(to.fold(0.0, f64::max) > 99.9, "the rest is cut");
}

/// A script that says nothing but Resume while a stop is active does not hold a job for ever; it can be taken up.
#[test]
fn a_job_that_is_told_to_go_on_again_and_again_while_a_stop_is_active_is_given_up() {
    for (number, on) in [(4, false), (Input::EmergencyStop.number(), true)] {
        let folder = tempdir().unwrap();
        let mut pace = Script::new(vec![(5.4, Wish::Input { number, on })], Vec::new());
        let mut says = Answers::read("paused=Resume");
        let (_, status) = run_work(&folder, job(|_| ()), &mut pace, &mut says);
        assert_eq!(status, Some(Status::Stopped), "input {number}");
        press(&folder, number, !on);
        let (rest, status) = resume(&folder, "hold=Resume\npaused=Resume");
        assert_eq!(status, Status::Ok, "input {number}: {rest:#?}");
        let to = rest.iter().filter_map(motion).map(|made| made.to.x);
        assert!(to.fold(0.0, f64::max) > 99.9, "the rest is cut");
    }
}

/// What the operator is asked when a job is taken up that was cut short at a time, and what comes on then.
fn asked_and_switched(at_s: f64) -> (String, Vec<String>) {
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

#[test]
fn whoever_takes_up_a_job_is_told_what_comes_on() {
    // In the delay of the router, on the way down, along the path.
    for at_s in [1.0, 3.3, 5.4] {
        let (asked, on) = asked_and_switched(at_s);
        let told = "Outputs job_running, router, tool1, cut1 come on, the tool goes back";
        assert!(asked.starts_with(told), "{asked}");
        assert_eq!(on, ["job_running", "router", "tool1", "cut1"], "cut short at {at_s} s");
    }
}

#[test]
fn who_is_not_ready_can_take_it_up_later() {
    let whole = uninterrupted();
    let folder = tempdir().unwrap();
    run(&folder, &mut StopAt(middle(&whole, 6)), "hold=Quit");
    let (_, status) = resume(&folder, "hold=Quit");
    assert_eq!(status, Status::Stopped);
    let (rest, status) = resume(&folder, "");
    assert_eq!(status, Status::Ok);
    same_rest(&whole, &rest, 6);
}

#[test]
fn a_switch_that_was_moved_at_rest_is_on_record() {
    let folder = tempdir().unwrap();
    let open = |folder: &TempDir| {
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let mut shelf = shelf(&journal, folder);
        let (session, _) = Session::recall(&journal, &mut shelf).unwrap();
        (session, shelf)
    };
    let part = b"IF %(53)=0 THEN GOTO OFF\nMX,1\nMX,5\nMX,9\nEND\nOFF:\nMX,-5\n";
    let start = |session: &mut Session, shelf: &mut Shelf, pace: &mut dyn Pace| {
        let company = Company { sink: &mut (), operator: &mut (), pace };
        let program = kerf_part::read("a.sbp".into(), part);
        session.run_on_record(program, RunOptions::default(), None, shelf, company).map(drop)
    };
    let (mut session, mut shelf) = open(&folder);
    start(&mut session, &mut shelf, &mut ()).unwrap();
    assert!(session.memory.position[Axis::X] < 0.0, "the switch is open");
    session.press(Press { number: 3, on: true }, &mut shelf);
    drop((session, shelf));
    // Kerf is started anew.
    let (mut session, mut shelf) = open(&folder);
    assert!(session.look(|machine| machine.input(3)), "it stays as it was put");
    let cut =
        catch_unwind(AssertUnwindSafe(|| start(&mut session, &mut shelf, &mut PowerCut(6.0))));
    assert!(cut.is_err(), "the power failed");
    drop((session, shelf));
    let (events, status) = resume(&folder, "hold=Resume");
    let last = events.iter().rev().find_map(|event| match event {
        Event::Move(made) => Some(made.to.x),
        _ => None,
    });
    assert_eq!((status, last), (Status::Ok, Some(9.0)), "{events:?}");
}

#[test]
fn settings_with_an_axis_whose_jerk_is_free_can_be_read_again() {
    // A jerk limit of 0 leaves an axis free: that is infinite, which a record has no number for.
    let mut jerk = Axes::splat(5000.0);
    jerk[Axis::Y] = f64::INFINITY;
    let mut settings = Settings::default();
    let usual = Dynamics::usual(&settings.speeds);
    settings.dynamics = Some(Dynamics { jerk_mm_s3: Some(jerk), ..usual });
    let text = serde_json::to_string(&settings).unwrap();
    assert_eq!(serde_json::from_str::<Settings>(&text).unwrap(), settings);
}

/// What was asked.
fn asked(events: &[Event]) -> Vec<&str> {
    events
        .iter()
        .filter_map(|event| match event {
            Event::Ask(question) => Some(&*question.text),
            _ => None,
        })
        .collect()
}

/// When the operator is asked whether all is ready.
const READY: &str =
    "Output 1 comes on, the tool goes back to where the cut ended. Is everything ready?";

/// Before, when a stop input is active.
const RELEASE: &str =
    "stopped by stop input 4. When it is released, Resume: the tool rises, and goes on";

/// The power fails while somebody is asked what follows on a stop: he is asked once, before the tool goes back.
#[test]
fn a_question_that_was_open_is_settled_when_the_tool_goes_back() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let at_s = middle(&whole, line);
        // The stop input opens its circuit.
        let pressed = Wish::Input { number: 4, on: false };
        let stops: [&mut dyn Pace; 4] = [
            &mut StopAt(at_s),
            &mut Script::new(vec![(at_s, Wish::Stop)], Vec::new()),
            &mut Script::new(vec![(at_s, pressed)], Vec::new()),
            &mut PowerCutHeld(at_s),
        ];
        for (n, pace) in stops.into_iter().enumerate() {
            let folder = tempdir().unwrap();
            let (_, status) = run_work(&folder, part(), pace, &mut PowerCutBehind(&[]));
            assert_eq!(status, None, "the power failed");
            // And again when he is asked whether all is ready.
            let (_, status) = resume_with(&folder, &mut (), &mut PowerCutBehind(&[]));
            assert_eq!(status, None, "the power failed");
            let released = format!("{line}:switch 4 1\nhold=Resume");
            let answers = if n == 2 { &released } else { "hold=Resume" };
            let (rest, status) = resume(&folder, answers);
            assert_eq!(status, Status::Ok, "line {line}, stop {n}: {rest:#?}");
            let pressed: &[&str] = if n == 2 { &[RELEASE] } else { &[] };
            assert_eq!(asked(&rest), [pressed, &[READY]].concat(), "line {line}, stop {n}");
            same_rest(&whole, &rest, line);
        }
    }
}

/// A stop that is told while the machine slows down for a hold comes after it; who gives the run up then takes it up
/// where it stood.
#[test]
fn a_run_that_was_given_up_at_a_stop_in_the_ramp_of_a_hold_goes_on_where_it_stood() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let (folder, at_s) = (tempdir().unwrap(), middle(&whole, line));
        let wishes = vec![(at_s, Wish::Hold), (at_s + 0.02, Wish::Stop)];
        let mut pace = Script::new(wishes, vec![at_s + 2.0]);
        let (begun, status) = run(&folder, &mut pace, "hold=Quit");
        assert_eq!(status, Some(Status::Stopped), "line {line}");
        let held = |event: &Event| matches!(event, Event::Hold { .. });
        assert!(begun.iter().any(held), "line {line}: {begun:#?}");
        assert!(asked(&begun).last().unwrap().starts_with("Stopped."), "line {line}");
        let (rest, status) = resume(&folder, "hold=Resume");
        assert_eq!((asked(&rest), status), (vec![READY], Status::Ok), "line {line}");
        same_rest(&whole, &rest, line);
    }
}

/// What was cut before the power failed is counted: only the way back down is more than without it.
#[test]
fn the_whole_cut_is_counted() {
    let whole = uninterrupted();
    let cut = |events: &[Event]| match events.last() {
        Some(Event::End(end)) => end.cut,
        _ => panic!("no end"),
    };
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        run(&folder, &mut PowerCut(middle(&whole, line)), "");
        let (rest, _) = resume(&folder, "");
        let down = rest.iter().filter_map(motion).find(|made| made.kind == MoveKind::Cut).unwrap();
        let back = down.from.z - down.to.z;
        let more = cut(&rest) - cut(&whole);
        assert!((more - back).abs() < 1e-6, "line {line}: {more} more, {back} down again");
    }
}

/// The program asks something before the tool goes back, and the power fails once more.
#[test]
fn a_question_of_the_program_behind_one_that_was_open_is_asked_once() {
    const ASKS: &str = "SA\nMX,1\nPAUSE 5\nINPUT \"How far\" &far\nMX,&far\nMX,3\n";
    let (folder, asks) = (tempdir().unwrap(), kerf_part::read("a.sbp".into(), ASKS.as_bytes()));
    let (whole, _) = run_work(&tempdir().unwrap(), asks, &mut (), &mut Answers::read("2"));
    let waits = |event: &Event| match event {
        Event::Wait { t, .. } => Some(t + 1.0),
        _ => None,
    };
    let mut stop = StopAt(whole.iter().find_map(waits).unwrap());
    let asks = kerf_part::read("a.sbp".into(), ASKS.as_bytes());
    assert_eq!(run_work(&folder, asks, &mut stop, &mut PowerCutBehind(&[])).1, None);
    let (begun, status) = resume_with(&folder, &mut (), &mut PowerCutSaid("2"));
    assert_eq!((asked(&begun).len(), status), (1, None), "{begun:#?}");
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!(status, Status::Ok, "{rest:#?}");
    assert!(asked(&rest)[0].ends_with("Is everything ready?"), "{rest:#?}");
    let along: Vec<_> = behind(&rest).iter().filter_map(motion).map(|made| made.to.x).collect();
    assert_eq!(along[along.len() - 2..], [2.0, 3.0]);
}

/// What stopped it is not what it meets again when it is taken up.
#[test]
fn a_run_that_was_given_up_at_a_stop_input_goes_on_where_it_stood() {
    let whole = uninterrupted();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let pressed = Wish::Input { number: 4, on: false };
        let mut pace = Script::new(vec![(middle(&whole, line), pressed)], Vec::new());
        let (_, status) = run(&folder, &mut pace, "hold=Quit");
        assert_eq!(status, Some(Status::Stopped), "line {line}");
        // Whoever is asked is asked behind the line before. He is not ready yet.
        let before = line - 1;
        let released = format!("{before}:switch 4 1\n{before}:Resume\n{before}:Quit");
        let (rest, status) = resume(&folder, &released);
        assert_eq!(status, Status::Stopped, "line {line}: {rest:#?}");
        assert_eq!(asked(&rest), [RELEASE, READY], "line {line}");
        let (rest, status) = resume(&folder, "hold=Resume");
        assert_eq!(status, Status::Ok, "line {line}: {rest:#?}");
        assert_eq!(asked(&rest), [READY], "line {line}");
        same_rest(&whole, &rest, line);
    }
}

/// Who nudged the workpiece before the power failed finds it nudged, also when it fails again before the tool is
/// back.
#[test]
fn a_nudge_before_the_power_failed_is_on_record() {
    let whole = uninterrupted();
    let (folder, line) = (tempdir().unwrap(), 6);
    let mut stop = StopAt(middle(&whole, line));
    let nudge = &mut PowerCutBehind(&["nudge y .25"]);
    assert_eq!(run_work(&folder, part(), &mut stop, nudge).1, None, "the power failed");
    let nudge = &mut PowerCutBehind(&["nudge y .5"]);
    assert_eq!(resume_with(&folder, &mut (), nudge).1, None, "the power failed");
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!(status, Status::Ok);
    assert_eq!(asked(&rest), [READY]);
    same_rest(&whole, &rest, line);
    // What is shown stays; the machine is elsewhere.
    let unmoved = tempdir().unwrap();
    run(&unmoved, &mut (), "");
    let by = stands(&folder).minus(stands(&unmoved));
    assert!((by[Axis::Y] - 0.75 * 25.4).abs() < 1e-9, "{by:?}");
}

/// Who stops it on the way back and gives it up has lost nothing of the cut.
#[test]
fn a_run_that_was_given_up_on_the_way_back_goes_on_where_it_stood() {
    let whole = uninterrupted();
    let cut_short = |line| {
        let folder = tempdir().unwrap();
        run(&folder, &mut PowerCut(middle(&whole, line)), "");
        folder
    };
    for line in [5, 6, 7] {
        let (back, _) = resume(&cut_short(line), "");
        let down = back.iter().filter_map(motion).find(|made| made.kind == MoveKind::Cut).unwrap();
        let folder = cut_short(line);
        let mut stop = StopAt(0.5 * (down.t0 + down.t1));
        let (begun, status) =
            resume_with(&folder, &mut stop, &mut PowerCutBehind(&["Resume", "Quit"]));
        assert_eq!(status, Some(Status::Stopped));
        assert!(!begun.iter().any(|event| matches!(event, Event::Resume { .. })), "too late");
        let (rest, status) = resume(&folder, "");
        assert_eq!(status, Status::Ok);
        let [rest, back] = [rest, back].map(|events| same_rest(&whole, &events, line).from);
        assert!(near(&rest, &back), "line {line}: {rest:?}");
    }
}

/// The power fails when a held run is given up, and that is not on record yet.
#[test]
fn a_held_run_that_was_about_to_be_given_up_goes_on() {
    let whole = uninterrupted();
    let (folder, at_s) = (tempdir().unwrap(), middle(&whole, 5));
    let pace = &mut Script::new(vec![(at_s, Wish::Hold)], Vec::new());
    let company = Company { sink: &mut PowerCutIn("idle"), operator: &mut (), pace };
    assert_eq!(run_in(&folder, part(), company), None, "the power failed");
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!((asked(&rest), status), (vec![READY], Status::Ok), "{rest:#?}");
    same_rest(&whole, &rest, 5);
}

/// Somebody moves a switch while nothing runs.
fn press(folder: &TempDir, number: u8, on: bool) {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let mut shelf = shelf(&journal, folder);
    let (mut session, _) = Session::recall(&journal, &mut shelf).unwrap();
    session.press(Press { number, on }, &mut shelf);
}

/// Nothing moves and nothing comes on before the emergency stop is released, and nothing of the cut is lost.
#[test]
fn a_run_is_not_taken_up_while_the_emergency_stop_is_pressed() {
    let whole = uninterrupted();
    let emergency = Input::EmergencyStop.number();
    for line in [5, 6, 7] {
        let folder = tempdir().unwrap();
        let pressed = Wish::Input { number: emergency, on: true };
        let mut pace = Script::new(vec![(middle(&whole, line), pressed)], Vec::new());
        let (begun, status) = run(&folder, &mut pace, "");
        assert_eq!(status, Some(Status::Stopped));
        let stood = begun.iter().filter_map(motion).next_back().unwrap().to;
        let (said, status) = resume(&folder, "hold=Resume");
        assert_eq!((asked(&said), status), (vec![], Status::Stopped), "line {line}: {said:#?}");
        let comes_on = |event: &Event| matches!(event, Event::Output { on: true, .. });
        assert!(!said.iter().any(|event| comes_on(event) || motion(event).is_some()), "{said:#?}");
        press(&folder, emergency, false);
        let (rest, status) = resume(&folder, "hold=Resume");
        assert_eq!((asked(&rest), status), (vec![READY], Status::Ok), "line {line}");
        let first = same_rest(&whole, &rest, line);
        assert!(near(&first.from, &stood), "line {line}: {first:?}");
    }
}

/// The tool does not go down before it is asked whether all is ready.
#[test]
fn a_run_that_is_taken_up_at_a_stop_input_only_rises_when_that_is_released() {
    let whole = uninterrupted();
    let folder = tempdir().unwrap();
    run(&folder, &mut PowerCut(middle(&whole, 6)), "");
    press(&folder, 4, false);
    let (rest, status) = resume(&folder, "5:switch 4 1\nhold=Resume");
    assert_eq!((asked(&rest), status), (vec![RELEASE, READY], Status::Ok));
    let ready = rest.iter().rposition(|event| matches!(event, Event::Ask(_))).unwrap();
    let kinds: Vec<_> = rest[..ready].iter().filter_map(motion).map(|made| made.kind).collect();
    assert_eq!(kinds, [MoveKind::Jog], "it only rises");
    same_rest(&whole, &rest, 6);
}

/// Whoever moves another switch while the machine slows down for a stop input is not told of that again.
#[test]
fn a_switch_that_is_moved_behind_a_stop_input_does_not_hide_it() {
    const RAMPED: &str = "VN,,,,,,,3\nSA\nMX,1\nMX,9\nMX,12\n";
    let work = || kerf_part::read("a.sbp".into(), RAMPED.as_bytes());
    let (whole, _) = run_work(&tempdir().unwrap(), work(), &mut (), &mut ());
    let (folder, at_s) = (tempdir().unwrap(), middle(&whole, 4));
    let input = |number, after_s, on| (at_s + after_s, Wish::Input { number, on });
    let mut pace = Script::new(vec![input(5, 0.0, true), input(1, 0.02, true)], Vec::new());
    let (begun, status) = run_work(&folder, work(), &mut pace, &mut Answers::read("hold=Quit"));
    assert_eq!(status, Some(Status::Stopped));
    let stops = |event: &Event| match event {
        Event::Stop { n, .. } => Some(*n),
        _ => None,
    };
    assert_eq!(begun.iter().filter_map(stops).collect::<Vec<_>>(), [5], "{begun:#?}");
    let cut = begun.iter().filter_map(motion).rfind(|made| made.kind == MoveKind::Cut).unwrap();
    press(&folder, 5, false);
    let (rest, status) = resume(&folder, "hold=Resume");
    assert_eq!((asked(&rest).len(), status), (1, Status::Ok), "{rest:#?}");
    let first = behind(&rest).iter().find_map(motion).unwrap();
    assert!(near(&first.from, &cut.to), "{first:?} {cut:?}");
}

/// Whoever gives a run up while it asks him something, or behind that at a stop input, can take it up there.
#[test]
fn a_run_that_was_given_up_at_a_question_is_taken_up() {
    const STILL: &str = "MX,1\nPAUSE\nMX,5\n";
    const TURNS: &str = "SO,1,1\nMX,1\nPAUSE\nMX,5\n";
    let pressed = &mut Answers::read("3:switch 4 0\n3:OK\nhold=Quit");
    let runs: [(&str, &mut dyn Operator); 2] = [(STILL, &mut GivesUp), (TURNS, pressed)];
    for (text, operator) in runs {
        let (folder, work) = (tempdir().unwrap(), kerf_part::read("a.sbp".into(), text.as_bytes()));
        assert_eq!(run_work(&folder, work, &mut (), operator).1, Some(Status::Stopped), "{text}");
        press(&folder, 4, true);
        let (rest, status) = resume(&folder, "pause=OK\nhold=Resume");
        assert_eq!(status, Status::Ok, "{text}: {rest:#?}");
        let to: Vec<f64> = rest.iter().filter_map(motion).map(|made| made.to.x).collect();
        assert_eq!(to.last(), Some(&5.0), "{text}");
        let turns = rest.iter().any(|it| matches!(it, Event::Output { n: 1, on: true, .. }));
        assert_eq!(turns, text == TURNS, "{text}: {rest:#?}");
    }
}

/// Where the machine stands.
fn stands(folder: &TempDir) -> Axes {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let (session, _) = Session::recall(&journal, &mut shelf(&journal, folder)).unwrap();
    session.memory.position
}
