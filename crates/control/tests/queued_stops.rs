//! Stops, holds and other feeds of a machine with step queues, in simulated time: how soon they come.

use crate::queued::{Ran, Shop, World, machine_of, ran};
use kerf_control::{OperatorRequest, Requests, RunContext, Session};
use kerf_driver_klipper::fake::Faults;
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::{Configuration, Driven, Machine};
use kerf_program::{Axes, Axis};
use kerf_sbp::Status;
use kerf_trace::{Event, Sink};
use kerf_workspace::Workspace;
use std::cell::RefCell;
use std::rc::Rc;

const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n\
    [limits]\nlow = [0, 0, -50, 0, 0, 0]\nhigh = [900, 900, 50, 0, 0, 0]\n\
    [board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\n\
    outputs = \"1 gpio20\"\nboth_edges = true\npulse_us = 0.1";

fn machine() -> Configuration {
    machine_of(FILE)
}

/// Asks for something once the motor of X has made so many steps.
struct Asks {
    world: Rc<RefCell<World>>,
    steps: i64,
    request: Option<OperatorRequest>,
    /// The moment of that, by the clock of the world.
    asked_s: Option<f64>,
}

impl Requests for Asks {
    fn take(&mut self, from_s: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        let world = self.world.borrow();
        if world.fake.steppers[&0].position < self.steps {
            return None;
        }
        let request = self.request.take()?;
        self.asked_s = Some(world.now_s);
        Some((from_s, request))
    }

    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        Some(held_s)
    }
}

#[derive(Default)]
struct Quiet;

impl Sink for Quiet {
    fn event(&mut self, _: &Event) {}
}

/// Notes what the operator is told.
#[derive(Default)]
struct Told(Vec<String>);

impl Sink for Told {
    fn event(&mut self, event: &Event) {
        if let Event::Message { text, .. } = event {
            self.0.push(text.to_string());
        }
    }
}

/// Runs lines, asks for something on the way; returns the moment of that, the steps of X by the clock of the world, and the place.
fn asked(
    lines: &str,
    request: OperatorRequest,
    (seed, faults): (u64, Faults),
) -> (f64, Vec<f64>, Axes) {
    let shop = Shop::of(&machine(), seed, faults, |_| {});
    let world = shop.world.clone();
    let steps = 2_000 + 137 * seed as i64;
    let mut asks = Asks { world: world.clone(), steps, request: Some(request), asked_s: None };
    let Ran { summary, session, queued } =
        ran(shop.queued, machine(), lines, &mut Quiet, &mut asks);
    assert_eq!(queued.borrow().fault(), None, "{:?}", summary.error);
    assert!(matches!(summary.status, Status::Ok | Status::Ended), "{:?}", summary.error);
    queued.borrow_mut().close(true, || false);
    let world = world.borrow();
    let made = world.fake.steppers[&0].made.iter().map(|(clock, _)| world.fake.time_at(*clock));
    let place = session.memory.position;
    assert_eq!(world.fake.steppers[&0].position, (place[Axis::X] * 100.0).round() as i64);
    (asks.asked_s.unwrap(), made.collect(), place)
}

/// The time from a request to the first step that comes later, or sooner, than at the speed before, seconds.
fn answered_s(asked_s: f64, made: &[f64]) -> f64 {
    let before = made.iter().rposition(|t_s| *t_s <= asked_s).unwrap();
    let cruise_s = made[before] - made[before - 1];
    let is_other = |pair: &&[f64]| ((pair[1] - pair[0]) / cruise_s - 1.0).abs() > 0.03;
    made[before..].windows(2).find(is_other).map_or(f64::INFINITY, |pair| pair[0] - asked_s)
}

fn one_percent() -> Faults {
    Faults::all(0.0025)
}

const LINES: &str = "VS,50,20\nMX,120\nMY,30\n";

fn longest(request: OperatorRequest, faults: Faults, seeds: u64) -> f64 {
    let answered = (1..=seeds).map(|seed| {
        let (asked_s, made, place) = asked(LINES, request, (seed, faults));
        if !matches!(request, OperatorRequest::End) {
            assert_eq!((place[Axis::X], place[Axis::Y]), (120.0, 30.0));
        }
        answered_s(asked_s, &made)
    });
    answered.fold(0.0, f64::max)
}

#[test]
fn a_hold_another_feed_and_a_key_that_is_released_are_answered_soon() {
    for (words, faults, seeds) in [("a good line", Faults::default(), 8), ("1 %", one_percent(), 8)]
    {
        for (what, request) in [
            ("hold", OperatorRequest::Hold),
            ("end", OperatorRequest::End),
            ("feed", OperatorRequest::Feed(0.5)),
        ] {
            let longest_s = longest(request, faults, seeds);
            eprintln!("{what}, {words}: {:.0} ms to the ramp", longest_s * 1e3);
            assert!(longest_s < 0.15, "{what}, {words}: {longest_s} s");
        }
    }
}

