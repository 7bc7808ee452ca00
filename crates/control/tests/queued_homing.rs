//! Homing and probing on a board with step queues, in time that is none.

use crate::queued::{Shop, machine_of};
use kerf_control::answers::Operator;
use kerf_control::{OperatorRequest, Requests, RunContext, Script, Session};
use kerf_driver_klipper::fake::Faults;
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::{Configuration, Driven, Machine};
use kerf_program::{Axes, Axis};
use kerf_trace::{Event, Sink, Summary};
use kerf_workspace::Workspace;
use std::cell::RefCell;
use std::rc::Rc;

/// Two motors turn Y, each with a switch. The edge is found at 20 mm/s.
const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n[motors]\ny2 = \"w\"\n\
    [homing]\nx = { fitted = true, end = \"low\", fast = 50, slow = 20, off = 3 }\n\
    y = { fitted = true, end = \"low\", fast = 50, slow = 20, off = 3 }\n\
    [axis]\nlength = [100, 100, 50, 0, 0, 0]\n\
    [board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\nw = \"gpio6 gpio7\"\n\
    home_x = \"gpio10\"\nhome_y = \"gpio11\"\nhome_y2 = \"gpio12\"\ninputs = \"1 gpio13, 4 gpio14\"\n\
    outputs = \"1 gpio20\"\nboth_edges = true\npulse_us = 0.1";

/// Counts at which the switches of X and of both motors of Y close.
const SWITCHES: [i64; 3] = [-731, -402, -455];

fn machine() -> Configuration {
    machine_of(FILE)
}

fn shop(seed: u64, faults: Faults) -> Shop {
    Shop::of(&machine(), seed, faults, |fake| {
        let [x, y, y2] = SWITCHES;
        fake.stops_at = vec![(10, 0, x), (11, 1, y), (12, 3, y2)];
    })
}

/// Counts of the motors X, Y, Z, W.
fn counts(shop: &Shop) -> Vec<i64> {
    shop.world.borrow().fake.steppers.values().map(|it| it.position).collect()
}

fn homes(shop: &mut Shop) -> Option<Axes> {
    shop.queued.home();
    while shop.queued.settle() {}
    assert_eq!(shop.queued.fault(), None);
    shop.queued.place()
}

#[test]
fn two_motors_of_an_axis_are_squared_and_home_is_the_same_step_again() {
    let mut farthest = 0;
    for (seed, share) in [(1, 0.0), (2, 0.0), (3, 0.01), (4, 0.01)] {
        let mut shop = shop(seed, Faults::all(share / 4.0));
        for _ in 0..3 {
            assert_eq!(homes(&mut shop), Some(Axes::default()));
            let found = counts(&shop);
            for (motor, switch) in [0, 1, 3].into_iter().zip(SWITCHES) {
                let off = found[motor] - (switch + 300);
                farthest = farthest.max(off.abs());
                assert!(off.abs() <= 1, "motor {motor}, seed {seed}: {off}");
            }
        }
    }
    eprintln!("home found at 20 mm/s, farthest from its step: {farthest}");
}

#[test]
fn a_switch_that_does_not_come_is_told_and_a_stop_stops_homing() {
    let mut shop = shop(5, Faults::default());
    shop.world.borrow_mut().fake.stops_at[0].2 = -100_000;
    shop.queued.home();
    while shop.queued.settle() {}
    let fault = shop.queued.fault().unwrap().clone();
    assert!(fault.message.contains("x home not found"), "{fault:?}");

    let mut shop = self::shop(6, Faults::default());
    shop.queued.home();
    while counts(&shop)[0] > -300 {
        assert!(shop.queued.settle());
    }
    shop.queued.halt();
    let stood = counts(&shop);
    assert!(!shop.queued.settle() && counts(&shop) == stood && stood[0] > -731, "{stood:?}");
    assert_eq!(shop.queued.place().unwrap()[Axis::X], stood[0] as f64 / 100.0);
}

