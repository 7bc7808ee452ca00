//! The process is killed at any instant; the run is taken up again and the cut is the same.
//!
//! KERF_KILLS says how many times (`make soak` runs 1,000). The seed of a failure is printed;
//! KERF_SEED runs it again, though the instant of a kill is never exactly the same.

#![cfg(unix)]

use crate::shop::Shop;
use serde_json::Value;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Something that runs long enough to be killed.
struct Subject {
    /// Arguments of `kerf run`.
    run: &'static str,
    /// The files.
    shop: fn() -> Shop,
    /// Moves that have to be the same however often it is killed.
    moves: fn(&[Value]) -> Vec<String>,
    /// Fewer moves would prove nothing.
    at_least: usize,
    /// State that is left behind.
    left: fn(&Shop) -> String,
}

const PART: Subject = Subject {
    run: "run parts/a.sbp --answers answers",
    shop: part_shop,
    moves,
    at_least: 1400,
    left: left_by_part,
};

const JOB: Subject = Subject {
    run: "run job.svg --config machine.toml --answers answers",
    shop: job_shop,
    moves: cuts,
    at_least: 1400,
    left: left_by_job,
};

/// Part file with every kind of step: jogs, cuts, arcs, a called file, a question, a file that is written, values
/// that stay, outputs, a pause, a loop.
const PART_TEXT: &str = "SA
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

/// A drawing of flowers, each of arcs and short lines, and a job that is cut in three passes, twice, with
/// every delay and output of a router.
fn job_shop() -> Shop {
    let mut paths = String::new();
    for n in 0..12 {
        let (x, y) = (f64::from(n % 4) * 60.0 + 30.0, f64::from(n / 4) * 60.0 + 30.0);
        paths += &format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"6\"/><path d=\"M {} {y}", x + 20.0);
        for i in 1..=60 {
            let turn = f64::from(i) * std::f64::consts::TAU / 60.0;
            let r = 15.0 + 5.0 * (5.0 * turn).cos();
            paths += &format!(" L {:.3} {:.3}", x + r * turn.cos(), y + r * turn.sin());
        }
        paths += " Z\"/>";
    }
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"240mm\" height=\"180mm\" \
         viewBox=\"0 0 240 180\">{paths}</svg>"
    );
    let machine = include_str!("../../../docs/figures/timing-router.toml").to_owned()
        + "\n[job]\nrepeats = 2\nchange_origin_at_start = true\n[misc]\ndouble_start = true\n";
    Shop::new(&[("job.svg", &svg), ("machine.toml", &machine), ("answers", "pause=continue\n")])
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

/// The cuts in the plane of a trace: kind, shape, where to. Whatever leads there may differ.
fn cuts(events: &[Value]) -> Vec<String> {
    let mut at = Value::Null;
    let mut found = Vec::new();
    for e in events.iter().filter(|e| e["e"] == "move" || e["e"] == "arc") {
        let to = &e["to"];
        // The first move of a run that begins or is taken up is never a cut in the plane.
        let flat = !at.is_null() && (&at["x"], &at["y"]) != (&to["x"], &to["y"]);
        let flat = flat || e["e"] == "arc";
        if e["kind"] == "cut" && flat {
            found.push(format!("{} {to}", e["line"]));
        }
        at = to.clone();
    }
    found
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

fn part_shop() -> Shop {
    Shop::new(&[("parts/a.sbp", PART_TEXT), ("parts/sub.sbp", &sub()), ("answers", "input=.4\n")])
}

fn begin(shop: &Shop, what: &str, trace: &str) -> Child {
    let args = format!("{what} --quiet --trace {trace}");
    let mut command = shop.command();
    command.args(args.split_whitespace()).stdout(Stdio::null()).stderr(Stdio::piped());
    command.spawn().unwrap()
}

/// Death of a process that did not finish its work.
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

/// Location at which the machine stands.
fn location(shop: &Shop) -> String {
    let mut send = shop.command();
    let out = send
        .args(["send", "--quiet", "&x=%(1)", "PRINT &x;\" \";%(2);\" \";%(3)"])
        .output()
        .unwrap();
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).unwrap()
}

