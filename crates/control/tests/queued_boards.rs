//! Two boards with step queues as one machine, in simulated time: X on one of them, Y on the other.

use crate::queued::{Far, Ran, Shop, machine_of, ran};
use kerf_driver_klipper::fake::Faults;
use kerf_machine::conformance::{CASES, Outcome};
use kerf_machine::{Configuration, Machine};
use kerf_program::Axes;
use kerf_sbp::Status;
use kerf_trace::{Event, Sink};
use std::cell::Cell;

/// X and Z on the first board, both motors of Y apart, and each switch of Y on the other one's board.
const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n[motors]\ny2 = \"w\"\n\
    [homing]\nx = { fitted = true, end = \"low\", fast = 50, slow = 20, off = 3 }\n\
    y = { fitted = true, end = \"low\", fast = 50, slow = 20, off = 3 }\n\
    [axis]\nlength = [100, 100, 50, 0, 0, 0]\n[board]\nothers = \"two /dev/two\"\n\
    x = \"gpio0 gpio1\"\ny = \"two:gpio0 two:gpio1\"\nz = \"gpio4 gpio5\"\nw = \"gpio6 gpio7\"\n\
    home_x = \"two:gpio10\"\nhome_y = \"gpio11\"\nhome_y2 = \"two:gpio12\"\ninputs = \"3 gpio22, 4 two:gpio22\"\n\
    outputs = \"1 two:gpio20\"\nspindle = \"two:gpio21\"\nboth_edges = true\npulse_us = 0.1";

fn machine() -> Configuration {
    machine_of(FILE)
}

/// Switches of X, Y and the second motor of Y: board and pin, board and motor, the count below which it closes.
const SWITCHES: [Far; 3] =
    [((1, 10), (0, 0), -731), ((0, 11), (1, 0), -402), ((1, 12), (0, 2), -455)];

/// Boards whose crystals are 100 ppm apart.
fn shop(seed: u64, faults: Faults) -> Shop {
    let drift = Cell::new(50e-6);
    Shop::of(&machine(), seed, faults, |fake| fake.drift = drift.replace(-50e-6))
}

struct Quiet;

impl Sink for Quiet {
    fn event(&mut self, _: &Event) {}
}

#[test]
fn two_boards_hold_what_every_machine_has_to_hold() {
    for share in [0.0, 0.01, 0.05, 0.3] {
        for seed in 0..3 {
            for case in CASES {
                let told = case.run(&mut shop(seed, Faults::all(share / 6.0)));
                assert!(told.is_ok(), "{}, seed {seed}, {share}: {told:?}", case.name);
                let held = share > 0.0 || told == Ok(Outcome::Held);
                assert!(held, "{}, seed {seed}: {told:?}", case.name);
            }
        }
    }
}

#[test]
fn a_diagonal_is_made_by_both_boards_at_the_same_moments() {
    for share in [0.0, 0.01] {
        let shop = shop(20, Faults::all(share / 6.0));
        let world = shop.world.clone();
        let Ran { summary, session, queued } = ran(
            shop.queued,
            machine(),
            "VS,50,20\nM2,40,40\nM2,0,0\nM2,25,50\n",
            &mut Quiet,
            &mut (),
        );
        assert_eq!(queued.borrow().fault(), None, "{:?}", summary.error);
        assert!(matches!(summary.status, Status::Ok | Status::Ended));
        queued.borrow_mut().close(true, || false);
        assert_eq!(session.memory.position.0[..2], [25.0, 50.0]);
        let world = world.borrow();
        let moments = |board: usize| -> Vec<f64> {
            let fake = &world.wired[board].fake;
            fake.steppers[&0].made.iter().map(|(clock, _)| fake.time_at(*clock)).collect()
        };
        let [x, y] = [moments(0), moments(1)];
        assert_eq!((x.len(), y.len()), (10_500, 13_000));
        let pairs = x.iter().zip(&y).take(8_000);
        let apart_s = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        eprintln!("a diagonal on two boards, {share}: steps {:.1} µs apart", apart_s * 1e6);
        assert!(apart_s < 10e-6, "{} µs", apart_s * 1e6);
    }
}

#[test]
fn axes_are_homed_by_switches_of_either_board() {
    for (seed, share) in [(1, 0.0), (2, 0.01)] {
        let mut shop = shop(seed, Faults::all(share / 4.0));
        shop.world.borrow_mut().far = SWITCHES.to_vec();
        shop.queued.home();
        while shop.queued.settle() {}
        assert_eq!(shop.queued.fault(), None);
        assert_eq!(shop.queued.place(), Some(Axes::default()));
        let world = shop.world.borrow();
        let at = |board: usize, oid: u8| world.wired[board].fake.steppers[&oid].position;
        // Switches are moved once in a millisecond of the test, which is two steps at 20 mm/s.
        for (_, (board, motor), edge) in SWITCHES {
            let off = at(board, motor) - (edge + 300);
            assert!(off.abs() <= 4, "{board} {motor}: {off}");
        }
    }
}

#[test]
fn a_board_that_is_lost_ends_the_run_and_both_stand() {
    for lost in [0, 1] {
        let shop = shop(30, Faults::default());
        let world = shop.world.clone();
        let mut pulls = Pulls { world: world.clone(), lost };
        let Ran { queued, .. } = ran(
            shop.queued,
            machine(),
            "SO,1,1\nVS,50,20\nM2,90,90\nM2,0,0\n",
            &mut Quiet,
            &mut pulls,
        );
        let name = ["board main: ", "board two: "][lost];
        let fault = queued.borrow().fault().cloned().expect("a fault");
        assert!(fault.message.contains(name) && fault.silent, "{fault:?}");
        queued.borrow_mut().close(false, || false);
        let world = world.borrow();
        let last = |board: usize| {
            let fake = &world.wired[board].fake;
            fake.steppers[&0].made.last().map_or(0.0, |(clock, _)| fake.time_at(*clock))
        };
        assert!((last(0) - last(1)).abs() < 0.2, "{} {}", last(0), last(1));
        let off = world.wired.iter().all(|it| it.fake.outputs.values().all(|it| it.value == 0));
        assert!(off, "outputs are off");
    }
}

/// Pulls the cable of a board once X has made some steps.
struct Pulls {
    world: std::rc::Rc<std::cell::RefCell<crate::queued::World>>,
    lost: usize,
}

impl kerf_control::Requests for Pulls {
    fn take(&mut self, _: f64, _: f64) -> Option<(f64, kerf_control::OperatorRequest)> {
        let world = &mut *self.world.borrow_mut();
        if world.fake.steppers[&0].position > 2_000 {
            world.wired[self.lost].spoil(Faults { drop: 1.0, ..Faults::default() });
        }
        None
    }

    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        Some(held_s)
    }
}
