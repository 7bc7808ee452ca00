//! A controller that a session drives from run to run: attaching it, comparing its place with the record, leaving it.

use super::either::dry_run;
use super::lacks::{lines, listed};
use super::stopwatch::Stopwatch;
use super::{
    CardEnd, CardState, CardWish, Connection, Lacks, LineLog, Socket, TouchedOff, WrittenSetting,
    card, kept_settings, touch_off, zeros,
};
use crate::Session;
use crate::answers::Operator;
use crate::kept_pace::keep_pace;
use crate::learned::Learned;
use crate::own_pace::OwnPace;
use crate::session::DrivenBy;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_journal::{RunOptions, Work, facts::Fact};
use kerf_machine::driver::{
    CardAnswer, CardJob, CardTask, Changed, Signal, ToldSetting, Zero, ZeroChange,
};
use kerf_machine::{Driven, Errand, Machine};
use kerf_program::{Axes, AxisSet, HostError};
use kerf_transport::Line;
use kerf_workspace::{Firmware, Workspace};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

/// Said of a controller that runs a file from its card while nothing of Kerf runs.
const RUNS_CARD: &str = "it runs a file from its own card: STOP ends it";

/// Steps that come before anything else.
#[derive(Clone, Copy, Debug, Default)]
pub struct First {
    /// The machine goes home.
    pub home: bool,
    /// The controller is unlocked after an alarm, without homing.
    pub unlock: bool,
    /// The controller may stay locked: the operator homes the machine later.
    pub may_be_locked: bool,
    /// It may run a file from its card, and tell nothing of itself before that is over.
    pub beside_card: bool,
}

/// Sentences about a controller that was attached.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AttachReport {
    /// Notes: nobody has to act on them.
    pub notes: Vec<String>,
    /// Warnings: the machine may be elsewhere than Kerf believes.
    pub warnings: Vec<String>,
}

/// A controller that is attached.
#[derive(Clone)]
pub struct Controller {
    socket: Socket,
    /// It has kept count of its place since it was driven last.
    counts: bool,
    /// It ran a file from its card when its port was opened, and has told nothing of itself yet.
    is_beside: bool,
    connection: Rc<RefCell<Connection>>,
}

/// The value that says where a controller without homing was left: its port, its own place, and that of the
/// machine. Runs on the simulated machine leave the location elsewhere.
const LEFT: &str = Fact::ControllerLeft.key();

/// The value that names the port of a controller while it is driven.
const DRIVEN: &str = Fact::ControllerDriven.key();

/// The value that says which setting of the controller at a port was changed: its port, the setting, its value before
/// and since.
const CHANGED: &str = Fact::ControllerChanged.key();

/// The value that says which outputs a controller was left with on: its port, a bit each.
const OUTPUTS: &str = Fact::ControllerOutputs.key();

/// Places closer than this are the same, mm: a controller tells thousandths.
const SAME_MM: f64 = 0.01;

