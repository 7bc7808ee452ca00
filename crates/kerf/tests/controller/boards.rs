//! Boards: found, their settings kept and compared, the list that every machine has to hold.

use crate::bench::Bench;
use crate::shop::console::Console;
use crate::shop::{Shop, until};
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
    assert!(!listed.out().contains("Highest speed"), "{}", listed.out());
}

#[test]
fn settings_are_explained_in_a_sentence_and_in_the_words_of_the_board() {
    let explains = |fake: Fake| {
        let (shop, bench) = (Shop::new(&[]), Bench::of(fake));
        let told = shop.kerf(&format!("machine settings --explain --machine grbl:{}", bench.port));
        (told.exits(0).out().to_owned(), bench)
    };
    let (hal, bench) = explains(Fake::of(Board::hal(0), &[(341, 1.0)]));
    let x = "$110=6000.000 mm/min     X: Quickest way [1 to 9000]\n    \
             Highest speed of the axis, which rapid moves have.\n    board: How quick X may be.\n           \
             NOTE: rapid moves are.\n$111=";
    assert!(hal.contains(x), "{hal}");
    assert!(hal.contains("$341=1.000\n    Says what M6 does: "), "{hal}");
    let asked = bench.look(|fake| fake.lines.iter().filter(|it| it.starts_with("$SED=")).count());
    assert_eq!(asked, hal.lines().filter(|line| line.starts_with('$')).count(), "each once");
    let (grbl, _) = explains(Fake::default());
    assert!(
        grbl.contains("$110=6000.000 mm/min     X greatest speed [0 or more]\n    Highest speed")
    );
    assert!(!grbl.contains("board:"), "{grbl}");
}

#[test]
fn a_setting_is_written_by_a_line_that_is_sent() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    let sends = |words: &str| shop.kerf(&format!("send {words} --machine grbl:{}", bench.port));
    let kept = "the controller keeps $120=321.000 now, and kept 400.000 before\n";
    let did = sends("$120=321");
    did.exits(0);
    assert_eq!(did.out(), kept);
    assert_eq!(bench.look(|fake| fake.is_set_to(120)), 321.0);
    sends("$100=200 $121=300 --quiet").exits(0);
    assert_eq!(bench.look(|fake| (fake.is_set_to(100), fake.is_set_to(121))), (200.0, 300.0));
    sends("--again").exits(0).says("200.000 steps a millimetre of X now: it counts anew");
    sends("$777=1").exits(1).complains("it has no setting $777");
    sends("$120=fast $121=9").exits(1).complains("$120 is a number, and 'fast' is none");
    assert_eq!(bench.look(|fake| fake.is_set_to(121)), 300.0, "those behind it are not written");
    sends("$120=1 MX,1")
        .exits(2)
        .complains("$120 is a setting of the controller: write it by itself");
    assert_eq!(bench.look(|fake| fake.is_set_to(120)), 321.0);
    assert_eq!(bench.look(|fake| fake.is_set_to(10)), 1.0, "it is left as it was");
}

#[test]
fn a_setting_is_written_by_a_line_that_is_sent_to_a_server() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    let console = Console::begin(&shop, &["--machine", &format!("grbl:{}", bench.port)]);
    let sends = |words: &str| shop.kerf(&format!("send {words} --server {}", console.url));
    sends("$120=321").exits(1).complains("arm it first");
    console.carry_out("VS,1");
    until("it stands", || console.ask("GET /api/state", "")["machine"]["state"] == "idle");
    let kept = sends("$120=321 $121=320");
    let told = ["$120=321.000 now, and kept 400.000", "$121=320.000 now, and kept 400.000"];
    told.iter().fold(kept.exits(0), |did, words| did.says(words));
    assert_eq!(bench.look(|fake| (fake.is_set_to(120), fake.is_set_to(121))), (321.0, 320.0));
    sends("$120=fast").exits(1).complains("$120 is a number, and 'fast' is none");
    sends("$120=9 MX,1").exits(2).complains("write it by itself");
    assert_eq!(bench.look(|fake| fake.is_set_to(120)), 321.0);
}

#[test]
fn a_server_whose_machine_keeps_none_by_number_refuses_a_setting() {
    let shop = Shop::new(&[]);
    let console = Console::begin(&shop, &[]);
    console.carry_out("VS,1");
    let sent = shop.kerf(&format!("send $120=300 --server {}", console.url));
    sent.exits(1).complains("$120 is a setting of a controller of grbl's family, and this machine");
}

#[test]
fn a_setting_is_refused_where_the_machine_keeps_none_by_number() {
    let shop = Shop::new(&[]);
    let refused = |machine: &str, why: &str| {
        let sent = shop.kerf(&format!("send $120=300 {machine}"));
        sent.exits(2)
            .complains("$120 is a setting of a controller of grbl's family")
            .complains(why);
    };
    refused("", "name one with --machine grbl:PORT; the simulated machine has none");
    refused("--machine linuxcnc:local", "in its INI file");
    refused("--machine klipper:/dev/ttyACM0", "in the machine's file");
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
    // Its card, which it does not have, twice.
    assert_eq!((held, not_tried), (CASES.len() - 3 + 9, 6), "{report}");
    assert!(
        report.contains("| its card lists its files | not tried: grbl 1.1 has no card"),
        "{report}"
    );
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
    assert_eq!(held, CASES.len() - 3 + 10, "{report}");
}

#[test]
fn a_board_proves_that_its_card_takes_shows_and_runs_files() {
    for board in [Board::hal_with_card, Board::fluid_with_card] {
        let bench = Bench::of(Fake::of(board(&[("box.nc", "G21\n")]), &[(10, 511.0)]));
        let (report, held) = proves(&bench, "");
        assert_eq!(held, CASES.len() - 3 + 11, "{report}");
        assert!(report.contains("| its card lists its files | held: 1 files |"), "{report}");
        assert!(bench.look(|fake| fake.card().files.keys().eq(["box.nc"])));
        assert!(bench.look(|fake| fake.lines.iter().any(|line| line == "G90")), "it ran");
    }
}
