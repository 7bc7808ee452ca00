//! Runs on record: what a run leaves stays, and one that was cut short can be taken up.

use crate::preparation::{Preparation, homes_before};
use crate::run_context::RunContext;
use crate::runs::lines_at_once;
use crate::session::Session;
use crate::settings_text;
use crate::whole_run::WholeRun;
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use kerf_journal::{
    CutShort, Journal, JournalError, KeptWork, Live, Owner, Placed, Remembered, RestingMachine,
    RunOptions, RunUnderWay, Tape, Whereabouts, Work, machine_file::MachineFileError, switches,
    switches::SWITCHES,
};
use kerf_machine::{Configuration, Setting};
use kerf_program::Settings;
use kerf_sim::Simulation;
use kerf_trace::{Event, Summary};
use kerf_workspace::{Workspace, unconfirmed};
use std::sync::Arc;

impl Session {
    /// Recalls what a journal remembers of the machine, a new machine where it remembers nothing; tells whether
    /// the machine is where that says. If not, the values of the workspace tell programs so.
    ///
    /// # Errors
    /// If the journal cannot be read.
    pub fn recall(
        journal: &Journal,
        workspace: &mut Workspace,
    ) -> Result<(Self, Whereabouts), JournalError> {
        let Some(remembered) = journal.memory.read(settings_text::read)? else {
            return Ok((Self::default(), Whereabouts::Known));
        };
        let whereabouts = remembered.whereabouts;
        let mut session = Self::new(remembered.memory.clone());
        session.machine_is = remembered.machine.clone();
        session.stands_as(remembered, workspace);
        Ok((session, whereabouts))
    }

    /// Looks whether `machine.toml` is as Kerf left it. Where it describes another machine, locations are confirmed
    /// once, and what was found is told.
    ///
    /// # Errors
    /// If the journal or the file cannot be read or written.
    pub fn meet_machine(&self, workspace: &mut Workspace) -> Result<Option<String>, JournalError> {
        let Some(journal) = workspace.journal().cloned() else { return Ok(None) };
        let told = journal.settings.meet()?;
        if let Some(told) = &told {
            journal.tell(told);
            workspace.doubts_location(self.machine_is.motors.axes());
        }
        Ok(told)
    }

    /// The machine stands as it is on record.
    fn stands_as(&mut self, remembered: Remembered, workspace: &mut Workspace) {
        if remembered.whereabouts == Whereabouts::Moving {
            workspace.learns_doubt(remembered.machine.motors.axes());
        }
        let (position, frame) = (remembered.memory.position, remembered.memory.frame);
        match &mut self.memory.before_preview {
            Some(before) => (before.position, before.frame) = (position, frame),
            None => (self.memory.position, self.memory.frame) = (position, frame),
        }
        (self.gcode, self.homed) = (remembered.gcode, remembered.homed);
        let machine = Simulation::default().equipped(&self.machine_is, self.homed);
        let switches = switches::read(workspace.stored.get(SWITCHES).unwrap_or_default());
        self.machine = Some(machine.with_truth(&remembered.truth).with_switches(&switches));
    }

    /// Takes over where another process has left the machine since this one knew it; whether one has. While it still
    /// runs nothing is known yet.
    ///
    /// # Errors
    /// If the journal cannot be read.
    pub fn catch_up(&mut self, workspace: &mut Workspace) -> Result<bool, JournalError> {
        let Some(journal) = workspace.journal().cloned() else { return Ok(false) };
        if !journal.memory.another_had_it()? {
            return Ok(false);
        }
        match journal.own() {
            Ok(_owner) => self.take_over(&journal, workspace),
            Err(JournalError::Owned { .. }) => Ok(false),
            Err(error) => Err(error),
        }
    }

