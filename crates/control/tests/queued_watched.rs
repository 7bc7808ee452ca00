//! Inputs that are watched on a board with step queues, in simulated time: probing, and what the operator asks for
//! meanwhile.

use crate::queued::{Shop, World};
use crate::queued_homing::machine;
use kerf_control::{OperatorRequest, Requests, RunContext, Script, Session};
use kerf_driver_klipper::fake::Faults;
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::{Driven, Machine};
use kerf_program::Axis;
use kerf_trace::{Event, Sink, Summary};
use kerf_workspace::Workspace;
use std::cell::RefCell;
use std::rc::Rc;

/// Notes what was told.
#[derive(Default)]
struct Notes(Vec<String>);

impl Sink for Notes {
    fn event(&mut self, event: &Event) {
        self.0.push(serde_json::to_string(event).unwrap());
    }
}

/// A run that is over.
struct Probed {
    summary: Summary,
    session: Session,
    world: Rc<RefCell<World>>,
    told: Vec<String>,
}

impl Probed {
    /// Counts of the motors X, Y, Z, W.
    fn counts(&self) -> Vec<i64> {
        self.world.borrow().fake.steppers.values().map(|it| it.position).collect()
    }

    /// Times of the steps of X, seconds.
    fn steps_s(&self) -> Vec<f64> {
        let world = self.world.borrow();
        world.fake.steppers[&0].made.iter().map(|(clock, _)| world.fake.time_at(*clock)).collect()
    }

    fn has_told(&self, what: &str) -> bool {
        self.told.iter().any(|event| event.contains(what))
    }
}

/// Runs lines on a board whose pin 13, input 1, closes at a count of a motor, with somebody who asks for something
/// meanwhile.
fn probes(
    lines: &str,
    (motor, count): (u8, i64),
    faults: Faults,
    requests: &mut dyn Requests,
) -> Probed {
    let shop = Shop::of(&machine(), 8, faults, |fake| {
        fake.stops_at = vec![(10, 0, -9999), (11, 1, -9999), (12, 3, -9999), (13, motor, count)];
    });
    let world = shop.world.clone();
    let mut session = Session::default();
    session.hold(machine());
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let program = kerf_sbp::read("part.sbp".into(), lines.as_bytes());
    let mut notes = Notes::default();
    let queued = Rc::new(RefCell::new(shop.queued));
    let driven: Driven = queued.clone();
    let context =
        RunContext { sink: &mut notes, operator: &mut (), requests, machine: driven.into() };
    let summary = session.run(program, RunOptions::default(), &mut workspace, context);
    assert_eq!(queued.borrow().fault(), None);
    queued.borrow_mut().close(true, || false);
    Probed { summary, session, world, told: notes.0 }
}

#[test]
fn a_probe_stops_the_machine_in_the_board_and_the_place_is_that_of_the_edge() {
    for (share, steps) in [(0.0, 1234), (0.01, 1100), (0.01, 777)] {
        let lines = "VS,30,30\nON INPUT(1,1) GOTO touched\nM3,20,10,0\nEND\ntouched:\nJZ,1\n";
        let probed = probes(lines, (0, steps), Faults::all(share / 4.0), &mut ());
        let counts = probed.counts();
        let x_mm = probed.session.memory.position[Axis::X];
        let off = counts[0] - steps;
        assert!((0..=2).contains(&off), "{off} steps behind the edge, {:?}", probed.summary.error);
        assert!((x_mm - counts[0] as f64 / 100.0).abs() < 0.006, "{x_mm} {counts:?}");
        assert_eq!(counts[2], 200, "the program went on from there");
    }
}

#[test]
fn the_plate_of_z_zero_is_found_by_the_board() {
    let lines = "VL,0,96,0,48,-60,50\nC2\n";
    let probed = probes(lines, (2, -2500), Faults::default(), &mut ());
    let (Probed { summary, session, .. }, counts) = (&probed, probed.counts());
    assert!(summary.error.is_none(), "{:?}", summary.error);
    let (z_mm, zero_mm) =
        (session.memory.position[Axis::Z], session.memory.frame.working_zero[Axis::Z]);
    assert!((z_mm - counts[2] as f64 / 200.0).abs() < 0.003, "{z_mm} {counts:?}");
    // The plate is an eighth of an inch thick.
    assert!((zero_mm - (-12.5 - 3.175)).abs() < 0.01, "{zero_mm}");
}

