//! Preparation of a run: the location is confirmed where it is in doubt, axes are homed, where the machine is set so or
//! where the operator wants it.

use crate::run_context::RunContext;
use crate::run_summary::end_event;
use crate::session::Session;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_journal::{Door, RunOptions, Work};
use kerf_machine::settings::homing::BeforeRuns;
use kerf_machine::{Configuration, Errand};
use kerf_program::{AxisSet, Button, Question, QuestionKind, Status};
use kerf_sbp::POSITION_LOST;
use kerf_trace::{Event, Summary};
use kerf_workspace::{Workspace, confirm, unconfirmed};
use std::sync::Arc;

/// Work that is about to begin, and what it is lent.
pub(crate) struct Preparation<'a, 'c> {
    session: &'a mut Session,
    work: &'a Work,
    options: &'a mut RunOptions,
    workspace: &'a mut Workspace,
    context: RunContext<'c>,
}

impl<'a, 'c> Preparation<'a, 'c> {
    pub const fn of(
        session: &'a mut Session,
        work: &'a Work,
        options: &'a mut RunOptions,
        workspace: &'a mut Workspace,
        context: RunContext<'c>,
    ) -> Self {
        Self { session, work, options, workspace, context }
    }

    /// Does everything that comes before a run. Gives how that ended when the run is not to begin.
    pub fn prepare(mut self) -> Option<Summary> {
        self.confirm_location().or_else(|| self.home_first())
    }

    /// After an emergency stop, a lost link, or the end of Kerf while it moved, nobody knows for sure where the
    /// machine is: the operator has it homed, or says that its location is right. Gives how that ended when the run is
    /// not to begin.
    pub fn confirm_location(&mut self) -> Option<Summary> {
        let machine = self.machine_that_cuts()?;
        loop {
            let doubted = unconfirmed(self.workspace);
            if doubted.is_empty() {
                return None;
            }
            let homes = self.session.fitted(&machine, doubted);
            let asks = Some(location_question(&axis_names(&machine, doubted), !homes.is_empty()));
            if let Some(open) = self.wait_for_door() {
                return Some(open);
            }
            let done = self.home(homes, asks);
            match done.status {
                Status::Ok => {
                    self.workspace.trusts_location(self.session.homed);
                    confirm(self.workspace, homes);
                }
                Status::Ended => {
                    self.workspace.stored.set(POSITION_LOST, None);
                    confirm(self.workspace, doubted);
                    self.session.machine =
                        self.session.machine.take().map(|machine| machine.trusting(doubted));
                }
                _ => return Some(done),
            }
        }
    }

    /// Does what comes before a run: homing, where the machine is set so, or where the operator wants it.
    /// Gives how that ended when the run is not to begin.
    pub fn home_first(&mut self) -> Option<Summary> {
        let machine = self.machine_that_cuts()?;
        let homing = &machine.homing;
        let first = !std::mem::replace(&mut self.session.begun, true);
        let at_start = if first { homing.at_program_start } else { AxisSet::EMPTY };
        let mut axes = self.session.fitted(&machine, homing.at_job_start.union(at_start));
        let missing = self.session.not_homed(&machine).without(axes);
        let asks = match homing.before_runs {
            BeforeRuns::Ask if !missing.is_empty() => {
                axes = axes.union(missing);
                Some(home_question(&axis_names(&machine, missing)))
            }
            _ => None,
        };
        if homing.before_runs == BeforeRuns::Refuse && !missing.is_empty() {
            return Some(self.not_begun(&machine, missing));
        }
        if axes.is_empty() {
            return None;
        }
        if let Some(open) = self.wait_for_door() {
            return Some(open);
        }
        let homed = self.home(axes, asks);
        self.workspace.trusts_location(self.session.homed);
        // Whoever says No goes on without.
        let goes_on = matches!(homed.status, Status::Ok | Status::Ended);
        (!goes_on).then_some(homed)
    }

