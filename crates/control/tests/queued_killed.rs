//! The host of a board with step queues is killed at any instant of a run, in time that is none; the run is taken up and the
//! board cuts the same.
//!
//! KERF_KILLS says how many times (`make soak` runs 1,000), KERF_SEED with which seed it begins.

use crate::queued::{Virtual, World, machine_of};
use crate::step_path::{Judge, MACHINE, part};
use kerf_control::answers::Answers;
use kerf_control::controller::queued::{Attached, Queued, Socket, Wiring};
use kerf_control::{RunContext, Session};
use kerf_driver_klipper::fake::{Dice, Faults};
use kerf_files::{Folders, MemoryDisk};
use kerf_journal::{CutShort, Journal, RunOptions};
use kerf_machine::Configuration;
use kerf_sbp::Status;
use kerf_trace::Summary;
use kerf_workspace::{Workspace, stored::Stored};
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;
use std::sync::Arc;
use tempfile::{TempDir, tempdir};

const NAME: &str = "klipper:board";

/// Times after which motors and outputs have to be off behind a kill, seconds: the deadline and the watch of the board.
const MOTORS_OFF_S: f64 = 0.11;
const OUTPUTS_OFF_S: f64 = 0.7;
/// A process that is killed so often in a run is let live then.
const KILLS_A_RUN: u32 = 3;

/// Legs of the part.
const LEGS: (usize, u32) = (23, 109);

fn part_text() -> String {
    part(LEGS.0, LEGS.1).text()
}

fn machine() -> Configuration {
    machine_of(MACHINE)
}

/// A machine with its board, and the folder in which its host keeps what it knows.
struct Bench {
    world: Rc<RefCell<World>>,
    folder: TempDir,
}

impl Bench {
    fn new(seed: u64, faults: Faults) -> Self {
        let machine = machine();
        let wiring = Wiring::of(&machine).unwrap();
        let world = World::new(seed, faults, &wiring, &machine.board);
        Self { world: Rc::new(RefCell::new(world)), folder: tempdir().unwrap() }
    }

    fn counts(&self) -> Vec<i64> {
        self.world.borrow().fake.steppers.values().map(|it| it.position).collect()
    }

    fn workspace(&self, journal: &Journal) -> Workspace {
        let disk = MemoryDisk::new([("a.sbp", part_text().as_bytes())]);
        let folders = Folders::new("".into(), Vec::new(), Vec::new());
        let stored = Stored::of(journal.clone()).unwrap();
        Workspace::new(Box::new(disk), folders, stored, self.folder.path().into())
    }

    /// A host begins the run, or takes it up where one was cut short, as `kerf run --resume` does. Nothing where it is
    /// killed meanwhile, a time after its beginning.
    fn lives(&self, after_s: f64) -> Option<Summary> {
        let lived = catch_unwind(AssertUnwindSafe(|| {
            let machine = machine();
            let wiring = Wiring::of(&machine).unwrap();
            let (version, counts) = {
                let world = &mut *self.world.borrow_mut();
                world.begin_anew(&wiring, &machine.board);
                world.dies_s = world.now_s + after_s;
                world.ready()
            };
            let parts = (wiring, machine.program.resolution.steps_per_unit);
            let berth = Box::new(Virtual(self.world.clone()));
            self.runs(Queued::new(NAME, &version, parts, counts, berth))
        }));
        lived
            .inspect_err(|why| {
                assert!(self.world.borrow().is_dead(), "{:?}", why.downcast_ref::<&str>())
            })
            .ok()
    }

