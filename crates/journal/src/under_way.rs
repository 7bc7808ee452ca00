//! The run under way: everything needed to run it again up to where it is.

use super::history::Past;
use super::kept_work::{KeptWork, WorkKind, read_back};
use super::reached::Reached;
use super::{JournalError, RestingMachine, RunOptions, Shell, Surroundings, Work};
use crate::machine_file::MACHINE_FILE;
use crate::switches::{self, SWITCHES, Switches};
use kerf_files::Folders;
use kerf_machine::Configuration;
use kerf_program::Settings;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Everything that a run was begun from.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct RunUnderWay {
    /// The version of Kerf: another may read the same part file otherwise.
    pub version: String,
    /// Name of the part file or job.
    pub file: String,
    /// Hash of its bytes.
    hash: String,
    /// Format of the bytes.
    kind: WorkKind,
    session: kerf_part::Session,
    /// Values that programs had kept.
    pub values: BTreeMap<String, String>,
    /// Options with which it is run.
    pub options: RunOptions,
    /// The settings that stay, where options replace them for this run.
    pub settings: Option<Settings>,
    /// Folders of its files.
    pub folders: Folders,
    /// Effect of SHELL.
    pub shell: Shell,
    /// Configuration of the machine beside the session's settings, as its file tells it.
    #[serde(default)]
    machine: String,
}

/// A run that was cut short: the process died.
#[derive(Clone, Debug)]
pub struct CutShort {
    /// Everything that it was begun from.
    pub run: RunUnderWay,
    /// Progress that it made.
    pub(crate) reached: Reached,
}

impl CutShort {
    /// The part file.
    pub fn file(&self) -> &str {
        &self.run.file
    }

    /// Returns `true` if a job was cut short: then its shapes are what lines are of a part file.
    pub fn is_job(&self) -> bool {
        self.run.kind == WorkKind::Job
    }

    /// Returns file and line of the last move that was made to its end.
    pub fn last_move(&self) -> (&str, u32) {
        (&self.reached.file, self.reached.line)
    }

    /// Returns `true` if the operator stopped it and gave it up; else Kerf was killed.
    pub const fn stopped(&self) -> bool {
        self.reached.stopped
    }

    /// The controller that it ran on, when it was no simulated machine.
    pub fn controller(&self) -> Option<&str> {
        self.run.options.controller.as_deref()
    }

    /// Returns `true` if the machine moved when it was cut short.
    pub const fn moved(&self) -> bool {
        self.reached.moving
    }

    /// Which run was stopped or cut short, and where: `the run of a.sbp was cut short behind line 5`.
    pub fn sentence(&self) -> String {
        self.sentence_by(str::to_owned)
    }

    /// The same, with names of files as somebody else knows them.
    pub fn sentence_by(&self, name: impl Fn(&str) -> String) -> String {
        let how = if self.stopped() { "stopped" } else { "cut short" };
        let (file, line) = self.last_move();
        let run = name(self.file());
        let place = match line {
            0 if self.moved() => "in its first move".to_owned(),
            0 => "before its first move".to_owned(),
            shape if self.is_job() => format!("at shape {shape}"),
            line if file == self.file() => format!("behind line {line}"),
            line => format!("behind line {line} of {}", name(file)),
        };
        let what = if self.is_job() && line > 0 { "job" } else { "run of" };
        let on = self.controller().map(|name| format!(" on {name}")).unwrap_or_default();
        format!("the {what} {run} was {how} {place}{on}")
    }

    /// Memory of the machine as it was when the run began.
    pub const fn memory(&self) -> &kerf_part::Session {
        &self.run.session
    }

    /// Configuration of the machine beside the settings of its memory, as it was when the run began.
    pub fn machine(&self) -> Configuration {
        let name = Arc::from(MACHINE_FILE);
        kerf_machine::file::read(&name, &self.run.machine).unwrap_or_default()
    }

    /// Returns the machine with the settings of programs that held when the run began.
    pub fn began_with(&self) -> Configuration {
        Configuration { program: self.memory().sbp.settings.clone(), ..self.machine() }
    }

    /// Reads back the work that the run carried out.
    pub(super) fn work(&self, contents: &BTreeMap<String, Vec<u8>>) -> Result<Work, JournalError> {
        let run = &self.run;
        let bytes = contents
            .get(run.hash())
            .ok_or_else(|| JournalError::Unfit(format!("the text of {} was not kept", run.file)))?;
        read_back(run.kind, &run.file, bytes)
    }

    /// Switches of the simulated machine as they were left when the run began.
    pub fn switches(&self) -> Switches {
        self.run.values.get(SWITCHES).map(|text| switches::read(text)).unwrap_or_default()
    }
}

impl RunUnderWay {
    /// A run that is about to begin.
    pub fn new(
        standing: &RestingMachine<'_>,
        work: &KeptWork<'_>,
        options: &RunOptions,
        settings: Option<Settings>,
        surroundings: Surroundings,
    ) -> Self {
        let Surroundings { values, folders, shell } = surroundings;
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            file: work.name.clone(),
            hash: work.hash(),
            kind: work.kind,
            session: kerf_part::Session {
                sbp: standing.memory.clone(),
                gcode: standing.gcode.clone(),
            },
            values,
            options: options.clone(),
            settings,
            folders: folders.rooted(),
            shell,
            machine: kerf_machine::file::write(standing.machine),
        }
    }
    /// Settings of the machine when it began.
    pub(super) const fn began_with(&self) -> &Settings {
        &self.session.sbp.settings
    }

    /// Hash of what it carries out.
    pub fn hash(&self) -> &str {
        &self.hash
    }

    /// The run as the history keeps it.
    pub(super) fn past(&self, status: &str, seconds: f64) -> Past {
        Past {
            file: self.file.clone(),
            hash: self.hash.clone(),
            started: self.options.started.clone(),
            seconds,
            status: status.into(),
        }
    }
}
