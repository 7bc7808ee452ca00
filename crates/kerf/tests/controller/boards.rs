//! Boards: found, their settings kept and compared, the list that every machine has to hold.

use crate::bench::Bench;
use crate::shop::Shop;
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::conformance::CASES;
use kerf_machine::driver::Axes;
use std::time::{Duration, Instant};

#[test]
fn a_controller_is_found_with_its_firmware() {
    let (shop, bench) = (Shop::new(&[]), Bench::tcp());
    let begin = Instant::now();
    let found = shop.kerf(&format!("machine connect {} tcp:127.0.0.1:9", bench.port));
    assert!(begin.elapsed() < Duration::from_secs(20), "a busy computer is no measure of 3 s");
    found.exits(0).says(&format!("grbl:{}", bench.port)).says("grbl 1.1h.20190825, axes XYZ");
    assert!(!found.out().contains(":9"), "{}", found.out());
}

#[test]
fn settings_of_a_board_are_listed_changed_kept_and_compared() {
    let (shop, bench, other) = (Shop::new(&[]), Bench::tcp(), Bench::tcp());
    other.look(|fake| fake.hear(b"$120=250\n", 0.0));
    let board =
        |words: &str| shop.kerf(&format!("machine settings {words} --machine grbl:{}", bench.port));
    let listed = board("");
    listed
        .exits(0)
        .says("$110=6000.000 mm/min")
        .says("X greatest speed [0 or more]")
        .says("$13=0.000");
    listed.says("$10=1 ");
    board("set 13 5").exits(2).complains("$13 is from 0 to 1");
    board("backup kept.txt").exits(0);
    board("set 110 5000").exits(0);
    assert_eq!(bench.look(|fake| fake.is_set_to(110)), 5000.0);
    board("compare kept.txt").exits(1).says("$110").says("5000").says("6000");
    board(&format!("compare grbl:{}", other.port)).exits(1).says("$120").says("250");
    shop.write("bad.txt", shop.read("kept.txt").replace("$13=0", "$13=5").as_bytes());
    board("restore bad.txt").exits(2).complains("$13 is from 0 to 1; nothing was changed");
    assert_eq!(bench.look(|fake| fake.is_set_to(110)), 5000.0);
    board("restore kept.txt").exits(0).says("$110=6000");
    board("compare kept.txt").exits(0);
    assert_eq!(bench.look(|fake| (fake.is_set_to(110), fake.is_set_to(10))), (6000.0, 1.0));
    shop.kerf("machine settings").exits(2).complains("--machine grbl:PORT");
}

#[test]
fn settings_are_named_as_the_board_names_them() {
    let (shop, bench) = (Shop::new(&[]), Bench::of(Fake::of(Board::hal(0), &[])));
    let listed = shop.kerf(&format!("machine settings --machine grbl:{}", bench.port));
    listed.exits(0).says("$110=6000.000 mm/min     X: Quickest way [1 to 9000]");
    listed.says("$111=6000.000 mm/min     Y greatest speed [0 or more]");
}

/// The outcomes of a report, by the case, and how many of them hold.
fn proves(bench: &Bench, words: &str) -> (String, usize) {
    let shop = Shop::new(&[]);
    let port = &bench.port;
    shop.kerf(&format!("machine prove --report r.md {words} --machine grbl:{port}")).exits(0);
    let report = shop.read("r.md");
    let held = report.lines().filter(|line| line.contains("| held")).count();
    (report, held)
}

#[test]
fn a_board_proves_that_it_holds_the_list() {
    let bench = Bench::tcp();
    let (report, held) = proves(&bench, "");
    assert!(report.contains("# grbl 1.1h.20190825 on grbl:tcp:"), "{report}");
    // A switch at rest and on the way, a fault, and homing, which it does not do.
    let not_tried = report.matches("| not tried: ").count();
    assert_eq!((held, not_tried), (CASES.len() - 3 + 8, 4), "{report}");
    assert!(report.contains("| it goes home | not tried: it has no homing ($22) |"), "{report}");
    let (spindle, offset) = bench.look(|fake| (fake.spindle(), fake.offsets.systems[8]));
    assert_eq!((spindle, offset), (None, Axes::default()));
    let settings = bench.look(|fake| [10, 13].map(|number| fake.is_set_to(number)));
    assert_eq!(settings, [1.0, 0.0], "they are as they were");
}

#[test]
fn a_board_that_homes_does_so_when_it_is_asked_for() {
    let bench = Bench::cabled("prove", Fake::of(Board::hal(0), &[(22, 1.0), (10, 511.0)]));
    let (report, held) = proves(&bench, "--home");
    assert!(report.contains("| it goes home | held |"), "{report}");
    assert_eq!(held, CASES.len() - 3 + 9, "{report}");
}
