//! Registers of motor drivers over a good line and a bad one.

use crate::world::{World, setup};
use kerf_driver_klipper::board::{Fault, News, Options};
use kerf_driver_klipper::fake::{Chip as Fake, Faults};
use kerf_driver_klipper::setup::{Driver, DriverSelect, DriverWire, Pin, RegisterLink, Setup};
use kerf_driver_klipper::tmc::{Chip, Trouble, Tuning};

/// Pins of the wire, and of the selects.
const WIRE: u32 = 40;
const SELECTS: [u32; 2] = [44, 45];

fn tuning(chip: Chip) -> Tuning {
    Tuning {
        chip,
        current_a: 0.8,
        hold: 0.5,
        ohms: chip.usual_ohms(),
        microsteps: 16,
        interpolates: true,
        quiet: false,
        stall: 0,
        both_edges: true,
    }
}

/// Two drivers on one wire, two behind selects on one bus.
fn with_drivers() -> Setup {
    let pin = |n: u32| Pin::new(&format!("gpio{n}"));
    let wire = |address| RegisterLink::Wire { wire: 0, address };
    let driver = |name: &str, way, chip| Driver { name: name.into(), way, tuning: tuning(chip) };
    let select = |cs| DriverSelect { cs: pin(cs), bus: [pin(50), pin(51), pin(52)] };
    Setup {
        drivers: vec![DriverWire { rx: pin(WIRE), tx: pin(WIRE + 1) }],
        selects: SELECTS.map(select).to_vec(),
        tuned: vec![
            driver("X", wire(0), Chip::Tmc2209),
            driver("Y", wire(2), Chip::Tmc2209),
            driver("Z", RegisterLink::Select(0), Chip::Tmc2130),
            driver("A", RegisterLink::Select(1), Chip::Tmc2130),
        ],
        ..setup()
    }
}

fn chips() -> Vec<Fake> {
    let [z, a] = SELECTS.map(Fake::tmc2130);
    vec![Fake::tmc2209(WIRE, 0), Fake::tmc2209(WIRE, 2), z, a]
}

fn world(seed: u64, faults: Faults, chips: Vec<Fake>) -> World {
    let mut world = World::new(seed, faults, with_drivers(), Options::default());
    world.fake.chips = chips;
    world
}

fn ready(news: &News) -> bool {
    matches!(news, News::Ready { .. })
}

fn check_set(world: &World) {
    for chip in &world.fake.chips {
        let select = SELECTS.contains(&chip.pin);
        let vsense = 1 << 17;
        assert_eq!(chip.get(0x6c), 0x3401_00c3 | vsense, "chopper of {}", chip.pin);
        assert_eq!(chip.get(0x00), if select { 0 } else { 0x1c4 });
        assert_eq!(chip.get(0x10) >> 8 & 0x1f, 25, "run current");
        assert_eq!(chip.get(0x01), 0, "a reset is noted");
    }
}

#[test]
fn drivers_are_set_before_the_board_is_ready() {
    let mut world = world(1, Faults::default(), chips());
    world.wait(ready);
    check_set(&world);
    assert!(world.now_s < 2.0, "{} s", world.now_s);
}

#[test]
fn drivers_are_set_on_bad_lines_and_where_they_miss_a_datagram() {
    for seed in 0..20 {
        let mut chips = chips();
        chips[..2].iter_mut().for_each(|chip| chip.deaf = 1);
        let mut world = world(100 + seed, Faults::all(0.01), chips);
        world.wait(ready);
        check_set(&world);
    }
}

fn check_fault(change: impl Fn(&mut Vec<Fake>), motor: &str, part: &str) {
    let mut chips = chips();
    change(&mut chips);
    let mut world = world(2, Faults::default(), chips);
    match world.wait_fault() {
        Fault::Driver { motor: told, why } => {
            assert_eq!(told, motor);
            assert!(why.contains(part), "{why}");
        }
        other => panic!("{other:?}"),
    }
    assert!(!world.news.iter().any(ready), "nothing can be moved");
}

#[test]
fn a_driver_that_is_not_there_or_another_one_is_told() {
    check_fault(|chips| chips[1].dead = true, "Y", "does not answer");
    check_fault(|chips| chips[2].dead = true, "Z", "does not answer");
    check_fault(|chips| chips[0].deaf = 99, "X", "does not take what is written");
    check_fault(|chips| chips[3].deaf = 99, "A", "does not take what is written");
    check_fault(|chips| _ = chips[0].registers.insert(6, 0x2000_0000), "X", "it is a tmc2208");
    check_fault(|chips| _ = chips[2].registers.insert(4, 0x3000_0000), "Z", "it is a tmc5160");
}

#[test]
fn a_setting_that_no_driver_has_is_told() {
    let mut setup = with_drivers();
    setup.tuned[1].tuning.current_a = 3.0;
    let mut world = World::new(3, Faults::default(), setup, Options::default());
    world.fake.chips = chips();
    let why = world.wait_fault().to_string();
    assert!(why.contains("driver of motor Y: 3 A is beyond its resistors"), "{why}");
}

#[test]
fn heat_shorts_and_a_lost_supply_are_told_between_runs() {
    for faults in [Faults::default(), Faults::all(0.01)] {
        let mut world = world(4, faults, chips());
        world.wait(ready);
        let mut check = |chip: usize, (register, value), expected: Option<(&str, bool, &str)>| {
            world.fake.chips[chip].registers.insert(register, value);
            world.host.check_drivers().expect("a board");
            world.pass_for(3.0);
            world.fake.chips[chip].registers.insert(register, 0);
            let told = world.news.drain(..).find_map(|news| match news {
                News::Driver(Trouble { name, drives, words }) => Some((name, drives, words)),
                _ => None,
            });
            match (told, expected) {
                (None, None) => {}
                (Some((name, drives, words)), Some((of, still, part))) => {
                    assert_eq!((&*name, drives), (of, still));
                    assert!(words.contains(part), "{words}");
                }
                other => panic!("{other:?}"),
            }
        };
        check(0, (0x6f, 0), None);
        check(0, (0x6f, 1), Some(("X", true, "it is warm")));
        check(1, (0x6f, 2), Some(("Y", false, "too hot")));
        check(2, (0x6f, 1 << 27), Some(("Z", false, "shorted")));
        check(3, (0x01, 1), Some(("A", false, "it was reset")));
    }
}
