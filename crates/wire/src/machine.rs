//! The machine as a page shows it.

use crate::{AXES, LAMPS};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Activity of the machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum State {
    /// It stands and waits for a command.
    #[default]
    Idle,
    /// It runs a part file or a command.
    Running,
    /// It moves for as long as somebody holds a key.
    Jogging,
    /// It ramped down in the middle of a job and stands.
    Held,
    /// A job asks something.
    Asking,
    /// The operator stopped a job, which waits: resume or quit.
    Stopped,
    /// Something ended a job that a person has to look at before anything moves again.
    Alarm,
}

/// Effect of running a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum Mode {
    /// Files are only drawn.
    Preview,
    /// The machine is simulated.
    #[default]
    Simulated,
    /// A real machine moves.
    Cut,
}

/// The state of the machine.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Machine {
    /// Its activity.
    pub state: State,
    /// Effect of running a file.
    pub mode: Mode,
    /// It may be moved: not after a start, a lost link, an alarm, until somebody arms it.
    pub armed: bool,
    /// Reason why it is disarmed, held or in alarm, for a person.
    pub why: Option<String>,
    /// Its controller has begun a change of tools and waits for the tool.
    pub wants_tool: bool,
    /// It touches that tool off by itself when it is asked to.
    pub touches_off: bool,
    /// Its name.
    pub name: String,
    /// Acts that a page may do to it beside moving it.
    pub offers: Offers,
    /// The factor that runs on it have shown, by which the time of files is told; nothing before the first.
    pub pace: Option<Pace>,
}

/// A factor by which the motion of runs takes longer than the planner of the controller says.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Pace {
    /// The factor.
    pub factor: f64,
    /// Runs that it was learned from.
    pub runs: u32,
}

/// Acts that a page may do to a machine beside moving it, as the machine itself tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Offers {
    /// Its switches are moved on a page.
    pub inputs: bool,
    /// The bits of its card are switched one at a time, and its motors stepped once.
    pub card: bool,
    /// Start arms it: nobody is hurt by what it does.
    pub start_arms: bool,
}

/// A setting that the controller of the machine keeps by number, as it told it last.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ControllerSetting {
    /// Its number.
    pub number: u16,
    /// Its value, as the controller writes it.
    pub value: String,
    /// Its name; empty where nobody knows it.
    pub name: String,
    /// The unit of its value; empty where it has none.
    pub unit: String,
    /// Least value, where there is one.
    pub least: Option<f64>,
    /// Greatest value, where there is one.
    pub most: Option<f64>,
    /// A sentence that explains it; empty where nobody knows.
    pub does: String,
    /// The same as the controller itself tells it; empty where it does not.
    pub own: String,
}

/// A zero point that the controller of the machine keeps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Zero {
    /// Its name, as G54; G92 is a shift of all others, TLO the length of the tool, which shifts them too.
    pub name: String,
    /// Its place, the machine's own frame; of a shift, its way.
    #[ts(type = "AxisPlace")]
    pub at: [f64; AXES],
    /// It is the one that holds; a shift always does.
    pub holds: bool,
}

/// A change of a zero point that the controller keeps. Axes without a number stay.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "to", deny_unknown_fields)]
pub enum ZeroChange {
    /// It is so that the axes read these numbers where the machine stands, mm or degrees.
    Reads {
        /// The numbers.
        #[ts(type = "AxisGoal")]
        values: [Option<f64>; AXES],
    },
    /// It is at this place.
    Lies {
        /// The place, the machine's own frame.
        #[ts(type = "AxisGoal")]
        at: [Option<f64>; AXES],
    },
    /// It holds from now on.
    Holds,
    /// The shift is taken away.
    Gone,
}

