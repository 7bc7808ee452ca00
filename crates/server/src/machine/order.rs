//! Orders to the thread that has the machine: what it carries out next.

use super::arrived::StopCount;
use super::planned::Planned;
use crate::handconsole::Happening;
use kerf_journal::Work;
use kerf_machine::driver::{CardAnswer, CardTask, ZeroChange};
use kerf_machine::table::Setting;
use kerf_machine::{Configuration, Errand};
use kerf_program::{AXES, Axis};
use kerf_sbp::FileParameters;
use kerf_wire::{SettingChange, ToolChange};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::mpsc::Sender;

/// Something that is to be done on the card of the controller.
#[derive(Debug)]
pub struct CardOrder {
    /// The task.
    pub task: CardTask,
    /// Ends it before it is done.
    pub given_up: Arc<AtomicBool>,
    /// Told how it ended.
    pub tells: Sender<Result<CardAnswer, String>>,
}

/// An order that the machine carries out next.
#[derive(Debug)]
pub enum Order {
    /// Run a part file or a job.
    File {
        /// Its content.
        work: Box<Work>,
        /// Its name, for pages.
        name: String,
        /// Its hash.
        hash: String,
        /// Its plan.
        planned: Planned,
        /// Parameters with which a part file is run.
        parameters: FileParameters,
        /// Settings that it makes may stay.
        opened: bool,
        /// It is only drawn, and needs no armed machine.
        draws_only: bool,
    },
    /// Take up the run that was cut short.
    TakeUp {
        /// Hash by which pages know the open file, where it is that which runs.
        hash: Option<String>,
        /// The plan of all of it.
        planned: Planned,
    },
    /// Carry out lines of OpenSBP.
    Command {
        /// The lines.
        line: String,
        /// They may change settings.
        opened: bool,
        /// The file that they run and nothing else, by its hash, and its plan.
        file: Option<(String, Planned)>,
        /// They are only drawn, and need no armed machine.
        draws_only: bool,
    },
    /// Carry out what whoever started Kerf wrote into the start-up line, one after the other, unless a stop comes.
    StartUp {
        /// The lines.
        lines: Vec<String>,
        /// Stops that had come when Kerf started.
        since: StopCount,
    },
    /// Move for as long as the link says.
    Jog {
        /// Direction of each axis.
        direction: [f64; AXES],
        /// Greatest multiple of the direction that it moves, mm or degrees.
        distance: Option<f64>,
        /// Share of the jog speed.
        speed: f64,
    },
    /// Do an errand.
    Hand {
        /// The errand.
        errand: Errand,
        /// The machine, and where on it the job lies.
        machine: Box<Configuration>,
        /// Told how it ended.
        tells: Sender<Happening>,
    },
    /// Cut straight from where the tool is to a place from the job origin, X and Y, mm.
    CutMove {
        /// The place.
        at: [f64; 2],
        /// The machine, and where on it the job lies.
        machine: Box<Configuration>,
    },
    /// Switch an output of the card, by its number.
    Switch(u8, bool),
    /// Change a zero point that the controller keeps.
    Zero {
        /// Its name.
        name: String,
        /// The change.
        change: ZeroChange,
    },
    /// Change a tool that is known by its number.
    Tool {
        /// Its number.
        number: u32,
        /// The change.
        change: ToolChange,
    },
    /// Write a setting into the controller.
    Setting {
        /// Its number.
        number: u16,
        /// Its value.
        value: String,
    },
    /// Ask the controller a question in its own language.
    Question(String),
    /// Forget the factor that runs on the controller have shown.
    ForgetPace,
    /// The tool is in for which the controller waits.
    ToolIn,
    /// Have the controller touch that tool off.
    TouchOff,
    /// Do something on the card of the controller.
    Card(CardOrder),
    /// Take this file of heights into force, or the map off.
    HeightMap(Option<String>),
    /// Shift the workpiece.
    Nudge(Axis, f64),
    /// Move the switches of the simulated machine that nothing which ran has moved.
    Switches,
    /// Choose the part folder, and which files lists show.
    Folder {
        /// Its path.
        path: PathBuf,
        /// The mask; nothing keeps it.
        mask: Option<String>,
    },
    /// Put a line at the end of the recorder's list.
    Record(String),
    /// Tell the watched variables.
    Watched,
    /// Have another configuration, of which this setting is new.
    Configure {
        /// The setting.
        setting: &'static Setting,
        /// The configuration.
        wanted: Box<Configuration>,
        /// The change that is entered in the history when it is on the disk.
        change: Option<SettingChange>,
        /// Told whether it is on the disk.
        tells: Sender<Result<(), String>>,
    },
    /// Have another configuration until Kerf ends.
    Hold {
        /// The configuration.
        wanted: Box<Configuration>,
        /// Told when it holds.
        tells: Sender<Happening>,
    },
    /// Keep the configuration that holds; told how that went.
    Keep(Sender<Happening>),
    /// Enter in the system log that a command was refused which came over the network.
    Refused(String),
}

impl Order {
    /// Returns `true` if it is only drawn: begun in preview, which it does not leave.
    pub const fn draws_only(&self) -> bool {
        matches!(self, Self::File { draws_only: true, .. } | Self::Command { draws_only: true, .. })
    }

    /// Returns `true` if it may move the machine: whoever asks for it drives, with the machine armed, when it begins.
    pub fn moves(&self) -> bool {
        match self {
            Self::Command { line, .. } => {
                !kerf_sbp::read_typed("command".into(), &format!("{line}\n")).moves_nothing()
            }
            Self::File { .. }
            | Self::TakeUp { .. }
            | Self::StartUp { .. }
            | Self::Jog { .. }
            | Self::Hand { .. }
            | Self::CutMove { .. }
            | Self::Switch(..)
            | Self::Zero { .. }
            | Self::ToolIn
            | Self::TouchOff
            | Self::Setting { .. }
            | Self::Nudge(..)
            | Self::Card(CardOrder { task: CardTask::Run(_), .. }) => true,
            Self::Switches
            | Self::HeightMap(_)
            | Self::Tool { .. }
            | Self::ForgetPace
            | Self::Question(_)
            | Self::Card(_)
            | Self::Folder { .. }
            | Self::Record(_)
            | Self::Watched
            | Self::Configure { .. }
            | Self::Hold { .. }
            | Self::Keep(_)
            | Self::Refused(_) => false,
        }
    }
}
