//! The process is killed at any instant; the run is taken up again and the cut is the same.
//!
//! KERF_KILLS says how many times (`make soak` runs 1,000). The seed of a failure is printed;
//! KERF_SEED runs it again, though the instant of a kill is never exactly the same.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod shop;

use serde_json::Value;
use shop::Shop;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const PART_FILE: &str = "parts/a.sbp";

/// What is cut: jogs, cuts, arcs, a called file, a question, a file that is written, values that stay,
/// outputs, a pause, a loop.
const PART: &str = "SA
JZ,.5
INPUT \"how deep\" &deep
&n = 0
SetUsrVal, 0
SO,3,1
AGAIN:
OPEN \"done.txt\" FOR APPEND AS #1
WRITE #1; \"pass \"; &n
CLOSE #1
FP,sub.sbp
CC,1,T,1
J3,0,0,.5
PAUSE .5
&n = &n + 1
$passes = &n
SetUsrVal, &n
IF &n < 12 THEN GOTO AGAIN
SO,3,0
JX,3
";

/// A zigzag that begins above and ends below.
fn sub() -> String {
    let line = |i: i32| {
        format!("M3,{:.3}+&n,{},-.{}\n", f64::from(i % 7) / 7.0, f64::from(i) / 40.0, i % 9)
    };
    "MZ,-&deep\n".to_owned() + &(0..120).map(line).collect::<String>() + "JZ,.5\n"
}

/// Numbers that look random; the same for the same seed.
struct Dice(u64);

impl Dice {
    /// A number from 0 to 1.
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }
}

/// The moves of a trace: kind, line, file, where to.
fn moves(events: &[Value]) -> Vec<String> {
    let moved = |e: &&Value| e["e"] == "move" || e["e"] == "arc";
    let told = |e: &Value| {
        let file = e["file"].as_str().unwrap().rsplit('/').next().unwrap().to_owned();
        format!("{} {file}:{} {}", e["kind"], e["line"], e["to"])
    };
    events.iter().filter(moved).map(told).collect()
}

/// The events of a trace; the last line may be cut short.
fn trace(shop: &Shop, name: &str) -> Vec<Value> {
    let text = std::fs::read_to_string(shop.file(name)).unwrap_or_default();
    text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect()
}

/// The events behind the point where the run was taken up.
fn behind_reentry(events: &[Value]) -> &[Value] {
    let at = events.iter().position(|e| e["e"] == "resume").map_or(0, |i| i + 1);
    &events[at..]
}

fn shop() -> Shop {
    Shop::new(&[("parts/a.sbp", PART), ("parts/sub.sbp", &sub()), ("answers", "input=.4\n")])
}

fn begin(shop: &Shop, what: &str, trace: &str) -> Child {
    let args = format!("run {what} --answers answers --quiet --trace {trace}");
    let mut command = shop.command();
    command.args(args.split_whitespace()).stdout(Stdio::null()).stderr(Stdio::piped());
    command.spawn().unwrap()
}

/// How a process ended that did not finish its work.
enum Death {
    Killed,
    /// It was killed before it had begun, or after it was over.
    NothingToResume,
}

/// Kills a process after a while.
fn kill(mut child: Child, after: Duration) -> Option<Death> {
    let until = Instant::now() + after;
    while Instant::now() < until {
        if child.try_wait().unwrap().is_some() {
            return ended(child);
        }
        sleep(Duration::from_micros(200));
    }
    child.kill().unwrap();
    ended(child)
}

fn ended(child: Child) -> Option<Death> {
    let output = child.wait_with_output().unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert!(!err.contains("panicked"), "{err}");
    match output.status.code() {
        Some(0) => None,
        None => Some(Death::Killed),
        Some(_) if err.contains("no run was cut short") => Some(Death::NothingToResume),
        Some(code) => panic!("ended with {code}: {err}"),
    }
}

/// What is left behind: the file, the values, the location.
fn left(shop: &Shop) -> String {
    let values = ["uValue", "$PASSES"].map(|key| shop.kerf(&format!("registry get {key}")).out());
    let mut send = shop.command();
    let out = send.args(["send", "--quiet", "PRINT %(1);\" \";%(2);\" \";%(3)"]).output().unwrap();
    let out = String::from_utf8(out.stdout).unwrap();
    format!("{}{values:?} {out}", shop.read("parts/done.txt"))
}

/// Tells how many processes were killed and how many runs were taken up again in the middle.
fn survives(seed: u64, whole: &[String], expected: &str, takes: Duration) -> [u32; 2] {
    let mut count = [0; 2];
    let mut dice = Dice(seed);
    let shop = shop();
    let mut seen = 0;
    let mut what = PART_FILE;
    for attempt in 0.. {
        let name = format!("t{attempt}");
        let child = begin(&shop, what, &name);
        let died =
            if attempt < 3 { kill(child, takes.mul_f64(dice.roll() * 1.1)) } else { ended(child) };
        let events = trace(&shop, &name);
        let taken_up = what == PART_FILE || events.iter().any(|e| e["e"] == "resume");
        let made = moves(behind_reentry(&events));
        if taken_up && !made.is_empty() {
            let from = (0..=seen).rev().find(|from| whole[*from..].starts_with(&made));
            let from = from.unwrap_or_else(|| {
                let (made, seen) = (&made[..made.len().min(5)], &whole[seen.saturating_sub(3)..]);
                panic!("seed {seed}: {made:#?}\ndoes not follow\n{:#?}", &seen[..seen.len().min(5)])
            });
            seen = seen.max(from + made.len());
        }
        count[0] += u32::from(matches!(died, Some(Death::Killed)));
        count[1] += u32::from(taken_up && what != PART_FILE);
        what = match died {
            Some(Death::Killed) => "--resume",
            // It was over when it was killed, or had not begun.
            Some(Death::NothingToResume) if seen == whole.len() => break,
            Some(Death::NothingToResume) => PART_FILE,
            None => break,
        };
    }
    assert_eq!(seen, whole.len(), "seed {seed}");
    assert_eq!(left(&shop), expected, "seed {seed}");
    count
}

#[test]
fn a_run_that_is_killed_is_taken_up_and_cuts_the_same() {
    let shop = shop();
    let begun = Instant::now();
    begin(&shop, PART_FILE, "whole").wait().unwrap();
    let takes = begun.elapsed();
    let whole = moves(&trace(&shop, "whole"));
    assert!(whole.len() > 1400, "{}", whole.len());
    let expected = left(&shop);
    let number = |name: &str, usual: u64| {
        std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(usual)
    };
    let (first, kills) = (number("KERF_SEED", 1), number("KERF_KILLS", 40));
    let [mut killed, mut taken_up] = [0; 2];
    for seed in first.. {
        let [more, again] = survives(seed, &whole, &expected, takes);
        (killed, taken_up) = (killed + more, taken_up + again);
        if u64::from(killed) >= kills {
            break;
        }
    }
    eprintln!("{killed} processes killed, {taken_up} runs taken up in the middle");
}
