//! Sessions with boards that are none: found, refused, shut down, restarted, gone.

use crate::world::{Motion, World, motor, setup};
use kerf_driver_klipper::board::{Ended, Fault, News, Options};
use kerf_driver_klipper::fake::{Board as Fake, Faults};
use kerf_driver_klipper::setup::{Pin, Setup, SetupError};

fn ready(news: &News) -> bool {
    matches!(news, News::Ready { .. })
}

/// Lets another host find the board, and returns what it tells first.
fn second(world: &mut World, setup: Setup) -> News {
    world.host = kerf_driver_klipper::board::Board::new(setup, Options::default(), world.now_s);
    world.news.clear();
    world.wait(|news| ready(news) || matches!(news, News::Fault(_)))
}

#[test]
fn a_board_that_is_known_is_taken_up_with_its_counts() {
    let mut world = World::ready(1, Faults::default());
    world.make(&Motion::straight(500.0, 1.0), &[]);
    let News::Ready { version, counts } = second(&mut world, setup()) else {
        panic!("it is ready")
    };
    assert_eq!((version.as_str(), &counts[..]), ("fake-1", &[500, 0, 0][..]));
}

#[test]
fn a_motor_that_turns_the_other_way_counts_as_it_is_planned() {
    let mut turned = setup();
    turned.motors[0].dir.inverted = true;
    let mut world = World::new(1, Faults::default(), turned.clone(), Options::default());
    world.wait(ready);
    assert_eq!(world.make(&Motion::straight(500.0, 1.0), &[]), (Ended::Rested, vec![500, 0, 0]));
    assert_eq!(world.fake.steppers[&0].position, -500);
    let News::Ready { counts, .. } = second(&mut world, turned) else { panic!("it is ready") };
    assert_eq!(counts, [500, 0, 0]);
}

#[test]
fn a_board_that_still_moves_is_put_at_rest_first() {
    let mut world = World::ready(2, Faults::default());
    let motion = Motion::straight(9000.0, 3.0);
    let mut feed = world.begin(&motion, &[]);
    for _ in 0..1500 {
        world.feed(&motion, &mut feed);
        world.pass();
    }
    let News::Ready { counts, .. } = second(&mut world, setup()) else { panic!("it is ready") };
    assert_eq!(counts[0], world.fake.steppers[&0].position);
    assert!(counts[0] > 100 && !world.fake.is_stepping(0));
}

#[test]
fn a_latch_of_a_former_session_is_put_at_rest() {
    let options = Options { deadline_s: 60.0, ..Options::default() };
    let mut world = World::new(2, Faults::default(), setup(), options);
    world.wait(ready);
    world.begin(&Motion::straight(9000.0, 3.0), &[]);
    world.pass_for(0.1);
    assert!(world.fake.trsyncs.values().any(|latch| latch.armed));
    second(&mut world, setup());
    assert!(!world.fake.trsyncs.values().any(|latch| latch.armed));
}

#[test]
fn a_host_that_may_be_silent_for_long_moves_the_board_beyond_the_first_deadline() {
    let options = Options { deadline_s: 0.8, ..Options::default() };
    let mut world = World::new(5, Faults::default(), setup(), options);
    world.wait(ready);
    let motion = Motion::straight(500.0, 2.0);
    let mut feed = world.begin(&motion, &[]);
    while world.feed(&motion, &mut feed) {
        world.pass();
    }
    assert_eq!(world.wait_end(), (Ended::Rested, vec![500, 0, 0]));
}

#[test]
fn steps_that_were_lost_are_told() {
    let mut world = World::ready(2, Faults::default());
    let motion = Motion::straight(500.0, 1.0);
    let mut feed = world.begin(&motion, &[]);
    while world.feed(&motion, &mut feed) {
        world.pass();
    }
    world.fake.steppers.get_mut(&0).unwrap().position -= 1;
    assert_eq!(world.wait_fault(), Fault::Lost { motor: 0, planned: 500, made: 499 });
}

