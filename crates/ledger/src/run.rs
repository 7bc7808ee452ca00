//! A program that ran, read from its trace, and the claims tests make about it.
//!
//! Every claim panics at the test's line when it does not hold, and returns the run so that claims
//! can follow each other.

use crate::read::{events, line_of, location, number, text};
use kerf_program::rounded;
use kerf_workspace::Workspace;
use serde_json::Value;

/// Locations in inches or millimetres agree within this (ledger convention: 0.0005 in).
const LOCATION: f64 = 0.0005;

/// The axes of a location in the trace.
const AXES: [&str; 6] = ["x", "y", "z", "a", "b", "c"];

/// A program that ran.
#[derive(Debug)]
pub struct Run {
    events: Vec<Value>,
    start: [f64; 6],
    workspace: Workspace,
}

impl Run {
    /// Reads a trace that began at a working location; the workspace holds what the run left.
    pub fn new(trace: &str, start: [f64; 6], workspace: Workspace) -> Self {
        Self { events: events(trace), start, workspace }
    }

    /// Returns the text that a file in the part folder holds now.
    #[track_caller]
    pub fn file(&self, name: &str) -> String {
        self.workspace.text(name).unwrap_or_else(|| panic!("there is no file {name}\n{self}"))
    }

    /// The events of one kind, in order.
    pub fn events<'a>(&'a self, kind: &'a str) -> impl Iterator<Item = &'a Value> {
        self.events.iter().filter(move |event| event["e"] == kind)
    }

    /// The working location at the end.
    pub fn location(&self) -> [f64; 6] {
        let mut here = self.start;
        for event in &self.events {
            if event["e"] == "units" {
                let factor = if event["units"] == "mm" { 25.4 } else { 1.0 / 25.4 };
                here[..3].iter_mut().for_each(|value| *value *= factor);
            }
            let moved = if event["e"] == "location" { &event["set"] } else { &event["to"] };
            for (axis, value) in AXES.iter().zip(&mut here) {
                *value = moved[axis].as_f64().unwrap_or(*value);
            }
        }
        here
    }

    /// The event that closes the trace.
    pub fn end(&self) -> &Value {
        let last = self.events.last();
        last.filter(|event| event["e"] == "end").expect("the trace has an end")
    }

    /// The run came to its end, and the tool stands here: the first axes of the working location.
    #[track_caller]
    pub fn ends_at<const N: usize>(&self, expected: [f64; N]) -> &Self {
        self.is_ok();
        self.stands_at(expected)
    }

    /// The tool stands here, however the run ended.
    #[track_caller]
    pub fn stands_at<const N: usize>(&self, expected: [f64; N]) -> &Self {
        let here = self.location();
        assert!(near(&here, &expected), "ends at {here:?}, expected {expected:?}\n{self}");
        self
    }

    /// The run came to its end without an error.
    #[track_caller]
    pub fn is_ok(&self) -> &Self {
        let status = &self.end()["status"];
        assert!(status == "ok" || status == "ended", "status {status}\n{self}");
        self
    }

    /// The run ended with this status of the trace.
    #[track_caller]
    pub fn status(&self, expected: &str) -> &Self {
        assert_eq!(self.end()["status"], expected, "\n{self}");
        self
    }

    /// Moves and arcs end at these places, in this order.
    #[track_caller]
    pub fn visits<const N: usize>(&self, expected: &[[f64; N]]) -> &Self {
        let moves = self.events.iter().filter(|e| e["e"] == "move" || e["e"] == "arc");
        let found: Vec<[f64; 6]> = moves.map(|event| location(&event["to"])).collect();
        let same = found.len() == expected.len()
            && found.iter().zip(expected).all(|(found, expected)| near(found, expected));
        assert!(same, "visits {found:?}, expected {expected:?}\n{self}");
        self
    }

    /// The print window shows exactly these lines.
    #[track_caller]
    pub fn prints(&self, expected: &[&str]) -> &Self {
        let lines: Vec<&str> = self.events("print").map(|event| text(event, "text")).collect();
        assert_eq!(lines, expected, "\n{self}");
        self
    }

