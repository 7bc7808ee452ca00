//! `kerf io`, `kerf get` and `kerf set` on a controller: its inputs, its outputs, and what a command leaves on.

use crate::bench::Bench;
use crate::shop::console::Console;
use crate::shop::{Did, Shop, until};
use kerf_driver_grbl::fake::{Board, Fake};

fn by_hand(bench: &Bench, shop: &Shop, words: &str) -> Did {
    shop.kerf(&format!("{words} --machine grbl:{}", bench.port))
}

fn heard(bench: &Bench, line: &str) -> usize {
    bench.look(|fake| fake.lines.iter().filter(|it| *it == line).count())
}

#[test]
fn an_output_of_a_grbl_is_switched_and_what_is_left_on_is_known_to_the_next_command() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    let set = |what: &str, line: &str| {
        let before = heard(&bench, line);
        by_hand(&bench, &shop, what).exits(0);
        assert_eq!(heard(&bench, line), before + 1, "{what} is {line}");
    };
    set("io set flood 1", "M8");
    let did = by_hand(&bench, &shop, "io get 2");
    did.exits(0).complains("left on by the last command: output 2 (flood)");
    assert_eq!((did.out(), heard(&bench, "M9")), ("1\n".into(), 0));
    // It may have been switched off meanwhile: what is wanted is ordered, whatever is believed.
    set("set out.2=1", "M8");
    set("io set 2 0", "M9");
    assert_eq!(by_hand(&bench, &shop, "get out.2").exits(0).out(), "0\n");
    set("io set router 1", "M3");
    assert!(bench.look(|fake| fake.spindle()).is_some());
    set("send SO,1,0", "M5");
    assert_eq!(bench.look(|fake| fake.spindle()), None);
}

#[test]
fn inputs_and_outputs_of_a_grbl_are_listed() {
    let (shop, bench) = (Shop::new(&[]), Bench::of(Fake::of(Board::hal(1), &[])));
    bench.look(|fake| fake.pins("PX"));
    let did = by_hand(&bench, &shop, "io list");
    let lines: Vec<String> = did.exits(0).out().lines().map(str::to_owned).collect();
    let has = |words: &str| {
        lines.iter().any(|line| line.split_whitespace().collect::<Vec<_>>().join(" ") == words)
    };
    for line in ["output 1 spindle 0", "output 4 0", "input 1 1", "input 5 1", "input 6 0"] {
        assert!(has(line), "{line}: {lines:?}");
    }
    assert!(!lines.iter().any(|line| line.contains("tool2")), "it has no card: {lines:?}");
    by_hand(&bench, &shop, "get in.").exits(0).says("in.5 = 1");
    assert_eq!(by_hand(&bench, &shop, "io get in.1").exits(0).out(), "1\n");
    bench.look(|fake| fake.pins("X"));
    assert_eq!(by_hand(&bench, &shop, "io get in.1").exits(0).out(), "0\n");
}

#[test]
fn what_a_grbl_does_not_have_is_refused_with_what_it_has() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    let check = |words: &str, code: i32, why: &str| {
        by_hand(&bench, &shop, words).exits(code).complains(why);
    };
    check("io set 7 1", 1, "has no output 7, but 1 (spindle), 2 (flood)");
    check("io get 7", 1, "tells of no output 7, but of 1, 2");
    check("io get in.3", 1, "tells of no input 3, but of 1, 5, 6, 7");
    check("io set in.1 1", 2, "is read, not set");
    check("io set tool2 1", 2, "kerf io list --machine grbl:");
    check("io step x +", 2, "makes the steps of its motors itself");
    check("set tool2=1", 2, "no setting");
    bench.look(Fake::hits_limit);
    check("io set flood 1", 1, "it is locked");
    check("io get in.5", 0, "it is locked");
    assert_eq!(heard(&bench, "M8"), 0);
}

#[test]
fn a_server_that_finds_an_output_left_on_switches_it_off() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    shop.kerf("machine use router-96x48").exits(0);
    shop.kerf("machine save shop").exits(0);
    by_hand(&bench, &shop, "io set spindle 1 --machine shop").exits(0);
    assert!(bench.look(|fake| fake.spindle()).is_some());
    let _console = Console::begin(&shop, &["--machine", &format!("grbl:{}", bench.port)]);
    until("nobody has armed it", || bench.look(|fake| fake.spindle()).is_none());
    // Through the server, as whoever drives an armed machine.
    shop.kerf("io set out.2 1").exits(1).complains("armed");
    by_hand(&bench, &shop, "io set out.2 1 --arm").exits(0).complains("goes off again");
    assert_eq!(heard(&bench, "M8"), 1);
    until("nobody drives", || heard(&bench, "M9") == 1);
    assert_eq!(shop.kerf("io get out.2").exits(0).out(), "0\n");
    shop.kerf("io get out.2 --machine grbl:COM77").exits(2).complains("is not heeded");
}
