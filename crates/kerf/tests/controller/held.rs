//! The operator's hold on a controller: the machine stands on its path and goes on from there, with its spindle on.

use crate::bench::Bench;
use crate::shop::{Did, Shop};
use crate::{SQUARE, events, interrupt};
use std::thread::sleep;
use std::time::Duration;

#[test]
fn a_hold_on_a_controller_is_its_own() {
    let (shop, bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::new(&[]));
    let child = bench.start(&shop, "run square.sbp --hold-at 1.5 --resume-at 3");
    bench.until(|fake| fake.stands() == 1 && fake.position().0[0] > 10.0);
    let stood = bench.x_mm();
    sleep(Duration::from_millis(600));
    assert_eq!(bench.x_mm(), stood, "it stands");
    assert!(bench.look(|fake| fake.spindle().is_some()), "a hold switches nothing off");
    Did::of(child.wait_with_output().unwrap()).exits(0).says("ran to its end");
    let lines = bench.look(|fake| fake.lines.clone());
    let on = lines.iter().filter(|line| *line == "M3").count();
    assert_eq!((on, bench.look(|fake| fake.stands())), (1, 2), "nothing is begun anew: {lines:?}");
    assert_eq!((events(&shop, "hold").len(), events(&shop, "resume").len()), (1, 1));
    assert_eq!(events(&shop, "move").len(), 4, "the plan stays what it is");
}

#[test]
fn a_stop_in_a_hold_gives_the_run_up_where_it_is_held() {
    let (shop, bench) =
        (Shop::new(&[("square.sbp", SQUARE), ("back.sbp", "J2,0,0\n")]), Bench::new(&[]));
    let child = bench.start(&shop, "run square.sbp --hold-at 1.5 --resume-at 60");
    bench.until(|fake| fake.stands() == 1 && fake.position().0[0] > 10.0);
    let stood = bench.x_mm();
    interrupt(&child);
    Did::of(child.wait_with_output().unwrap()).exits(3).says("STOPPED");
    assert_eq!((bench.x_mm(), bench.look(|fake| fake.spindle())), (stood, None));
    let told = events(&shop, "move")[0]["to"]["x"].as_f64().unwrap() * 25.4;
    assert!((told - stood).abs() < 0.01, "{told} {stood}");
    bench.run(&shop, "run back.sbp").exits(0);
    assert!(bench.x_mm().abs() < 0.01, "the location was kept: {}", bench.x_mm());
}

#[test]
fn what_a_controller_waits_for_at_its_own_controls_is_told() {
    let (shop, bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::new(&[]));
    let child = bench.start(&shop, "run square.sbp");
    bench.until(|fake| fake.position().0[0] > 20.0);
    bench.look(|fake| fake.hear(b"!", 0.0));
    sleep(Duration::from_millis(1500));
    bench.look(|fake| fake.hear(b"~", 0.0));
    bench.until(|fake| fake.position().0[1] > 5.0);
    bench.look(|fake| fake.pins("D"));
    sleep(Duration::from_millis(1500));
    bench.look(|fake| fake.pins(""));
    bench.look(kerf_driver_grbl::fake::Fake::cycle_start);
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(0).complains("waiting: it is held").complains("waiting: its door is open");
    did.complains("it goes on");
}

/// A pendant has a machine go on that the operator holds.
#[test]
fn a_pendant_ends_the_hold_of_the_operator() {
    let (shop, bench) = (Shop::new(&[("square.sbp", SQUARE)]), Bench::new(&[]));
    let child = bench.start(&shop, "run square.sbp --hold-at 1.5 --resume-at 600");
    bench.until(|fake| fake.stands() == 1 && fake.position().0[0] > 10.0);
    sleep(Duration::from_millis(500));
    bench.look(|fake| fake.hear(b"~", 0.0));
    Did::of(child.wait_with_output().unwrap()).exits(0).says("ran to its end");
}