    /// The same for the one who has the machine.
    fn take_over(
        &mut self,
        journal: &Journal,
        workspace: &mut Workspace,
    ) -> Result<bool, JournalError> {
        if !journal.memory.another_had_it()? {
            return Ok(false);
        }
        let Some(remembered) = journal.memory.read(settings_text::read)? else { return Ok(false) };
        workspace.stored.renew()?;
        self.stands_as(remembered, workspace);
        Ok(true)
    }

    /// Runs a program or a job on record. What it changes of the settings stays, unless others hold for this run
    /// only: then `settings` are those that stay. Without a journal it is a run like any other.
    ///
    /// # Errors
    /// If the journal cannot be written: then nothing has run, or what it left is not kept.
    pub fn run_on_record(
        &mut self,
        work: impl Into<Work>,
        mut options: RunOptions,
        settings: Option<Settings>,
        workspace: &mut Workspace,
        context: RunContext<'_>,
    ) -> Result<Summary, JournalError> {
        let work = work.into();
        let Some(journal) = workspace.journal().cloned() else {
            return Ok(self.run(work, options, workspace, context));
        };
        let owner = journal.own()?;
        journal.memory.move_settings(settings_text::read)?;
        if settings.is_none() {
            self.refresh(&journal)?;
        }
        if let Some(told) = self.meet_machine(workspace)? {
            let place = SourcePlace::line(journal.settings.file().name().into(), 1);
            let told = Diagnostic::new(Code::AnotherMachine, place, told);
            context.sink.event(&Event::Diag(Box::new(told.severity(Severity::Warning))));
        }
        if context.machine.machine.borrow().facts().placed_by_record {
            self.take_over(&journal, workspace)?;
        }
        options.lines_at_once = lines_at_once(&options, &*context.sink);
        let RunContext { sink, operator, requests, machine } = context;
        let mut whole = WholeRun::new(sink);
        let context = RunContext { sink: &mut whole, operator, requests, machine };
        let summary = self.begin_on_record(work, options, settings, workspace, context, &owner);
        whole.ends();
        summary
    }

    /// The same for the one who has the machine, and knows where it stands.
    fn begin_on_record(
        &mut self,
        work: Work,
        mut options: RunOptions,
        settings: Option<Settings>,
        workspace: &mut Workspace,
        mut context: RunContext<'_>,
        owner: &Owner,
    ) -> Result<Summary, JournalError> {
        let nothing = || JournalError::Unfit("nothing is kept".into());
        let journal = workspace.journal().cloned().ok_or_else(nothing)?;
        if let Some(summary) = self.take_height_map(&work, &mut options, workspace, context.sink) {
            return Ok(summary);
        }
        if let Some(summary) =
            self.confirm_on_record(&work, &mut options, workspace, context.again(), &journal)?
        {
            return Ok(summary);
        }
        if let Some(summary) =
            self.before_run_on_record(&work, &mut options, workspace, context.again(), &journal)?
        {
            return Ok(summary);
        }
        let kept = KeptWork::of(&work)?;
        let run =
            RunUnderWay::new(&self.resting(), &kept, &options, settings, workspace.surroundings());
        // A location that is in doubt is so for everybody from now on, before the run says that nothing moves.
        workspace.keep_doubts();
        workspace.tape = journal.runs.begin(&run, &self.resting(), &kept.bytes)?;
        in_time(&journal, &mut workspace.tape, &context)?;
        let summary = self.go(work, options, workspace, context, None);
        self.over(&run, summary, workspace, owner)
    }

    /// Keeps where the machine is, after its locations were shifted.
    ///
    /// # Errors
    /// If the journal cannot be written, or another process has the machine.
    pub fn keep_place(&self, workspace: &mut Workspace) -> Result<(), JournalError> {
        let Some(journal) = workspace.journal().cloned() else { return Ok(()) };
        let _owner = journal.own()?;
        workspace.keep_doubts();
        journal.runs.end_by_hand(&self.resting())
    }

