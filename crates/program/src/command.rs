//! The canonical commands.

use crate::job::{Heights, InForce};
use crate::{Axes, Axis, AxisSet, Beam, Frame, HeightLaw, Settings};
use kerf_diag::Diagnostic;
use serde::{Deserialize, Serialize};
use std::sync::Arc as Shared;

/// Place in the sources that a command comes from. The producer keeps the table of files.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct At {
    /// Index into the producer's table of files.
    pub file: u32,
    /// Line, counted from 1; 0 when no line stands for it.
    pub line: u32,
}

/// A command and where it comes from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sourced {
    /// Its place in the sources.
    pub at: At,
    /// The command itself.
    pub command: Command,
}

/// Kind of a move: material is cut, or the tool only travels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum MoveKind {
    /// At move speed.
    Cut,
    /// At jog speed, ramping to a stop at its end.
    Jog,
}

/// Feed of a move: the speed that it may have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Feed {
    /// The speeds of [`Settings::speeds`]: XY vector speed when X or Y moves, reduced so that no
    /// other axis exceeds its own, else the slowest of the axes that move.
    #[default]
    Axis,
    /// Along the path, mm/s.
    Path(f64),
    /// The whole move takes so long, seconds (inverse time feed).
    Time(f64),
}

/// A straight move of all axes together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Cut or jog.
    pub kind: MoveKind,
    /// End, machine frame.
    pub to: Axes,
    /// Feed of the move.
    pub feed: Feed,
}

/// A circular move in the XY plane; every other axis moves in proportion to the angle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arc {
    /// Cut or jog.
    pub kind: MoveKind,
    /// Centre in X and Y, machine frame.
    pub centre: [f64; 2],
    /// Swept angle in radians, positive counter-clockwise.
    pub sweep_rad: f64,
    /// End, machine frame.
    pub to: Axes,
    /// Feed of the move.
    pub feed: Feed,
    /// Number of chords that the circle resolution of VU asks for; machines that know only lines use it.
    pub chords: u32,
    /// Below the small circle size of VR: run at ramp speed.
    pub small: bool,
}

/// A circle in a plane of two axes that the lines behind it follow as chords: no motion itself. What can
/// say the arc whole takes it instead of them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Chorded {
    /// Number of lines.
    pub chords: u32,
    /// The axes of the plane, as indices; turning from the first to the second is counter-clockwise.
    pub axes: [usize; 2],
    /// Centre in these axes, machine frame.
    pub centre: [f64; 2],
    /// Swept angle in radians, positive counter-clockwise.
    pub sweep_rad: f64,
    /// End, machine frame.
    pub to: Axes,
    /// Feed of the whole arc.
    pub feed: Feed,
}

/// Cause of the change of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum OutputReason {
    /// SO in a program.
    Program,
    /// Output 4 in its automatic modes.
    Motion,
    /// An output mode of VN at the start of a file, at a stop or at resume.
    Mode,
    /// The Z or A trigger of VC.
    Trigger,
    /// A stop, MO or an emergency.
    Stop,
    /// The end of the file.
    End,
}

/// Operation on a file of the user.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[allow(missing_docs)]
pub enum FileOp {
    Open,
    Close,
    Write,
    Read,
}

/// Motion of one axis beside everything else (MI).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Independent {
    /// Turns at a speed in units of the axis a second; the sign is the direction.
    Rotate(f64),
    /// Swings with so many cycles a second and this peak-to-peak displacement.
    Oscillate {
        /// Cycles a second.
        frequency_hz: f64,
        /// Peak-to-peak displacement.
        distance: f64,
    },
    /// Stops.
    Off,
}

/// The beginning of a tool path, told by a program's comments.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ToolPathStart {
    /// Name of the tool path.
    pub name: Option<Shared<str>>,
    /// Name of the tool.
    pub tool: Option<Shared<str>>,
}

/// Closeness with which the path is followed where moves meet (G61, G61.1, G64 of G-code).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum PathControl {
    /// Every programmed point is visited, slowing down as little as that allows.
    ExactPath,
    /// Motion comes to rest at every programmed point.
    ExactStop,
    /// Corners may be rounded to keep up speed.
    Blend {
        /// Largest distance of the path from the programmed one, mm; `None`: as the machine likes.
        tolerance_mm: Option<f64>,
        /// Points that lie so close to a line may be left out, mm.
        merge_mm: Option<f64>,
    },
}

/// Drive of a spindle or laser (M3, M4, M5 of G-code).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SpindleTurn {
    /// Stopped.
    Off,
    /// Clockwise, or a laser at constant power.
    Clockwise,
    /// Counter-clockwise.
    Counterclockwise,
    /// A laser whose power follows the real speed; off at rest.
    Dynamic,
}

