//! Turns values of the machine half into those of the messages to pages.

use crate::machine::ports;
use kerf_control::Session;
use kerf_control::controller::Controller;
use kerf_diag::{Diagnostic, Severity};
use kerf_digitize::{Digitizer, Dimension, Kind};
use kerf_journal::JournalError;
use kerf_machine::Configuration;
use kerf_machine::driver::Facts;
use kerf_machine::lines::Input;
use kerf_model::Model;
use kerf_program::settings::{AxisUnit, Distance, IoModes, LinearUnit, PerGroup};
use kerf_program::{Axes, Axis, Frame, Settings};
use kerf_sbp::Status;
use kerf_trace::Summary;
use kerf_wire::{
    AxisUnits, Digitized, DigitizedPoint, Duty, HeightMap, Io, LAMPS, Lamp, Message, Mode,
    NamedValue, NumberedTool, Offers, Pace, Positions, RunSummary, Speeds, Tone, ToolTable, Units,
};
use kerf_workspace::Workspace;

/// Returns the height map in force. One that is damaged is told by each run.
pub fn height_map(workspace: &Workspace) -> Option<HeightMap> {
    let map = kerf_workspace::height_map::height_map(workspace).ok().flatten()?;
    let (xs, ys, zs) = map.grid();
    Some(HeightMap::of(xs, ys, zs))
}

/// Returns the tools that are known by their numbers.
pub fn tools(session: &Session, workspace: &Workspace) -> ToolTable {
    let tool = |(number, tool): (&u32, &kerf_program::Tool)| NumberedTool {
        number: *number,
        name: tool.name.as_deref().unwrap_or_default().to_owned(),
        diameter: tool.diameter_mm,
        length: tool.offset[Axis::Z],
        measured: tool.measured,
    };
    ToolTable {
        tools: session.gcode.tools.iter().map(tool).collect(),
        in_spindle: session.gcode.tool,
        has_sensor: session.memory.settings.tool_changes.sensor_input.is_some()
            || workspace.stored.get("$tool_sensor").is_some_and(|input| !input.is_empty()),
        finds_home: session.homes(&session.machine_is).contains(Axis::Z),
    }
}

/// The points that are being digitized, which count from the job origin.
pub fn digitized(points: &Digitizer, origin: [f64; 2]) -> Digitized {
    let point = |point: &kerf_digitize::Point| DigitizedPoint {
        at: [point.stand.at.x, point.stand.at.y, point.stand.z_mm],
        arc: point.kind == Kind::Arc,
    };
    Digitized {
        origin,
        points: points.points().iter().map(point).collect(),
        bulges: points.segments().iter().map(kerf_geom::Segment::bulge).collect(),
        current: points.current() as u32,
        three_d: points.dimension() == Dimension::Three,
        next_arc: points.next() == Kind::Arc,
        unsaved: points.is_unsaved(),
    }
}

/// Tells how a run ended, for whoever waits for it: why, when it did not come to its end.
/// Nothing more is told of one that did.
pub fn outcome(driven: &Result<Summary, JournalError>) -> Result<String, String> {
    let summary = driven.as_ref().map_err(ToString::to_string)?;
    match (&summary.error, summary.status) {
        (Some(error), _) => Err(error.message.clone()),
        (None, Status::Ok | Status::Ended) => Ok(String::new()),
        (None, status) => Err(status.word().into()),
    }
}

/// Returns the summary of a run.
pub fn summary(summary: &Summary) -> RunSummary {
    let tally = &summary.tally;
    let bounds = (!tally.bounds.is_empty()).then_some([tally.bounds.min, tally.bounds.max]);
    RunSummary {
        seconds: summary.taken_s.unwrap_or(summary.seconds),
        lines: summary.lines,
        moves: tally.moves,
        arcs: tally.arcs,
        cut_mm: tally.cut_mm,
        jog_mm: tally.jog_mm,
        bounds,
        millimetres: summary.unit == LinearUnit::Mm,
    }
}

/// A place in every frame.
pub fn positions(frame: &Frame, machine: Axes) -> Positions {
    Positions { working: frame.working(machine).0, base: frame.base(machine).0, machine: machine.0 }
}

/// Returns the effect of running a file: SP draws only, SM moves.
pub const fn mode(session: &Session) -> Mode {
    match &session.driven_by {
        _ if session.memory.before_preview.is_some() => Mode::Preview,
        Some(_) => Mode::Cut,
        None => Mode::Simulated,
    }
}

/// Returns the name of the machine, for its chip.
pub fn machine_name(session: &Session) -> String {
    session.driven_by.as_ref().map_or_else(|| "simulated".to_owned(), |it| it.name.clone())
}

/// Returns what a page may do to a machine beside moving it.
pub const fn offers(facts: &Facts) -> Offers {
    Offers { inputs: facts.inputs_by_hand, card: facts.card, start_arms: facts.harmless }
}