    /// The operator says whether the location is right, where that is in doubt.
    fn confirm_on_record(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        workspace: &mut Workspace,
        context: RunContext<'_>,
        journal: &Journal,
    ) -> Result<Option<Summary>, JournalError> {
        if unconfirmed(workspace).is_empty() {
            return Ok(None);
        }
        journal.runs.begin_by_hand(&self.resting())?;
        let summary = Preparation::of(self, work, options, workspace, context).confirm_location();
        workspace.keep_doubts();
        journal.runs.end_by_hand(&self.resting())?;
        Ok(summary)
    }

    /// A move by hand, or what comes before another run. Its moves are not on record: until it is over
    /// nobody knows where the machine is.
    fn before_run_on_record(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        workspace: &mut Workspace,
        context: RunContext<'_>,
        journal: &Journal,
    ) -> Result<Option<Summary>, JournalError> {
        let moves = matches!(work, Work::Hand(..)) || homes_before(work, options, &self.machine_is);
        if moves {
            journal.runs.begin_by_hand(&self.resting())?;
        }
        let summary = match work {
            Work::Hand(errand, machine) => {
                let options = options.clone();
                Some(self.run_hand(errand.clone(), machine, options, None, workspace, context))
            }
            _ => Preparation::of(self, work, options, workspace, context).home_first(),
        };
        if moves {
            workspace.trusts_location(self.homed);
            workspace.keep_doubts();
            journal.runs.end_by_hand(&self.resting())?;
        }
        Ok(summary)
    }

    /// Puts on record where somebody left the switches of the simulated machine.
    pub(crate) fn keep_switches(&self, workspace: &mut Workspace) {
        let moved = self.machine.as_ref().map(Simulation::switches).unwrap_or_default();
        let kept = switches::write(&moved);
        if workspace.stored.get(SWITCHES) != kept.as_deref() {
            workspace.stored.set(SWITCHES, kept.as_deref());
            workspace.stored.keep(SWITCHES);
        }
    }

    /// Has another configuration from now on, and keeps a setting of it where that is kept.
    ///
    /// # Errors
    /// It holds, but cannot be kept.
    pub fn configure(
        &mut self,
        setting: &'static Setting,
        wanted: Configuration,
        workspace: &Workspace,
    ) -> Result<(), MachineFileError> {
        let kept = |journal: &Journal| journal.settings.file().keep_one(setting, &wanted);
        let told = workspace.journal().map_or(Ok(()), kept);
        self.hold(wanted);
        told
    }

    /// Keeps the configuration that holds, where settings are kept. Gives how many of them were not yet.
    ///
    /// # Errors
    /// If it cannot be kept.
    pub fn keep_configuration(&self, workspace: &Workspace) -> Result<usize, MachineFileError> {
        let kept = |journal: &Journal| journal.settings.file().keep_all(&self.configuration());
        workspace.journal().map_or(Ok(0), kept)
    }

    /// Returns work, options and session from which a run that was cut short was begun; the workspace is as it was.
    ///
    /// # Errors
    /// If the file cannot be read, or its text was not kept.
    pub fn begun(
        journal: &Journal,
        cut: &CutShort,
        workspace: &mut Workspace,
    ) -> Result<(Work, RunOptions, Self), JournalError> {
        let (work, run) = (journal.runs.work_of(cut)?, &cut.run);
        workspace.as_it_was(&run.folders, run.shell);
        workspace.stored.begin_from(run.values.clone());
        Ok((work, run.options.clone(), Self::as_begun(cut)))
    }

    /// The session as it was when a run that was cut short began.
    fn as_begun(cut: &CutShort) -> Self {
        let kerf_part::Session { sbp, gcode } = cut.memory().clone();
        let machine = Simulation::default().with_switches(&cut.switches());
        let machine_is = Arc::new(cut.machine());
        Self { gcode, machine_is, machine: Some(machine), ..Self::new(sbp) }
    }

