//! A case lived through: once without a kill, once with kills and resumes, on a journal of its own.

use crate::simulated::case::{Case, What};
use crate::simulated::levels::Levels;
use crate::simulated::path::{Done, is_flat, laid};
use crate::simulated::programs::SUB;
use crate::simulated::watch::{Doom, Killed, Seen, Watch};
use kerf_control::answers::Operator;
use kerf_control::{OperatorRequest, Requests, RunContext, Session};
use kerf_files::{Folders, RealDisk};
use kerf_journal::{Journal, RunOptions, Whereabouts, Work};
use kerf_machine::{Errand, Going};
use kerf_program::settings::Resolution;
use kerf_program::{Axes, Axis, MoveKind, Question, QuestionKind, Status};
use kerf_sim::{Clock, Opened, Simulated};
use kerf_trace::{Doing, Event, Sink, Summary, json};
use kerf_workspace::{Workspace, stored::Stored};
use std::cell::RefCell;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::Path;
use std::sync::Arc;
use tempfile::TempDir;

/// Result of a case.
pub struct Lived {
    pub kills: u64,
    pub resumes: u64,
    /// The path of the killed run was held against that of the other.
    pub compared: bool,
}

/// The operator: what he asks for and when, whatever process runs.
struct Person<'a> {
    doom: &'a Doom,
    requests: &'a RefCell<Vec<(f64, OperatorRequest)>>,
}

impl Requests for Person<'_> {
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        self.doom.tick();
        let mut requests = self.requests.borrow_mut();
        let (at_s, request) = requests.pop_if(|(at_s, _)| to_s > from_s && to_s >= *at_s)?;
        Some((at_s.max(from_s), request))
    }

    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        Some(held_s + 0.5)
    }
}

/// Notes where the machine comes by.
struct Onlooker<'a> {
    doom: &'a Doom,
    /// Places in the middle of a cut that the machine came by since it was looked at last.
    under_way: Vec<Axes>,
    /// Up to when it was watched: a way that is looked through again is on record already.
    looked_s: f64,
    /// Something was cut in the plane.
    cut: bool,
}

impl<'a> Onlooker<'a> {
    const fn new(doom: &'a Doom) -> Self {
        Self { doom, under_way: Vec::new(), looked_s: 0.0, cut: false }
    }
}

impl Sink for Onlooker<'_> {
    fn event(&mut self, _: &Event) {}

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn under_way(&mut self, doing: &Doing<'_>, from_s: f64, to_s: f64) {
        if to_s > self.looked_s || doing.going.is_none() {
            self.cut |= doing.going.is_some_and(|going| cuts_flat(going));
            let near = doing.going.filter(|_| self.doom.is_near());
            self.under_way = near.map_or_else(Vec::new, |it| cut_under_way(from_s, to_s, it));
            self.looked_s = to_s;
        }
    }
}

/// The machine of a process whose every move is on record before it begins.
fn on_record() -> Opened {
    Simulated::opened(AtOnce)
}

/// Time that passes at once and counts as that of the world.
struct AtOnce;

impl Clock for AtOnce {
    fn pass(&mut self, _: f64, until_s: f64) -> f64 {
        until_s
    }

    fn in_real_time(&self) -> bool {
        true
    }
}

/// Tells whether something is cut in the plane.
fn cuts_flat(going: &Going<'_>) -> bool {
    going.made().is_some_and(|made| {
        let flat = is_flat(made.from.first3(), made.to.first3(), made.arc().is_some());
        made.kind == MoveKind::Cut && flat
    })
}

/// Places that the machine comes by from one moment to another, in the middle of a cut in the plane.
fn cut_under_way(from_s: f64, to_s: f64, going: &Going<'_>) -> Vec<Axes> {
    let ends_s = going.t0_s + going.plan.span_s(going.index).1;
    if !cuts_flat(going) || to_s > ends_s - 1e-6 {
        return Vec::new();
    }
    let share = |n: u32| f64::from(n) / f64::from(PLACES);
    let moment = |n: u32| from_s + (to_s - from_s) * share(n) - going.t0_s;
    (0..=PLACES).map(|n| going.plan.at(moment(n)).position).collect()
}

