//! Runs on record: what a run leaves stays, and one that was cut short can be taken up.

use crate::Work;
use crate::before::Whole;
use crate::errands::unconfirmed;
use crate::journal::{
    CutShort, Journal, JournalError, KeptWork, KnownMachine, Owner, Placed, Remembered,
    RunUnderWay, Tape, Whereabouts,
};
use crate::session::{Company, RunOptions, Session, Summary};
use crate::shelf::Shelf;
use crate::switches::{self, SWITCHES};
use kerf_diag::{Code, Diagnostic, Place, Severity};
use kerf_program::Settings;
use kerf_sim::Machine;
use kerf_trace::Event;

impl Session {
    /// Recalls what a journal remembers of the machine, a new machine where it remembers nothing; tells whether
    /// the machine is where that says. If not, the values of the shelf tell programs so.
    ///
    /// # Errors
    /// As the journal cannot be read.
    pub fn recall(
        journal: &Journal,
        shelf: &mut Shelf,
    ) -> Result<(Self, Whereabouts), JournalError> {
        let Some(remembered) = journal.remembered()? else {
            return Ok((Self::default(), Whereabouts::Known));
        };
        let whereabouts = remembered.whereabouts;
        let mut session = Self::new(remembered.memory.clone());
        session.machine_is = remembered.machine.clone();
        session.stands_as(remembered, shelf);
        Ok((session, whereabouts))
    }

    /// Looks whether `machine.toml` is as Kerf left it. Where it describes another machine, locations are confirmed
    /// once, and what was found is told.
    ///
    /// # Errors
    /// As the journal or the file cannot be read or written.
    pub fn meet_machine(&self, shelf: &mut Shelf) -> Result<Option<String>, JournalError> {
        let Some(journal) = shelf.journal().cloned() else { return Ok(None) };
        let told = KnownMachine(&journal).meet()?;
        if let Some(told) = &told {
            journal.tell(told);
            shelf.doubts_location(self.machine_is.motors.axes());
        }
        Ok(told)
    }

    /// The machine stands as it is on record.
    fn stands_as(&mut self, remembered: Remembered, shelf: &mut Shelf) {
        if remembered.whereabouts == Whereabouts::Moving {
            shelf.learns_doubt(remembered.machine.motors.axes());
        }
        let (position, frame) = (remembered.memory.position, remembered.memory.frame);
        match &mut self.memory.before_preview {
            Some(before) => (before.position, before.frame) = (position, frame),
            None => (self.memory.position, self.memory.frame) = (position, frame),
        }
        (self.gcode, self.homed) = (remembered.gcode, remembered.homed);
        let machine = Machine::default().equipped(&self.machine_is, self.homed);
        let switches = switches::read(shelf.stored.get(SWITCHES).unwrap_or_default());
        self.machine = Some(machine.with_truth(&remembered.truth).with_switches(&switches));
    }

    /// Takes over where another process has left the machine since this one knew it; whether one has. While it still
    /// runs nothing is known yet.
    ///
    /// # Errors
    /// As the journal cannot be read.
    pub fn catch_up(&mut self, shelf: &mut Shelf) -> Result<bool, JournalError> {
        let Some(journal) = shelf.journal().cloned() else { return Ok(false) };
        if !journal.another_had_it()? {
            return Ok(false);
        }
        match journal.own() {
            Ok(_owner) => self.take_over(&journal, shelf),
            Err(JournalError::Owned { .. }) => Ok(false),
            Err(error) => Err(error),
        }
    }

    /// The same for the one who has the machine.
    fn take_over(&mut self, journal: &Journal, shelf: &mut Shelf) -> Result<bool, JournalError> {
        if !journal.another_had_it()? {
            return Ok(false);
        }
        let Some(remembered) = journal.remembered()? else { return Ok(false) };
        shelf.stored.renew()?;
        self.stands_as(remembered, shelf);
        Ok(true)
    }

    /// Runs a program or a job on record. What it changes of the settings stays, unless others hold for this run
    /// only: then `settings` are those that stay. Without a journal it is a run like any other.
    ///
    /// # Errors
    /// As the journal cannot be written: then nothing has run, or what it left is not kept.
    pub fn run_on_record(
        &mut self,
        work: impl Into<Work>,
        mut options: RunOptions,
        settings: Option<Settings>,
        shelf: &mut Shelf,
        company: Company<'_>,
    ) -> Result<Summary, JournalError> {
        let work = work.into();
        let Some(journal) = shelf.journal().cloned() else {
            return Ok(self.run(work, options, shelf, company));
        };
        let owner = journal.own()?;
        journal.move_settings()?;
        if settings.is_none() {
            journal.refresh(self)?;
        }
        if let Some(told) = self.meet_machine(shelf)? {
            let place = Place::line(journal.machine_file().name().into(), 1);
            let told = Diagnostic::new(Code::AnotherMachine, place, told);
            company.sink.event(&Event::Diag(Box::new(told.severity(Severity::Warning))));
        }
        // A controller says itself where it stands.
        if options.controller.is_none() {
            self.take_over(&journal, shelf)?;
        }
        options.lines_at_once = options.lines_for(&*company.sink);
        let Company { sink, operator, requests, machine } = company;
        let mut whole = Whole::new(sink);
        let company = Company { sink: &mut whole, operator, requests, machine };
        let summary = self.begin_on_record(work, options, settings, shelf, company, &owner);
        whole.ends();
        summary
    }

