//! Controllers in the network: everything that goes over a serial port goes over TCP and a WebSocket.

use crate::bench::Bench;
use crate::shop::{Did, Shop};
use crate::{BOX, SQUARE, close, interrupt};

fn runs(bench: &Bench) {
    let shop = Shop::new(&[("box.sbp", BOX), ("square.sbp", SQUARE)]);
    bench.run(&shop, "run box.sbp").exits(0).complains("grbl 1.1h").says("ran to its end");
    let [x, y, z, ..] = bench.look(|fake| fake.position()).0;
    assert!(x.abs() < 0.01 && y.abs() < 0.01 && close(z, 5.08), "{x} {y} {z}");
    assert_eq!(bench.look(|fake| (fake.spindle(), fake.overflowed)), (None, 0));
    shop.kerf(&format!("machine move to 10,20 --machine grbl:{}", bench.port)).exits(0);
    bench.until(|fake| close(fake.position().0[0], 10.0) && close(fake.position().0[1], 20.0));
    let child = bench.start(&shop, "run square.sbp");
    bench.until(|fake| fake.spindle().is_some() && fake.position().0[0] > 20.0);
    interrupt(&child);
    Did::of(child.wait_with_output().unwrap()).exits(3).says("STOPPED");
    assert_eq!(bench.look(|fake| fake.spindle()), None);
}

#[test]
fn a_controller_behind_tcp_is_driven() {
    runs(&Bench::tcp());
}

#[test]
fn a_controller_behind_a_websocket_is_driven() {
    runs(&Bench::web());
}

#[test]
fn an_address_at_which_nobody_is_is_told() {
    let shop = Shop::new(&[("box.sbp", BOX)]);
    for name in ["grbl:tcp:127.0.0.1:9", "grbl:ws:127.0.0.1:9"] {
        let run = shop.kerf(&format!("run box.sbp --machine {name}"));
        run.exits(1).complains("127.0.0.1:9").complains("cannot be reached");
    }
}
