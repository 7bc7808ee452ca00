//! Homing on a board with step queues, in simulated time.

use crate::queued::{Shop, machine_of};
use kerf_driver_klipper::fake::Faults;
use kerf_machine::{Configuration, Machine};
use kerf_program::{Axes, Axis};

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

pub fn machine() -> Configuration {
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