    fn runs(&self, queued: Queued) -> Summary {
        let (journal, _) = Journal::open(self.folder.path()).unwrap();
        let mut workspace = self.workspace(&journal);
        let (mut session, _) = Session::recall(&journal, &mut workspace).unwrap();
        let cut = journal.runs.cut_short().unwrap();
        session.hold(cut.as_ref().map_or_else(machine, CutShort::began_with));
        let socket = Socket {
            name: NAME.into(),
            port: "board".into(),
            opens: Arc::new(|| Err("it is open".into())),
        };
        let (attached, told) = Attached::of(socket, queued, &mut session, &mut workspace);
        let counts = self.counts();
        let place = session.memory.position.0;
        for (axis, count) in counts.iter().enumerate() {
            let per_mm = machine().program.resolution.steps_per_unit.0[axis];
            assert!((place[axis] - *count as f64 / per_mm).abs() < 1e-9, "{place:?} {counts:?}");
        }
        // A board that has made no step since it was powered does not show that it was not switched off meanwhile.
        let cut = cut.filter(|_| attached.knows_place());
        let stood = self.world.borrow().fake.steppers.values().all(|it| it.made.is_empty());
        assert!(attached.knows_place() || stood, "{:?} {counts:?}", told.notes);
        let mut operator = Answers::read("hold=Resume\nlocation=Continue");
        let context = RunContext {
            sink: &mut (),
            operator: &mut operator,
            requests: &mut (),
            machine: attached.driven().into(),
        };
        attached.begins(&mut workspace);
        let summary = match cut {
            Some(cut) => session.resume(&cut, &mut workspace, context),
            None => {
                let program = kerf_part::read("a.sbp".into(), part_text().as_bytes());
                let options = RunOptions { controller: Some(NAME.into()), ..RunOptions::default() };
                session.run_on_record(program, options, None, &mut workspace, context)
            }
        };
        let summary = summary.unwrap();
        attached.ends(summary.status == Status::Ok, &mut workspace, || false);
        summary
    }

    /// The host is dead for a time: the board ends motion and outputs by itself.
    fn rests(&self, time_s: f64, seed: u64) {
        let world = &mut *self.world.borrow_mut();
        let (died_s, until_s) = (world.dies_s, world.now_s + time_s);
        while world.now_s < until_s {
            world.pass();
        }
        let fake = &world.fake;
        let last =
            fake.steppers.values().filter_map(|it| it.made.last()).map(|(clock, _)| *clock).max();
        let moved_s = last.map_or(0.0, |clock| fake.time_at(clock) - died_s);
        assert!(moved_s < MOTORS_OFF_S, "seed {seed}: moved for {moved_s} s");
        let off = fake.outputs.values().all(|output| output.value == 0);
        assert!(off || time_s < OUTPUTS_OFF_S, "seed {seed}: an output is on");
    }
}

/// A run that nobody kills: the time that it takes, seconds.
fn uninterrupted() -> f64 {
    let bench = Bench::new(1, Faults::default());
    let summary = bench.lives(f64::INFINITY).unwrap();
    assert_eq!(summary.status, Status::Ok, "{:?}", summary.error);
    Judge::new(&part(LEGS.0, LEGS.1)).holds(&bench.world.borrow().fake, "uninterrupted");
    let world = bench.world.borrow();
    world.now_s
}

/// Kills hosts of one run until it is over; tells how many were killed, how many took it up, and how much was made again, mm.
fn survives(seed: u64, takes_s: f64, judge: &Judge) -> (u32, u32, f64) {
    let mut dice = Dice(seed);
    let share = if seed.is_multiple_of(2) { 0.01 } else { 0.0 };
    let bench = Bench::new(seed, Faults::all(share / 6.0));
    let (mut killed, mut taken_up) = (0, 0);
    loop {
        let after_s = if killed < KILLS_A_RUN { dice.share() * takes_s } else { f64::INFINITY };
        let before = bench.counts();
        let summary = bench.lives(after_s);
        taken_up += u32::from(killed > 0 && bench.counts() != before);
        let Some(summary) = summary else {
            killed += 1;
            bench.rests(dice.share() * 1.5, seed);
            continue;
        };
        assert_eq!(summary.status, Status::Ok, "seed {seed}: {:?}", summary.error);
        break;
    }
    let world = bench.world.borrow();
    let again_mm = judge.holds(&world.fake, &format!("seed {seed}"));
    (killed, taken_up, again_mm)
}

#[test]
fn a_run_whose_host_is_killed_is_taken_up_and_its_board_cuts_the_same() {
    let number = |name: &str, usual: u64| {
        std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(usual)
    };
    let (first, kills) = (number("KERF_SEED", 1), number("KERF_KILLS", 12));
    let (takes_s, judge) = (uninterrupted(), Judge::new(&part(LEGS.0, LEGS.1)));
    let (mut killed, mut taken_up, mut again_mm) = (0, 0, 0.0_f64);
    for seed in first.. {
        let (more, up, again) = survives(seed, takes_s, &judge);
        (killed, taken_up, again_mm) = (killed + more, taken_up + up, again_mm.max(again));
        if u64::from(killed) >= kills {
            break;
        }
    }
    eprintln!(
        "{killed} hosts killed, {taken_up} runs taken up in the middle, {again_mm:.1} mm made again at most; \
         a run takes {takes_s:.1} s"
    );
}