/// Places that are looked at between two moments.
const PLACES: u32 = 8;

/// Looks at the operator before a process dies in a move by hand.
const LIFE_BY_HAND: u64 = 3;

/// So often.
const PATIENCE: u32 = 60;

/// Answers everything so that the run goes on, or can be taken up.
struct Helpful<'a> {
    doom: &'a Doom,
    asked: u32,
    /// Number of times that he is asked after a stop before he gives up, for each time that he does.
    gives_up: &'a RefCell<Vec<u32>>,
    gave_up: bool,
}

impl Helpful<'_> {
    fn gives_up(&mut self) -> bool {
        let mut left = self.gives_up.borrow_mut();
        let now = left.contains(&0);
        *left = left.iter().filter_map(|n| n.checked_sub(1)).collect();
        self.gave_up |= now;
        now
    }
}

impl Operator for Helpful<'_> {
    fn answer(&mut self, question: &Question, _line: u32) -> Option<String> {
        self.doom.tick();
        self.asked += 1;
        let word = match question.kind {
            QuestionKind::Input => "2",
            QuestionKind::Msgbox => "Yes",
            QuestionKind::Limit => return None,
            QuestionKind::Hold if self.gives_up() => "Quit",
            QuestionKind::Hold => "Resume",
            // What does not go away by itself.
            QuestionKind::Paused if self.asked > PATIENCE => "abort",
            // One that is given up before it begins is over.
            QuestionKind::Paused if question.prefill.is_empty() && self.gives_up() => "abort",
            QuestionKind::Paused => "continue",
            _ => "OK",
        };
        Some(word.into())
    }
}

/// One life of a case.
struct Life<'a> {
    case: &'a Case,
    folder: TempDir,
    doom: Doom,
    requests: RefCell<Vec<(f64, OperatorRequest)>>,
    gives_up: RefCell<Vec<u32>>,
    takes_s: f64,
}

/// Remains of a process.
struct Process {
    seen: Seen,
    /// `None`: it was killed.
    summary: Option<Summary>,
    /// Locations at its begin and at its end.
    from: Axes,
    to: Axes,
    took_up: bool,
    /// The operator's patience ended.
    gave_up: bool,
    /// He gave up before anything moved.
    over_early: bool,
    /// He gave up, and the run can be taken up.
    put_off: bool,
    /// Places at which it may have died, when that was in the middle of a cut.
    under_way: Vec<Axes>,
    /// Something was cut in the plane.
    cut: bool,
}

impl<'a> Life<'a> {
    fn new(case: &'a Case, takes_s: f64) -> Self {
        let shm = Path::new("/dev/shm");
        let folder = if shm.is_dir() { TempDir::new_in(shm) } else { TempDir::new() }.unwrap();
        fs::write(folder.path().join("sub.sbp"), SUB).unwrap();
        let mut requests: Vec<_> =
            case.requests.iter().map(|(share, request)| (share * takes_s, *request)).collect();
        requests.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (doom, requests) = (Doom::default(), RefCell::new(requests));
        Self { case, folder, doom, requests, gives_up: RefCell::default(), takes_s }
    }