/// Position and motion of the machine. Sent about 30 times a second while it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Motion {
    /// Positions of the axes.
    pub at: Positions,
    /// Speed along the path.
    #[ts(type = "MmPerS")]
    pub speed_mm_s: f64,
    /// Machine time since the run began, seconds.
    #[ts(type = "Seconds")]
    pub t: f64,
    /// It is a cut; a jog otherwise.
    pub cutting: bool,
    /// Line of the part file that makes the move; 0 when none does.
    pub line: u32,
    /// Moves of the job made so far: segments of the preview before this are done.
    pub made: u32,
    /// Progress of the job, 0 … 1 of its planned time.
    pub progress: f64,
    /// Planned time that is left at the present override, seconds of whoever waits: a simulated machine may be faster.
    #[ts(type = "Seconds")]
    pub remaining: f64,
    /// Time of the run so far, seconds of whoever waits: with the planned time of what was made before it was taken up.
    #[ts(type = "Seconds")]
    pub elapsed: f64,
}

/// A place in every frame: mm or degrees, X Y Z A B C.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Positions {
    /// Working location: what the location display shows.
    #[ts(type = "AxisPlace")]
    pub working: [f64; AXES],
    /// Table base coordinates.
    #[ts(type = "AxisPlace")]
    pub base: [f64; AXES],
    /// The machine's own frame, in which previews are drawn.
    #[ts(type = "AxisPlace")]
    pub machine: [f64; AXES],
}

/// Units in which a person reads lengths.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Units {
    /// `in` or `mm`.
    pub linear: String,
    /// Millimetres in one of them.
    #[ts(type = "UnitSize")]
    pub mm: f64,
    /// Each axis.
    pub axes: Vec<AxisUnits>,
    /// The numbers of moves are places (SA); distances otherwise (SR).
    pub absolute: bool,
}

impl Default for Units {
    fn default() -> Self {
        Self { linear: "in".into(), mm: 25.4, axes: Vec::new(), absolute: true }
    }
}

/// Unit in which a person reads an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct AxisUnits {
    /// Its letter.
    pub letter: char,
    /// `in`, `mm` or `deg`.
    pub unit: String,
    /// Internal units (mm or degrees) in one of them.
    #[ts(type = "UnitSize")]
    pub scale: f64,
    /// The machine has it.
    pub used: bool,
}

/// Speeds; of axes that turn, degrees a second.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Speeds {
    /// Cutting: X and Y together, then Z, A, B, C.
    #[ts(type = "AxisSpeeds")]
    pub cut_mm_s: [f64; 5],
    /// Jogging.
    #[ts(type = "AxisSpeeds")]
    pub jog_mm_s: [f64; 5],
    /// Spindle, revolutions a minute.
    pub rpm: f64,
}

/// Duty that is assigned to an input (VN).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub enum Duty {
    /// Nothing but what programs make of it.
    #[default]
    Standard,
    /// A limit or proximity switch: it ends motion when limits are active.
    Limit,
    /// It stops motion, and forbids it until it is released.
    Stop,
}

/// An input or output.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Lamp {
    /// Its number, from 1.
    pub number: u8,
    /// It is on.
    pub on: bool,
    /// Its purpose, when something is known.
    pub label: String,
    /// Duty that is assigned to it, when it is an input.
    pub duty: Duty,
}

/// All inputs and outputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Io {
    /// Inputs 1 … 12.
    pub inputs: Vec<Lamp>,
    /// Outputs 1 … 12.
    pub outputs: Vec<Lamp>,
    /// The ports of the card.
    pub ports: Ports,
    /// The mend that is needed before anything moves, while a pressed stop forbids motion.
    pub forbidden: Option<String>,
}

/// The ports of the card, a byte each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Ports {
    /// Input ports A and B.
    pub inputs: [u8; 2],
    /// Output ports A, B and C. The step bit of a motor is on while it steps.
    pub outputs: [u8; 3],
}

/// One bit of a port.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct PortBit {
    /// An output; an input otherwise.
    pub output: bool,
    /// The letter of its port.
    pub port: char,
    /// Its place, 0 … 7.
    pub place: u8,
    /// Its name on this machine.
    pub name: String,
    /// Its purpose.
    pub about: String,
}

impl Default for Io {
    fn default() -> Self {
        let lamps = || (1..=LAMPS as u8).map(|number| Lamp { number, ..Lamp::default() }).collect();
        Self { inputs: lamps(), outputs: lamps(), ports: Ports::default(), forbidden: None }
    }
}