#[test]
fn a_stop_input_stops_homing() {
    let mut shop = shop(7, Faults::default());
    // The board looks at its inputs from half a second on.
    (0..600).for_each(|_| shop.world.borrow_mut().pass());
    shop.queued.home();
    while counts(&shop)[0] > -300 {
        assert!(shop.queued.settle());
    }
    let now = shop.world.borrow().fake.now;
    shop.world.borrow_mut().fake.driven.insert(14, vec![(now, true)]);
    while shop.queued.settle() {}
    assert!(shop.queued.fault().unwrap().message.contains("input 4"), "{:?}", shop.queued.fault());
    assert!(counts(&shop)[0] > -400, "{:?}", counts(&shop));
}

/// Notes where motion ended.
#[derive(Default)]
struct Notes(Vec<Event>);

impl Sink for Notes {
    fn event(&mut self, event: &Event) {
        self.0.push(event.clone());
    }
}

/// Runs lines on a board whose pin 13, input 1, closes at a count of a motor.
fn probes(lines: &str, at: (u8, i64), faults: Faults) -> (Summary, Session, Vec<i64>) {
    probes_asked(lines, at, faults, &mut ())
}

/// The same with somebody who asks for something meanwhile.
fn probes_asked(
    lines: &str,
    (motor, count): (u8, i64),
    faults: Faults,
    requests: &mut dyn Requests,
) -> (Summary, Session, Vec<i64>) {
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
    let operator: &mut dyn Operator = &mut ();
    let driven: Driven = queued.clone();
    let context = RunContext { sink: &mut notes, operator, requests, machine: driven.into() };
    let summary = session.run(program, RunOptions::default(), &mut workspace, context);
    assert_eq!(queued.borrow().fault(), None);
    queued.borrow_mut().close(true, || false);
    let counts = world.borrow().fake.steppers.values().map(|it| it.position).collect();
    (summary, session, counts)
}

#[test]
fn a_probe_stops_the_machine_in_the_board_and_the_place_is_that_of_the_edge() {
    for (share, steps) in [(0.0, 1234), (0.01, 1100), (0.01, 777)] {
        let lines = "VS,30,30\nON INPUT(1,1) GOTO touched\nM3,20,10,0\nEND\ntouched:\nJZ,1\n";
        let (summary, session, counts) = probes(lines, (0, steps), Faults::all(share / 4.0));
        let x_mm = session.memory.position[Axis::X];
        let off = counts[0] - steps;
        assert!((0..=2).contains(&off), "{off} steps behind the edge, {:?}", summary.error);
        assert!((x_mm - counts[0] as f64 / 100.0).abs() < 0.006, "{x_mm} {counts:?}");
        assert_eq!(counts[2], 200, "the program went on from there");
    }
}

#[test]
fn the_plate_of_z_zero_is_found_by_the_board() {
    let lines = "VL,0,96,0,48,-60,50\nC2\n";
    let (summary, session, counts) = probes(lines, (2, -2500), Faults::default());
    assert!(summary.error.is_none(), "{:?}", summary.error);
    let (z_mm, zero_mm) =
        (session.memory.position[Axis::Z], session.memory.frame.working_zero[Axis::Z]);
    assert!((z_mm - counts[2] as f64 / 200.0).abs() < 0.003, "{z_mm} {counts:?}");
    // The plate is an eighth of an inch thick.
    assert!((zero_mm - (-12.5 - 3.175)).abs() < 0.01, "{zero_mm}");
}

#[test]
fn a_hold_while_an_input_is_watched_stands_where_the_counts_say_and_goes_on() {
    let lines = "VS,30,30\nON INPUT(1,1) GOTO touched\nM3,40,20,0\nEND\ntouched:\nJZ,1\n";
    let script = Script::new(vec![(0.6, OperatorRequest::Hold)], vec![0.0]);
    let (summary, session, counts) =
        probes_asked(lines, (0, 99_999), Faults::default(), &mut { script });
    assert!(summary.error.is_none(), "{:?}", summary.error);
    assert_eq!((session.memory.position[Axis::X], counts[0], counts[1]), (40.0, 4000, 2000));
}
