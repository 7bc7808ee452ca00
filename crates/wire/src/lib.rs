//! Messages between server and console.
//!
//! ```text
//!  server ── Snapshot, then Change, Change … ──► page       one WebSocket, /ws
//!         ◄── Request { id, act } ──────────────
//!         ─── Reply { id, … } ──────────────────►
//! ```
//!
//! - The server owns all state. A page that connects gets a [`Snapshot`], then [`Change`]s; each
//!   replaces a section of the snapshot or adds to one ([`Snapshot::apply`] says how, and the page
//!   does the same). A page that missed some gets a new snapshot.
//! - A page asks with a [`Request`]; the [`Reply`] carries its id. Scripts send the same [`Act`]s
//!   over HTTP.
//! - Places are millimetres or degrees, times seconds. Names of speeds end in their unit.
//!   [`Units`] says what a person reads instead.
//! - The tool path comes in binary pieces over HTTP ([`preview`]).
//!
//! The TypeScript of these types is in `console/src/wire`; `cargo xtask wire` writes it, and a test
//! says when it is old. [`fold_vectors`] lie beside it: the page's own `apply` is tested against them.

mod act;
mod by_hand;
mod change;
mod controller_card;
mod controller_line;
mod digitized;
mod drawing;
mod file;
mod hand_console;
mod height_map;
mod history;
mod job;
mod job_view;
mod language;
mod machine;
mod operation;
mod people;
pub mod preview;
mod reply;
mod served_machine;
mod setting;
mod setup;
mod snapshot;
mod tool;
mod typescript;
mod vectors;
mod wiring;

pub use act::{Act, Request};
pub use by_hand::ByHand;
pub use change::{Change, ToPage};
pub use controller_card::{CardAct, CardFile, CardLook, CardTask, CardTaskKind, ControllerCard};
pub use controller_line::{ControllerLine, ControllerLines, LineKind};
pub use digitized::{Digitized, DigitizedPoint, Look, Looked};
pub use drawing::{
    ArrayState, Block, CutHeight, CutPass, CutShape, DrawingState, GroupState, Op, ShapeList,
    ShapePath, ToolPaths,
};
pub use file::{FileAbout, FileVersion, TextDraft, TextEdit};
pub use hand_console::HandConsole;
pub use height_map::{HeightMap, HeightMapChange, PLACES_TOLD};
pub use history::{RunRecord, ToDo};
pub use job::{
    Asked, Call, CurrentRun, FileInfo, FileParameters, Folder, InForce, Interrupted, LastRun,
    Message, Opened, Overrides, Pause, PreviewState, Recorder, RunSummary, SampleAnswer, Sound,
    Tone,
};
pub use job_view::{FileKind, JobChoice, JobPath, JobView};
pub use language::{
    Checked, CommandEntry, Completion, Finding, Hint, Hover, Level, NamedValue, Parameter,
    ParameterKind, SystemValue, Values,
};
pub use machine::{
    AxisUnits, ControllerSetting, Duty, Io, Lamp, Machine, Mode, Motion, Offers, Pace, PortBit,
    Ports, Positions, Speeds, State, Units, Zero, ZeroChange,
};
pub use operation::{OperationEntry, OperationPart, OperationValue, OperationVariant};
pub use people::{Client, Lease, Role, Who};
pub use reply::{Problem, Reply, Why};
pub use served_machine::ServedMachine;
pub use setting::{SettingArea, SettingChange, SettingEntry, SettingKind};
pub use setup::{Setup, ZHeights};
pub use snapshot::{Snapshot, StartUp};
pub use tool::{NumberedTool, ToolChange, ToolTable};
pub use typescript::typescript;
pub use vectors::fold_vectors;
pub use wiring::{FoundBoard, FoundPort, SoldBoard, WiredSwitch, Wiring};

/// Inputs, and outputs, of a machine.
pub const LAMPS: usize = 12;

/// Axes: X Y Z A B C.
pub const AXES: usize = 6;

/// Version of the messages: a page of another version loads itself anew.
pub const VERSION: u32 = 1;
