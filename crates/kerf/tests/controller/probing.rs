//! TP, the Probe, on a controller: a bore and a corner come out where they are.

use crate::bench::Bench;
use crate::close;
use crate::shop::Shop;
use kerf_driver_grbl::fake::Solid;

/// Runs a program of the Probe with these entries, begun where the controller stands: its words, and X, Y and Z that
/// the tool reads afterwards, mm.
fn found(entries: &str, solid: Solid) -> (String, [f64; 3]) {
    let (shop, bench) = (
        Shop::new(&[("where.sbp", "PRINT %(1) * 25.4;\" \";%(2) * 25.4;\" \";%(3) * 25.4\n")]),
        Bench::new(&[]),
    );
    bench.look(|fake| fake.solids.push(solid));
    shop.kerf(&format!("send TP,units=mm,diameter=6,travel=30,clear=1,fast=5,slow=.5,{entries}"))
        .exits(0);
    let ran = bench.run(&shop, "run probe.nc");
    ran.exits(0);
    let at = bench.run(&shop, "run where.sbp");
    let read = |line: &str| -> Option<Vec<f64>> {
        line.split(' ').map(|word| word.parse().ok()).collect()
    };
    let at = at.out().lines().find_map(read).unwrap();
    (ran.out().to_owned(), [at[0], at[1], at[2]])
}

/// The numbers behind `Probed:`.
fn numbers(told: &str) -> Vec<f64> {
    let line = told.lines().find_map(|line| line.split_once("Probed: ")).unwrap().1;
    line.split([' ', ',']).filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn a_bore_is_found_on_a_grbl() {
    let (told, at) = found("kind=bore", Solid::Bore { centre: [4.2, -3.1], radius: 12.0 });
    let [x, y, size] = numbers(&told)[..] else { panic!("{told}") };
    assert!(close(x, 4.2) && close(y, -3.1) && (size - 30.0).abs() < 0.01, "{told}");
    assert!(close(at[0], 0.0) && close(at[1], 0.0), "{at:?}");
}

#[test]
fn a_corner_is_found_on_a_grbl() {
    let block = Solid::Block { low: [-8.0, -9.0, -50.0], high: [90.0, 90.0, -4.0] };
    let (told, at) = found("kind=outside-corner,inset=9,depth=3", block);
    let [x, y, z] = numbers(&told)[..] else { panic!("{told}") };
    assert!(close(x, -5.0) && close(y, -6.0) && close(z, -4.0), "{told}");
    assert!(close(at[0], 5.0) && close(at[1], 6.0) && close(at[2], 1.0), "{at:?}");
}
