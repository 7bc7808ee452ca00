//! `kerf run` on a board with step queues is killed at random instants, taken up with `--resume`, and the board cuts the same.
//! A thousand such kills are made in time that is none (`kerf-control`, `queued_killed`).

use crate::shop::{Did, Shop, until};
use crate::step_board::Bench;
use crate::step_path::{Judge, MACHINE, part};
use kerf_driver_klipper::fake::Dice;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Longest time from its beginning after which a process is killed, seconds.
const LIVES_S: f64 = 9.0;

fn begin(shop: &Shop, args: &str) -> Child {
    let mut command = shop.command();
    command.args(args.split_whitespace());
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Kills a process after a time; tells whether it was still alive.
fn kill(mut child: Child, after: Duration) -> Result<(), Did> {
    let until = Instant::now() + after;
    while Instant::now() < until {
        if child.try_wait().unwrap().is_some() {
            return Err(Did::of(child.wait_with_output().unwrap()));
        }
        sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    Ok(())
}

/// Runs a part whose host is killed so often, and holds the board against its path.
fn survives(seed: u64, kills: u32) {
    let part = part(13, 30);
    let machine = format!("{MACHINE}\ndeadline_s = 2\nwatch_s = 3\n");
    let files = [("a.sbp", &*part.text()), ("board.toml", &machine), ("yes.txt", "hold=Resume\n")];
    let (shop, bench, mut dice) = (Shop::new(&files), Bench::new(), Dice(seed));
    let first = bench.args("run a.sbp --unlock");
    let again = format!("run --resume --unlock --answers yes.txt --machine klipper:{}", bench.port);
    let (mut args, mut killed) = (&first, 0);
    loop {
        let child = begin(&shop, args);
        let lives_s = if killed < kills { dice.share() * LIVES_S } else { 300.0 };
        match kill(child, Duration::from_secs_f64(lives_s)) {
            Ok(()) => killed += 1,
            Err(did) if did.err().contains("no run was cut short") => args = &first,
            Err(did) => {
                did.exits(0).says("ran to its end");
                break;
            }
        }
        if killed > 0 {
            args = &again;
        }
        // Somebody is there at once, or when the board has switched all off by itself.
        if dice.share() < 0.5 {
            let is_off = || bench.look(|board| board.outputs.values().all(|it| it.value == 0));
            until("all is off", is_off);
        }
    }
    bench.look(|board| Judge::new(&part).holds(board, &format!("seed {seed}")));
}

#[test]
fn a_run_that_is_killed_is_taken_up_to_the_step() {
    survives(1, 2);
}

#[test]
fn a_run_that_is_killed_again_and_again_is_taken_up_to_the_step() {
    survives(2, 4);
}
