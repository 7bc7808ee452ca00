//! A line that is gone for a while: the job goes on where the controller has lost nothing.

use crate::bench::Bench;
use crate::events;
use crate::shop::{Did, Shop};
use std::thread::sleep;
use std::time::Duration;

const WAY: &str = "MS,1,1\nSO,1,1\nMX,1\nMY,1\nMX,2\nMY,2\nMX,3\nMY,3\n";

fn goes_on(mut bench: Bench) {
    let shop = Shop::new(&[("way.sbp", WAY)]);
    let child = bench.start(&shop, "run way.sbp");
    bench.until(|fake| fake.position().0[0] > 10.0);
    bench.pulls();
    sleep(Duration::from_secs(2));
    bench.plugs();
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(0).says("ran to its end").complains("its line is gone");
    let [x, y, ..] = bench.look(|fake| fake.position()).0;
    assert!((x - 76.2).abs() < 0.01 && (y - 76.2).abs() < 0.01, "{x} {y}");
    let way = bench.look(|fake| fake.way_mm());
    assert!((way - 152.4).abs() < 0.05, "{way}");
    assert_eq!(events(&shop, "move").len(), 6);
}

#[test]
fn a_cable_that_is_plugged_in_again_ends_no_job() {
    goes_on(Bench::plugged_at("gone-serial"));
}

#[test]
fn a_network_that_was_down_ends_no_job() {
    goes_on(Bench::tcp());
}

#[test]
fn a_controller_that_was_switched_off_meanwhile_ends_the_job() {
    let (mut bench, shop) = (Bench::plugged_at("gone-reset"), Shop::new(&[("way.sbp", WAY)]));
    let child = bench.start(&shop, "run way.sbp");
    bench.until(|fake| fake.position().0[0] > 10.0);
    bench.pulls();
    bench.look(kerf_driver_grbl::fake::Fake::begins_anew);
    sleep(Duration::from_secs(1));
    bench.plugs();
    let did = Did::of(child.wait_with_output().unwrap());
    did.exits(1).complains("M008").complains("the line was gone").complains("stands at");
}
