//! Moves by hand as runs, and the homing that comes before other runs.

use crate::homing::Found;
use crate::runner::{Over, Runner};
use crate::world::World;
use crate::{session::Company, session::Session, session::end_event, session::summary};
use kerf_diag::{Code, Diagnostic, Place};
use kerf_journal::{Door, RunOptions, Work};
use kerf_machine::settings::homing::BeforeRuns;
use kerf_machine::{Configuration, Errand, Hand};
use kerf_program::{
    AXES, Answer, At, AxisSet, Button, Command, Interpreter as _, Question, QuestionKind, Status,
};
use kerf_sbp::POSITION_LOST;
use kerf_trace::{Event, Sink, Summary};
use kerf_workspace::{Workspace, confirm, unconfirmed, unverified};
use std::sync::Arc;

impl Session {
    /// Does an errand to its end. Settings of part files stay what they were.
    pub(crate) fn run_hand(
        &mut self,
        errand: Errand,
        machine: &Arc<Configuration>,
        options: RunOptions,
        asks: Option<Question>,
        workspace: &mut Workspace,
        company: Company<'_>,
    ) -> Summary {
        let Company { sink, operator, requests, machine: driven } = company;
        let mode = if options.program.preview { "preview" } else { "move" };
        let file = errand.name().into();
        let hand =
            Hand::new(errand.clone(), machine.clone(), self.memory.position, self.memory.frame);
        let before = options.before;
        let hand = before.unit.into_iter().fold(hand, Hand::told_in);
        let units = hand.settings().linear_unit.symbol();
        sink.event(&Event::Start { file, units, mode, dialect: "hand" });
        let settings = std::mem::replace(&mut self.memory.settings, (**hand.settings()).clone());
        let simulated = self.machine_like(machine, options.inputs, AxisSet::first(AXES));
        let simulated = simulated.begun_at(before.ends_s).pushed(options.pushes);
        let simulated = simulated.doubting(unverified(workspace));
        self.memory.settings = settings;
        let mut world = World::new(simulated, workspace, sink, operator, driven);
        (world.previews, world.machine_is) = (options.program.preview, machine.clone());
        (world.homed, world.homes) = (self.homed, self.homes(machine));
        world.tally = before.tally();
        // No file begins or ends: outputs stay as they are.
        world.typed_files = 1;
        let mut runner = Runner::new(hand, world, requests, options.limits, 0);
        let over = match errand {
            Errand::FindHome(axes) => {
                let over = match runner.asked(asks) {
                    Ok(()) => self.learn_homes(runner.find_home(axes, self.homed)),
                    Err(over) => over,
                };
                runner.told(over)
            }
            _ => runner.run(),
        };
        let Runner { interpreter, mut world, .. } = runner;
        let summary = summary(&interpreter, &mut world, over);
        world.tell(&Event::End(end_event(&summary, &world.machine, None)));
        (self.memory.position, self.memory.frame) =
            (world.machine.position(), *world.machine.frame());
        self.machine = Some(world.into_machine());
        summary
    }

    /// Which axes are homed now, however homing ended.
    fn learn_homes(&mut self, found: Found) -> Over {
        self.homed = self.homed.without(found.lost).union(found.done);
        found.over.unwrap_or(Over { status: Status::Ok, diagnostic: None })
    }

    /// Does what comes before a run: homing, where the machine is set so, or where the operator wants it.
    /// Gives how that ended when the run is not to begin.
    pub(crate) fn before_run(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        workspace: &mut Workspace,
        mut company: Company<'_>,
    ) -> Option<Summary> {
        let machine = self.machine_that_cuts(work, options)?;
        let homing = &machine.homing;
        let first = !std::mem::replace(&mut self.begun, true);
        let at_start = if first { homing.at_program_start } else { AxisSet::EMPTY };
        let mut axes = self.fitted(&machine, homing.at_job_start.union(at_start));
        let missing = self.not_homed(&machine).without(axes);
        let asks = match homing.before_runs {
            BeforeRuns::Ask if !missing.is_empty() => {
                axes = axes.union(missing);
                Some(home_question(&names(&machine, missing)))
            }
            _ => None,
        };
        if homing.before_runs == BeforeRuns::Refuse && !missing.is_empty() {
            return Some(self.not_begun(work, &machine, missing, company.sink));
        }
        if axes.is_empty() {
            return None;
        }
        if let Some(open) = self.wait_for_door(work, options, workspace, company.again()) {
            return Some(open);
        }
        let homed = self.home_before(work, axes, asks, options, workspace, company);
        self.location_is_known(workspace);
        // Whoever says No goes on without.
        let goes_on = matches!(homed.status, Status::Ok | Status::Ended);
        (!goes_on).then_some(homed)
    }

