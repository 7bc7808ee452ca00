//! Finds, before anything moves, what a program asks for that a controller does not have.

use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_machine::Actuator;
use kerf_machine::driver::Facts;
use kerf_machine::lines::Output;
use kerf_program::{Axes, Axis, Gauge, HeightLaw, OutputReason, SpindleTurn};
use kerf_trace::{Event, ExecutedMove, Sink, event::MoveEvent};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The mend of a file that leads beyond what the controller reaches.
const OUT_OF_REACH: &str = "change the file, or where its zero lies";

/// Looks at a dry run of the program.
#[derive(Clone, Debug)]
pub struct Lacks {
    name: String,
    facts: Facts,
    /// A place of the machine less that of the controller.
    offset: Axes,
    /// File of the last move.
    file: Arc<str>,
    line: u32,
    seen: BTreeSet<String>,
    found: Vec<Diagnostic>,
}

/// Tells why a controller cannot go to a place.
pub(super) fn out_of_reach(facts: &Facts, from: Axes, to: Axes, offset: Axes) -> Option<String> {
    let lacks =
        Axis::ALL.into_iter().find(|axis| axis.index() >= facts.axes && from[*axis] != to[*axis]);
    if let Some(axis) = lacks {
        return Some(format!("has no axis {}", axis.letter()));
    }
    let place = to.minus(offset);
    Axis::ALL.into_iter().find_map(|axis| {
        let (low, high) = facts.travel_mm[axis.index()]?;
        let outside = from[axis] != to[axis] && !(low..=high).contains(&place[axis]);
        let (letter, at) = (axis.letter(), place[axis]);
        outside.then(|| format!("ends at {letter} {low:.3} … {high:.3}: {letter} would go to {at:.3}, its own places"))
    })
}

impl Lacks {
    /// Looks for what a controller lacks that stands at a place of the machine.
    pub fn new(name: &str, facts: &Facts, offset: Axes) -> Self {
        let (name, facts) = (name.to_owned(), facts.clone());
        let (file, seen, found) = (Arc::default(), BTreeSet::new(), Vec::new());
        Self { name, facts, offset, file, line: 0, seen, found }
    }

    /// Returns the controller's facts.
    pub const fn facts(&self) -> &Facts {
        &self.facts
    }

    /// Returns what it lacks, and what it does slower.
    pub fn found(self) -> Vec<Diagnostic> {
        self.found
    }

    /// The machine of the job is a plasma table or a laser.
    pub fn burns(&mut self, plasma: bool) {
        let torch = Output::Cut1.number();
        let burns = if plasma { has(&self.facts, torch) } else { self.facts.follows_speed };
        if !burns {
            let what = "has no output for a torch or a beam: it drives machines with a spindle";
            self.tell(Severity::Error, what);
        }
    }

    /// The job follows a sheet by a law.
    pub fn follows(&mut self, law: &HeightLaw) {
        if !self.facts.follows(law) {
            let what = match law.gauge {
                Gauge::Proportional { .. } => "has no height control by readings",
                Gauge::Simple { .. } => {
                    "has no height control by two switches, inputs 17 (zhigh) and 20 (zlow)"
                }
            };
            self.tell(Severity::Error, what);
        }
    }

    fn tell(&mut self, severity: Severity, what: &str) {
        self.tells(severity, what, "");
    }

    /// Tells something once, and how it is mended.
    fn tells(&mut self, severity: Severity, what: &str, hint: &str) {
        if self.seen.insert(what.to_owned()) {
            let place = SourcePlace::line(self.file.clone(), self.line);
            let told = Diagnostic::new(Code::Controller, place, format!("{} {what}", self.name));
            self.found.push(told.severity(severity).hint(hint));
        }
    }

    fn moves(&mut self, event: &MoveEvent) {
        (self.file, self.line) = (event.file.clone(), event.line);
    }

    fn is_slower(&mut self, made: &ExecutedMove<'_>) {
        let (from, to, seconds) = (
            made.span.made.from,
            made.span.made.to,
            made.span.made.length_mm / made.span.made.top_mm_s(),
        );
        for axis in Axis::ALL {
            let Some(most) = self.facts.speed_mm_s[axis.index()] else { continue };
            let wanted = (to[axis] - from[axis]).abs() / seconds;
            let letter = axis.letter();
            // A hundredth is the rounding of units.
            if wanted > most * 1.01 && self.seen.insert(format!("slow {letter}")) {
                let what = format!(
                    "moves {letter} at {most:.1} mm/s at most, the program asks for {wanted:.1}"
                );
                self.tell(Severity::Warning, &what);
            }
        }
    }
}

/// Returns `true` if the controller lacks an output that a program needs. It does not need a light that is on while
/// something moves.
pub(super) fn needs(facts: &Facts, number: u8, why: OutputReason) -> bool {
    is_missing(facts, number) && why != OutputReason::Motion
}

fn is_missing(facts: &Facts, number: u8) -> bool {
    wired(facts, number).is_some_and(|line| !has(facts, line))
}

/// Tells whether a controller has an output.
fn has(facts: &Facts, line: u8) -> bool {
    lines(facts.outputs).any(|own| own == line)
}

/// Tells in words that a controller lacks an output, and which ones it has.
pub(super) fn no_output(facts: &Facts, number: u8) -> String {
    if wired(facts, number) == Some(1) && !facts.no_spindle.is_empty() {
        return format!("has no spindle: {}", facts.no_spindle);
    }
    format!("has no output {number}, but {}", listed(facts.outputs))
}

