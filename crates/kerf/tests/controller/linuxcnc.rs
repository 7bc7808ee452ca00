//! LinuxCNC itself, where it is installed: going home, a program, zero points, outputs at their place, its emergency stop.

#[path = "../../../../tests/linuxcnc/session.rs"]
mod session;

use crate::close;
use crate::shop::console::Console;
use crate::shop::{Did, Shop};
use session::{PYTHON, Session, begins};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Moves along X with an output switched on between them, and the spindle beside it.
const SWITCHED: &str = "TR,9000\nSO,1,1\nMS,1\nMX,1\nSO,5,1\nMX,2\nSO,5,0\nMX,3\nSO,1,0\n";

/// Tells where X was at each change of an output and of the spindle, until its input ends.
const LOOKS: &str = "
import linuxcnc, select, sys
state, was = linuxcnc.stat(), None
while not select.select([sys.stdin], [], [], 0.001)[0]:
    state.poll()
    spindle = state.spindle[0]
    now = (state.dout[1], spindle['enabled'] * spindle['speed'])
    if was not in (None, now):
        print(*now, state.actual_position[0])
    was = now
";

/// Waits until LinuxCNC itself has seen its emergency stop.
const STOPPED: &str = "
import linuxcnc, time
state = linuxcnc.stat()
for _ in range(1000):
    state.poll()
    if state.estop:
        break
    time.sleep(0.01)
else:
    raise SystemExit('its emergency stop is not seen')
";

fn kerf(shop: &Shop, words: &str) -> Did {
    shop.kerf(&format!("{words} --machine linuxcnc:local"))
}

fn begun() -> Option<Session> {
    match begins() {
        Ok(session) => Some(session),
        Err(why) => {
            println!("skipped: {why}");
            None
        }
    }
}

#[test]
fn a_real_linuxcnc_does_what_the_fake_one_does() {
    let Some(session) = begun() else { return };
    let shop = Shop::new(&[("switched.sbp", SWITCHED)]);
    kerf(&shop, "machine home").exits(1).complains("switched off").complains("--unlock");
    kerf(&shop, "machine home --unlock").exits(0).says("homed");
    switches_at_its_place(&shop);
    kerf(&shop, "machine zeros set G55 -20,5,").exits(0);
    kerf(&shop, "machine zeros use G55").exits(0);
    let listed = kerf(&shop, "machine zeros").exits(0).out();
    let line = listed.lines().find(|line| line.starts_with("G55 ")).unwrap();
    let words: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(words, ["G55", "96.2", "-5", "0", "holds"]);
    keeps_zeros_behind_a_run(&shop);
    presses_stop(&session);
    kerf(&shop, "run switched.sbp --start fresh").exits(1).complains("emergency stop is pressed");
}

/// The program stops for an output: it is switched where the move before it ends.
fn switches_at_its_place(shop: &Shop) {
    let mut looks = Command::new(PYTHON);
    looks.args(["-c", LOOKS]).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut looks = looks.spawn().unwrap();
    kerf(shop, "run switched.sbp").exits(0).says("ran to its end");
    drop(looks.stdin.take());
    let told = Did::of(looks.wait_with_output().unwrap()).exits(0).out();
    let seen: Vec<Vec<f64>> = told
        .lines()
        .map(|line| line.replace("True", "1").replace("False", "0"))
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect())
        .collect();
    let (rpm, inch) = (9000.0, 25.4);
    let expected =
        [[0.0, rpm, 0.0], [1.0, rpm, inch], [0.0, rpm, 2.0 * inch], [0.0, 0.0, 3.0 * inch]];
    assert_eq!(seen.len(), expected.len(), "{told}");
    for (seen, expected) in seen.iter().zip(expected) {
        assert!(seen.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.01), "{told}");
    }
}

/// A zero point of a system that does not hold, changed behind a run while the connection stays, is told as it is.
fn keeps_zeros_behind_a_run(shop: &Shop) {
    let console = Console::begin(shop, &["--machine", "linuxcnc:local"]);
    let comes = |path: &str, mm: f64| {
        let begin = Instant::now();
        let is_there = || {
            let told = console.ask("GET /api/state", "");
            told.pointer(path).and_then(serde_json::Value::as_f64).is_some_and(|at| close(at, mm))
        };
        while !is_there() {
            assert!(begin.elapsed() < Duration::from_secs(60), "{path} does not come to {mm}");
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    console.carry_out("MX,1");
    comes("/motion/at/machine/0", 25.4 + 96.2);
    let lease = console.ask("GET /api/state", "")["lease"]["number"].clone();
    let lies = r#"{"to":"lies","at":[10,null,null,null,null,null]}"#;
    let body = format!("{{\"lease\":{lease},\"name\":\"G57\",\"change\":{lies}}}");
    let begin = Instant::now();
    // The command is over a moment after it stands.
    while console.answer("POST /api/do/zero", &body).0 != 200 {
        assert!(begin.elapsed() < Duration::from_secs(60), "it stays at work");
        std::thread::sleep(Duration::from_millis(50));
    }
    comes("/zeros/3/at/0", 10.0);
}

fn presses_stop(session: &Session) {
    let mut hal = Command::new("halcmd");
    hal.args(["setp", "button.in1", "0"])
        .env("RTAPI_FIFO_PATH", session.folder.path().join("fifo"));
    assert!(hal.status().unwrap().success());
    assert!(Command::new(PYTHON).args(["-c", STOPPED]).status().unwrap().success());
}