/// A way of X and Y at 30 mm/s while input 1 is watched, and one more behind a stand.
const WATCHED: &str =
    "VS,30,30\nON INPUT(1,1) GOTO touched\nM3,40,20,0\nPAUSE 0.1\nMX,60\nEND\ntouched:\nJZ,1\n";

#[test]
fn a_hold_while_an_input_is_watched_slows_down_along_the_ramp_and_goes_on() {
    for (share, at_s) in [(0.0, 0.6), (0.0, 0.7), (0.01, 0.6), (0.01, 0.8)] {
        let mut script = Script::new(vec![(at_s, OperatorRequest::Hold)], vec![0.0]);
        let probed = probes(WATCHED, (0, 99_999), Faults::all(share / 4.0), &mut script);
        assert!(probed.summary.error.is_none(), "{:?}", probed.summary.error);
        assert!(probed.has_told("\"hold\""), "{:?}", probed.told);
        let steps_s = probed.steps_s();
        let gaps_s: Vec<f64> = steps_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let stand = (0..3_900).max_by(|a, b| gaps_s[*a].total_cmp(&gaps_s[*b])).unwrap();
        let (cruise_s, last_s) = (gaps_s[stand - 600], gaps_s[stand - 1]);
        assert!(last_s > 2.0 * cruise_s, "{share} {at_s}: {cruise_s} {last_s} at {stand}");
        let place = probed.session.memory.position;
        assert_eq!((place[Axis::X], place[Axis::Y]), (60.0, 20.0));
        assert_eq!(probed.counts()[..2], [6000, 2000]);
    }
}

#[test]
fn another_feed_while_an_input_is_watched_comes_at_the_next_stand_and_is_told_then() {
    let asks = || Script::new(vec![(0.6, OperatorRequest::Feed(0.5))], vec![]);
    let probed = probes(WATCHED, (0, 99_999), Faults::default(), &mut asks());
    assert!(probed.summary.error.is_none(), "{:?}", probed.summary.error);
    let steps_s = probed.steps_s();
    let pace = |n: usize| (steps_s[n + 200] - steps_s[n]) / 200.0;
    let cruise = 1.0 / (100.0 * 30.0 * 2.0 / 5_f64.sqrt());
    assert!((pace(3_000) / cruise - 1.0).abs() < 0.01, "{} {cruise}", pace(3_000));
    assert!((pace(4_900) * 100.0 * 15.0 - 1.0).abs() < 0.01, "{}", pace(4_900));
    let place = |what: &str| probed.told.iter().position(|event| event.contains(what)).unwrap();
    assert!(place("\"move\"") < place("\"override\""), "{:?}", probed.told);
    assert!(probed.has_told("while an input is watched"), "{:?}", probed.told);
}

#[test]
fn an_input_that_changes_while_a_hold_slows_down_stops_it_and_is_heeded_when_it_goes_on() {
    for (share, count) in [(0.0, 2_300), (0.01, 2_250)] {
        let mut script = Script::new(vec![(0.6, OperatorRequest::Hold)], vec![0.0]);
        let probed = probes(WATCHED, (0, count), Faults::all(share / 4.0), &mut script);
        assert!(probed.summary.error.is_none(), "{:?}", probed.summary.error);
        assert!(probed.has_told("\"hold\""), "{:?}", probed.told);
        let counts = probed.counts();
        assert!((0..=2).contains(&(counts[0] - count)) && counts[2] == 200, "{counts:?}");
        let x_mm = probed.session.memory.position[Axis::X];
        assert!((x_mm - counts[0] as f64 / 100.0).abs() < 0.006, "{x_mm} {counts:?}");
    }
}
