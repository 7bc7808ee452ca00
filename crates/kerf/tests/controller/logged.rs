//! `--controller-log`: what was sent to the controller and what it answered, as a file.

use crate::bench::Bench;
use crate::shop::{Did, Shop};
use std::thread::sleep;
use std::time::Duration;

fn lines(shop: &Shop) -> Vec<String> {
    let text = std::fs::read_to_string(shop.file("lines.txt")).unwrap();
    // The time leads each line but the first.
    text.lines().skip(1).map(|line| line.get(13..).unwrap_or_default().to_owned()).collect()
}

#[test]
fn a_pulled_cable_stands_in_the_log_between_the_lines() {
    let shop = Shop::new(&[("way.sbp", "MS,1,1\nMX,1\nMY,1\nMX,2\nMY,2\nMX,3\nMY,3\n")]);
    let mut bench = Bench::plugged_at("logged");
    let child = bench.start(&shop, "run way.sbp --controller-log lines.txt");
    bench.until(|fake| fake.position().0[0] > 10.0);
    bench.pulls();
    sleep(Duration::from_secs(1));
    bench.plugs();
    Did::of(child.wait_with_output().unwrap()).exits(0);
    let lines = lines(&shop);
    let at = |wanted: &str| {
        let found = lines.iter().position(|line| line.contains(wanted));
        found.unwrap_or_else(|| panic!("no {wanted} in {lines:#?}"))
    };
    let order =
        [at("the line is open"), at("> $$"), at("< $110="), at("X25.4"), at("the line is lost")];
    assert!(order.is_sorted(), "{order:?}");
    assert!(at("the line is open again") > at("the line is lost"));
    assert!(at("the line is closed") == lines.len() - 1);
    at("> ?  # status report asked");
    at("< <Run|");
}

#[test]
fn a_log_needs_a_controller_that_speaks_in_lines() {
    let shop = Shop::new(&[("way.sbp", "MX,1\n")]);
    let check = |command: &str, why: &str| {
        shop.kerf(&format!("run way.sbp --controller-log lines.txt{command}"))
            .exits(2)
            .complains(why);
    };
    check("", "--controller-log is for a controller");
    check(" --machine klipper:/dev/none", "is told each step");
}
