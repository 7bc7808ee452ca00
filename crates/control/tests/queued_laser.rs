//! A laser on a board with step queues, in simulated time: its power is that of the speed, also where the machine slows
//! down for a stop, an input or a late host.

use crate::queued::{Shop, World, machine_of};
use kerf_control::{OperatorRequest, Requests, RunContext, Session};
use kerf_driver_klipper::fake::Faults;
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::{Driven, Machine};
use kerf_trace::{Event, Sink};
use kerf_workspace::Workspace;
use std::cell::RefCell;
use std::rc::Rc;

/// S1000 is full power.
const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n\
    [board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\nspindle = \"gpio21\"\n\
    spindle_rpm = 1000\nspindle_hz = 5000\ninputs = \"1 gpio13\"\nboth_edges = true\npulse_us = 0.1";

/// Steps a second of X at the speed that is asked for.
const ASKED: f64 = 5_000.0;
/// Share of power at that speed.
const POWER: f64 = 0.8;

const LINES: &str = "G21 G90\nM4 S800\nG1 X40 F3000\nG0 X50\nG1 X80\nM5\nG0 X0\n";

struct Quiet;

impl Sink for Quiet {
    fn event(&mut self, _: &Event) {}
}

fn burns(lines: &str, faults: Faults, requests: &mut dyn Requests) -> Rc<RefCell<World>> {
    let shop = Shop::of(&machine_of(FILE), 4, faults, |_| {});
    let world = shop.world.clone();
    assert_eq!(burns_on(shop, lines, requests), None);
    world
}

/// Burns lines on a machine; returns its fault.
fn burns_on(shop: Shop, lines: &str, requests: &mut dyn Requests) -> Option<String> {
    let mut session = Session::default();
    session.hold(machine_of(FILE));
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let program = kerf_part::read("part.nc".into(), lines.as_bytes());
    let queued = Rc::new(RefCell::new(shop.queued));
    let driven: Driven = queued.clone();
    let context =
        RunContext { sink: &mut Quiet, operator: &mut (), requests, machine: driven.into() };
    let mut options = RunOptions::default();
    options.gcode.laser = true;
    let summary = session.run(program, options, &mut workspace, context);
    let fault = queued.borrow().fault().map(|fault| fault.message.clone());
    assert_eq!(summary.error.is_none(), fault.is_none(), "{:?}", summary.error);
    queued.borrow_mut().close(true, || false);
    fault
}

/// Time and share of each change of the laser.
fn shares(world: &World) -> Vec<(f64, f64)> {
    let laser = world.fake.outputs.values().next().unwrap();
    let share = |(at, value): &(u64, u32)| (world.fake.time_at(*at), f64::from(*value) / 255.0);
    laser.made.iter().map(share).collect()
}

/// Times of the steps of X.
fn steps_s(world: &World) -> Vec<f64> {
    world.fake.steppers[&0].made.iter().map(|(at, _)| world.fake.time_at(*at)).collect()
}

/// The power at each moment of motion is that of the speed, and there is none where the machine stands.
fn check(world: &World) -> usize {
    let (shares, steps_s) = (shares(world), steps_s(world));
    let share_at = |t_s: f64| {
        let n = shares.partition_point(|(at_s, _)| *at_s <= t_s);
        if n == 0 { 0.0 } else { shares[n - 1].1 }
    };
    let mut looked = 0;
    for pair in steps_s.windows(2) {
        let (gap_s, middle_s) = (pair[1] - pair[0], 0.5 * (pair[0] + pair[1]));
        if gap_s > 0.05 {
            assert_eq!(share_at(pair[0] + 0.03), 0.0, "it stands at {middle_s}");
            continue;
        }
        let (pace, share) = (1.0 / gap_s / ASKED, share_at(middle_s) / POWER);
        if share > 0.0 && share_at(middle_s - 0.002) > 0.0 && pace > 0.1 {
            // Slices of 1 ms at 1,000 mm/s² or less, and levels of 1/127.
            assert!((share - pace).abs() < 0.06, "at {middle_s}: share {share}, pace {pace}");
            looked += 1;
        }
    }
    assert_eq!(shares.last().unwrap().1, 0.0);
    looked
}

#[test]
fn the_power_of_a_laser_follows_the_speed_along_every_ramp() {
    for share in [0.0, 0.01] {
        let world = burns(LINES, Faults::all(share / 4.0), &mut ());
        let world = world.borrow();
        assert_eq!(check(&world).clamp(5_000, 7_000), check(&world), "cuts of 40 and 30 mm");
        let jog = steps_s(&world);
        let (from_s, to_s) = (jog[4_100], jog[4_900]);
        let lit =
            shares(&world).iter().any(|(t_s, share)| (from_s..to_s).contains(t_s) && *share > 0.0);
        assert!(!lit, "a jog does not burn");
    }
}

/// Holds the machine from a moment on, as somebody does who sees it there, and resumes at once.
struct Holds(Option<f64>);

impl Requests for Holds {
    fn take(&mut self, from_s: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        self.0.take_if(|at_s| *at_s <= from_s).map(|_| (from_s, OperatorRequest::Hold))
    }

    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        Some(held_s)
    }
}

#[test]
fn a_hold_takes_the_power_down_with_the_speed() {
    for at_s in [0.21, 0.37, 0.5, 0.583, 0.611] {
        let world = burns(LINES, Faults::default(), &mut Holds(Some(at_s)));
        let world = world.borrow();
        assert!(check(&world) > 5_000);
        let stands = steps_s(&world).windows(2).filter(|pair| pair[1] - pair[0] > 0.05).count();
        assert!(stands >= 2, "{stands}");
    }
}

/// The run does nothing for a time, while the link goes on.
struct Stalls(Rc<RefCell<World>>, bool);

impl Requests for Stalls {
    fn take(&mut self, from_s: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        if from_s > 0.5 && !std::mem::replace(&mut self.1, true) {
            (0..400).for_each(|_| self.0.borrow_mut().pass());
            let world = self.0.borrow();
            let (shares, steps_s) = (shares(&world), steps_s(&world));
            let ((off_s, share), stood_s) = (*shares.last().unwrap(), *steps_s.last().unwrap());
            assert!(world.now_s > stood_s + 0.05, "it has slowed down by itself");
            assert!(share == 0.0 && off_s < stood_s + 0.005, "{off_s} {share} {stood_s}");
            assert!(check(&world) > 1_000);
        }
        None
    }
}

#[test]
fn a_machine_that_slows_down_because_its_host_is_late_burns_nothing_where_it_stands() {
    let shop = Shop::of(&machine_of(FILE), 4, Faults::default(), |_| {});
    let mut stalls = Stalls(shop.world.clone(), false);
    let fault = burns_on(shop, LINES, &mut stalls);
    assert!(stalls.1 && fault.is_some_and(|why| why.contains("was late")), "{}", stalls.1);
}
