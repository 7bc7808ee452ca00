//! Events of a run, as the trace has them, in the user's units.
//!
//! Names and fields are a promise of the command line (`kerf trace`); new fields and new events may
//! come, these stay. Locations are working locations in the program's units, as the display shows
//! them; times are seconds of machine time since the start.

use kerf_diag::Diagnostic;
use kerf_program::{AXES, FileOp, MoveKind, OutputReason, QuestionKind, SpindleTurn};
use kerf_sbp::Status;
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::Arc;

/// One event.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "e", rename_all = "lowercase")]
pub enum Event {
    /// The run begins.
    Start {
        /// The part file.
        file: Arc<str>,
        /// `in` or `mm`.
        units: &'static str,
        /// `preview` or `move`.
        mode: &'static str,
        /// Which reading of the language.
        dialect: &'static str,
    },
    /// A straight move was made.
    Move(MoveEvent),
    /// A circular move or a helix was made.
    Arc(ArcEvent),
    /// An output changed.
    Output {
        /// Its number.
        n: u8,
        /// Its state from now on.
        on: bool,
        /// Machine time, s.
        t: f64,
        /// Cause of the change.
        why: OutputReason,
        /// Name in jobs.
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<&'static str>,
    },
    /// An input changed.
    Input {
        /// Its number.
        n: u8,
        /// Its state from now on.
        on: bool,
        /// Machine time, s.
        t: f64,
        /// Name in jobs.
        #[serde(skip_serializing_if = "Option::is_none")]
        name: Option<&'static str>,
    },
    /// The intensity output of a laser changed.
    Intensity {
        /// Its value, 0 … 127.
        value: u8,
        /// The byte of the port: the value in its upper seven bits, the burn bit below.
        byte: u8,
        /// The parallel port, 1 or 2.
        port: u8,
        /// Length of a pulse of a pulsed laser, microseconds.
        #[serde(skip_serializing_if = "Option::is_none")]
        pulse_us: Option<f64>,
        /// Machine time, s.
        t: f64,
    },
    /// Height control took a reading.
    Height {
        /// Z of the tool, machine frame, mm.
        z: f64,
        /// Difference of the gap from the one that is wanted, mm.
        error: f64,
        /// Reading of the sensor, 0 … 255.
        reading: u8,
        /// The error is larger than the accuracy that the display is set to.
        #[serde(skip_serializing_if = "is_false")]
        off: bool,
        /// ZSurface now, machine frame, mm.
        surface: f64,
        /// ZTop now.
        top: f64,
        /// Machine time, s.
        t: f64,
    },
    /// The heights in force, machine frame, mm.
    Heights {
        /// Height at which the tool travels.
        top: f64,
        /// The surface of the material.
        surface: f64,
        /// The lowest the tool goes.
        bottom: f64,
        /// Machine time, s.
        t: f64,
    },
    /// A pause has changed what holds for the rest of a job.
    #[serde(rename = "in_force")]
    InForce {
        /// Highest cutting speed, mm/s.
        cut_mm_s: f64,
        /// Plunging speed, mm/s.
        plunge_mm_s: f64,
        /// The tool rises in pauses.
        raise: bool,
        /// Machine time, s.
        t: f64,
    },
    /// The pulse frequency of a laser was set.
    #[serde(rename = "laser_hz")]
    LaserHz {
        /// Hz.
        hz: f64,
        /// Machine time, s.
        t: f64,
    },
    /// An axis was homed.
    Homed {
        /// The axis, as people call it.
        axis: &'static str,
        /// Number of steps by which the last home was off.
        steps: i64,
        /// Machine time, s.
        t: f64,
    },
    /// The machine entered a state: `running`, `paused`, `estop`, `idle` …
    State {
        /// Its name.
        state: Arc<str>,
        /// Reason, when there is something to say.
        #[serde(skip_serializing_if = "str::is_empty")]
        why: Arc<str>,
        /// Machine time, s.
        t: f64,
    },
    /// The duty of a PWM channel changed.
    Pwm {
        /// Its number, from 1.
        channel: u8,
        /// Duty, 0 … 100.
        percent: f64,
        /// Machine time, s.
        t: f64,
        /// Pulse frequency, kHz.
        khz: f64,
    },
    /// A spindle got a speed.
    Spindle {
        /// Revolutions a minute.
        rpm: f64,
        /// Its output is on.
        on: bool,
        /// Machine time, s.
        t: f64,
        /// Its number, from 1.
        n: u8,
    },
    /// A spindle turns, which way, or stops (G-code).
    Turn {
        /// `off`, `clockwise`, `counterclockwise`, or `dynamic`: a laser whose power follows the speed.
        turn: SpindleTurn,
        /// Machine time, s.
        t: f64,
        /// Number of the spindle, from 1.
        n: u8,
    },
    /// Coolant (M7, M8, M9 of G-code).
    Coolant {
        /// Mist.
        mist: bool,
        /// Flood.
        flood: bool,
        /// Machine time, s.
        t: f64,
    },
    /// The warning light before and during motion.
    Light {
        /// Its state from now on.
        on: bool,
        /// Machine time, s.
        t: f64,
    },
    /// Power of the motors.
    Motors {
        /// Its state from now on.
        on: bool,
        /// Machine time, s.
        t: f64,
    },
    /// Somebody pushed an axis of the simulated machine by hand.
    #[serde(rename = "handmove")]
    HandMove {
        /// Its letter.
        axis: char,
        /// Distance by which it gave way; 0 while its motor holds it.
        by: f64,
        /// Machine time, s.
        t: f64,
    },
    /// Steps became coarser, or fine again (VU); locations do not change.
    Resolution {
        /// Factor of each axis, X to C.
        multipliers: [u8; AXES],
        /// Machine time, s.
        t: f64,
    },
    /// An axis began or stopped to move beside the others (MI, torch height).
    Independent {
        /// Its letter.
        axis: char,
        /// Units of the axis a second; 0 when it swings or stops.
        speed: f64,
        /// Cycles a second; 0 when it turns or stops.
        frequency: f64,
        /// Peak-to-peak displacement.
        distance: f64,
        /// Machine time, s.
        t: f64,
    },
    /// Locations were set.
    Location {
        /// Working locations that were set.
        set: Partial,
        /// Table base coordinates that were set.
        base: Partial,
        /// Machine time, s.
        t: f64,
    },
    /// The user's unit changed.
    Units {
        /// `in` or `mm`.
        units: &'static str,
        /// Machine time, s.
        t: f64,
    },
    /// Commands are only drawn from here on, or carried out again (SP, SM).
    Mode {
        /// `preview` or `move`.
        mode: &'static str,
        /// Machine time, s.
        t: f64,
    },
    /// Text for the print window. Lines are told whole.
    Print {
        /// The text.
        text: Arc<str>,
        /// Machine time, s.
        t: f64,
    },
    /// A comment or warning shown to the operator.
    Message {
        /// The text.
        text: Arc<str>,
        /// Machine time, s.
        t: f64,
    },
    /// The operator was asked.
    Ask(AskEvent),
    /// A file of the user was used.
    File {
        /// Operation on the file.
        op: FileOp,
        /// Its path.
        path: Arc<str>,
        /// Machine time, s.
        t: f64,
    },
    /// A sound was started.
    Sound {
        /// The file.
        path: Arc<str>,
        /// Machine time, s.
        t: f64,
    },
    /// The program waited.
    Wait {
        /// Length of the wait, s.
        seconds: f64,
        /// Machine time at which it began, s.
        t: f64,
    },
    /// A tool path begins.
    #[serde(rename = "toolpath")]
    ToolPath {
        /// Its name.
        name: Option<Arc<str>>,
        /// The tool.
        tool: Option<Arc<str>>,
        /// Machine time, s.
        t: f64,
    },
    /// A tool change begins or is over.
    #[serde(rename = "toolchange")]
    ToolChange {
        /// True when it begins.
        begin: bool,
        /// Machine time, s.
        t: f64,
    },
    /// The preview display was cleared.
    Clear {
        /// Machine time, s.
        t: f64,
    },
    /// Motion was stopped before its end.
    Stop {
        /// By what: `watch`, `limit`, `stop` or `operator`.
        by: &'static str,
        /// The input; 0 for the operator.
        n: u8,
        /// Machine time at which the machine stood, s.
        t: f64,
    },
    /// The operator holds the machine, which stands.
    Hold {
        /// Machine time at which it stood, s.
        t: f64,
    },
    /// The operator lets the machine go on.
    Resume {
        /// Machine time, s.
        t: f64,
    },
    /// The operator changed the feed override.
    Override {
        /// Cuts run at so much of the speed asked for, percent.
        percent: f64,
        /// Machine time, s.
        t: f64,
    },
    /// Something a person should know about the program.
    Diag(Box<Diagnostic>),
    /// The run is over.
    End(EndEvent),
}

