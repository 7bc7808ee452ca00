//! The run under way: everything needed to run it again up to where it is.

use super::history::{self, Past};
use super::kept_work::{KeptWork, WorkKind};
use super::progress::{PROGRESS, Progress, Reached};
use super::remembered::{remember, remember_homed};
use super::rows::{self, Rows, Table};
use super::tape::{Step, Tape};
use super::{Journal, JournalError, Live, Placed, json, mirror};
use crate::machine_file::MACHINE_FILE;
use crate::switches::{self, SWITCHES, Switches};
use crate::{RunOptions, Shell, Standing, Surroundings, Work};
use kerf_files::Folders;
use kerf_machine::Configuration;
use kerf_program::{Settings, Status};
use kerf_trace::Summary;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

const RUN: &str = "run";

/// Key of the progress of the run under way, while other commands are carried out.
const REACHED: &str = "reached";

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
    pub(super) kind: WorkKind,
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
    pub fn told(&self) -> String {
        self.told_by(str::to_owned)
    }

    /// The same, with names of files as somebody else knows them.
    pub fn told_by(&self, name: impl Fn(&str) -> String) -> String {
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

    /// Switches of the simulated machine as they were left when the run began.
    pub fn switches(&self) -> Switches {
        self.run.values.get(SWITCHES).map(|text| switches::read(text)).unwrap_or_default()
    }
}

impl RunUnderWay {
    /// A run that is about to begin.
    pub fn new(
        standing: &Standing<'_>,
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
}

impl Journal {
    /// A run begins. It is on record before anything moves; typed lines cannot be taken up again.
    pub fn begin(
        &self,
        run: &RunUnderWay,
        standing: &Standing<'_>,
        bytes: &[u8],
    ) -> Result<Tape, JournalError> {
        let (earlier, takes_up) = (self.cut_short()?, !run.options.program.typed);
        self.write(|rows| {
            remember(rows, standing.memory, standing.gcode)?;
            // After a run that was killed in motion nobody knows homes any more.
            remember_homed(rows, standing)?;
            if takes_up {
                forget(rows, earlier.as_ref())?;
                rows.keep_content(run.hash(), bytes)?;
                rows.put(Table::Fact, RUN, &json(run)?)?;
            } else {
                keep_reached(rows, earlier.as_ref())?;
            }
            rows.set(Table::Fact, PROGRESS, None)
        })?;
        Ok(Tape::recording(standing.place(), Progress::new(self.clone(), takes_up.then_some(1))))
    }

    /// A run is over: what it left is kept. One that was given up can still be taken up.
    pub fn end(
        &self,
        run: &RunUnderWay,
        standing: &Standing<'_>,
        summary: &Summary,
        tape: &Tape,
        live: &Live,
    ) -> Result<(), JournalError> {
        // What options say holds for this run; what the run itself changed stays.
        let kept = match run.settings {
            Some(_) => Ok(()),
            None => self.keep_settings(Some(&run.session.sbp.settings), &standing.memory.settings),
        };
        self.write(|rows| {
            remember(rows, standing.memory, standing.gcode)?;
            remember_homed(rows, standing)?;
            if !run.options.program.typed {
                history::add(rows, &run.past(status_word(summary.status), summary.seconds))?;
                if let Some(reached) = tape.left_at() {
                    return rows.put(Table::Fact, PROGRESS, &json(reached)?);
                }
                forget(rows, None)?;
            }
            rows.set(Table::Fact, PROGRESS, None)
        })?;
        mirror::publish(self, live)?;
        kept
    }

    /// The run that was cut short; `None` when the last one came to its end.
    ///
    /// # Errors
    /// As the file cannot be read.
    pub fn cut_short(&self) -> Result<Option<CutShort>, JournalError> {
        let [run, reached, progress] = self.read(|rows| {
            let fact = |key| rows.text(Table::Fact, key);
            Ok([fact(RUN)?, fact(REACHED)?, fact(PROGRESS)?])
        })?;
        let Some(run) = self.parsed(RUN, run)? else { return Ok(None) };
        let reached = self.parsed(REACHED, reached.or(progress))?.unwrap_or_default();
        Ok(Some(CutShort { run, reached }))
    }

