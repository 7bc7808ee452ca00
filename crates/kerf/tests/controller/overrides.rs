//! Overrides of rapid moves and of the spindle on a controller.

use crate::bench::Bench;
use crate::shop::{Did, Shop};

#[test]
fn rapid_moves_and_the_spindle_are_overridden_by_the_controller() {
    // Jogs as fast as the controller goes, in inches.
    let jogs = "JS,3.95,2\nSO,1,1\nMX,1\nJX,8\nJX,0\nSO,1,0\n";
    let (shop, bench) = (Shop::new(&[("jogs.sbp", jogs)]), Bench::new(&[]));
    let child = bench.start(&shop, "run jogs.sbp --rapids 25@1 --spindle 80@1");
    bench.until(|fake| fake.rapid_percent == 25 && fake.spindle_percent == 80);
    Did::of(child.wait_with_output().unwrap()).exits(0);
    let lines = bench.look(|fake| fake.lines.clone());
    assert!(lines.iter().any(|line| line.starts_with("G53G0X")), "{lines:?}");
    bench.run(&shop, "run jogs.sbp").exits(0);
    let turned = bench.look(|fake| (fake.rapid_percent, fake.spindle_percent));
    assert_eq!(turned, (100, 100), "the next run begins anew");
    let short = shop.kerf("run jogs.sbp --rapids 20@1");
    short.exits(2).complains("rapid moves is overridden by 25 to 100 percent");
}
