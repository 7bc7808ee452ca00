//! `kerf machine warm-up`: the spindle turns in steps, and is off behind them, however they end.

use crate::bench::Bench;
use crate::shop::{Did, Shop};
use std::process::{Child, Command, Stdio};

/// Begins a warm-up of the controller.
fn warms(shop: &Shop, bench: &Bench, steps: &str) -> Child {
    let mut command = shop.command();
    command.args(["machine", "warm-up", steps, "--machine", &format!("grbl:{}", bench.port)]);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

#[test]
fn steps_are_shares_of_the_greatest_speed_of_the_controller() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    let child = warms(&shop, &bench, "25:0.05,100:0.05");
    bench.until(|fake| fake.spindle() == Some(6000.0));
    bench.until(|fake| fake.spindle() == Some(24_000.0));
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(0)
        .says("step 1 of 2: 6000 rpm for 0.05 min, 0.1 min left")
        .says("step 2 of 2: 24000");
    bench.until(|fake| fake.spindle().is_none());
    Did::of(warms(&shop, &bench, "25").wait_with_output().unwrap())
        .exits(2)
        .complains("'25' is no step of a warm-up");
}

#[test]
fn a_warm_up_that_is_stopped_ends_with_the_spindle_off() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    let child = warms(&shop, &bench, "50:5");
    bench.until(|fake| fake.spindle() == Some(12_000.0));
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
    child.wait_with_output().unwrap();
    bench.until(|fake| fake.spindle().is_none());
}
