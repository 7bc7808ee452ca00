//! A controller of either kind: one that plans for itself and is followed, or a board that is told each step.

use super::attached::{self, AttachReport, First};
use super::kept_settings::WrittenSetting;
use super::lacks::Lacks;
use super::line_log::LineLog;
use super::queued;
use super::touch_off::TouchedOff;
use super::{CardEnd, CardState, CardWish, Socket};
use crate::answers::Operator;
use crate::learned::Learned;
use crate::session::DrivenBy;
use crate::{Requests, RunContext, Session};
use kerf_diag::Diagnostic;
use kerf_journal::{RunOptions, Work};
use kerf_machine::driver::{CardAnswer, CardJob, CardTask, ToldSetting, Zero, ZeroChange};
use kerf_machine::{Driven, Machine};
use kerf_program::Axes;
use kerf_sequence::Sequence;
use kerf_workspace::{Firmware, Workspace};
use std::sync::Arc;

/// The place where a controller hangs.
#[derive(Clone, Debug)]
pub enum Place {
    /// A controller that plans for itself.
    Followed(Socket),
    /// A board with step queues.
    Queued(queued::Socket),
}

/// A controller that is attached.
#[derive(Clone)]
pub enum Controller {
    /// One that plans for itself.
    Followed(attached::Controller),
    /// A board with step queues.
    Queued(queued::Attached),
}

impl Controller {
    /// Opens the port, waits until the controller has told who it is, and has the session stand where it stands.
    ///
    /// # Errors
    /// Nobody answers, something that is no such controller, or one that takes no orders.
    pub fn attach(
        place: Place,
        first: First,
        session: &mut Session,
        workspace: &mut Workspace,
        is_stopped: impl Fn() -> bool,
    ) -> Result<(Self, AttachReport), String> {
        match place {
            Place::Followed(socket) => {
                attached::Controller::attach(socket, first, session, workspace, is_stopped)
                    .map(|(controller, told)| (Self::Followed(controller), told))
            }
            Place::Queued(socket) => {
                queued::Attached::attach(socket, first, session, workspace, is_stopped)
                    .map(|(attached, told)| (Self::Queued(attached), told))
            }
        }
    }

    /// Opens the port once more, after the controller was lost or had an alarm.
    ///
    /// # Errors
    /// As [`Controller::attach`].
    pub fn attach_again(
        &mut self,
        session: &mut Session,
        workspace: &mut Workspace,
    ) -> Result<AttachReport, String> {
        match self {
            Self::Followed(controller) => controller.attach_again(session, workspace),
            Self::Queued(attached) => attached.attach_again(session, workspace),
        }
    }

    /// The machine, for a run.
    pub fn driven(&self) -> Driven {
        match self {
            Self::Followed(controller) => controller.driven(),
            Self::Queued(attached) => attached.driven(),
        }
    }

    /// Returns `true` if it has kept count of its place since it was driven last: a run can be taken up there.
    const fn knows_place(&self) -> bool {
        match self {
            Self::Followed(controller) => controller.knows_place(),
            Self::Queued(attached) => attached.knows_place(),
        }
    }

    /// Tells in words why a run is not taken up on it: nobody knows where it stands.
    pub fn doubts_place(&self) -> Option<String> {
        (!self.knows_place()).then(|| {
            format!(
                "{} has not kept count of where it stands: a run is taken up at the very place, and nobody knows it",
                self.name()
            )
        })
    }

    /// Its name, as people give it.
    pub fn name(&self) -> &str {
        match self {
            Self::Followed(controller) => controller.name(),
            Self::Queued(attached) => attached.name(),
        }
    }

    /// Looks at it while nothing runs: inputs that changed, by number and whether active, and the place where it stands,
    /// machine frame.
    pub fn attend(&self) -> (Vec<(u8, bool)>, Option<Axes>) {
        match self {
            Self::Followed(controller) => controller.attend(),
            Self::Queued(attached) => attached.attend(),
        }
    }