impl Controller {
    /// Opens the port, waits until the controller has told who it is, and has the session stand where it stands. What goes
    /// on from a run that was abandoned is stopped first.
    ///
    /// # Errors
    /// Nobody answers, something that is no such controller, or one that takes no orders.
    pub fn attach(
        socket: Socket,
        first: First,
        session: &mut Session,
        workspace: &mut Workspace,
        is_stopped: impl Fn() -> bool,
    ) -> Result<(Self, AttachReport), String> {
        let abandoned = workspace.stored.get(DRIVEN) == Some(&*socket.port);
        let (driver, line) = (socket.opens)()?;
        let (line, log) = (line as Box<dyn Line>, socket.log.clone());
        let mut connection = match first.beside_card && !abandoned {
            true => Connection::open_beside_card(&socket.name, driver, line, log)?,
            false => Connection::open_logged(&socket.name, (driver, line), log, abandoned)?,
        };
        connection.opens_again(socket.opens.clone());
        if let Some(job) = connection.card_job() {
            return Ok(Self::beside(socket, connection, &job, session));
        }
        let mut told = AttachReport::default();
        let axes: String = "XYZABC".chars().take(connection.facts().axes).collect();
        told.notes.push(format!("{}: {}, axes {axes}", socket.name, connection.facts().name));
        told.notes.extend(keeps_changed(&socket, &mut connection, workspace));
        if first.unlock {
            connection.unlock()?;
        }
        if first.home {
            connection.go_home(is_stopped)?;
        }
        if let Some(locked) = connection.locked() {
            if !first.may_be_locked {
                return Err(locked);
            }
            told.warnings.push(locked);
        }
        // Outputs and switches of the simulated machine are none of this one's.
        session.machine = None;
        if !abandoned && !connection.facts().is_fresh {
            told.warnings.extend(keeps_on(&socket, &mut connection, session, workspace));
        }
        connection.learned = Learned::of(&socket.port, &workspace.stored);
        let connection = Rc::new(RefCell::new(connection));
        let mut controller = Self { socket, counts: true, is_beside: false, connection };
        session.driven_by = Some(controller.driven_by());
        controller.finds_place(first, abandoned, session, workspace, &mut told);
        Ok((controller, told))
    }

    /// Has hold of a controller that runs a file from its card: it is attached anew when that is over.
    fn beside(
        socket: Socket,
        connection: Connection,
        job: &CardJob,
        session: &mut Session,
    ) -> (Self, AttachReport) {
        let note = format!("{} runs {} from its own card: it is followed", socket.name, job.name);
        let connection = Rc::new(RefCell::new(connection));
        let controller = Self { socket, counts: false, is_beside: true, connection };
        session.machine = None;
        session.driven_by = Some(controller.driven_by());
        (controller, AttachReport { notes: vec![note], warnings: Vec::new() })
    }

    /// Holds the place that the controller tells against the one on record.
    fn finds_place(
        &mut self,
        first: First,
        abandoned: bool,
        session: &mut Session,
        workspace: &mut Workspace,
        told: &mut AttachReport,
    ) {
        let connection = self.connection.clone();
        let mut connection = connection.borrow_mut();
        let (stands, axes) = (connection.stands(), AxisSet::first(connection.facts().axes));
        if connection.facts().homes {
            told.notes.extend(takes_place(&connection, session, stands));
            axes.iter().for_each(|axis| session.homed.insert(axis));
            if first.home {
                workspace.trusts_location(axes);
            }
            return;
        }
        match (self.left_at(stands, workspace), abandoned) {
            (Some(place), false) => told.notes.extend(takes_place(&connection, session, place)),
            (None, false) => {
                self.counts = false;
                told.notes.push(self.believed(session.memory.position));
            }
            (_, true) => {
                let counted = self.counted_on(stands, workspace);
                self.counts = counted.is_some();
                session.memory.position = counted.unwrap_or(session.memory.position);
                told.warnings.push(self.abandoned(session.memory.position));
                workspace.doubts_location(axes);
            }
        }
        connection.is_at(session.memory.position);
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
        self.connection.borrow_mut().let_go();
        let attached = Self::attach(
            self.socket.clone(),
            First { may_be_locked: true, beside_card: self.is_beside, ..First::default() },
            session,
            workspace,
            || false,
        )?;
        // Whoever has hold of the connection has the new one from now on.
        let (again, told) = attached;
        self.connection.swap(&again.connection);
        (self.counts, self.is_beside) = (again.counts, again.is_beside);
        Ok(told)
    }

    /// The machine, for a run.
    pub fn driven(&self) -> Driven {
        self.connection.clone()
    }

    /// Returns `true` if it has kept count of its place since it was driven last, or was homed: a run can be taken up there.
    pub const fn knows_place(&self) -> bool {
        self.counts
    }