    /// A process: begins the case, or takes it up; `None` when there is nothing left to do.
    fn process(&self, pushed: Axes) -> Option<Process> {
        let data = self.folder.path().join("data");
        let (journal, told) = Journal::open(&data).unwrap();
        assert!(told.is_empty(), "the journal was damaged: {told:?}");
        let cut = journal.runs.cut_short().unwrap();
        if cut.is_none() && !journal.runs.history().unwrap().is_empty() {
            return None;
        }
        let folders = Folders::new(self.folder.path().into(), Vec::new(), Vec::new());
        let stored = Stored::of(journal.clone()).unwrap();
        let mut workspace = Workspace::new(Box::new(RealDisk), folders, stored, data);
        let (mut session, _) = Session::recall(&journal, &mut workspace).unwrap();
        let kept = session.memory.settings.clone();
        if cut.is_some() {
            self.type_lines(&mut session, &mut workspace, pushed);
            self.die_by_hand(&mut session, &mut workspace, &journal, pushed);
            self.move_by_hand(
                (&mut session, &mut workspace),
                pushed,
                &mut (),
                kerf_control::simulated(),
            );
            let (again, whereabouts) = Session::recall(&journal, &mut workspace).unwrap();
            assert_eq!(again.memory.position, session.memory.position, "it was moved by hand");
            assert!(whereabouts == Whereabouts::Known || pushed == Axes::default());
            session = again;
        } else {
            session.memory.settings = self.case.settings.clone();
        }
        let from = session.memory.position;
        let mut watch =
            Watch { doom: &self.doom, allowed: self.case.allowed(), seen: Seen::default() };
        let mut person = Person { doom: &self.doom, requests: &self.requests };
        let mut onlooker = Onlooker::new(&self.doom);
        let (doom, gives_up) = (&self.doom, &self.gives_up);
        let mut helpful = Helpful { doom, asked: 0, gives_up, gave_up: false };
        let ran = catch_unwind(AssertUnwindSafe(|| {
            let context = RunContext {
                sink: &mut (&mut watch, &mut onlooker),
                operator: &mut helpful,
                requests: &mut person,
                machine: on_record(),
            };
            match &cut {
                Some(cut) => session.resume(cut, &mut workspace, context).unwrap(),
                None => {
                    let (work, options) = (self.case.work(), self.case.options(self.takes_s));
                    let kept = Some(kept);
                    session.run_on_record(work, options, kept, &mut workspace, context).unwrap()
                }
            }
        }));
        let summary = match ran {
            Ok(summary) => Some(summary),
            Err(death) if death.is::<Killed>() => None,
            Err(failure) => {
                talk(&watch.seen);
                resume_unwind(failure);
            }
        };
        talk(&watch.seen);
        let to = session.memory.position;
        let gave_up = helpful.asked > PATIENCE;
        let took_up = cut.is_some();
        let put_off = helpful.gave_up && journal.runs.cut_short().unwrap().is_some();
        // What was given up before it moved is over.
        let begun = summary.as_ref().is_none_or(|it| it.tally.moves > 0);
        let over_early = helpful.gave_up && !begun && !took_up;
        if summary.is_some() {
            let last = watch.seen.events.last();
            assert!(matches!(last, Some(Event::End(_))), "nobody was told that it ended");
        }
        if summary.as_ref().is_some_and(|it| it.status == Status::Stopped) && !put_off {
            let told = |event: &Event| matches!(event, Event::Ask(_) | Event::Diag(_));
            let told = watch.seen.events.iter().any(told);
            assert!(told || !took_up, "it was taken up and stopped, and nobody was told");
        }
        let Onlooker { under_way, cut, .. } = onlooker;
        let seen = watch.seen;
        Some(Process {
            seen,
            summary,
            from,
            to,
            took_up,
            gave_up,
            over_early,
            put_off,
            under_way,
            cut,
        })
    }

    /// Now and then the process dies while somebody moves the tool: it is near where it stood, and not homed.
    fn die_by_hand(
        &self,
        session: &mut Session,
        workspace: &mut Workspace,
        journal: &Journal,
        by: Axes,
    ) {
        if by[Axis::X] >= 0.0 {
            return;
        }
        let (doom, nothing) = (Doom::default(), RefCell::default());
        doom.after(LIFE_BY_HAND);
        let mut person = Person { doom: &doom, requests: &nothing };
        let stands = session.memory.position;
        let moves = || self.move_by_hand((session, workspace), by, &mut person, on_record());
        let died = catch_unwind(AssertUnwindSafe(moves)).is_err();
        let (again, whereabouts) = Session::recall(journal, workspace).unwrap();
        if died {
            assert_eq!((again.memory.position, whereabouts), (stands, Whereabouts::Moving));
            assert!(again.homed.is_empty());
        }
        *session = again;
    }

