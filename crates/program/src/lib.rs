//! The one language inside Kerf.
//!
//! Interpreters of OpenSBP and G-code, and jobs made from drawings, all produce [`Command`]s: what
//! a machine is asked to do, in order, with the place in the source it came from. Motion planning,
//! the simulated machine, the trace and the printers consume them and know nothing of where they
//! came from.
//!
//! Units and frames: every length in this crate is millimetres, every rotary angle degrees, every
//! time seconds; every position is in the *machine frame* (see [`Frame`]). Inches exist only where
//! a person types or reads them; [`Settings::linear_unit`] says which unit that is.
//!
//! An interpreter is stepped and never blocks: what it wants to know it asks through [`Host`],
//! whose answers are [`std::task::Poll`]; on `Pending` the step has no effect and is repeated later.

mod asking;
mod axes;
mod beam;
mod command;
mod dynamics;
mod frame;
mod go_to;
mod height;
mod height_map;
mod host;
mod interpreter;
pub mod job;
mod number;
mod printer;
pub mod settings;
mod shift;
mod smoothing;
pub mod testing;
mod tool_change;
mod tool_table;

pub use asking::{Answers, StepChoice};
pub use axes::{AXES, AXIS_LETTERS, Axes, Axis, AxisSet};
pub use beam::{Beam, IntensityLaw, LEVELS};
pub use command::{
    Arc, At, Chorded, Command, Feed, FileOp, Independent, Line, MoveKind, OutputReason,
    PathControl, Sourced, SpindleTurn, ToolPathStart,
};
pub use dynamics::Dynamics;
pub use frame::Frame;
pub use go_to::GoTo;
pub use height::{Gauge, HeightLaw, TORCH_INPUT};
pub use height_map::{HEAD as HEIGHT_MAP_HEAD, HeightMap, MARGIN_MM};
pub use host::{
    Answer, Button, ConversionRequest, CutChoice, FileConversion, FileMode, FileRequest, Folder,
    Host, HostError, Question, QuestionKind, SPINDLE_OUTPUT, SPINDLE_STATUS, ShellCall, SourceFile,
    ToolCall, no_such_tool,
};
pub use interpreter::{FileCall, Halted, Interpreter, Status, Step, StoppedBy, Watch};
pub use number::{decimal, rounded};
pub use printer::{Hold, Lost, Printer, Written, length_places};
pub use settings::Settings;
pub use smoothing::{FACTOR_MM, RampModel, Smoothing};
pub use tool_change::{ChangeWords, Changing};
pub use tool_table::{Tool, ToolTable};