    /// Homes before a run, which goes on from there.
    fn home_before(
        &mut self,
        work: &Work,
        axes: AxisSet,
        asks: Option<Question>,
        options: &mut RunOptions,
        workspace: &mut Workspace,
        company: Company<'_>,
    ) -> Summary {
        company.sink.event(&self.begins(work, options));
        let unit = matches!(work, Work::Part(_)).then_some(self.memory.settings.linear_unit);
        let before = options.before.clone().told_in(unit);
        let machine = match work {
            Work::Job(_, machine) | Work::Hand(_, machine) => machine.clone(),
            Work::Part(_) => Arc::new(self.configuration()),
        };
        let part = RunOptions { inputs: options.inputs.clone(), before, ..RunOptions::default() };
        let homed = self.run_hand(Errand::FindHome(axes), &machine, part, asks, workspace, company);
        options.before.went_on(&homed);
        homed
    }

    /// Nothing moves before the door is shut, where a job waits for that.
    fn wait_for_door(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        workspace: &mut Workspace,
        company: Company<'_>,
    ) -> Option<Summary> {
        let Work::Job(job, machine) = work else { return None };
        if !machine.job.external_start || options.before.door == Door::Shut {
            return None;
        }
        let before = options.before.clone().seeing_to(Door::Only);
        let part = RunOptions { inputs: options.inputs.clone(), before, ..RunOptions::default() };
        let waited = self.run_job(job.clone(), machine, part, workspace, company, None);
        options.before.went_on(&waited);
        options.before.door = Door::Shut;
        (waited.status != Status::Ok).then_some(waited)
    }

    /// The machine of a run that cuts: no preview, no typed line, no move by hand.
    fn machine_that_cuts(&self, work: &Work, options: &RunOptions) -> Option<Arc<Configuration>> {
        match work {
            _ if options.program.preview => None,
            Work::Part(_) if options.program.typed => None,
            Work::Part(program) if program.has_errors() => None,
            Work::Part(_) => Some(Arc::new(self.configuration())),
            Work::Job(_, machine) => Some(machine.clone()),
            Work::Hand(..) => None,
        }
    }

    /// After an emergency stop, a lost link, or the end of Kerf while it moved, nobody knows for sure where the
    /// machine is: the operator has it homed, or says that its location is right. Gives how that ended when the run is not to
    /// begin.
    pub(crate) fn confirm_location(
        &mut self,
        work: &Work,
        options: &mut RunOptions,
        workspace: &mut Workspace,
        mut company: Company<'_>,
    ) -> Option<Summary> {
        let machine = self.machine_that_cuts(work, options)?;
        loop {
            let doubted = unconfirmed(workspace);
            if doubted.is_empty() {
                return None;
            }
            let homes = self.fitted(&machine, doubted);
            let asks = Some(location_question(&names(&machine, doubted), !homes.is_empty()));
            if let Some(open) = self.wait_for_door(work, options, workspace, company.again()) {
                return Some(open);
            }
            let done = self.home_before(work, homes, asks, options, workspace, company.again());
            match done.status {
                Status::Ok => {
                    self.location_is_known(workspace);
                    confirm(workspace, homes);
                }
                Status::Ended => {
                    workspace.stored.set(POSITION_LOST, None);
                    confirm(workspace, doubted);
                    self.machine = self.machine.take().map(|machine| machine.trusting(doubted));
                }
                _ => return Some(done),
            }
        }
    }

