//! PAUSE UNTIL on a controller, asked at a terminal: its input has the run go on, also where the run was taken up.

use crate::bench::Bench;
use crate::shop::{Did, Shop};
use std::fs::File;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Input 1 is the probe. What is cut ahead of the pause leads to 10.16 mm, what is behind it to 25.4 mm.
const WAITS: &str = "MX,.4\n'Close the clamp\nPAUSE UNTIL 1,1\nMX,1\n";

/// Has somebody at a terminal run something; the near end of the terminal belongs to the caller.
fn at_terminal(shop: &Shop, words: &str) -> (File, Child) {
    let pair = nix::pty::openpty(None, None).unwrap();
    let mut command = shop.command();
    command.args(words.split_whitespace()).stdin(File::from(pair.slave));
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    (File::from(pair.master), command.spawn().unwrap())
}

fn x(bench: &Bench) -> f64 {
    bench.look(|fake| fake.position().0[0])
}

/// It stands at the pause, and goes on when the input comes.
fn waits_and_goes_on(bench: &Bench, child: Child) -> Did {
    bench.until(|fake| (fake.position().0[0] - 10.16).abs() < 0.01);
    sleep(Duration::from_millis(700));
    assert!((x(bench) - 10.16).abs() < 0.01, "it waits at {}", x(bench));
    bench.look(|fake| fake.pins("P"));
    bench.until(|fake| (fake.position().0[0] - 25.4).abs() < 0.01);
    Did::of(child.wait_with_output().unwrap())
}

#[test]
fn a_pause_that_is_asked_at_the_terminal_ends_by_its_input() {
    let (shop, bench) = (Shop::new(&[("waits.sbp", WAITS)]), Bench::new(&[]));
    let (_keys, child) =
        at_terminal(&shop, &format!("run waits.sbp --machine grbl:{}", bench.port));
    waits_and_goes_on(&bench, child).exits(0).says("ran to its end");
}

#[test]
fn a_run_that_was_killed_in_such_a_pause_is_taken_up_and_waits_again() {
    let (shop, bench) = (Shop::new(&[("waits.sbp", WAITS)]), Bench::new(&[]));
    shop.write("yes.txt", b"hold=Resume\nlocation=Continue\n");
    let (_keys, mut child) =
        at_terminal(&shop, &format!("run waits.sbp --machine grbl:{}", bench.port));
    bench.until(|fake| (fake.position().0[0] - 10.16).abs() < 0.01);
    sleep(Duration::from_millis(700));
    child.kill().unwrap();
    child.wait().unwrap();
    let again = format!("run --resume --machine grbl:{} --answers yes.txt", bench.port);
    let (_keys, child) = at_terminal(&shop, &again);
    waits_and_goes_on(&bench, child).exits(0).says("ran to its end");
}