#[test]
fn a_board_whose_clock_stood_still_makes_its_last_steps() {
    for still_s in [0.03, 0.3, 1.5] {
        for faults in [Faults::default(), Faults::all(0.01 / 6.0)] {
            let mut world = World::ready(2, faults);
            let motion = Motion::straight(500.0, 1.0);
            let mut feed = world.begin(&motion, &[]);
            while world.feed(&motion, &mut feed) {
                world.pass();
            }
            world.pass_for(0.2);
            let made = world.fake.steppers[&0].position;
            assert!((1..500).contains(&made), "it is on its way: {made}");
            world.fake.stand_still(still_s);
            assert_eq!(world.wait_end(), (Ended::Rested, vec![500, 0, 0]), "{still_s} s");
        }
    }
}

#[test]
fn a_board_behind_a_line_of_a_tenth_of_a_second_is_found_and_moved() {
    let options = Options { deadline_s: 0.8, ..Options::default() };
    let mut world = World::new(6, Faults::default(), setup(), options);
    world.delay(0.05);
    world.wait(ready);
    println!("ready after {:.2} s", world.now_s);
    let motion = Motion::straight(500.0, 2.0);
    assert_eq!(world.make(&motion, &[]), (Ended::Rested, vec![500, 0, 0]));
}

#[test]
fn a_board_whose_clock_is_never_told_is_given_up() {
    let mut world = World::new(6, Faults::default(), setup(), Options::default());
    world.fake.mute = Some("clock");
    assert_eq!(world.wait_fault(), Fault::Unanswered("get_clock"));
}

#[test]
fn a_board_that_was_configured_otherwise_is_refused() {
    let mut world = World::ready(3, Faults::default());
    let other = Setup { motors: vec![motor(5)], ..Setup::default() };
    let told = second(&mut world, other);
    assert!(matches!(told, News::Fault(Fault::Foreign(_))), "{told:?}");
    let before = world.fake.ran.get("queue_step").copied();
    world.pass_for(1.0);
    assert_eq!(before, world.fake.ran.get("queue_step").copied(), "nothing moves by itself");
}

#[test]
fn a_shutdown_is_told_with_its_reason_and_counts_survive() {
    let mut world = World::ready(4, Faults::default());
    let motion = Motion::straight(9000.0, 3.0);
    let mut feed = world.begin(&motion, &[]);
    for _ in 0..1500 {
        world.feed(&motion, &mut feed);
        world.pass();
    }
    world.host.emergency_stop().expect("a board");
    let told = world.wait(|news| matches!(news, News::Shutdown(_)));
    assert_eq!(told, News::Shutdown("Command request".to_owned()));
    let made = world.fake.steppers[&0].position;
    assert!(made > 100);
    assert!(world.host.start(&[], world.now_s).is_err());
    world.host.recover().expect("a board that is shut down");
    assert_eq!(world.wait_end(), (Ended::Shutdown, vec![made, 0, 0]));
    world.news.clear();
    assert!(world.host.start(&[], world.now_s).is_ok());
}

#[test]
fn a_board_that_is_shut_down_already_tells_why() {
    let mut world = World::ready(5, Faults::default());
    world.fake.shut("ADC out of range");
    let told = second(&mut world, setup());
    assert_eq!(told, News::Fault(Fault::ShutDown("ADC out of range".to_owned())));
}

#[test]
fn a_shutdown_is_cleared_where_somebody_has_looked_why() {
    let mut world = World::ready(5, Faults::default());
    world.make(&Motion::straight(500.0, 1.0), &[]);
    world.fake.shut("ADC out of range");
    let options = Options { clears: true, ..Options::default() };
    world.host = kerf_driver_klipper::board::Board::new(setup(), options, world.now_s);
    world.news.clear();
    let told = world.wait(|news| ready(news) || matches!(news, News::Fault(_)));
    let News::Ready { counts, .. } = told else { panic!("{told:?}") };
    assert_eq!(counts[0], 500);
    assert_eq!(world.make(&Motion::straight(500.0, 1.0), &[]).0, Ended::Rested);
}

#[test]
fn a_shutdown_is_cleared_over_faulty_lines() {
    // Questions are asked twice there, and some answers are from before.
    for seed in 0..200 {
        let mut world = World::ready(300 + seed, Faults::all(0.03));
        world.fake.shut("ADC out of range");
        let options = Options { clears: true, ..Options::default() };
        world.host = kerf_driver_klipper::board::Board::new(setup(), options, world.now_s);
        world.news.clear();
        let told = world.wait(|news| ready(news) || matches!(news, News::Fault(_)));
        assert!(ready(&told), "seed {seed}: {told:?}");
    }
}