    /// The operator is shown exactly these messages.
    #[track_caller]
    pub fn shows(&self, expected: &[&str]) -> &Self {
        let shown: Vec<&str> = self.events("message").map(|event| text(event, "text")).collect();
        assert_eq!(shown, expected, "\n{self}");
        self
    }

    /// The operator is asked exactly this, in order.
    #[track_caller]
    pub fn asks(&self, expected: &[&str]) -> &Self {
        let asked: Vec<&str> = self.events("ask").map(|event| text(event, "text")).collect();
        assert_eq!(asked, expected, "\n{self}");
        self
    }

    /// An output is switched like this: on or off and why, in order.
    #[track_caller]
    pub fn switches(&self, output: u8, expected: &[(bool, &str)]) -> &Self {
        let events = self.events("output").filter(|event| event["n"] == output);
        let found: Vec<(bool, &str)> =
            events.map(|event| (event["on"] == true, text(event, "why"))).collect();
        assert_eq!(found, expected, "\n{self}");
        self
    }

    /// The run fails with an error of this code at this line.
    #[track_caller]
    pub fn fails(&self, line: u64, code: &str) -> &Self {
        assert_eq!(self.end()["status"], "failed", "\n{self}");
        self.tells("error", line, code)
    }

    /// An error of this code points to this line; the run goes on.
    #[track_caller]
    pub fn errs(&self, line: u64, code: &str) -> &Self {
        self.tells("error", line, code)
    }

    /// A warning of this code points to this line.
    #[track_caller]
    pub fn warns(&self, line: u64, code: &str) -> &Self {
        self.tells("warning", line, code)
    }

    /// Since the machine was switched on the first motors have made so many steps.
    #[track_caller]
    pub fn steps(&self, expected: &[i64]) -> &Self {
        let steps = self.end()["steps"].as_array().expect("the end tells steps");
        let steps: Vec<i64> = steps.iter().filter_map(Value::as_i64).collect();
        assert_eq!(steps[..expected.len()], *expected, "\n{self}");
        self
    }

    /// Nothing is said about the program.
    #[track_caller]
    pub fn is_silent(&self) -> &Self {
        assert_eq!(self.events("diag").count(), 0, "\n{self}");
        self
    }

    #[track_caller]
    fn tells(&self, severity: &str, line: u64, code: &str) -> &Self {
        let mut diagnostics = self.events("diag");
        let told = diagnostics
            .any(|d| d["severity"] == severity && d["code"] == code && line_of(d) == line);
        assert!(told, "no {severity} {code} at line {line}\n{self}");
        self
    }

    /// A message of a diagnostic holds this text.
    #[track_caller]
    pub fn says(&self, part: &str) -> &Self {
        let said = self.events("diag").any(|d| text(d, "message").contains(part));
        assert!(said, "no message says {part:?}\n{self}");
        self
    }

    /// A value that the run keeps under a key.
    pub fn stored(&self, key: &str) -> Option<String> {
        self.workspace.stored.get(key).map(str::to_owned)
    }

    /// Returns the time that the run takes in machine time, seconds.
    pub fn seconds(&self) -> f64 {
        number(self.end(), "t")
    }

    /// From X to X of each level move at this height: the tops of tabs.
    pub fn tops(&self, z: f64) -> Vec<[f64; 2]> {
        let ends = self.events("move").map(|event| location(&event["to"]));
        let ends: Vec<[f64; 6]> = ends.collect();
        let level = |end: &[f64; 6]| (end[2] - z).abs() < LOCATION;
        let pairs = ends.windows(2).filter(|pair| level(&pair[0]) && level(&pair[1]));
        pairs.map(|pair| [rounded(pair[0][0], 4), rounded(pair[1][0], 4)]).collect()
    }

    /// The run takes this long in machine time, seconds, within a thousandth.
    #[track_caller]
    pub fn lasts(&self, seconds: f64) -> &Self {
        let found = self.seconds();
        assert!((found - seconds).abs() < 1e-3, "lasts {found} s, expected {seconds}\n{self}");
        self
    }
}

impl std::fmt::Display for Run {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.events.iter().try_for_each(|event| writeln!(f, "  {event}"))
    }
}

fn near(found: &[f64], expected: &[f64]) -> bool {
    found.iter().zip(expected).all(|(a, b)| (a - b).abs() < LOCATION)
}
