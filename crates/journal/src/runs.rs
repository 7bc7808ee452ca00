//! Runs on record: the one under way, the one that was cut short, those that are over.

use super::history::{self, Past};
use super::memory::{remember, remember_homed};
use super::progress::Progress;
use super::reached::{PROGRESS, Reached};
use super::rows::{self, Rows, Table, json};
use super::store::Store;
use super::tape::{Step, Tape};
use super::{
    CutShort, JournalError, Live, MachineSettings, Placed, Registry, RestingMachine, RunUnderWay,
    Work,
};
use crate::switches::Switches;
use kerf_machine::Configuration;
use kerf_trace::Summary;

const RUN: &str = "run";

/// Key of the progress of the run under way, while other commands are carried out.
const REACHED: &str = "reached";

/// Runs on record. Clones are the same.
#[derive(Clone, Debug)]
pub struct Runs {
    registry: Registry,
    settings: MachineSettings,
}

impl Runs {
    pub(super) const fn new(registry: Registry, settings: MachineSettings) -> Self {
        Self { registry, settings }
    }

    /// A run begins. It is on record before anything moves; typed lines cannot be taken up again.
    pub fn begin(
        &self,
        run: &RunUnderWay,
        standing: &RestingMachine<'_>,
        bytes: &[u8],
    ) -> Result<Tape, JournalError> {
        let (earlier, takes_up) = (self.cut_short()?, !run.options.program.typed);
        self.store().write(|rows| {
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
        Ok(Tape::recording(
            standing.place(),
            Progress::new(self.registry.clone(), takes_up.then_some(1)),
        ))
    }

    /// A run is over: what it left is kept. One that was given up can still be taken up.
    pub fn end(
        &self,
        run: &RunUnderWay,
        standing: &RestingMachine<'_>,
        summary: &Summary,
        tape: &Tape,
        live: &Live,
    ) -> Result<(), JournalError> {
        // What options say holds for this run; what the run itself changed stays.
        let kept = match run.settings {
            Some(_) => Ok(()),
            None => self.settings.keep(Some(run.began_with()), &standing.memory.settings),
        };
        self.store().write(|rows| {
            remember(rows, standing.memory, standing.gcode)?;
            remember_homed(rows, standing)?;
            if !run.options.program.typed {
                history::add(rows, &run.past(summary.status.word(), summary.seconds))?;
                if let Some(reached) = tape.left_at() {
                    return rows.put(Table::Fact, PROGRESS, &json(reached)?);
                }
                forget(rows, None)?;
            }
            rows.set(Table::Fact, PROGRESS, None)
        })?;
        self.registry.publish(live)?;
        kept
    }

    /// The run that was cut short; `None` when the last one came to its end.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn cut_short(&self) -> Result<Option<CutShort>, JournalError> {
        let [run, reached, progress] = self.store().read(|rows| {
            let fact = |key| rows.text(Table::Fact, key);
            Ok([fact(RUN)?, fact(REACHED)?, fact(PROGRESS)?])
        })?;
        let Some(run) = self.store().parsed(RUN, run)? else { return Ok(None) };
        let reached = self.store().parsed(REACHED, reached.or(progress))?.unwrap_or_default();
        Ok(Some(CutShort { run, reached }))
    }

    /// The work of a run that was cut short.
    ///
    /// # Errors
    /// If the file cannot be read, or its text was not kept.
    pub fn work_of(&self, cut: &CutShort) -> Result<Work, JournalError> {
        cut.work(&self.store().read(|rows| rows.contents())?)
    }

    /// Returns the work of a run that was cut short, and the tape of what the world told it. The machine is at
    /// this place now, its switches are so, and the controller that it hangs on is this one; how far the run is, is told
    /// by its own progress again.
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
        let (steps, contents, last) = self.store().read(|rows| {
            let steps = rows.all(Table::Step)?;
            Ok((steps, rows.contents()?, rows.last(Table::Step)?))
        })?;
        let work = cut.work(&contents)?;
        let parse = |(_, text): (String, String)| serde_json::from_str::<Step>(&text);
        let steps: Result<Vec<Step>, _> = steps.into_iter().map(parse).collect();
        let steps = steps.map_err(|error| JournalError::Unfit(error.to_string()))?;
        self.store().write(|rows| {
            if rows.text(Table::Fact, REACHED)?.is_some() {
                let reached = Reached { place, moving: false, ..cut.reached.clone() };
                rows.put(Table::Fact, PROGRESS, &json(&reached)?)?;
            }
            rows.set(Table::Fact, REACHED, None)
        })?;
        let progress = Progress::new(self.registry.clone(), Some(last + 1));
        let switches = [switches, cut.switches()];
        Ok((work, Tape::playing(steps, contents, &cut.reached, progress, switches)))
    }

    /// The machine of a run that was cut short: a job has its own, part files that of the session.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn machine_of(&self, cut: &CutShort) -> Result<Configuration, JournalError> {
        match self.work_of(cut)? {
            Work::Job(_, machine) => Ok((*machine).clone()),
            Work::Part(_) | Work::Hand(..) => Ok(cut.began_with()),
        }
    }

    /// The runs that are over, oldest first.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn history(&self) -> Result<Vec<Past>, JournalError> {
        history::all(self.store())
    }

    /// The machine is about to be moved by hand. Until that is over it is near where it stands now; a run
    /// that was cut short can still be taken up afterwards.
    pub fn begin_by_hand(&self, standing: &RestingMachine<'_>) -> Result<(), JournalError> {
        let earlier = self.cut_short()?;
        let place = standing.place();
        let reached = Reached { moving: true, place, ..Reached::default() };
        self.store().write(|rows| {
            keep_reached(rows, earlier.as_ref())?;
            rows.put(Table::Fact, PROGRESS, &json(&reached)?)
        })
    }

    /// Records the machine after a move by hand. What a run that was cut short knew
    /// of that holds no longer.
    pub fn end_by_hand(&self, standing: &RestingMachine<'_>) -> Result<(), JournalError> {
        let earlier = self.cut_short()?;
        self.store().write(|rows| {
            keep_reached(rows, earlier.as_ref())?;
            remember(rows, standing.memory, standing.gcode)?;
            remember_homed(rows, standing)?;
            rows.set(Table::Fact, PROGRESS, None)
        })
    }

    fn store(&self) -> &Store {
        &self.registry.store
    }
}

/// Keeps the progress of the run that was cut short: it can still be taken up after what comes now.
fn keep_reached(rows: &Rows<'_>, earlier: Option<&CutShort>) -> rows::Result<()> {
    match earlier {
        Some(earlier) => rows.put(Table::Fact, REACHED, &json(&earlier.reached)?),
        None => Ok(()),
    }
}

/// Removes the run under way from the record.
fn forget(rows: &Rows<'_>, cut: Option<&CutShort>) -> rows::Result<()> {
    if let Some(cut) = cut.filter(|cut| !cut.stopped()) {
        history::add(rows, &cut.run.past("cut short", 0.0))?;
    }
    rows.clear(Table::Step)?;
    rows.clear(Table::Content)?;
    rows.set(Table::Fact, RUN, None)?;
    rows.set(Table::Fact, REACHED, None)
}