#[test]
fn a_board_that_restarts_is_told() {
    for seed in 0..20 {
        let mut world = World::ready(6 + seed, Faults::default());
        // Whatever number its frames had come to.
        world.pass_for(0.7 * seed as f64);
        world.fake.reset();
        assert_eq!(world.wait_fault(), Fault::Restarted);
    }
}

#[test]
fn a_cable_that_is_pulled_is_told() {
    let mut world = World::ready(7, Faults::default());
    world.there.faults.drop = 1.0;
    assert_eq!(world.wait_fault(), Fault::Silent);
}

#[test]
fn a_port_without_a_board_is_told() {
    let mut world =
        World::new(8, Faults { drop: 1.0, ..Faults::default() }, setup(), Options::default());
    assert_eq!(world.wait_fault(), Fault::NoBoard);
}

#[test]
fn sessions_begin_on_faulty_lines() {
    for seed in 0..10 {
        World::ready(100 + seed, Faults::all(0.01));
    }
}

fn check_setup(setup: Setup, expected: SetupError) {
    let mut world = World::new(9, Faults::default(), setup, Options::default());
    assert_eq!(world.wait_fault(), Fault::Setup(expected));
    assert!(!world.fake.ran.contains_key("allocate_oids"), "nothing was configured");
}

#[test]
fn setups_that_do_not_fit_are_refused_before_anything_is_configured() {
    let twice = Setup { motors: vec![motor(1), motor(1)], ..Setup::default() };
    check_setup(twice, SetupError::Twice("gpio2".to_owned()));
    let many = Setup {
        buttons: (0..9).map(|n| Pin::new(&format!("gpio{n}"))).collect(),
        ..Setup::default()
    };
    check_setup(many, SetupError::Many { what: "inputs that are looked at", most: 8, count: 9 });
    let mut fault = World::new(
        9,
        Faults::default(),
        Setup { switches: vec![Pin::new("gpio99")], ..Setup::default() },
        Options::default(),
    );
    assert_eq!(fault.wait_fault().to_string(), "the board has no pin `gpio99`");
}

#[test]
fn an_output_is_kept_on_and_goes_off_when_it_is_told() {
    let mut world = World::ready(10, Faults::default());
    world.host.set_output(0, 1.0, world.now_s).expect("a board");
    world.pass_for(3.0);
    let value = |fake: &Fake| fake.outputs.values().next().unwrap().value;
    assert_eq!(value(&world.fake), 1, "{:?}", world.fake.reason());
    world.host.set_output(0, 0.0, world.now_s).expect("a board");
    world.pass_for(0.5);
    assert_eq!(value(&world.fake), 0);
    assert!(!world.fake.is_shutdown());
}

/// Changes that come in one moment go out as they came: the last one holds.
#[test]
fn outputs_that_are_told_in_one_moment_change_in_that_order() {
    for (told, last) in [([1.0, 0.0], 0), ([0.0, 1.0], 1)] {
        let mut world = World::ready(10, Faults::default());
        for share in told {
            world.host.set_output(0, share, world.now_s).expect("a board");
        }
        world.pass_for(0.5);
        assert_eq!(world.fake.outputs.values().next().unwrap().value, last, "{told:?}");
    }
}

#[test]
fn a_stop_puts_outputs_off() {
    let mut world = World::ready(11, Faults::default());
    let mut motion = Motion::straight(9000.0, 3.0);
    motion.switches_s = vec![(0.2, 1), (1.2, 0), (1.21, 1)];
    let mut feed = world.begin(&motion, &[]);
    let since_s = world.now_s;
    while world.now_s < since_s + 1.3 {
        world.feed(&motion, &mut feed);
        world.pass();
    }
    world.host.stop().expect("a board");
    world.wait_end();
    world.pass_for(1.0);
    assert_eq!(world.fake.outputs.values().next().unwrap().value, 0);
    assert!(!world.fake.is_shutdown(), "{:?}", world.fake.reason());
}