    /// Its name, as people give it.
    pub fn name(&self) -> &str {
        &self.socket.name
    }

    /// The connection to it.
    pub fn connection(&self) -> &Rc<RefCell<Connection>> {
        &self.connection
    }

    /// Looks at it while nothing runs: inputs that changed, by number and whether active, and the place where it stands,
    /// machine frame.
    pub fn attend(&self) -> (Vec<(u8, bool)>, Option<Axes>) {
        let mut connection = self.connection.borrow_mut();
        connection.look();
        connection.hears_facts();
        if connection.waits_for_tool() {
            connection.signal(Signal::ByHand);
        }
        (connection.take_inputs(), connection.place())
    }

    /// Returns for what it waits at its own controls while nothing runs, or that it runs a file by itself, in words.
    pub fn waits(&self) -> Option<&'static str> {
        let waits = self.connection.borrow_mut().waits();
        waits.or_else(|| self.card_job().map(|_| RUNS_CARD))
    }

    /// Returns the zero points that the controller keeps, machine frame.
    pub fn zeros(&self) -> Vec<Zero> {
        zeros::zeros_of(&mut self.connection.borrow_mut())
    }

    /// Has the controller change a zero point, a place being one of the machine.
    ///
    /// # Errors
    /// As [`change_zero`](zeros::change_zero).
    pub fn keeps_zero(
        &self,
        name: &str,
        change: ZeroChange,
        is_stopped: impl FnMut() -> bool,
    ) -> Result<(), String> {
        zeros::change_zero(&mut self.connection.borrow_mut(), name, change, is_stopped)
    }

    /// Returns the steps of a millimetre that the controller keeps, of each axis; none where it keeps none.
    pub fn steps_per_mm(&self) -> Vec<f64> {
        self.connection.borrow_mut().link.driver().steps_per_mm()
    }

    /// Returns all settings that the controller keeps by number, as it told them last.
    pub fn settings(&self) -> Vec<ToldSetting> {
        self.connection.borrow_mut().link.driver().told_settings()
    }

    /// Has the controller keep another value of a setting; the time that is told of files follows.
    ///
    /// # Errors
    /// As [`change_setting`](kept_settings::change_setting).
    pub fn keeps_setting(
        &self,
        number: u16,
        value: &str,
        workspace: &mut Workspace,
        is_stopped: impl FnMut() -> bool,
    ) -> Result<WrittenSetting, String> {
        let mut connection = self.connection.borrow_mut();
        let was = connection.link.driver().setting(number).unwrap_or_default().to_owned();
        let kept = kept_settings::change_setting(&mut connection, number, value, is_stopped)?;
        drop(connection);
        self.keeps_pace(workspace);
        Ok(WrittenSetting { number, was, kept })
    }

    /// Asks the controller a question in its own language.
    ///
    /// # Errors
    /// As [`ask`](kept_settings::ask).
    pub fn asks(&self, question: &str, is_stopped: impl FnMut() -> bool) -> Result<(), String> {
        kept_settings::ask(&mut self.connection.borrow_mut(), question, is_stopped)
    }

    /// Keeps how it makes moves, for whoever tells the time of a file without opening it; returns that.
    fn keeps_pace(&self, workspace: &mut Workspace) -> Option<OwnPace> {
        let pace = OwnPace::of(self.connection.borrow().facts());
        pace.iter().for_each(|pace| keep_pace(pace, &self.socket.port, &mut workspace.stored));
        pace
    }

    /// Returns what a session has to know of it, by its settings as it told them last.
    pub fn driven_by(&self) -> DrivenBy {
        let connection = self.connection.borrow();
        let facts = connection.facts();
        let homes = if facts.homes { AxisSet::first(facts.axes) } else { AxisSet::EMPTY };
        let pace = OwnPace::of(facts).map(|pace| pace.learned(connection.learned));
        DrivenBy { name: self.socket.name.clone(), homes, pace }
    }

    /// Returns the record of what was sent to the controller and what it answered.
    pub fn log(&self) -> &Arc<LineLog> {
        &self.socket.log
    }

    /// Returns `true` if it has told nothing of itself yet, because it ran a file from its card when its port was opened.
    pub const fn is_beside(&self) -> bool {
        self.is_beside
    }

    /// Tells whether it has a card with files that it runs by itself.
    ///
    /// # Errors
    /// It has none, for a reason.
    pub fn has_card(&self) -> Result<(), &'static str> {
        self.connection.borrow_mut().has_card()
    }

    /// Does something on its card.
    ///
    /// # Errors
    /// As [`do_on_card`](card::do_on_card).
    pub fn does_on_card(
        &self,
        task: CardTask,
        tells: &mut dyn FnMut(usize, usize),
        is_stopped: &mut dyn FnMut() -> bool,
    ) -> Result<CardAnswer, String> {
        card::do_on_card(&mut self.connection.borrow_mut(), task, tells, is_stopped)
    }

    /// Returns the file that it runs from its card, whoever has begun it.
    pub fn card_job(&self) -> Option<CardJob> {
        self.connection.borrow_mut().link.driver().card_job()
    }

    /// Ends that file where the machine stands, outputs off.
    ///
    /// # Errors
    /// As [`stop_card`](card::stop_card).
    pub fn stops_card(&self) -> Result<(), String> {
        card::stop_card(&mut self.connection.borrow_mut())
    }

    /// Follows that file to its end.
    ///
    /// # Errors
    /// As [`follow_card`](card::follow_card).
    pub fn follows_card(
        &self,
        tells: &mut dyn FnMut(&CardState),
        wishes: &mut dyn FnMut() -> Option<CardWish>,
    ) -> Result<CardEnd, String> {
        card::follow_card(&mut self.connection.borrow_mut(), tells, wishes)
    }

    /// Tells why it takes no orders but to go home, in words.
    pub fn locked(&self) -> Option<String> {
        self.connection.borrow_mut().locked()
    }

    /// Returns `true` if it has begun a change of tools by itself and waits for the tool.
    pub fn waits_for_tool(&self) -> bool {
        self.connection.borrow_mut().waits_for_tool()
    }

    /// Has it touch off the tool for which it waits.
    ///
    /// # Errors
    /// As [`touch_off`](touch_off::touch_off).
    pub fn touches_off(&self, is_stopped: impl FnMut() -> bool) -> Result<TouchedOff, String> {
        touch_off::touch_off(&mut self.connection.borrow_mut(), is_stopped)
    }

    /// Returns the reason for which it does nothing more, in words.
    pub fn fault(&self) -> Option<String> {
        self.connection.borrow().fault().map(|fault| fault.message.clone())
    }

    /// Puts on record that a run drives the controller, until its run ends.
    pub fn begins(&self, workspace: &mut Workspace) {
        self.keeps_place(workspace);
        workspace.stored.set(DRIVEN, Some(&self.socket.port));
        let pace = self.keeps_pace(workspace);
        self.connection.borrow_mut().stopwatch = Stopwatch::of(pace);
    }

    /// The run is over; when it did not end well, everything is stopped and switched off. Keeps where it was left.
    pub fn ends(&self, well: bool, workspace: &mut Workspace, is_stopped: impl FnMut() -> bool) {
        self.connection.borrow_mut().close(well, is_stopped);
        self.learns(well, workspace);
        self.keeps_place(workspace);
        workspace.stored.set(DRIVEN, None);
        let on = self.connection.borrow().has_on();
        let left = (on != 0).then(|| serde_json::to_string(&(&self.socket.port, on)).ok());
        workspace.stored.set(OUTPUTS, left.flatten().as_deref());
    }

    /// Learns from a run that went well how long its motion took beside what was told.
    fn learns(&self, well: bool, workspace: &mut Workspace) {
        let mut connection = self.connection.borrow_mut();
        let (told_s, taken_s) = connection.stopwatch.take_times();
        let learned = connection.learned.run(told_s, taken_s);
        if well && learned != connection.learned {
            connection.learned = learned;
            learned.keep(&self.socket.port, &mut workspace.stored);
        }
    }

    /// Returns the factor that runs on it have shown.
    pub fn learned(&self) -> Learned {
        self.connection.borrow().learned
    }

    /// Forgets that factor.
    pub fn forgets_pace(&self, workspace: &mut Workspace) {
        self.connection.borrow_mut().learned = Learned::default();
        Learned::forget(&self.socket.port, &mut workspace.stored);
    }

    /// A file that it ran from its card is over: keeps where that has left it.
    pub fn stood_by_card(&self, workspace: &mut Workspace) {
        self.keeps_place(workspace);
    }

    /// Leaves the controller and puts back the settings that were changed in it.
    pub fn detach(&self, workspace: &mut Workspace) {
        let mut connection = self.connection.borrow_mut();
        connection.put_back();
        if connection.changed().is_none() {
            workspace.stored.set(CHANGED, None);
        }
    }

    /// Keeps where it stands, as it counts and as the machine does.
    fn keeps_place(&self, workspace: &mut Workspace) {
        let mut connection = self.connection.borrow_mut();
        let own = connection.stands();
        let left = (&self.socket.port, own, own.plus(connection.offset()));
        workspace.stored.set(LEFT, serde_json::to_string(&left).ok().as_deref());
    }

    /// Returns the kept place, as the controller counts and as the machine does.
    fn kept_at(&self, workspace: &Workspace) -> Option<(Axes, Axes)> {
        let (port, own, place): (String, Axes, Axes) =
            serde_json::from_str(workspace.stored.get(LEFT)?).ok()?;
        (port == self.socket.port).then_some((own, place))
    }

    /// Returns the place of the machine, when its controller was neither moved nor switched off since it was driven
    /// last.
    fn left_at(&self, stands: Axes, workspace: &Workspace) -> Option<Axes> {
        let (own, place) = self.kept_at(workspace)?;
        same(own, stands).then_some(place)
    }

    /// Returns the place of the machine, when its controller has gone on counting since its run began. One that was
    /// switched off, or reset when its port was opened, counts from zero.
    fn counted_on(&self, stands: Axes, workspace: &Workspace) -> Option<Axes> {
        let (own, place) = self.kept_at(workspace)?;
        (!same(stands, Axes::default())).then(|| place.plus(stands.minus(own)))
    }

    /// Returns the warning of a controller that does not know its place: Kerf believes its own record.
    fn believed(&self, place: Axes) -> String {
        let [x, y, z, ..] = place.0;
        format!(
            "{} has not been driven before, or was moved or switched off since: the machine is believed to stand \
             at {x:.3}, {y:.3}, {z:.3}, where the last run ended; stop and set its location where that is wrong",
            self.socket.name
        )
    }

    /// Kerf has not seen the end of the last run.
    fn abandoned(&self, place: Axes) -> String {
        let [x, y, z, ..] = place.0;
        format!(
            "the last run on {} has no end: Kerf was killed, or the power failed. What still moved is stopped; the \
             machine is believed to stand at {x:.3}, {y:.3}, {z:.3}",
            self.socket.name
        )
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
        if let (true, Some(why)) = (!is_made_in_wait(work) && self.waits_for_tool(), self.waits()) {
            let why = format!("{}: {why}", self.name());
            return vec![Diagnostic::new(Code::Controller, SourcePlace::line(work.name(), 0), why)];
        }
        dry_run(self.limits(), work, (session, options), workspace, (operator, &mut ()))
    }

    /// Returns what a dry run is held against, where the controller stands now.
    pub fn limits(&self) -> Lacks {
        let connection = self.connection.borrow();
        Lacks::new(connection.name(), connection.facts(), connection.offset())
    }

    /// Returns the loader of the controller's firmware (UI): it runs the command of the settings while the port is closed.
    /// The firmware is loaded when the command says so and the controller answers again.
    pub fn firmware(&self, command: &str) -> Firmware {
        let (controller, command) = (self.clone(), command.to_owned());
        Box::new(move |run| {
            if command.is_empty() {
                let why = "name the command that loads it: kerf set options.firmware='avrdude … -P {port} …'";
                return Err(HostError::Refused(why.into()));
            }
            let Socket { port, opens, .. } = &controller.socket;
            let line = command.replace("{port}", port);
            let (done, again) = controller.connection.borrow_mut().anew(|| run(&line), || opens());
            done?;
            again.map_err(HostError::Refused)
        })
    }
}