    /// Returns for what it waits at its own controls while nothing runs, in words.
    pub fn waits(&self) -> Option<&'static str> {
        match self {
            Self::Followed(controller) => controller.waits(),
            Self::Queued(_) => None,
        }
    }

    /// Returns the zero points that it keeps, machine frame.
    pub fn zeros(&self) -> Vec<Zero> {
        match self {
            Self::Followed(controller) => controller.zeros(),
            Self::Queued(_) => Vec::new(),
        }
    }

    /// Has it change a zero point that it keeps, a place being one of the machine.
    ///
    /// # Errors
    /// It keeps none of this name, cannot change it so, is at work, or refuses.
    pub fn keeps_zero(
        &self,
        name: &str,
        change: ZeroChange,
        is_stopped: impl FnMut() -> bool,
    ) -> Result<(), String> {
        match self {
            Self::Followed(controller) => controller.keeps_zero(name, change, is_stopped),
            Self::Queued(attached) => Err(format!(
                "{} keeps no zero points: Kerf keeps its own (ZX, VA)",
                attached.name()
            )),
        }
    }

    /// Returns the steps of a millimetre that it keeps itself, of each axis; none where Kerf's own settings have them.
    pub fn steps_per_mm(&self) -> Vec<f64> {
        match self {
            Self::Followed(controller) => controller.steps_per_mm(),
            Self::Queued(_) => Vec::new(),
        }
    }

    /// Returns all settings that it keeps by number, as it told them last; none of a board, whose machine's file has them.
    pub fn settings(&self) -> Vec<ToldSetting> {
        match self {
            Self::Followed(controller) => controller.settings(),
            Self::Queued(_) => Vec::new(),
        }
    }

    /// Has it keep another value of a setting; the time that is told of files follows.
    ///
    /// # Errors
    /// The controller is busy, has no setting of this number, or refuses the value.
    pub fn keeps_setting(
        &self,
        number: u16,
        value: &str,
        workspace: &mut Workspace,
        is_stopped: impl FnMut() -> bool,
    ) -> Result<WrittenSetting, String> {
        match self {
            Self::Followed(controller) => {
                controller.keeps_setting(number, value, workspace, is_stopped)
            }
            Self::Queued(attached) => Err(format!(
                "{} keeps no settings by number: they are in its machine's file (steps.per_unit)",
                attached.name()
            )),
        }
    }

    /// Returns the record of what was sent and answered; nothing of a board, whose frames are no lines.
    pub fn log(&self) -> Option<&Arc<LineLog>> {
        match self {
            Self::Followed(controller) => Some(controller.log()),
            Self::Queued(_) => None,
        }
    }

    /// Asks it a question in its own language (`$I`); the answer is in the record of its lines.
    ///
    /// # Errors
    /// It is at work, this is no question that leaves the machine as it is, or it knows no answer.
    pub fn asks(&self, question: &str, is_stopped: impl FnMut() -> bool) -> Result<(), String> {
        match self {
            Self::Followed(controller) => controller.asks(question, is_stopped),
            Self::Queued(attached) => {
                Err(format!("{} is asked nothing in lines of text", attached.name()))
            }
        }
    }

    /// Has it touch off the tool for which it waits.
    ///
    /// # Errors
    /// It does no such thing, the tool has touched nothing, or it was stopped.
    pub fn touches_off(&self, is_stopped: impl FnMut() -> bool) -> Result<TouchedOff, String> {
        match self {
            Self::Followed(controller) => controller.touches_off(is_stopped),
            Self::Queued(attached) => Err(format!("{} waits for no tool", attached.name())),
        }
    }

    /// Returns `true` if it has told nothing of itself yet, because it ran a file from its card when its port was opened.
    pub const fn is_beside(&self) -> bool {
        match self {
            Self::Followed(controller) => controller.is_beside(),
            Self::Queued(_) => false,
        }
    }

    /// Returns what a dry run of a file for its card is held against; nothing while it has told nothing of itself.
    pub fn card_limits(&self) -> Option<Lacks> {
        match self {
            Self::Followed(controller) if !controller.is_beside() => Some(controller.limits()),
            _ => None,
        }
    }

    /// A file that it ran from its card is over: keeps where that has left it.
    pub fn stood_by_card(&self, workspace: &mut Workspace) {
        if let Self::Followed(controller) = self {
            controller.stood_by_card(workspace);
        }
    }

    /// Tells whether it has a card with files that it runs by itself.
    ///
    /// # Errors
    /// It has none, for a reason.
    pub fn has_card(&self) -> Result<(), &'static str> {
        match self {
            Self::Followed(controller) => controller.has_card(),
            Self::Queued(_) => Err("a board with step queues has no card of its own"),
        }
    }

    /// Does something on its card; tells how many bytes of how many are there.
    ///
    /// # Errors
    /// It has none, is at work, refuses, says nothing, or it was stopped meanwhile.
    pub fn does_on_card(
        &self,
        task: CardTask,
        tells: &mut dyn FnMut(usize, usize),
        is_stopped: &mut dyn FnMut() -> bool,
    ) -> Result<CardAnswer, String> {
        match self {
            Self::Followed(controller) => controller.does_on_card(task, tells, is_stopped),
            Self::Queued(_) => {
                self.has_card().map(|()| CardAnswer::default()).map_err(str::to_owned)
            }
        }
    }

    /// Returns the file that it runs from its card, whoever has begun it.
    pub fn card_job(&self) -> Option<CardJob> {
        match self {
            Self::Followed(controller) => controller.card_job(),
            Self::Queued(_) => None,
        }
    }

    /// Ends that file where the machine stands, outputs off.
    ///
    /// # Errors
    /// It does not say that it has stopped.
    pub fn stops_card(&self) -> Result<(), String> {
        match self {
            Self::Followed(controller) => controller.stops_card(),
            Self::Queued(_) => Ok(()),
        }
    }

    /// Follows that file to its end.
    ///
    /// # Errors
    /// The line is lost for good: the file goes on.
    pub fn follows_card(
        &self,
        tells: &mut dyn FnMut(&CardState),
        wishes: &mut dyn FnMut() -> Option<CardWish>,
    ) -> Result<CardEnd, String> {
        match self {
            Self::Followed(controller) => controller.follows_card(tells, wishes),
            Self::Queued(_) => Ok(CardEnd::Ended),
        }
    }

    /// Returns what a session has to know of it, where it plans for itself and may be set otherwise meanwhile.
    pub fn driven_by(&self) -> Option<DrivenBy> {
        match self {
            Self::Followed(controller) => Some(controller.driven_by()),
            Self::Queued(_) => None,
        }
    }

    /// Returns the factor that runs on it have shown; nothing of a board, which makes the plan in its time.
    pub fn learned(&self) -> Option<Learned> {
        match self {
            Self::Followed(controller) => Some(controller.learned()),
            Self::Queued(_) => None,
        }
    }

    /// Forgets that factor.
    pub fn forgets_pace(&self, workspace: &mut Workspace) {
        if let Self::Followed(controller) = self {
            controller.forgets_pace(workspace);
        }
    }

    /// Tells why it takes no orders but to go home, in words.
    pub fn locked(&self) -> Option<String> {
        match self {
            Self::Followed(controller) => controller.locked(),
            Self::Queued(_) => None,
        }
    }

    /// Returns the reason for which it does nothing more, in words.
    pub fn fault(&self) -> Option<String> {
        match self {
            Self::Followed(controller) => controller.fault(),
            Self::Queued(attached) => attached.fault(),
        }
    }

    /// It is driven from now on. That is on record until it is left.
    pub fn begins(&self, workspace: &mut Workspace) {
        match self {
            Self::Followed(controller) => controller.begins(workspace),
            Self::Queued(attached) => attached.begins(workspace),
        }
    }

    /// Ends the run on the controller, which stops and switches everything off unless it ended well. Keeps where it was left.
    pub fn ends(&self, well: bool, workspace: &mut Workspace, is_stopped: impl FnMut() -> bool) {
        match self {
            Self::Followed(controller) => controller.ends(well, workspace, is_stopped),
            Self::Queued(attached) => attached.ends(well, workspace, is_stopped),
        }
    }

    /// Lets the controller go, and puts back what was changed in it.
    pub fn detach(&self, workspace: &mut Workspace) {
        match self {
            Self::Followed(controller) => controller.detach(workspace),
            Self::Queued(_) => {}
        }
    }

    /// Looks at a dry run for what the controller does not have, before anything moves: errors, and what it leaves out.
    pub fn lacks(
        &self,
        work: &Work,
        session: &Session,
        options: &RunOptions,
        workspace: &mut Workspace,
        operator: &mut dyn Operator,
    ) -> Vec<Diagnostic> {
        match self {
            Self::Followed(controller) => {
                controller.lacks(work, session, options, workspace, operator)
            }
            Self::Queued(attached) => {
                let queued = attached.queued().borrow();
                let lacks = Lacks::new(queued.name(), queued.facts(), Axes::default());
                drop(queued);
                dry_run(lacks, work, (session, options), workspace, (operator, &mut ()))
            }
        }
    }

    /// Returns the loader of the controller's firmware (UI).
    pub fn firmware(&self, command: &str) -> Firmware {
        match self {
            Self::Followed(controller) => controller.firmware(command),
            Self::Queued(attached) => attached.firmware(),
        }
    }
}

/// Looks at a dry run of the work for what a controller lacks; requests may end it.
pub fn dry_run(
    mut lacks: Lacks,
    work: &Work,
    (session, options): (&Session, &RunOptions),
    workspace: &mut Workspace,
    (operator, requests): (&mut dyn Operator, &mut dyn Requests),
) -> Vec<Diagnostic> {
    let again = match work {
        Work::Part(program) => Work::Part(program.clone()),
        Work::Job(job, machine) => Work::Job(job.clone(), machine.clone()),
        Work::Hand(..) => return Vec::new(),
    };
    if let Work::Job(_, machine) = &again
        && (machine.plasma.use_sequence || machine.laser.use_laser)
    {
        lacks.burns(machine.plasma.use_sequence);
    }
    if let Work::Job(job, machine) = &again {
        let sequence = Sequence::new(job.clone(), machine.clone(), Axes::default());
        sequence.follows_sheet().iter().for_each(|law| lacks.follows(law));
    }
    let machine = crate::simulated_for(lacks.facts());
    let mut options = RunOptions { started: None, ..options.clone() };
    options.program.preview = true;
    let context = RunContext { sink: &mut lacks, operator, requests, machine };
    drop(session.clone().run(again, options, workspace, context));
    lacks.found()
}