/// Tells in words that a controller lacks a PWM channel, and which ones it has.
pub(super) fn no_channel(facts: &Facts, channel: u8) -> String {
    format!("has no PWM channel {channel}, but {}", shown(lines(facts.pwm).map(|n| n.to_string())))
}

/// Names of the outputs that have a line of their own in every controller.
const NAMED: [(u8, &str); 3] = [(1, "spindle"), (2, "flood"), (3, "mist")];

/// The name of an output of a controller, where it has one.
pub fn output_name(line: u8) -> Option<&'static str> {
    NAMED.iter().find(|(named, _)| *named == line).map(|(_, name)| *name)
}

/// The output of a controller with a name.
pub fn output_of_name(word: &str) -> Option<u8> {
    NAMED.iter().find(|(_, name)| name.eq_ignore_ascii_case(word)).map(|(line, _)| *line)
}

/// The lines of a set of outputs or inputs, a bit each, line 1 lowest.
pub fn lines(bits: u32) -> impl Iterator<Item = u8> {
    (1..=u32::BITS as u8).filter(move |line| bits & (1 << (line - 1)) != 0)
}

/// Outputs by number, with the names that they have.
pub(super) fn listed(outputs: u32) -> String {
    shown(lines(outputs).map(|line| match output_name(line) {
        Some(name) => format!("{line} ({name})"),
        None => line.to_string(),
    }))
}

fn shown(names: impl Iterator<Item = String>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

/// The controller's line for an output of the machine: that of its own number, where it has one. The router of a job is its
/// spindle; signals for other machines, and what follows the first tool up and down, it can do without.
pub fn wired(facts: &Facts, number: u8) -> Option<u8> {
    if has(facts, number) {
        return Some(number);
    }
    match Output::of_number(number) {
        Some(Output::Router) => Some(1),
        Some(Output::JobRunning | Output::Jig1 | Output::Jig2) => None,
        Some(Output::Tool1 | Output::Cut1) => None,
        _ => Some(number),
    }
}

/// Tells whether an output follows the first tool up and down.
fn is_followed(number: u8) -> bool {
    matches!(Output::of_number(number), Some(Output::Tool1 | Output::Cut1))
}

impl Sink for Lacks {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Move(made) => self.moves(made),
            Event::Arc(arc) => self.moves(&arc.made),
            Event::Start { file, .. } => self.file = file.clone(),
            Event::Output { n, on: true, name: Some(name), .. }
                if is_followed(*n) && !has(&self.facts, *n) =>
            {
                let what = format!("has no output {n} ({name}): it is left out");
                self.tell(Severity::Warning, &what);
            }
            Event::Output { n, on: true, why, .. } if is_missing(&self.facts, *n) => {
                let what = no_output(&self.facts, *n);
                if *why == OutputReason::Motion {
                    self.tell(Severity::Note, &format!("{what}: it is left out"));
                } else {
                    self.tell(Severity::Error, &what);
                }
            }
            Event::Independent { speed, frequency, .. } if *speed != 0.0 || *frequency != 0.0 => {
                self.tell(
                    Severity::Error,
                    "has no axis that moves by itself (MI), and no torch that moves Z (VH)",
                );
            }
            Event::Pwm { channel, percent, .. } if *percent > 0.0 && self.facts.pwm != 0 => {
                if !lines(self.facts.pwm).any(|own| own == *channel) {
                    self.tell(Severity::Error, &no_channel(&self.facts, *channel));
                }
            }
            other => {
                let beam = matches!(
                    other,
                    Event::Intensity { .. } | Event::Turn { turn: SpindleTurn::Dynamic, .. }
                );
                let set = set_by(other).filter(|_| !(beam && self.facts.follows_speed));
                if let Some(what) = set.as_ref().and_then(lacked) {
                    self.tell(Severity::Error, &format!("has no {what}"));
                }
            }
        }
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        let (from, to) = (made.span.made.from, made.span.made.to);
        if let Some(why) = out_of_reach(&self.facts, from, to, self.offset) {
            self.tells(Severity::Error, &why, OUT_OF_REACH);
        }
        self.is_slower(made);
    }
}

/// Returns the actuator that an event sets, as far as machines may lack it.
fn set_by(event: &Event) -> Option<Actuator> {
    Some(match *event {
        Event::Output { n: number, on, why, .. } => Actuator::Output { number, on, why },
        Event::Pwm { channel, percent, .. } => Actuator::Pwm { channel, percent },
        Event::Intensity { byte, .. } => Actuator::Intensity { byte },
        Event::Turn { turn, .. } => Actuator::Turn(turn),
        _ => return None,
    })
}

/// Names what an actuator asks for and no controller has that is driven move by move.
pub(super) fn lacked(actuator: &Actuator) -> Option<&'static str> {
    match *actuator {
        Actuator::Output { on: true, why: OutputReason::Trigger, .. } => {
            Some("output that switches within a move (VC)")
        }
        Actuator::Pwm { percent, .. } if percent > 0.0 => Some("PWM output"),
        Actuator::Intensity { byte } if byte > 0 => Some("intensity output"),
        Actuator::Turn(SpindleTurn::Counterclockwise) => Some("spindle that turns the other way"),
        Actuator::Turn(SpindleTurn::Dynamic) => Some("laser whose power follows the speed"),
        _ => None,
    }
}