    /// The machine as it goes on record.
    fn resting(&self) -> RestingMachine<'_> {
        RestingMachine {
            memory: &self.memory,
            gcode: &self.gcode,
            machine: &self.machine_is,
            homed: self.homed,
            truth: self.machine.as_ref().map(Simulation::truth),
        }
    }

    /// Takes over what somebody changed in the file of the machine since it was looked at last.
    ///
    /// # Errors
    /// The mistakes of the file: with those nothing may move.
    fn refresh(&mut self, journal: &Journal) -> Result<(), JournalError> {
        if let Some(now) = journal.settings.refreshed(self.configuration())? {
            self.memory.settings = now.program.clone();
            self.machine_is = Arc::new(now);
        }
        Ok(())
    }

    /// Takes up a run that was cut short, with a machine that is where this session says.
    ///
    /// # Errors
    /// If it cannot be taken up, or what it left is not kept.
    pub fn resume(
        &mut self,
        cut: &CutShort,
        workspace: &mut Workspace,
        context: RunContext<'_>,
    ) -> Result<Summary, JournalError> {
        let nothing = || JournalError::Unfit("nothing is kept".into());
        let journal = workspace.journal().cloned().ok_or_else(nothing)?;
        let owner = journal.own()?;
        if context.machine.machine.borrow().facts().placed_by_record {
            self.take_over(&journal, workspace)?;
        }
        let stands = Placed { position: self.memory.position, frame: self.memory.frame };
        let switches = self.machine.as_ref().map(Simulation::switches).unwrap_or_default();
        let on = self.driven_by.as_ref().map(|controller| &*controller.name);
        let (work, tape) = journal.runs.take_up(cut, on, stands, switches)?;
        let run = &cut.run;
        // Whoever homed the machine since knows its homes.
        let driven_by = self.driven_by.take();
        *self = Self { homed: self.homed, driven_by, ..Self::as_begun(cut) };
        workspace.as_it_was(&run.folders, run.shell);
        workspace.stored.begin_from(run.values.clone());
        workspace.tape = tape;
        in_time(&journal, &mut workspace.tape, &context)?;
        let summary = self.go(work, run.options.clone(), workspace, context, Some(stands));
        self.over(run, summary, workspace, &owner)
    }

    /// A run is over: what it left is kept.
    fn over(
        &self,
        run: &RunUnderWay,
        summary: Summary,
        workspace: &mut Workspace,
        owner: &Owner,
    ) -> Result<Summary, JournalError> {
        match self.keep_ended(run, &summary, workspace, owner) {
            Ok(()) => Ok(summary),
            // It has not come where it was.
            Err(why @ JournalError::Unfit(_)) => Err(why),
            Err(why) => {
                Err(JournalError::NotKept { summary: Box::new(summary), why: Box::new(why) })
            }
        }
    }

    fn keep_ended(
        &self,
        run: &RunUnderWay,
        summary: &Summary,
        workspace: &mut Workspace,
        _: &Owner,
    ) -> Result<(), JournalError> {
        let mut tape: Tape = std::mem::take(&mut workspace.tape);
        tape.ends();
        self.keep_switches(workspace);
        let Some(journal) = workspace.journal() else { return Ok(()) };
        if let Some(why) = tape.unfit() {
            return Err(JournalError::Unfit(why.to_owned()));
        }
        journal.each_commit_lasts(true)?;
        journal.runs.end(run, &self.resting(), summary, &tape, &self.look(Live::at_rest))?;
        journal.back_up()
    }
}

/// Makes records survive a power cut, written by a thread, where machine time is the time of the world.
fn in_time(
    journal: &Journal,
    tape: &mut Tape,
    context: &RunContext<'_>,
) -> Result<(), JournalError> {
    let in_real_time = context.machine.machine.borrow().in_real_time();
    journal.each_commit_lasts(in_real_time)?;
    if in_real_time {
        tape.writes_behind(context.requests.hurry());
    }
    let leads_s = context.machine.machine.borrow().facts().leads_s;
    if leads_s > 0.0 {
        tape.lags(leads_s);
    }
    Ok(())
}

#[cfg(test)]
mod tests;