    /// The work of a run that was cut short.
    ///
    /// # Errors
    /// As the file cannot be read, or its text was not kept.
    pub fn work_of(&self, cut: &CutShort) -> Result<Work, JournalError> {
        cut.work(&self.read(|rows| rows.contents())?)
    }

    /// Returns the work of a run that was cut short, and the tape of what the world told it. The machine is at
    /// this place now, its switches are so, and the controller that it hangs on is this one; how far the run is, is told by its own progress again.
    pub fn take_up(
        &self,
        cut: &CutShort,
        on: Option<&str>,
        place: Placed,
        switches: Switches,
    ) -> Result<(Work, Tape), JournalError> {
        let run = &cut.run;
        if cut.controller() != on {
            let ran = cut.controller().unwrap_or("sim");
            let why = format!("it ran on {ran}: name that machine, --machine {ran}");
            return Err(JournalError::Unfit(why));
        }
        let version = env!("CARGO_PKG_VERSION");
        if run.version != version {
            let why = format!("Kerf {} ran it, this is {version}", run.version);
            return Err(JournalError::Unfit(why));
        }
        let (steps, contents, last) = self.read(|rows| {
            let steps = rows.all(Table::Step)?;
            Ok((steps, rows.contents()?, rows.last(Table::Step)?))
        })?;
        let work = cut.work(&contents)?;
        let parse = |(_, text): (String, String)| serde_json::from_str::<Step>(&text);
        let steps: Result<Vec<Step>, _> = steps.into_iter().map(parse).collect();
        let steps = steps.map_err(|error| JournalError::Unfit(error.to_string()))?;
        self.write(|rows| {
            if rows.text(Table::Fact, REACHED)?.is_some() {
                let reached = Reached { place, moving: false, ..cut.reached.clone() };
                rows.put(Table::Fact, PROGRESS, &json(&reached)?)?;
            }
            rows.set(Table::Fact, REACHED, None)
        })?;
        let progress = Progress::new(self.clone(), Some(last + 1));
        let switches = [switches, cut.switches()];
        Ok((work, Tape::playing(steps, contents, &cut.reached, progress, switches)))
    }
}

impl RunUnderWay {
    /// Hash of what it carries out.
    pub fn hash(&self) -> &str {
        &self.hash
    }

    fn past(&self, status: &str, seconds: f64) -> Past {
        Past {
            file: self.file.clone(),
            hash: self.hash.clone(),
            started: self.options.started.clone(),
            seconds,
            status: status.into(),
        }
    }
}

/// Keeps the progress of the run that was cut short: it can still be taken up after what comes now.
pub(super) fn keep_reached(rows: &Rows<'_>, earlier: Option<&CutShort>) -> rows::Result<()> {
    match earlier {
        Some(earlier) => rows.put(Table::Fact, REACHED, &json(&earlier.reached)?),
        None => Ok(()),
    }
}

/// Nothing is under way any more.
fn forget(rows: &Rows<'_>, cut: Option<&CutShort>) -> rows::Result<()> {
    if let Some(cut) = cut.filter(|cut| !cut.stopped()) {
        history::add(rows, &cut.run.past("cut short", 0.0))?;
    }
    rows.clear(Table::Step)?;
    rows.clear(Table::Content)?;
    rows.set(Table::Fact, RUN, None)?;
    rows.set(Table::Fact, REACHED, None)
}

const fn status_word(status: Status) -> &'static str {
    match status {
        Status::Ok => "ok",
        Status::Ended => "ended",
        Status::Failed => "failed",
        Status::Stopped => "stopped",
        Status::Limit => "limit",
    }
}