/// The longest time from a stop without a ramp to the last step, seconds.
fn longest_to_stand_s(faults: Faults) -> f64 {
    let stop = |n: u64| {
        let machine = machine_of(&format!(
            "{FILE}\nhome_x = \"gpio10\"\n[axis]\nlength = [900, 900, 50, 0, 0, 0]\n[homing]\n\
             x = {{ fitted = true, end = \"low\", fast = 50, slow = 5, off = 3 }}"
        ));
        let mut shop = Shop::of(&machine, n, faults, |fake| fake.stops_at = vec![(10, 0, -90_000)]);
        shop.queued.home();
        while shop.world.borrow().fake.steppers[&0].position > -2_000 - 37 * n as i64 {
            assert!(shop.queued.settle());
        }
        let stops_s = shop.world.borrow().now_s;
        shop.queued.halt();
        let world = shop.world.borrow();
        let last = world.fake.steppers[&0].made.last().map_or(0, |(clock, _)| *clock);
        let counted = shop.queued.counted()[Axis::X];
        assert_eq!((counted * 100.0).round() as i64, world.fake.steppers[&0].position);
        world.fake.time_at(last) - stops_s
    };
    (1..=40).map(stop).fold(0.0, f64::max)
}

#[test]
fn a_stop_without_a_ramp_ends_pulses_at_once() {
    let [good_s, bad_s] = [Faults::default(), one_percent()].map(longest_to_stand_s);
    eprintln!(
        "stop to the last step, longest of 40: {:.1} ms, 1 %: {:.1} ms",
        good_s * 1e3,
        bad_s * 1e3
    );
    assert!(good_s <= 0.002 && bad_s < 0.1, "{good_s} {bad_s}");
}

/// The host stalls again and again, each time for longer.
struct Stalls {
    world: Rc<RefCell<World>>,
    stall_s: f64,
    grows_s: f64,
    most_s: f64,
    next_s: f64,
}

impl Requests for Stalls {
    fn take(&mut self, _: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        let mut world = self.world.borrow_mut();
        if world.now_s >= self.next_s {
            world.stalls_until_s = world.now_s + self.stall_s;
            self.next_s = world.now_s + self.stall_s + 0.5;
            self.stall_s = (self.stall_s + self.grows_s).min(self.most_s);
        }
        None
    }
}

/// Makes a move of 9 s while the host stalls, first for so long, in the end for so long; returns `true` where it comes to
/// its end, and what the operator was told. In either case the board was late for nothing, and its counts are known.
fn bears(deadline_s: f64, first_s: f64, most_s: f64) -> (bool, Vec<String>) {
    let mut machine = machine();
    machine.board.deadline_s = deadline_s;
    let shop = Shop::of(&machine, 3, Faults::default(), |_| {});
    let world = shop.world.clone();
    let mut session = Session::default();
    session.hold(machine);
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let program = kerf_sbp::read("part.sbp".into(), b"VS,50,20\nMX,450\n");
    let queued = Rc::new(RefCell::new(shop.queued));
    let next_s = world.borrow().now_s + 1.0;
    let (world_of, stall_s) = (world.clone(), first_s);
    let mut stalls = Stalls { world: world_of, stall_s, grows_s: 0.02, most_s, next_s };
    let (operator, requests) = (&mut (), &mut stalls);
    let driven: Driven = queued.clone();
    let mut told = Told::default();
    let context = RunContext { sink: &mut told, operator, requests, machine: driven.into() };
    session.run(program, RunOptions::default(), &mut workspace, context);
    let bears = queued.borrow().fault().is_none();
    queued.borrow_mut().close(bears, || false);
    assert_eq!(world.borrow().fake.reason(), None);
    let counted = (queued.borrow().counted()[Axis::X] * 100.0).round() as i64;
    assert_eq!(counted, world.borrow().fake.steppers[&0].position);
    (bears, told.0)
}

#[test]
fn stalls_of_the_host_are_borne_and_the_lead_follows_them() {
    for (deadline_s, at_once_s, grown_s) in [(0.1, 0.06, 0.07), (0.3, 0.14, 0.22)] {
        assert!(bears(deadline_s, at_once_s, at_once_s).0, "{deadline_s} {at_once_s}");
        let (bears_it, told) = bears(deadline_s, 0.02, grown_s);
        assert!(bears_it, "{deadline_s}, growing to {grown_s}");
        let tells =
            |text: &String| text.contains("the computer stalled for") && text.contains("ms ahead");
        assert!(told.iter().any(tells), "{told:?}");
        assert!(!bears(deadline_s, deadline_s, deadline_s).0, "a host as late as this is dead");
    }
}

#[test]
fn a_host_that_stalls_for_no_time_is_told_of_no_lead() {
    let (bears_it, told) = bears(0.1, 0.0, 0.0);
    assert!(bears_it && told.is_empty(), "{told:?}");
}