/// Returns `true` for what is made while the controller waits for a tool: what somebody's hands move (errands, and the keypad
/// that is typed, SK), and what moves nothing, as a zero of Kerf that is set.
fn is_made_in_wait(work: &Work) -> bool {
    match work {
        Work::Hand(errand, _) => !matches!(errand, Errand::FindHome(_)),
        Work::Part(program) => {
            let is_keypad = program.sbp.text.trim().eq_ignore_ascii_case("SK");
            is_keypad || program.sbp.names_places_at_most()
        }
        Work::Job(..) => false,
    }
}

/// Keeps in mind what was changed in the controller, and says it; what a run that has no end has left changed is put back
/// behind this one.
fn keeps_changed(
    socket: &Socket,
    connection: &mut Connection,
    workspace: &mut Workspace,
) -> Option<String> {
    let kept: Option<(String, u16, u32, u32)> =
        workspace.stored.get(CHANGED).and_then(|kept| serde_json::from_str(kept).ok());
    if let Some((_, number, was, is)) = kept.filter(|(port, ..)| *port == socket.port) {
        connection.owes(Changed { number, was, is });
    }
    let Changed { number, was, is } = connection.changed()?;
    let kept = serde_json::to_string(&(&socket.port, number, was, is)).ok();
    workspace.stored.set(CHANGED, kept.as_deref());
    let name = &socket.name;
    Some(format!("{name}: ${number} is {is} while Kerf drives it, {was} again afterwards"))
}