    /// Homes before a run, which goes on from there.
    fn home(&mut self, axes: AxisSet, asks: Option<Question>) -> Summary {
        self.context.sink.event(&self.session.begins(self.work, self.options));
        let unit =
            matches!(self.work, Work::Part(_)).then_some(self.session.memory.settings.linear_unit);
        let before = self.options.before.clone().told_in(unit);
        let machine = match self.work {
            Work::Job(_, machine) | Work::Hand(_, machine) => machine.clone(),
            Work::Part(_) => Arc::new(self.session.configuration()),
        };
        let part =
            RunOptions { inputs: self.options.inputs.clone(), before, ..RunOptions::default() };
        let (errand, context) = (Errand::FindHome(axes), self.context.again());
        let homed = self.session.run_hand(errand, &machine, part, asks, self.workspace, context);
        self.options.before.went_on(&homed);
        homed
    }

    /// Waits until the door is shut, where the job asks for that.
    fn wait_for_door(&mut self) -> Option<Summary> {
        let Work::Job(job, machine) = self.work else { return None };
        if !machine.job.external_start || self.options.before.door == Door::Shut {
            return None;
        }
        let before = self.options.before.clone().seeing_to(Door::Only);
        let part =
            RunOptions { inputs: self.options.inputs.clone(), before, ..RunOptions::default() };
        let (job, context) = (job.clone(), self.context.again());
        let waited = self.session.run_job(job, machine, part, self.workspace, context, None);
        self.options.before.went_on(&waited);
        self.options.before.door = Door::Shut;
        (waited.status != Status::Ok).then_some(waited)
    }

    /// The machine of a run that cuts: no preview, no typed line, no move by hand.
    fn machine_that_cuts(&self) -> Option<Arc<Configuration>> {
        match self.work {
            _ if self.options.program.preview => None,
            Work::Part(_) if self.options.program.typed => None,
            Work::Part(program) if program.has_errors() => None,
            Work::Part(_) => Some(Arc::new(self.session.configuration())),
            Work::Job(_, machine) => Some(machine.clone()),
            Work::Hand(..) => None,
        }
    }

    fn not_begun(&mut self, machine: &Configuration, missing: AxisSet) -> Summary {
        let place = SourcePlace::line(self.work.name(), 0);
        let message = format!("{} must be homed first", axis_names(machine, missing));
        let why = Diagnostic::new(Code::NotHomed, place, message).hint("kerf machine home");
        self.context.sink.event(&Event::Diag(Box::new(why.clone())));
        let summary =
            Summary::not_begun(self.session.memory.settings.linear_unit, Some(Box::new(why)));
        let stands = self.session.machine.get_or_insert_default();
        self.context.sink.event(&Event::End(end_event(
            &summary,
            &stands.model,
            stands.astray(),
            None,
        )));
        summary
    }
}

/// Returns `true` if homing comes before a run.
pub(crate) fn homes_before(work: &Work, options: &RunOptions, machine: &Configuration) -> bool {
    let homing = match work {
        Work::Part(_) if options.program.typed => return false,
        Work::Part(_) => machine.homing,
        Work::Job(_, machine) => machine.homing,
        Work::Hand(..) => return true,
    };
    let asks = homing.before_runs == BeforeRuns::Ask;
    let axes = homing.at_job_start.union(homing.at_program_start);
    !options.program.preview && (asks || !axes.is_empty())
}

/// The names of axes, as a machine calls them.
pub(crate) fn axis_names(machine: &Configuration, axes: AxisSet) -> String {
    let names: Vec<_> = axes.iter().map(|axis| machine.motors.axis_name(axis)).collect();
    names.join(", ")
}

fn location_question(axes: &str, homes: bool) -> Question {
    let text = format!("Position unverified: {axes}.");
    let (text, buttons) = match homes {
        true => {
            let text = format!("{text} Home now? Continue, if the location is right as it is.");
            (text, vec![Button::Yes, Button::Continue, Button::Cancel])
        }
        false => {
            let text = format!("{text} Continue, if the location is right; else zero it first.");
            (text, vec![Button::Continue, Button::Cancel])
        }
    };
    let default = buttons.len() - 1;
    let title = "Location".into();
    let kind = QuestionKind::Location;
    Question { kind, text, title, buttons, default, prefill: String::new(), icon: 48, until: None }
}

fn home_question(axes: &str) -> Question {
    Question {
        kind: QuestionKind::Msgbox,
        text: format!("Not homed: {axes}. Home now? No runs without."),
        title: "Homing".into(),
        buttons: vec![Button::Yes, Button::No, Button::Cancel],
        default: 2,
        prefill: String::new(),
        icon: 32,
        until: None,
    }
}