/// Left out of the trace where it says nothing.
const fn is_false(value: &bool) -> bool {
    !*value
}

/// A straight move. Also the common part of an arc.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MoveEvent {
    /// Cut or jog.
    pub kind: MoveKind,
    /// The part file.
    pub file: Arc<str>,
    /// Its line.
    pub line: u32,
    /// Place where it ended.
    pub to: Location,
    /// Machine time at its start, s.
    pub t0: f64,
    /// Machine time at its end, s.
    pub t1: f64,
    /// Speed asked for, units a second.
    pub speed: f64,
    /// Place where it started; not part of the trace.
    #[serde(skip)]
    pub from: Location,
}

/// A circular move or a helix.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ArcEvent {
    /// Fields that it has in common with a straight move.
    #[serde(flatten)]
    pub made: MoveEvent,
    /// Its centre.
    pub centre: Centre,
    /// `cw` or `ccw`.
    pub dir: &'static str,
    /// Swept angle, degrees, positive.
    pub sweep: f64,
}

/// A location of all axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[allow(missing_docs)]
pub struct Location {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub a: f64,
    pub b: f64,
    pub c: f64,
}

impl Location {
    /// The value of an axis.
    pub fn of(&self, axis: kerf_program::Axis) -> f64 {
        [self.x, self.y, self.z, self.a, self.b, self.c][axis.index()]
    }
}

