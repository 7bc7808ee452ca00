//! LinuxCNC itself, where it is installed: going home, a program, zero points, outputs at their place, its emergency stop.

#[path = "../../../../tests/linuxcnc/session.rs"]
mod session;

use crate::shop::{Did, Shop};
use session::{PYTHON, Session, begins};
use std::process::{Command, Stdio};

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

fn presses_stop(session: &Session) {
    let mut hal = Command::new("halcmd");
    hal.args(["setp", "button.in1", "0"])
        .env("RTAPI_FIFO_PATH", session.folder.path().join("fifo"));
    assert!(hal.status().unwrap().success());
    assert!(Command::new(PYTHON).args(["-c", STOPPED]).status().unwrap().success());
}