    /// Now and then somebody types lines before, which ask the world and write to it.
    fn type_lines(&self, session: &mut Session, workspace: &mut Workspace, by: Axes) {
        if by[Axis::Y] >= 0.0 {
            return;
        }
        let mut options = RunOptions::default();
        options.program.typed = true;
        let lines = kerf_sbp::read_typed("command".into(), "UD\nPAUSE 0.1\nSetUsrVal, 7\n");
        let context = RunContext {
            sink: &mut (),
            operator: &mut (),
            requests: &mut (),
            machine: kerf_control::simulated(),
        };
        session.run_on_record(lines, options, None, workspace, context).unwrap();
    }

    /// Somebody moves the tool before the run is taken up.
    fn move_by_hand(
        &self,
        (session, workspace): (&mut Session, &mut Workspace),
        by: Axes,
        requests: &mut dyn Requests,
        machine: Opened,
    ) {
        if by == Axes::default() {
            return;
        }
        let stands = session.memory.position;
        let way = self.within(stands.plus(by)).minus(stands);
        let machine_is = match &self.case.what {
            What::Part { .. } => Arc::new(session.configuration()),
            What::Job(_, machine) => Arc::new((**machine).clone()),
        };
        let errand = Errand::To { place: way.0.map(Some), relative: true, flat: true };
        let context = RunContext { sink: &mut (), operator: &mut (), requests, machine };
        let work = Work::Hand(errand, machine_is);
        session.run_on_record(work, RunOptions::default(), None, workspace, context).unwrap();
    }

    /// A place on the table near one.
    fn within(&self, at: Axes) -> Axes {
        let Some([low, high]) = self.case.allowed().bounds else { return at };
        let mut at = at;
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            at[axis] = at[axis].clamp(low[axis], high[axis]);
        }
        at
    }
}

/// Prints the events of a process, for whoever looks for the reason of a failure (KERF_SIM_TALK).
fn talk(seen: &Seen) {
    if std::env::var_os("KERF_SIM_TALK").is_some() {
        eprintln!("--- a process");
        seen.events.iter().for_each(|event| eprintln!("{}", json::to_string(event)));
    }
}

/// Lives through a case.
pub fn live(case: &Case) -> Lived {
    let quiet = Case { inputs: early(case), requests: Vec::new(), ..case.clone() };
    let plain = Life::new(&quiet, 0.0).process(Axes::default()).unwrap();
    plain.check_location(case);
    let takes_s = plain.summary.as_ref().unwrap().seconds;
    let whole = Life::new(case, takes_s).process(Axes::default()).unwrap();
    whole.check_location(case);
    if plain.seen.faults + whole.seen.faults == 0 {
        same_levels(case, &plain, &Levels::of(&whole.seen));
    }
    killed(case, takes_s, &whole)
}

/// Checks that a sheet which is followed is followed at the same heights, whatever happens.
fn same_levels(case: &Case, usual: &Process, levels: &Levels) {
    if case.keeps_its_path() && case.follows_sheet() {
        let left = Levels::of(&usual.seen).left_by(levels);
        assert!(left.is_none(), "heights differ: {}", left.unwrap_or_default());
    }
}

/// Inputs that are on from the beginning.
fn early(case: &Case) -> Vec<(u8, f64, bool)> {
    case.inputs.iter().filter(|(_, at, _)| *at == 0.0).copied().collect()
}

/// Everything that one run of a case tells.
pub fn events(case: &Case) -> Vec<Event> {
    Life::new(case, 30.0).process(Axes::default()).unwrap().seen.events
}

/// The same as lines of a trace. Where its folder lies is none of the run's doing.
pub fn trace(case: &Case) -> Vec<String> {
    let life = Life::new(case, 30.0);
    let folder = life.folder.path().display().to_string();
    let events = life.process(Axes::default()).unwrap().seen.events;
    events.iter().map(|event| json::to_string(event).replace(&folder, "")).collect()
}