/// The location, in the zero points of part files.
fn left_by_job(shop: &Shop) -> String {
    location(shop)
}

/// The file, the values, the location.
fn left_by_part(shop: &Shop) -> String {
    let values = ["uValue", "$PASSES"].map(|key| shop.kerf(&format!("registry get {key}")).out());
    format!("{}{values:?} {}", shop.read("parts/done.txt"), location(shop))
}

/// A subject and what a run of it does that nobody kills.
struct Whole {
    subject: Subject,
    made: Vec<String>,
    left: String,
    takes: Duration,
}

impl Whole {
    fn of(subject: Subject) -> Self {
        let shop = (subject.shop)();
        let begun = Instant::now();
        begin(&shop, subject.run, "whole").wait().unwrap();
        let takes = begun.elapsed();
        let made = (subject.moves)(&trace(&shop, "whole"));
        assert!(made.len() > subject.at_least, "{}", made.len());
        Self { made, left: (subject.left)(&shop), takes, subject }
    }

    /// Number of moves of the whole that are made when these follow on that many.
    fn follow(&self, seen: usize, made: &[String], seed: u64) -> usize {
        if made.is_empty() {
            return seen;
        }
        let from = (0..=seen).rev().find(|from| self.made[*from..].starts_with(made));
        let from = from.unwrap_or_else(|| {
            let (made, seen) = (&made[..made.len().min(5)], &self.made[seen.saturating_sub(3)..]);
            panic!("seed {seed}: {made:#?}\ndoes not follow\n{:#?}", &seen[..seen.len().min(5)])
        });
        seen.max(from + made.len())
    }

    /// Tells how many processes were killed and how many runs were taken up again in the middle.
    fn survives(&self, seed: u64) -> [u32; 2] {
        let mut count = [0; 2];
        let mut dice = Dice(seed);
        let shop = (self.subject.shop)();
        let mut seen = 0;
        let resume = "run --resume --answers answers";
        let mut what = self.subject.run;
        for attempt in 0.. {
            let name = format!("t{attempt}");
            let child = begin(&shop, what, &name);
            let after = self.takes.mul_f64(dice.roll() * 1.1);
            let died = if attempt < 3 { kill(child, after) } else { ended(child) };
            let events = trace(&shop, &name);
            let anew = what == self.subject.run;
            let taken_up = anew || events.iter().any(|e| e["e"] == "resume");
            if taken_up {
                let made = (self.subject.moves)(behind_reentry(&events));
                seen = self.follow(seen, &made, seed);
            }
            count[0] += u32::from(matches!(died, Some(Death::Killed)));
            count[1] += u32::from(taken_up && !anew);
            what = match died {
                Some(Death::Killed) => resume,
                // It was over when it was killed, or had not begun.
                Some(Death::NothingToResume) if seen == self.made.len() => break,
                Some(Death::NothingToResume) => self.subject.run,
                None => break,
            };
        }
        assert_eq!(seen, self.made.len(), "seed {seed}");
        assert_eq!((self.subject.left)(&shop), self.left, "seed {seed}");
        count
    }
}

fn check(subject: Subject, usual_kills: u64) {
    let whole = Whole::of(subject);
    let number = |name: &str, usual: u64| {
        std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(usual)
    };
    let (first, kills) = (number("KERF_SEED", 1), number("KERF_KILLS", usual_kills));
    let [mut killed, mut taken_up] = [0; 2];
    for seed in first.. {
        let [more, again] = whole.survives(seed);
        (killed, taken_up) = (killed + more, taken_up + again);
        if u64::from(killed) >= kills {
            break;
        }
    }
    eprintln!("{killed} processes killed, {taken_up} runs taken up in the middle");
}

#[test]
fn a_run_that_is_killed_is_taken_up_and_cuts_the_same() {
    check(PART, 40);
}

#[test]
fn a_job_that_is_killed_is_taken_up_and_cuts_the_same() {
    check(JOB, 30);
}