#[test]
fn inputs_are_told_once_each_change() {
    let mut setup = setup();
    setup.buttons = vec![Pin::new("gpio30"), Pin { inverted: true, ..Pin::new("gpio31") }];
    let mut world = World::new(12, Faults::all(0.01), setup, Options::default());
    world.wait(ready);
    world.pass_for(1.0);
    let now = world.fake.now;
    let at = |s: f64| now + (s * 12e6) as u64;
    world.fake.driven.insert(30, vec![(at(0.1), true), (at(0.5), false)]);
    world.fake.driven.insert(31, vec![(at(0.3), true)]);
    world.pass_for(1.5);
    let told: Vec<u8> = world
        .news
        .iter()
        .filter_map(|n| match n {
            News::Buttons(b) => Some(*b),
            _ => None,
        })
        .collect();
    assert_eq!(told, [0b11, 0b01, 0b00]);
}

#[test]
fn voltages_and_registers_are_read() {
    let mut setup = setup();
    setup.voltages = vec![Pin::new("ADC")];
    setup.drivers = vec![kerf_driver_klipper::setup::DriverWire {
        rx: Pin::new("gpio40"),
        tx: Pin::new("gpio40"),
    }];
    let mut world = World::new(13, Faults::default(), setup, Options::default());
    world.fake.answers = vec![(
        vec![0x0a, 0x02, 0xc8, 0xa0, 0xb7],
        vec![0x0a, 0xfa, 0xcf, 0xa0, 0x90, 0x00, 0x02, 0x08, 0xa8, 0xa7],
    )];
    world.wait(ready);
    world.host.ask_register(0, 0, 6).expect("a board");
    let told = world.wait(|news| matches!(news, News::Register { .. }));
    assert_eq!(told, News::Register { driver: 0, register: 6, value: Ok(0x2100_0040) });
    world.host.measure(0, Some(0.1), world.now_s).expect("a board");
    let asked = world.fake.now;
    let voltage = |news: &News| matches!(news, News::Voltage { .. });
    let mut all = Vec::new();
    for _ in 0..3 {
        let News::Voltage { all: told, .. } = world.wait(voltage) else { panic!() };
        all.extend(told);
    }
    assert!((all[0].share - 0.5).abs() < 0.01, "{all:?}");
    // From half a second on, in the middle of eight samples 1 ms apart.
    let first_s = (all[0].clock - asked) as f64 / 12e6;
    assert!((first_s - 0.5035).abs() < 0.005, "{first_s}");
    assert!(all.windows(2).all(|pair| pair[1].clock - pair[0].clock == 1_200_000), "{all:?}");
    world.host.measure(0, None, world.now_s).expect("a board");
    world.pass_for(0.2);
    world.news.clear();
    world.pass_for(0.5);
    assert!(!world.news.iter().any(voltage), "no more");
}

/// A frame that is lost comes some 30 ms later. An output at rest has no moment that it could miss.
#[test]
fn an_output_changes_on_a_bad_line_and_the_board_goes_on() {
    let faults = Faults { drop: 0.02, flip: 0.02, ..Faults::default() };
    for seed in 0..20 {
        let mut world = World::ready(seed, faults);
        for n in 0..20 {
            let on = n % 2 == 0;
            world.host.set_output(0, f64::from(u8::from(on)), world.now_s).expect("a board");
            let asked = world.fake.now;
            world.pass_for(0.25 + 0.013 * f64::from(n));
            assert_eq!(world.fake.reason(), None, "seed {seed}, change {n}");
            let output = &world.fake.outputs.values().next().expect("an output");
            assert_eq!(output.value != 0, on, "seed {seed}, change {n}");
            let first =
                output.made.iter().find(|(clock, value)| *clock >= asked && (*value != 0) == on);
            let late_s = (first.expect("the change").0 - asked) as f64 / 12e6;
            assert!(late_s < 0.2, "seed {seed}, change {n}: {late_s} s");
        }
    }
}

/// The bytes of a host that is kept waiting go out 30 ms after it looked at the clock.
#[test]
fn an_output_of_a_host_that_is_kept_waiting_changes() {
    let mut world = World::ready(3, Faults::default());
    for on in [1.0, 0.0, 1.0, 0.0] {
        world.host.set_output(0, on, world.now_s).expect("a board");
        let out = world.host.transmit(world.now_s).bytes;
        world.stalls_until_s = world.now_s + 0.03;
        world.pass_for(0.03);
        let now_s = world.now_s;
        world.there.put(&out, now_s);
        world.pass_for(0.3);
        assert_eq!(world.fake.reason(), None);
        let value = world.fake.outputs.values().next().map(|output| output.value);
        assert_eq!(value, Some(on as u32));
    }
}
