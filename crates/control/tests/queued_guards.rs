//! Limits, doors and emergency stops on a board with step queues, in simulated time: the board ends motion by itself, and
//! the run can be taken up.

use crate::queued::{Shop, World, machine_of};
use crate::taking_up::on_record;
use kerf_control::{OperatorRequest, Requests, RunContext, Session};
use kerf_driver_klipper::fake::Faults;
use kerf_files::{Folders, MemoryDisk};
use kerf_journal::{Journal, RunOptions};
use kerf_machine::{Configuration, Driven, Machine as _};
use kerf_program::{Axes, Axis};
use kerf_sbp::Status;
use kerf_trace::{Event, Summary};
use kerf_workspace::{Workspace, stored::Stored};
use std::cell::RefCell;
use std::rc::Rc;
use tempfile::{TempDir, tempdir};

/// Input 1 is a limit, input 2 one that opens, input 3 the door, 4 the stop, 19 the emergency stop; pins 13 to 17.
const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n\
    [limits]\nlow = [0, 0, -50, 0, 0, 0]\nhigh = [900, 900, 50, 0, 0, 0]\n\
    [io]\ninputs = [1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\ninterlock = 3\n\
    [board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\n\
    inputs = \"1 gpio13, 2 gpio14, 3 gpio15, 4 gpio16, 19 gpio17\"\nenable = \"gpio19\"\n\
    outputs = \"1 gpio20\"\nboth_edges = true\npulse_us = 0.1";

/// A way of many short moves, then a long one.
const PART: &str =
    "SO,1,1\nVS,50,20\nMX,20\nMX,21\nMX,22\nMX,23\nMX,24\nMX,25\nMX,26\nMX,90\nMY,30\nSO,1,0\n";

fn machine() -> Configuration {
    machine_of(FILE)
}

fn workspace(journal: &Journal, folder: &TempDir) -> Workspace {
    let disk = MemoryDisk::new([("a.sbp", PART.as_bytes())]);
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    Workspace::new(
        Box::new(disk),
        folders,
        Stored::of(journal.clone()).unwrap(),
        folder.path().into(),
    )
}

/// The host stalls from a count of X on, so that it has no part in what happens then.
struct Stalls {
    world: Rc<RefCell<World>>,
    at: Option<i64>,
}

impl Requests for Stalls {
    fn take(&mut self, _: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        let world = &mut *self.world.borrow_mut();
        if self.at.is_some_and(|at| world.fake.steppers[&0].position >= at) {
            (world.stalls_until_s, self.at) = (world.now_s + 0.05, None);
        }
        None
    }
}

/// A run that an input ended.
struct Ended {
    folder: TempDir,
    summary: Summary,
    /// Steps of X behind the edge, and the place that the run learned.
    behind: i64,
    place: Axes,
    /// Time from the last step to the moment at which output 1 was off, seconds.
    off_s: f64,
    enabled: bool,
}

/// Runs the part file on a board whose pin closes at a count of X.
fn ended(pin: u32, count: i64, share: f64, stalls: bool) -> Ended {
    let folder = tempdir().unwrap();
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let shop = Shop::of(&machine(), 3, Faults::all(share / 4.0), |fake| {
        fake.stops_at = vec![(pin, 0, count)];
    });
    let world = shop.world.clone();
    let mut session = Session::default();
    session.hold(machine());
    let mut workspace = workspace(&journal, &folder);
    let program = kerf_part::read("a.sbp".into(), PART.as_bytes());
    let queued = Rc::new(RefCell::new(shop.queued));
    let driven: Driven = queued.clone();
    let mut requests = Stalls { world: world.clone(), at: stalls.then_some(count - 60) };
    let context = RunContext {
        sink: &mut (),
        operator: &mut (),
        requests: &mut requests,
        machine: driven.into(),
    };
    let options = RunOptions::default();
    let summary = session.run_on_record(program, options, None, &mut workspace, context).unwrap();
    queued.borrow_mut().close(false, || false);
    (0..200).for_each(|_| world.borrow_mut().pass());
    let world = world.borrow();
    assert_eq!(world.fake.reason(), None, "the board has not shut down");
    let x = &world.fake.steppers[&0];
    let last_s = x.made.last().map_or(0.0, |(clock, _)| world.fake.time_at(*clock));
    let output = |pin| world.fake.outputs.values().find(|it| it.pin == pin).unwrap();
    let (off, value) = *output(20).made.last().unwrap();
    assert_eq!(value, 0, "output 1 is off");
    Ended {
        behind: x.position - count,
        place: session.memory.position,
        off_s: world.fake.time_at(off) - last_s,
        enabled: output(19).value == 1,
        summary,
        folder,
    }
}

#[test]
fn each_of_them_ends_motion_in_the_board_and_the_run_says_which() {
    let kinds = [
        (13, "limit input 1"),
        (14, "limit input 2"),
        (15, "stop input 3"),
        (16, "stop input 4"),
        (17, "stop input 19"),
    ];
    for (pin, words) in kinds {
        for (count, share) in [(2_350, 0.0), (2_350, 0.01), (5_000, 0.01)] {
            let ended = ended(pin, count, share, false);
            let why = ended.summary.error.as_ref().map(|it| it.message.clone()).unwrap_or_default();
            assert_eq!(ended.summary.status, Status::Stopped, "{pin}, {share}: {why}");
            assert!(why.contains(words), "{pin}, {share}: {why}");
            assert!((0..=2).contains(&ended.behind), "{pin}, {share}: {} steps", ended.behind);
            let off_mm = ended.place[Axis::X] - (count + ended.behind) as f64 / 100.0;
            assert!(off_mm.abs() < 1e-9, "{off_mm}");
            assert!(ended.off_s < if share > 0.0 { 0.3 } else { 0.06 }, "{share}: {}", ended.off_s);
            assert!(ended.enabled, "motors keep their current, and so their place");
        }
    }
}

#[test]
fn motors_stop_also_while_the_computer_does_nothing() {
    let ended = ended(16, 5_000, 0.0, true);
    assert!((0..=2).contains(&ended.behind), "{} steps", ended.behind);
    assert!(ended.off_s > 0.01, "the computer stalled: {}", ended.off_s);
}

#[test]
fn the_run_is_taken_up_where_the_input_ended_it() {
    // Among short moves the run had told of several more.
    for (count, share) in [(2_350, 0.0), (2_120, 0.01), (5_000, 0.01)] {
        let Ended { folder, behind, .. } = ended(16, count, share, false);
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let cut = journal.runs.cut_short().unwrap().expect("a run to take up");
        let mut workspace = workspace(&journal, &folder);
        let (mut session, _) = Session::recall(&journal, &mut workspace).unwrap();
        let mut events: Vec<Event> = Vec::new();
        let mut operator = kerf_control::answers::Answers::read("");
        let context = RunContext {
            sink: &mut events,
            operator: &mut operator,
            requests: &mut (),
            machine: on_record(),
        };
        let summary = session.resume(&cut, &mut workspace, context).unwrap();
        assert_eq!(summary.status, Status::Ok, "{:?}", summary.error);
        let first = crate::taking_up::behind(&events).iter().find_map(crate::taking_up::motion);
        let from_mm = first.unwrap().from.x;
        let again_mm = (count + behind) as f64 / 100.0 - from_mm;
        assert!((0.0..1.1).contains(&again_mm), "{count}: {again_mm} mm are made again");
    }
}

#[test]
fn an_input_that_is_active_when_the_board_is_connected_is_known_at_once() {
    let mut shop = Shop::of(&machine(), 1, Faults::default(), |fake| {
        fake.driven.insert(16, vec![(0, true)]);
    });
    assert_eq!(shop.queued.take_inputs(), [(4, true)]);
    assert!(shop.queued.fault().is_none());
}