fn killed(case: &Case, takes_s: f64, whole: &Process) -> Lived {
    let life = Life::new(case, takes_s);
    life.gives_up.replace(case.gives_up.clone());
    let all = whole.seen.events.len() as f64;
    let mut lived = Lived { kills: 0, resumes: 0, compared: false };
    let mut done = Done::nothing();
    let mut kills = case.kills.iter().zip(&case.pushed);
    let mut pushed = Axes::default();
    let compared = |seen: &Seen| laid(&seen.pieces, case.keeps_heights(), |line| case.slopes(line));
    let path = compared(&whole.seen);
    let (mut why, mut gave_up, mut over_early) = (None, false, false);
    let mut under_way: Vec<Axes> = Vec::new();
    let (mut levels, mut faults) = (Levels::default(), whole.seen.faults);
    let status = loop {
        let kill = kills.next();
        life.doom.after(kill.map_or(0, |(share, _)| 1 + (share * all) as u64));
        let Some(process) = life.process(pushed) else { break None };
        life.doom.after(0);
        pushed = kill.map(|(_, by)| *by).unwrap_or_default();
        lived.resumes += u64::from(process.took_up);
        let next = compared(&process.seen);
        if let Some(first) = next.first().filter(|_| case.keeps_its_path()) {
            let again = first.goes_down() && case.ramps(first.line);
            let goes_on = under_way.is_empty() || again || first.begins_by(&under_way);
            assert!(goes_on, "it died at {under_way:?} and goes on with {first:?}");
        }
        if process.cut {
            under_way = process.under_way;
        }
        done.follow_on(&next, &path);
        levels.add(&process.seen);
        faults += process.seen.faults;
        if process.put_off {
            continue;
        }
        if let Some(summary) = process.summary {
            (why, gave_up, over_early) = (summary.error, process.gave_up, process.over_early);
            break Some(summary.status);
        }
        lived.kills += 1;
    };
    if case.keeps_its_path() && status.is_none_or(|it| it == whole.status()) {
        // An operator whose patience ends gives up where a fault comes again and again: not at the same place
        // when it began anew in between.
        let to_the_end = whole.status() != Status::Stopped;
        let different = done.differs(&path, to_the_end);
        assert!(different.is_none(), "the path differs: {}", different.unwrap_or_default());
        lived.compared = true;
    }
    if faults == 0 {
        same_levels(case, whole, &levels);
    }
    // A cut that the machine cannot make ends when the operator says so.
    let hopeless = gave_up && whole.seen.faults > 0 || over_early;
    if case.keeps_its_path() && whole.status() == Status::Ok && !hopeless {
        assert!(
            status.is_none_or(|status| status == Status::Ok),
            "it ended as {status:?}: {why:?}"
        );
    }
    lived
}

impl Process {
    fn status(&self) -> Status {
        self.summary.as_ref().unwrap().status
    }

    /// The location is the sum of all motion, and of all steps.
    fn check_location(&self, case: &Case) {
        let (way, moved) = (self.seen.way, self.to.minus(self.from));
        let Some(Event::End(end)) = self.seen.events.last() else { panic!("no end") };
        let resolution = match &case.what {
            What::Part { .. } => &case.settings.resolution,
            What::Job(_, machine) => &machine.program.resolution,
        };
        let allowed = case.allowed();
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            if allowed.z_wanders && axis == Axis::Z {
                continue;
            }
            let off = (way[axis] - moved[axis]).abs();
            assert!(
                off < 4.0 * allowed.jump_mm,
                "{axis:?} moved by {} and is at {}",
                way[axis],
                moved[axis]
            );
            let steps = turned(resolution, axis, moved[axis]);
            let made = end.steps[axis.index()] as f64;
            assert!((steps - made).abs() <= 1.0, "{axis:?}: {made} steps, not {steps}");
        }
    }
}

/// Steps of a way.
fn turned(resolution: &Resolution, axis: Axis, way: f64) -> f64 {
    way * resolution.steps_per_unit[axis]
}