impl From<kerf_program::Axes> for Location {
    fn from(axes: kerf_program::Axes) -> Self {
        let [x, y, z, a, b, c] = axes.0;
        Self { x, y, z, a, b, c }
    }
}

/// A centre in X and Y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[allow(missing_docs)]
pub struct Centre {
    pub x: f64,
    pub y: f64,
}

/// Values of some axes, by their letter.
pub type Partial = BTreeMap<char, f64>;

/// A question and its answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AskEvent {
    /// Kind of the box.
    pub kind: QuestionKind,
    /// The text in it.
    pub text: String,
    /// Its title.
    pub title: String,
    /// The words on its buttons.
    pub buttons: Vec<&'static str>,
    /// The button that ENTER presses, or what stands in the entry field.
    pub default: String,
    /// Answer that was given.
    pub answer: String,
    /// Somebody or a script answered, not the default.
    pub scripted: bool,
    /// Machine time, s.
    pub t: f64,
    /// The part file that asks.
    pub file: Arc<str>,
    /// Its line.
    pub line: u32,
}

/// The end of a run and what it came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EndEvent {
    /// Outcome of the run.
    pub status: Status,
    /// Machine time.
    pub t: f64,
    /// Seconds that a real machine took, with holds and questions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub took: Option<f64>,
    /// Lines executed.
    pub lines: u64,
    /// Straight moves made.
    pub moves: u64,
    /// Arcs made.
    pub arcs: u64,
    /// Length of the cutting moves.
    pub cut: f64,
    /// Length of the jogs.
    pub jog: f64,
    /// Bounds of the cutting moves; nothing when nothing was cut.
    pub bounds: Option<BoundsEvent>,
    /// Steps each motor has made since the machine was switched on, driver channel 1 first.
    pub steps: [i64; AXES],
    /// Temperature of the heater, when one is controlled (VH).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heater: Option<f64>,
    /// Axes whose location should be verified: the motors had no power.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub verify: Vec<char>,
    /// Distances of axes of the simulated machine from where the controller believes them, because
    /// they were pushed by hand; nothing for those that are where they should be.
    #[serde(skip_serializing_if = "Partial::is_empty")]
    pub astray: Partial,
    /// The user's variables, when asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vars: Option<BTreeMap<String, VarValue>>,
}

/// A box.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[allow(missing_docs)]
pub struct BoundsEvent {
    pub min: Corner,
    pub max: Corner,
}

/// A corner of a box.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[allow(missing_docs)]
pub struct Corner {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

/// The value of a variable.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[allow(missing_docs)]
pub enum VarValue {
    Number(f64),
    Text(String),
}