/// The outputs with which the controller was left on are on, as far as anybody knows: the session believes it, and says so.
fn keeps_on(
    socket: &Socket,
    connection: &mut Connection,
    session: &mut Session,
    workspace: &Workspace,
) -> Option<String> {
    let (port, left): (String, u32) =
        serde_json::from_str(workspace.stored.get(OUTPUTS)?).ok().filter(|(_, on)| *on != 0)?;
    if port != socket.port {
        return None;
    }
    connection.was_left_on(left);
    let mut machine = session.machine(Vec::new());
    lines(left).for_each(|line| machine.model.was_left_on(line));
    session.machine = Some(machine);
    Some(format!("{}: left on by the last command: output {}", socket.name, listed(left)))
}

/// The machine stands where its controller tells; the session believes it. Says where they differed.
fn takes_place(connection: &Connection, session: &mut Session, stands: Axes) -> Vec<String> {
    let mut place = session.memory.position;
    let mut told = Vec::new();
    for axis in AxisSet::first(connection.facts().axes).iter() {
        let (believed_mm, stands_mm) = (place[axis], stands[axis]);
        if (believed_mm - stands_mm).abs() > SAME_MM {
            told.push(format!(
                "{} stands at {stands_mm:.3} and not at {believed_mm:.3} of the machine, as the controller tells; \
                 zero points are where they were",
                axis.letter()
            ));
        }
        place[axis] = stands_mm;
    }
    session.memory.position = place;
    told
}

fn same(a: Axes, b: Axes) -> bool {
    a.minus(b).0.iter().all(|way| way.abs() < SAME_MM)
}