/// An order to a machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Command {
    /// A straight move.
    Line(Line),
    /// A circular move or a helix.
    Arc(Arc),
    /// The lines behind are chords of an arc in another plane.
    Chorded(Chorded),
    /// From here on these settings hold (speeds, ramps, I/O modes, trigger, limits).
    Settings(Shared<Settings>),
    /// The frames changed; no motion. The sets tell which axes the program set.
    Location {
        /// The frames from here on.
        frame: Frame,
        /// Axes whose working location was set.
        working: AxisSet,
        /// Axes whose table base coordinate was set.
        base: AxisSet,
    },
    /// The current stack of moves ends here; motion comes to rest.
    EndStack,
    /// Wait this long.
    Wait {
        /// Seconds.
        seconds: f64,
    },
    /// Switch an output. Switching on belongs to the stack, switching off ends it.
    Output {
        /// Number of the output.
        number: u8,
        /// On or off.
        on: bool,
    },
    /// Set the PWM channel.
    Pwm {
        /// Channel number, from 1.
        channel: u8,
        /// Duty, 0 … 100.
        percent: f64,
    },
    /// The intensity output of a laser from here on.
    Beam(Beam),
    /// The pulse frequency of a laser.
    LaserFrequency {
        /// Hz.
        hz: f64,
    },
    /// From here on Z follows the sheet while a cut moves, or does not.
    HeightControl(Option<Shared<HeightLaw>>),
    /// The heights of the job in force, machine frame; while Z follows the sheet, top and surface go with
    /// it.
    Heights(Heights),
    /// A pause has changed what holds for the rest of the job.
    InForce(InForce),
    /// The machine enters a state that people should know about (`running`, `paused` …).
    State {
        /// Its name.
        name: Shared<str>,
        /// Reason, when there is something to say.
        why: Shared<str>,
    },
    /// Speed of a spindle (TR); `on` as far as known.
    Spindle {
        /// Spindle number, from 1.
        number: u8,
        /// Revolutions a minute.
        rpm: f64,
    },
    /// Which way a spindle turns; the speed comes with [`Command::Spindle`].
    SpindleTurn {
        /// Spindle number, from 1.
        number: u8,
        /// Direction, or off.
        turn: SpindleTurn,
    },
    /// Coolant on or off.
    Coolant {
        /// Mist.
        mist: bool,
        /// Flood.
        flood: bool,
    },
    /// Closeness with which the path is followed from here on. Does not end motion.
    PathControl(PathControl),
    /// Effect of the operator's overrides from here on: `true` where they hold.
    Overrides {
        /// Of the feed.
        feed: bool,
        /// Of the spindle speed.
        spindle: bool,
    },
    /// Motion of one axis beside the others (MI).
    Independent {
        /// The axis.
        axis: Axis,
        /// Its motion.
        motion: Independent,
    },
    /// Cut motor power and turn all outputs off (MO).
    MotorsOff,
    /// End the flashing warning until the next motion (WARNING OFF).
    WarningOff,
    /// Text for the print window; no line end when `newline` is false.
    Print {
        /// The text.
        text: Shared<str>,
        /// A line end follows.
        newline: bool,
    },
    /// A comment shown to the operator.
    Message {
        /// The text.
        text: Shared<str>,
    },
    /// Something to tell about the program, found while running it.
    Diagnostic(Box<Diagnostic>),
    /// A file of the user was used.
    File {
        /// The operation.
        op: FileOp,
        /// Its path as the host resolved it.
        path: Shared<str>,
    },
    /// Start a sound and go on.
    Sound {
        /// The file.
        path: Shared<str>,
    },
    /// A tool path begins (cutter comments).
    ToolPath(ToolPathStart),
    /// A tool change begins or is over; the time between counts as tool change.
    ToolChange {
        /// True when it begins.
        begin: bool,
    },
    /// Clear the preview display.
    ClearPreview,
}

impl Command {
    /// Returns `true` if the stack of moves ends with this command: motion comes to rest before it, and
    /// it is carried out before anything behind it is read (OpenSBP handbook, "Movement stacks"). A jog
    /// is a stack of its own.
    pub const fn ends_stack(&self) -> bool {
        match self {
            Self::Line(Line { kind, .. }) | Self::Arc(Arc { kind, .. }) => {
                matches!(kind, MoveKind::Jog)
            }
            Self::Output { on, .. } => !*on,
            Self::Settings(_)
            | Self::Print { .. }
            | Self::Message { .. }
            | Self::Diagnostic(_)
            | Self::File { .. }
            | Self::Sound { .. }
            | Self::ToolPath(_)
            | Self::ToolChange { .. }
            | Self::State { .. }
            | Self::ClearPreview
            | Self::PathControl(_)
            | Self::Chorded(_)
            | Self::Overrides { .. }
            // S in the lines of a laser raster, M67.
            | Self::Spindle { .. }
            | Self::Pwm { .. } => false,
            _ => true,
        }
    }

    /// Returns `true` if this is motion.
    pub const fn is_motion(&self) -> bool {
        matches!(self, Self::Line(_) | Self::Arc(_))
    }
}