    /// Returns `true` if homing comes before a run.
    pub(crate) fn homes_before(&self, work: &Work, options: &RunOptions) -> bool {
        let homing = match work {
            Work::Part(_) if options.program.typed => return false,
            Work::Part(_) => self.machine_is.homing,
            Work::Job(_, machine) => machine.homing,
            Work::Hand(..) => return true,
        };
        let asks = homing.before_runs == BeforeRuns::Ask;
        let axes = homing.at_job_start.union(homing.at_program_start);
        !options.program.preview && (asks || !axes.is_empty())
    }

    /// Axes that can be homed: those that a controller homes by itself, else those whose home switch is fitted.
    pub fn homes(&self, machine: &Configuration) -> AxisSet {
        if let Some(controller) = &self.driven_by {
            return controller.homes;
        }
        let all = AxisSet::first(AXES);
        let fitted = all.iter().filter(|axis| machine.homing.of(*axis).fitted);
        fitted.fold(AxisSet::EMPTY, AxisSet::with)
    }

    /// Those of the axes that can be homed.
    fn fitted(&self, machine: &Configuration, axes: AxisSet) -> AxisSet {
        let homes = self.homes(machine);
        axes.iter().filter(|axis| homes.contains(*axis)).fold(AxisSet::EMPTY, AxisSet::with)
    }

    /// Axes that can be homed and were not.
    pub fn not_homed(&self, machine: &Configuration) -> AxisSet {
        self.homes(machine).without(self.homed)
    }

    /// Takes homed axes out of doubt.
    pub(crate) fn location_is_known(&self, workspace: &mut Workspace) {
        workspace.trusts_location(self.homed);
    }

    /// Tells which axes are not homed, where the machine has switches for them.
    pub(crate) fn tell_not_homed(
        &self,
        machine: &Configuration,
        options: &RunOptions,
        sink: &mut dyn Sink,
    ) {
        let missing = self.not_homed(machine);
        if !missing.is_empty() && !options.program.preview && !options.program.typed {
            let text = format!("not homed: {}", names(machine, missing));
            sink.event(&Event::Message { text: text.into(), t: options.before.ends_s });
        }
    }

    fn not_begun(
        &mut self,
        work: &Work,
        machine: &Configuration,
        missing: AxisSet,
        sink: &mut dyn Sink,
    ) -> Summary {
        let place = Place::line(work.name(), 0);
        let message = format!("{} must be homed first", names(machine, missing));
        let why = Diagnostic::new(Code::NotHomed, place, message).hint("kerf machine home");
        sink.event(&Event::Diag(Box::new(why.clone())));
        let summary = Summary::not_begun(self.memory.settings.linear_unit, Some(Box::new(why)));
        let stands = self.machine.get_or_insert_default();
        sink.event(&Event::End(end_event(&summary, stands, None)));
        summary
    }
}

impl Runner<'_, Hand> {
    /// Asks whether to home first; `Ended` goes on without.
    fn asked(&mut self, question: Option<Question>) -> Result<(), Over> {
        let Some(question) = question else { return Ok(()) };
        let status = match self.ask(&question, At::default())? {
            Answer::Button(Button::Yes) => return Ok(()),
            Answer::Button(Button::No | Button::Continue) => Status::Ended,
            _ => Status::Stopped,
        };
        Err(Over { status, diagnostic: None })
    }

    /// Homes axes. An axis that was homed before keeps the numbers of its zero points, which count from
    /// home; of one that was not they stay where they were on the table.
    fn find_home(&mut self, axes: AxisSet, before: AxisSet) -> Found {
        let found = self.home(axes);
        let mut frame = *self.world.machine.frame();
        for axis in found.zeroed.without(before).iter() {
            frame.working_zero[axis] -= found.shift[axis];
            frame.base_zero[axis] -= found.shift[axis];
        }
        found.done.iter().for_each(|axis| frame.base_zero[axis] = 0.0);
        if found.over.is_none() || !found.zeroed.is_empty() {
            let (working, base) = (found.done, found.done);
            self.world.perform(Command::Location { frame, working, base });
        }
        found
    }

    fn told(&mut self, over: Over) -> Over {
        if let Some(why) = &over.diagnostic {
            self.world.tell_diagnostic((**why).clone());
        }
        over
    }
}

fn names(machine: &Configuration, axes: AxisSet) -> String {
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
