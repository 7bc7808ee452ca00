//! Changes that the server tells without being asked.

use crate::preview::TypedPath;
use crate::{
    Asked, Client, ControllerCard, ControllerSetting, CurrentRun, Digitized, DrawingState, Folder,
    HandConsole, HeightMap, Interrupted, Io, Lease, Looked, Machine, Message, Motion, NamedValue,
    Opened, Overrides, Pause, Recorder, Reply, ServedMachine, Setup, Snapshot, Sound, Speeds,
    StartUp, ToolTable, Units, Who, Wiring, Zero,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// One change of what a page shows: a section of the [`Snapshot`] as it is now, or what is added to one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "change")]
#[allow(missing_docs)]
pub enum Change {
    Machine {
        machine: Machine,
    },
    Motion {
        motion: Motion,
    },
    Units {
        units: Units,
    },
    Setup {
        setup: Setup,
    },
    Speeds {
        speeds: Speeds,
    },
    Io {
        io: Io,
    },
    Opened {
        opened: Option<Opened>,
    },
    Job {
        job: Option<CurrentRun>,
    },
    /// More was drawn of what is typed, or it begins anew.
    Typed {
        typed: TypedPath,
    },
    Interrupted {
        interrupted: Option<Interrupted>,
    },
    Asked {
        asked: Option<Asked>,
    },
    /// A pause of so many seconds begins, or is over.
    Pause {
        pause: Option<Pause>,
    },
    /// A sound begins, on every page that hears it.
    Sound {
        sound: Option<Sound>,
    },
    Overrides {
        overrides: Overrides,
    },
    Zeros {
        zeros: Vec<Zero>,
    },
    /// Steps of a millimetre that the controller keeps.
    #[serde(rename_all = "camelCase")]
    ControllerSteps {
        controller_steps: Vec<f64>,
    },
    /// Settings that the controller keeps by number.
    #[serde(rename_all = "camelCase")]
    ControllerSettings {
        controller_settings: Vec<ControllerSetting>,
    },
    /// The card of the controller.
    #[serde(rename_all = "camelCase")]
    ControllerCard {
        controller_card: ControllerCard,
    },
    Tools {
        tools: ToolTable,
    },
    /// The machines that are served together.
    Together {
        together: Vec<ServedMachine>,
    },
    /// Another height map is followed, or none.
    #[serde(rename_all = "camelCase")]
    HeightMap {
        height_map: Option<HeightMap>,
    },
    Wiring {
        wiring: Option<Wiring>,
    },
    /// Lines are added to the print window.
    Printed {
        lines: Vec<String>,
    },
    /// The print window is emptied.
    ClearPrinted,
    /// Messages are added.
    Messages {
        messages: Vec<Message>,
    },
    /// The sheet of the start-up line is done.
    Start {
        start: Option<StartUp>,
    },
    Lease {
        lease: Option<Lease>,
    },
    Clients {
        clients: Vec<Client>,
    },
    Drawing {
        drawing: Option<DrawingState>,
    },
    /// Files of the part folder changed.
    Files {
        files: u32,
    },
    Folder {
        folder: Folder,
    },
    Recorder {
        recorder: Recorder,
    },
    Watched {
        watched: Vec<NamedValue>,
    },
    /// The machine's configuration changed.
    Settings {
        settings: u32,
    },
    #[serde(rename_all = "camelCase")]
    HandConsole {
        hand_console: HandConsole,
    },
    Digitized {
        digitized: Option<Digitized>,
    },
    Looked {
        looked: Option<Looked>,
    },
}

/// A message over the socket to the page: one JSON text each.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", tag = "tell")]
pub enum ToPage {
    /// The first message, and again whenever the page missed changes.
    Snapshot {
        /// The page: its number, role and device.
        who: Who,
        /// Everything.
        snapshot: Box<Snapshot>,
    },
    /// The changes, in order.
    Changes {
        /// At least one.
        changes: Vec<Change>,
    },
    /// The answer to a request of this page.
    Reply(Reply),
}