/// Returns the factor that runs on a controller have shown; nothing before the first.
pub fn pace(controller: &Controller) -> Option<Pace> {
    let learned = controller.learned().filter(|learned| learned.runs() > 0)?;
    Some(Pace { factor: learned.factor(), runs: learned.runs() })
}

/// Returns the units in which a person reads lengths.
pub fn units(settings: &Settings) -> Units {
    let axes = Axis::ALL.into_iter().map(|axis| axis_units(settings, axis)).collect();
    Units {
        linear: settings.linear_unit.symbol().into(),
        mm: settings.linear_unit.mm(),
        axes,
        absolute: settings.distance == Distance::Absolute,
    }
}

fn axis_units(settings: &Settings, axis: Axis) -> AxisUnits {
    let unit = match settings.axis_unit(axis) {
        AxisUnit::Linear(LinearUnit::Inch) => "in",
        AxisUnit::Linear(LinearUnit::Mm) => "mm",
        AxisUnit::Degrees => "deg",
    };
    AxisUnits {
        letter: axis.letter(),
        unit: unit.into(),
        scale: settings.axis_scale(axis),
        used: axis.index() < usize::from(settings.axis_count),
    }
}

/// Speeds in force; that of the spindle is not known here.
pub fn speeds(settings: &Settings) -> Speeds {
    let list = |s: &PerGroup| [s.xy, s.z, s.a, s.b, s.c];
    Speeds { cut_mm_s: list(&settings.speeds.cut), jog_mm_s: list(&settings.speeds.jog), rpm: 0.0 }
}

/// Inputs and outputs as they are at a moment of what the machine does, after others.
pub fn io(machine: &Model, t_s: f64, is: &Configuration, before: &Io) -> Io {
    let reads = machine.inputs_at(t_s);
    let output = |number| {
        let (on, label) = (machine.outputs().is_on(number), String::new());
        Lamp { number, on, label, duty: Duty::Standard }
    };
    Io {
        inputs: (1..=LAMPS as u8).map(|number| input(machine, &reads, number)).collect(),
        outputs: (1..=LAMPS as u8).map(output).collect(),
        ports: ports(machine, &reads, &before.ports),
        forbidden: forbidden(&reads, &machine.settings().io, is),
    }
}

/// The mend that is needed before anything moves, where a pressed stop forbids motion.
pub fn forbidden(
    reads: impl Fn(u8) -> bool,
    modes: &IoModes,
    is: &Configuration,
) -> Option<String> {
    if reads(Input::EmergencyStop.number()) == is.estop.active {
        return Some("release the emergency stop".into());
    }
    let stops = modes.stop_inputs().find(|number| modes.stops(*number, reads(*number)));
    stops.map(|number| format!("release stop input {number}"))
}

/// An input with what it reads, whichever of the lines it is.
pub fn input(machine: &Model, reads: impl Fn(u8) -> bool, number: u8) -> Lamp {
    let duty = match kerf_model::duty(number, &machine.settings().io) {
        kerf_model::Duty::Free => Duty::Standard,
        kerf_model::Duty::Limit => Duty::Limit,
        kerf_model::Duty::Stop | kerf_model::Duty::Cable | kerf_model::Duty::Stall => Duty::Stop,
    };
    let label = Input::of_number(number).map_or("", |line| line.name());
    Lamp { number, on: reads(number), label: label.into(), duty }
}

/// Values with their names.
pub fn named(values: impl IntoIterator<Item = (String, String)>) -> Vec<NamedValue> {
    values.into_iter().map(|(name, value)| NamedValue { name, value }).collect()
}

/// Returns the tone in which a diagnostic is told.
pub const fn tone(found: &Diagnostic) -> Tone {
    match found.severity {
        Severity::Error => Tone::Error,
        Severity::Warning => Tone::Warning,
        Severity::Note => Tone::Note,
    }
}

/// Returns a sentence with the way to mend it behind, where one is told.
pub fn with_hint(text: &str, hint: &str) -> String {
    if hint.is_empty() { text.into() } else { format!("{text} ({hint})") }
}

/// Returns a diagnostic as a message of no run, without its place.
pub fn message(found: &Diagnostic) -> Message {
    Message {
        tone: tone(found),
        code: found.code.as_str().into(),
        text: found.message.clone(),
        hint: found.hint.clone(),
        ..Message::default()
    }
}

/// Returns the message of a diagnostic behind its line.
pub fn at_line(Diagnostic { message, place, .. }: &Diagnostic) -> String {
    if place.line > 0 { format!("line {}: {message}", place.line) } else { message.clone() }
}

/// A diagnostic in a sentence that begins with its line.
pub fn sentence(found: &Diagnostic) -> String {
    with_hint(&at_line(found), &found.hint)
}