    /// The same for the one who has the machine, and knows where it stands.
    fn begin_on_record(
        &mut self,
        work: Work,
        mut options: RunOptions,
        settings: Option<Settings>,
        shelf: &mut Shelf,
        mut company: Company<'_>,
        owner: &Owner,
    ) -> Result<Summary, JournalError> {
        let nothing = || JournalError::Unfit("nothing is kept".into());
        let journal = shelf.journal().cloned().ok_or_else(nothing)?;
        if let Some(summary) =
            self.confirm_on_record(&work, &mut options, shelf, company.again(), &journal)?
        {
            return Ok(summary);
        }
        if let Some(summary) =
            self.before_run_on_record(&work, &mut options, shelf, company.again(), &journal)?
        {
            return Ok(summary);
        }
        let kept = KeptWork::of(&work)?;
        let run = RunUnderWay::new(self, &kept, &options, settings, shelf);
        // A location that is in doubt is so for everybody from now on, before the run says that nothing moves.
        shelf.keep_doubts();
        shelf.tape = journal.begin(&run, self, &kept.bytes)?;
        in_time(&journal, &mut shelf.tape, &company)?;
        let summary = self.go(work, options, shelf, company, None);
        self.over(&run, summary, shelf, owner)
    }

    /// Keeps where the machine is, after its locations were shifted.
    ///
    /// # Errors
    /// As the journal cannot be written, or another process has the machine.
    pub fn keep_place(&self, shelf: &mut Shelf) -> Result<(), JournalError> {
        let Some(journal) = shelf.journal().cloned() else { return Ok(()) };
        let _owner = journal.own()?;
        shelf.keep_doubts();
        journal.end_by_hand(self)
    }

    /// The operator says whether the location is right, where that is in doubt.
    fn confirm_on_record(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        shelf: &mut Shelf,
        company: Company<'_>,
        journal: &Journal,
    ) -> Result<Option<Summary>, JournalError> {
        if unconfirmed(shelf).is_empty() {
            return Ok(None);
        }
        journal.begin_by_hand(self)?;
        let summary = self.confirm_location(work, options, shelf, company);
        shelf.keep_doubts();
        journal.end_by_hand(self)?;
        Ok(summary)
    }

    /// A move by hand, or what comes before another run. Its moves are not on record: until it is over
    /// nobody knows where the machine is.
    fn before_run_on_record(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        shelf: &mut Shelf,
        company: Company<'_>,
        journal: &Journal,
    ) -> Result<Option<Summary>, JournalError> {
        let moves = matches!(work, Work::Hand(..)) || self.homes_before(work, options);
        if moves {
            journal.begin_by_hand(self)?;
        }
        let summary = match work {
            Work::Hand(errand, machine) => {
                let options = options.clone();
                Some(self.run_hand(errand.clone(), machine, options, None, shelf, company))
            }
            _ => self.before_run(work, options, shelf, company),
        };
        if moves {
            self.location_is_known(shelf);
            shelf.keep_doubts();
            journal.end_by_hand(self)?;
        }
        Ok(summary)
    }

    /// Takes up a run that was cut short, with a machine that is where this session says.
    ///
    /// # Errors
    /// As it cannot be taken up, or what it left is not kept.
    pub fn resume(
        &mut self,
        cut: &CutShort,
        shelf: &mut Shelf,
        company: Company<'_>,
    ) -> Result<Summary, JournalError> {
        let nothing = || JournalError::Unfit("nothing is kept".into());
        let journal = shelf.journal().cloned().ok_or_else(nothing)?;
        let owner = journal.own()?;
        self.take_over(&journal, shelf)?;
        let stands = Placed { position: self.memory.position, frame: self.memory.frame };
        let switches = self.machine.as_ref().map(Machine::switches).unwrap_or_default();
        let (work, tape) = journal.take_up(cut, stands, switches)?;
        let run = &cut.run;
        // Whoever homed the machine since knows its homes.
        *self = Self { homed: self.homed, ..cut.session() };
        shelf.as_it_was(&run.folders, run.shell);
        shelf.stored.begin_from(run.values.clone());
        shelf.tape = tape;
        in_time(&journal, &mut shelf.tape, &company)?;
        let summary = self.go(work, run.options.clone(), shelf, company, Some(stands));
        self.over(run, summary, shelf, &owner)
    }

    /// A run is over: what it left is kept.
    fn over(
        &self,
        run: &RunUnderWay,
        summary: Summary,
        shelf: &mut Shelf,
        owner: &Owner,
    ) -> Result<Summary, JournalError> {
        match self.keep_ended(run, &summary, shelf, owner) {
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
        shelf: &mut Shelf,
        _: &Owner,
    ) -> Result<(), JournalError> {
        let mut tape: Tape = std::mem::take(&mut shelf.tape);
        tape.ends();
        self.keep_switches(shelf);
        let Some(journal) = shelf.journal() else { return Ok(()) };
        if let Some(why) = tape.unfit() {
            return Err(JournalError::Unfit(why.to_owned()));
        }
        journal.each_commit_lasts(true)?;
        journal.end(run, self, summary, &tape)?;
        journal.back_up()
    }
}

/// Makes records survive a power cut, written by a thread, where machine time is the time of the world.
fn in_time(journal: &Journal, tape: &mut Tape, company: &Company<'_>) -> Result<(), JournalError> {
    let is_real = company.machine.borrow().is_real();
    journal.each_commit_lasts(is_real)?;
    if is_real {
        tape.writes_behind(company.requests.hurry());
    }
    Ok(())
}
